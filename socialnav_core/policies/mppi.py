"""
Model predictive path integral control: a sampler with the costs and predictions of the search.

Source: G. Williams et al., Information theoretic MPC for model-based reinforcement learning, ICRA
2017. Sequences of velocities are drawn around the last plan; the next plan is their mean, each
weighted by exp(-cost / temperature).
"""

import dataclasses
import math
from typing import Annotated

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.config import SearchConfig
from socialnav_core.config.ranges import Range, require_allowed
from socialnav_core.config.training import LARGEST_SEED
from socialnav_core.finiteness import require_finite
from socialnav_core.policies.protocol import PolicyDescription
from socialnav_core.policies.search.costs import COLLISION, cost_of_gap, length
from socialnav_core.policies.search.fields import distance_at, frame_of, GeodesicCache, way_down
from socialnav_core.policies.search.lattice import (
    CONTACT_DISTANCE,
    INVERSE_DEVIATION,
    make_lattice,
    make_workspace,
    REACH,
    WEIGHT,
)
from socialnav_core.policies.search.scene import gather_obstacles, gather_people
from socialnav_core.policies.search.search_policy import costs_of
from socialnav_core.policies.search.worlds import worlds_of
from socialnav_core.prediction import make_predictor
from socialnav_core.simulation.kinematics import Limits
from socialnav_core.simulation.rewards import swept_distance
from socialnav_core.states import CrowdState

NEGLIGIBLE = 14.0
"""Sequences that cost more by so many temperatures weigh less than a millionth: nothing."""
SHARED = ('lookahead', 'time_step', 'goal_tolerance')


@dataclasses.dataclass(frozen=True)
class MppiConfig:
    """How sequences of velocities are drawn and weighted."""

    samples: Annotated[int, Range(2, 100_000)] = 256
    """Sequences that are drawn in each round."""
    rounds: Annotated[int, Range(1, 100)] = 3
    """Rounds of a decision; each is drawn around the mean of the one before."""
    deviation: Annotated[float, Range(0.001, 100)] = 0.8
    """Standard deviation of the first round's velocities, in units of the preferred speed."""
    shrinkage: Annotated[float, Range(0.001, 1)] = 0.6
    """Factor of the deviation from round to round."""
    correlation: Annotated[float, Range(0, 0.999)] = 0.8
    """Correlation of a sequence's noise from one step to the next."""
    temperature: Annotated[float, Range(1e-6, 1000)] = 0.05
    """Sequences that cost so much more weigh 1 / e, s."""
    seed: Annotated[int, Range(0, LARGEST_SEED)] = 0
    """Of the noise, which is the same in every decision."""
    lookahead: str = 'constant_velocity'
    """Prediction of the pedestrians, by its name."""
    time_step: Annotated[float, Range(0.01, 2)] = 0.25
    """Time that a command lasts, s."""
    goal_tolerance: Annotated[float, Range(0.001, 5)] = 0.3
    """Distance at which the goal counts as reached, m."""
    costs: SearchConfig = SearchConfig()
    """Costs and horizon of the search; what it shares with this is taken from here."""

    def __post_init__(self) -> None:
        """Refuse values that describe no sampler."""
        require_allowed(self)


