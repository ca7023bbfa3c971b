"""The search for a differential drive as a policy."""

import numpy as np

from socialnav_core.config import ConfigError, SearchConfig
from socialnav_core.finiteness import require_finite
from socialnav_core.policies.protocol import PolicyDescription
from socialnav_core.policies.search.candidates import Candidates, make_candidates
from socialnav_core.policies.search.differential.base import Base, base_of
from socialnav_core.policies.search.differential.ends import Ends, make_ends, write_time_left
from socialnav_core.policies.search.differential.lattice import make_lattice, make_workspace
from socialnav_core.policies.search.differential.search import plan_worlds
from socialnav_core.policies.search.differential.surprises import unavoidable
from socialnav_core.policies.search.fields import GeodesicCache
from socialnav_core.policies.search.search_policy import costs_of
from socialnav_core.policies.search.terminal import Horizon, Valuation
from socialnav_core.policies.search.ways import ways_from
from socialnav_core.policies.search.worlds import Worlds, worlds_of
from socialnav_core.prediction import make_predictor, Prediction, Predictor
from socialnav_core.simulation.kinematics import DifferentialDrive, Limits
from socialnav_core.states import CrowdState


class DifferentialSearchPolicy:
    """
    Plans some seconds ahead, along arcs that the base can drive, and takes the first step.

    docs/planning.md says how. Nothing but the predictor has a memory that changes a decision.
    """

    kinematics = 'differential'

    def __init__(
        self,
        settings: SearchConfig | None = None,
        predictor: Predictor | None = None,
        value: Valuation | None = None,
        name: str = 'search',
    ) -> None:
        """
        Choose settings.

        :param predictor: takes the place of the one that the settings name.
        :param value: what the ways on are worth at the horizon; None: the time still to drive.
        :param name: what results call it.
        :raises ConfigError: when the settings name no prediction, or another kind of robot.
        """
        self.settings = settings or SearchConfig(kinematics=self.kinematics)
        if self.settings.kinematics != self.kinematics:
            raise ConfigError(f'this search needs kinematics={self.kinematics}')
        self.predictor = predictor or make_predictor(self.settings.lookahead)
        self.value = value
        self.name = name
        self.prediction: Prediction | None = None
        """What was predicted at the last decision, at `times`."""
        self.plan: np.ndarray | None = None
        """Where the robots were meant to go at the last decision, m, (batch, layers, 2)."""
        self.expected_cost = np.empty(0)
        """What that was expected to cost, s, (batch,)."""
        self._prediction = type(predictor).__name__ if predictor else self.settings.lookahead
        self._costs = costs_of(self.settings)
        self._geodesics = GeodesicCache(self.settings)
        self._lattice = make_lattice(self.settings, self.settings.time_step)
        self._space = make_workspace(self._lattice, 0, 1)
        self._tables: dict[tuple[Base, float], np.ndarray] = {}

    @property
    def description(self) -> PolicyDescription:
        """Return what results tell of this policy."""
        return PolicyDescription(
            name=self.name,
            kinematics=self.kinematics,
            prediction=self._prediction,
            knowledge=self.predictor.knowledge,
            remembers=self.predictor.remembers,
        )

    @property
    def last_layer(self) -> float:
        """Return how long the last layer lasts, s."""
        return float(self._lattice.durations[-1])

    @property
    def times(self) -> np.ndarray:
        """Return when the positions of the plan are meant to be reached, s ahead, (layers,)."""
        return np.cumsum(self._lattice.durations)

    def act(self, state: CrowdState, limits: Limits | None = None) -> np.ndarray:
        """
        Return speeds and turn rates within the limits, (batch, 2).

        :param limits: of the robot; where they are infinite, those of the settings count.
        """
        require_finite(state)
        base = self._fitted(limits)
        worlds = within_speed(worlds_of(state), base.speed)
        prediction = self.prediction = self.predictor.predict(state, self.times)
        modes, agents = prediction.positions.shape[1], prediction.positions.shape[3]
        if modes * agents > len(self._space.order):
            self._space = make_workspace(self._lattice, agents, modes)
        speeds, chosen = np.unique(worlds.speed, return_inverse=True)
        tables = np.stack([self._table(base, speed) for speed in speeds.tolist()])
        batch, layers = state.batch_size, len(self._lattice.durations)
        commands, self.expected_cost = np.zeros((batch, 2)), np.zeros(batch)
        plan = self.plan = np.zeros((batch, layers, 2))
        valued = self.value is not None and self.settings.value_weight > 0.0
        candidates = make_candidates(batch, self.settings.candidates * valued, layers)
        ends = make_ends(batch, self.settings.candidates * valued)
        plan_worlds(
            worlds, present_motion(state), base, self._geodesics.slots_of(worlds),
            self._geodesics.fields,
            np.ascontiguousarray(prediction.positions, dtype=np.float64),
            np.ascontiguousarray(prediction.deviations, dtype=np.float64),
            np.ascontiguousarray(prediction.weights, dtype=np.float64),
            self._lattice, self._costs, tables, chosen, self._space,
            self.settings.candidate_slack, candidates, ends, commands, plan, self.expected_cost,
        )  # fmt: skip
        if self.value is not None and valued:
            used = np.isfinite(candidates.totals)
            used &= used.sum(axis=1, keepdims=True) > 1  # between one there is no choice
            positions = candidates.plans[:, :, -1]
            _, subgoals = self.ways_on(state, positions)
            horizon = Horizon(
                state, prediction, self.last_layer, positions, subgoals, used, ends.headings,
                ends.speeds,
            )  # fmt: skip
            self._choose(candidates, ends, self.value.costs(horizon), used, commands, plan)
        return commands

    def _choose(
        self,
        candidates: Candidates,
        ends: Ends,
        costs: np.ndarray,
        used: np.ndarray,
        commands: np.ndarray,
        plan: np.ndarray,
    ) -> None:
        """Replace commands and plans by those of the candidates that are cheapest in all."""
        totals = candidates.totals + self.settings.value_weight * costs
        worlds = np.flatnonzero(used.any(axis=1))
        best = np.where(used, totals, np.inf)[worlds].argmin(axis=1)
        plan[worlds] = candidates.plans[worlds, best]
        commands[worlds] = ends.commands[worlds, best]
        self.expected_cost[worlds] = totals[worlds, best]

    def ways_on(self, state: CrowdState, positions: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """
        Return distances to the goals around the obstacles, and goals in sight at that distance.

        :param positions: from where, m, (batch, positions, 2).
        :returns: m, (batch, positions), and m, (batch, positions, 2).
        """
        return ways_from(self._geodesics, state, positions)

    def time_left(self, state: CrowdState, limits: Limits | None = None) -> np.ndarray:
        """Return the time that the search reckons for the ways to the goals, s, (batch,)."""
        base = self._fitted(limits)
        worlds, times = within_speed(worlds_of(state), base.speed), np.zeros(state.batch_size)
        slots = self._geodesics.slots_of(worlds)
        write_time_left(
            worlds, present_motion(state), base, slots, self._geodesics.fields, self._lattice,
            self._costs, times,
        )  # fmt: skip
        return times

    def _fitted(self, limits: Limits | None) -> Base:
        """Return the base; the lattice is made anew where its period is another."""
        base = base_of(self.settings, limits)
        if base.period != self._lattice.durations[0]:
            self._lattice = make_lattice(self.settings, base.period)
            self._space = make_workspace(self._lattice, 0, 1)
        return base

    def _table(self, base: Base, speed: float) -> np.ndarray:
        """Return who cannot be evaded at a preferred speed, m/s; see `unavoidable`."""
        known = self._tables.get((base, speed))
        if known is None:
            walking = self.settings.differential.surprise_speed
            known = self._tables[base, speed] = unavoidable(base, speed, base.period, walking)
        return known

    def attention(self, state: CrowdState) -> np.ndarray | None:
        """Return how much the network looks at each agent, (batch, agents); None without one."""
        return self.value.attention(state) if self.value else None

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Forget the history of some worlds, of all where none are named."""
        self.predictor.reset(worlds)


def within_speed(worlds: Worlds, limit: float) -> Worlds:
    """Return worlds whose robots prefer no speed above a limit, m/s."""
    return worlds._replace(speed=np.minimum(worlds.speed, limit))


def present_motion(state: CrowdState) -> np.ndarray:
    """Return headings, rad, speeds, m/s, and turn rates, rad/s, (batch, 3)."""
    command = DifferentialDrive().present_command(state.robot)
    return np.concatenate([state.robot.heading[:, None], command], axis=1, dtype=np.float64)