class MppiPolicy:
    """Draws many ways to go on and takes the first step of their weighted mean."""

    kinematics = 'holonomic'

    def __init__(self, config: MppiConfig | None = None) -> None:
        """
        Choose settings.

        :raises ConfigError: when the settings name no prediction.
        """
        config = config or MppiConfig()
        shared = {name: getattr(config, name) for name in SHARED}
        settings = dataclasses.replace(config.costs, **shared)
        self.config = config
        self.predictor = make_predictor(settings.lookahead)
        self.plan: np.ndarray | None = None
        self._lattice, self._costs = make_lattice(settings), costs_of(settings)
        self._geodesics = GeodesicCache(settings)
        self._space = make_workspace(self._lattice, 0, 1)
        self._noise = make_noise(config, len(self._lattice.durations))
        self._mean = np.empty((0, 0, 2))

    @property
    def description(self) -> PolicyDescription:
        """Return what results tell of this policy."""
        return PolicyDescription(
            'mppi', self.kinematics, self.config.lookahead, self.predictor.knowledge,
            remembers=True, settings={'samples': self.config.samples},
        )  # fmt: skip

    def act(self, state: CrowdState, limits: Limits | None = None) -> np.ndarray:
        """
        Return the commands, (batch, 2).

        :param limits: not used: the sampler has no inertia.
        """
        require_finite(state)
        worlds, times = worlds_of(state), np.cumsum(self._lattice.durations)
        prediction = self.predictor.predict(state, times)
        modes, agents = prediction.positions.shape[1], prediction.positions.shape[3]
        if modes * agents > len(self._space.order):
            self._space = make_workspace(self._lattice, agents, modes)
        if len(self._mean) != state.batch_size:
            self._mean = np.full((state.batch_size, len(times), 2), np.nan)
        commands, self.plan = np.zeros((state.batch_size, 2)), np.zeros_like(self._mean)
        sample_worlds(
            worlds, self._geodesics.slots_of(worlds), self._geodesics.fields,
            np.ascontiguousarray(prediction.positions, dtype=np.float64),
            np.ascontiguousarray(prediction.deviations, dtype=np.float64),
            np.ascontiguousarray(prediction.weights, dtype=np.float64),
            self._lattice, self._costs, self._space, self._noise, self.config.temperature,
            self._mean, commands, self.plan,
        )  # fmt: skip
        return commands

    def attention(self, state: CrowdState) -> None:
        """Return nothing: people count by where they will be."""

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Forget the plans of some worlds, of all where none are named."""
        self.predictor.reset(worlds)
        self._mean[slice(None) if worlds is None else worlds] = np.nan


def make_noise(config: MppiConfig, steps: int) -> np.ndarray:
    """Return the noise of all sequences, shares of the speed, (rounds, samples, steps, 2)."""
    draws = np.random.default_rng(config.seed).standard_normal(
        (config.rounds, config.samples, steps, 2)
    )
    draws[:, 0] = 0.0  # one sequence is the plan itself
    for step in range(1, steps):
        fresh = math.sqrt(1.0 - config.correlation**2)
        draws[:, :, step] = config.correlation * draws[:, :, step - 1] + fresh * draws[:, :, step]
    shrinking = config.deviation * config.shrinkage ** np.arange(config.rounds)
    return draws * shrinking[:, None, None, None]


@compiled
def sample_worlds(  # type: ignore[no-untyped-def]
    worlds, slots, fields, positions, deviations, weights, lattice, costs, space, noise,
    temperature, mean, commands, plans,
):  # fmt: skip
    """
    Plan in each world; write commands, m/s, and plans, m, (batch, steps, 2).

    :param noise: (rounds, samples, steps, 2).
    :param mean: the last plan's velocities over the preferred speed, NaN without one, moved on by
        a step, (batch, steps, 2).
    """
    rounds, samples, steps = noise.shape[0], noise.shape[1], noise.shape[2]
    cost, drawn = np.empty(samples), np.empty((steps, 2))
    for world in range(slots.size):
        speed = worlds.speed[world]
        plans[world] = worlds.position[world]
        if speed <= 0.0:
            continue
        people = gather_people(
            worlds, world, positions, deviations, weights, lattice, costs, space
        )
        obstacles = gather_obstacles(worlds, world, lattice, costs, space)
        field, frame = fields.distance[max(0, slots[world])], frame_of(fields, slots[world])
        plan = mean[world]
        if math.isnan(plan[0, 0]):
            down_x, down_y, _ = way_down(
                field, frame, worlds.position[world, 0], worlds.position[world, 1],
                worlds.goal[world, 0], worlds.goal[world, 1],
            )  # fmt: skip
            plan[:, 0], plan[:, 1] = down_x, down_y
        for number in range(rounds):
            least = math.inf
            for k in range(samples):
                draw(plan, noise[number, k], drawn)
                cost[k] = rollout(
                    worlds, world, field, frame, people, obstacles, lattice, costs, space, drawn,
                    least + NEGLIGIBLE * temperature,
                )  # fmt: skip
                least = min(least, cost[k])
            average(plan, noise[number], cost, temperature, drawn)
        x, y = worlds.position[world, 0], worlds.position[world, 1]
        for step in range(steps):
            x += speed * lattice.durations[step] * plan[step, 0]
            y += speed * lattice.durations[step] * plan[step, 1]
            plans[world, step, 0], plans[world, step, 1] = x, y
        commands[world, 0], commands[world, 1] = speed * plan[0, 0], speed * plan[0, 1]
        for step in range(steps - 1):
            plan[step, 0], plan[step, 1] = plan[step + 1, 0], plan[step + 1, 1]


@compiled
def draw(plan, noise, drawn):  # type: ignore[no-untyped-def]
    """Write a plan with noise, no velocity of which is above the preferred speed."""
    for step in range(plan.shape[0]):
        x, y = plan[step, 0] + noise[step, 0], plan[step, 1] + noise[step, 1]
        scale = 1.0 / max(1.0, length(x, y))
        drawn[step, 0], drawn[step, 1] = x * scale, y * scale


@compiled
def average(plan, noise, cost, temperature, drawn):  # type: ignore[no-untyped-def]
    """Put the weighted mean of the sequences in the plan's place."""
    least, total = cost.min(), 0.0
    following = np.zeros_like(plan)
    for k in range(cost.size):
        weight = math.exp((least - cost[k]) / temperature)
        if cost[k] < least + NEGLIGIBLE * temperature:
            draw(plan, noise[k], drawn)
            following += weight * drawn
            total += weight
    plan[:] = following / total


@compiled
def rollout(  # type: ignore[no-untyped-def]
    worlds, world, field, frame, people, obstacles, lattice, costs, space, drawn, enough
):
    """
    Return what a sequence of velocities over the preferred speed costs, s.

    :param drawn: the velocities, (steps, 2).
    :param enough: a cost, s, from which on it does not matter how much more it is.
    """
    speed, total = worlds.speed[world], 0.0
    x, y = worlds.position[world, 0], worlds.position[world, 1]
    goal_x, goal_y = worlds.goal[world, 0], worlds.goal[world, 1]
    last_x, last_y = worlds.velocity[world, 0] / speed, worlds.velocity[world, 1] / speed
    limit = worlds.bounds[world] - worlds.radius[world] - costs.obstacle_margin
    for layer in range(drawn.shape[0]):
        duration = lattice.durations[layer]
        move_x, move_y = speed * duration * drawn[layer, 0], speed * duration * drawn[layer, 1]
        total += duration
        total += costs.turning * length(drawn[layer, 0] - last_x, drawn[layer, 1] - last_y)
        last_x, last_y = drawn[layer, 0], drawn[layer, 1]
        if max(abs(x + move_x), abs(y + move_y)) > max(limit, max(abs(x), abs(y))):
            total += COLLISION
        for disc in range(obstacles):
            off_x, off_y = space.discs[disc, 0] - x, space.discs[disc, 1] - y
            least = swept_distance(off_x, off_y, -move_x, -move_y)
            if least < space.discs[disc, 2] and least < length(off_x, off_y) - 1e-6:
                total += COLLISION
        contact = costs.contact * costs.contact_discount**layer
        intrusion = costs.intrusion * costs.intrusion_discount**layer * duration
        for person in range(people):
            from_x, from_y = space.track[layer, person, 0] - x, space.track[layer, person, 1] - y
            walk_x = space.track[layer + 1, person, 0] - space.track[layer, person, 0]
            walk_y = space.track[layer + 1, person, 1] - space.track[layer, person, 1]
            gap = swept_distance(from_x, from_y, walk_x - move_x, walk_y - move_y)
            gap -= space.body[person, CONTACT_DISTANCE]
            if gap < space.spread[layer, person, REACH]:
                inverse = space.spread[layer, person, INVERSE_DEVIATION]
                total += space.body[person, WEIGHT] * cost_of_gap(
                    costs, gap, inverse, layer, contact, intrusion
                )
        x, y = x + move_x, y + move_y
        if total >= enough:
            return total
        if length(goal_x - x, goal_y - y) < costs.goal_tolerance:
            return total
    remaining = distance_at(field, frame, x, y, goal_x, goal_y) - costs.goal_tolerance
    return total + max(remaining, 0.0) / speed
