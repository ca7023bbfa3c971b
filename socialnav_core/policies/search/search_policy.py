"""The search as a policy."""

import dataclasses

import numpy as np

from socialnav_core.config import ConfigError, SearchConfig
from socialnav_core.finiteness import require_finite
from socialnav_core.policies.protocol import PolicyDescription
from socialnav_core.policies.search.candidates import Candidates, make_candidates
from socialnav_core.policies.search.costs import Costs
from socialnav_core.policies.search.crowding import Crowding
from socialnav_core.policies.search.fields import GeodesicCache
from socialnav_core.policies.search.lattice import make_lattice, make_workspace
from socialnav_core.policies.search.search import (
    ARRIVAL_SHARE,
    LEAST_REMAINING,
    plan_worlds,
)
from socialnav_core.policies.search.terminal import Horizon, Valuation
from socialnav_core.policies.search.ways import ways_from
from socialnav_core.policies.search.worlds import worlds_of
from socialnav_core.prediction import make_predictor, Prediction, Predictor
from socialnav_core.simulation.kinematics import Limits
from socialnav_core.states import CrowdState


class SearchPolicy:
    """
    Plans some seconds ahead among predicted people and takes the first step.

    docs/planning.md says how. Nothing but the predictor has a memory that changes a decision.
    """

    kinematics = 'holonomic'

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
        :param value: what the ways on are worth at the horizon; None: the distance to the goal.
        :param name: what results call it.
        :raises ConfigError: when the settings name no prediction, or another kind of robot.
        """
        self.settings = settings or SearchConfig()
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
        self._lattice = make_lattice(self.settings)
        self._costs = costs_of(self.settings)
        self._geodesics = GeodesicCache(self.settings)
        self._crowding = Crowding(self.settings)
        self._space = make_workspace(self._lattice, 0, 1)

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

    def time_left(self, state: CrowdState, limits: Limits | None = None) -> np.ndarray:
        """
        Return the time that the search reckons for the ways to the goals, s, (batch,).

        :param limits: not used: the search has no inertia.
        """
        distance, _ = self.ways_on(state, state.robot.position[:, None])
        remaining = distance[:, 0] - ARRIVAL_SHARE * self.settings.goal_tolerance
        return np.maximum(remaining, LEAST_REMAINING) / state.robot.preferred_speed

    @property
    def times(self) -> np.ndarray:
        """Return when the positions of the plan are meant to be reached, s ahead, (layers,)."""
        return np.cumsum(self._lattice.durations)

    def act(self, state: CrowdState, limits: Limits | None = None) -> np.ndarray:
        """
        Return the commands, (batch, 2).

        :param limits: not used: the search has no inertia.
        """
        require_finite(state)
        worlds = worlds_of(state)
        prediction = self.prediction = self.predictor.predict(state, self.times)
        modes, agents = prediction.positions.shape[1], prediction.positions.shape[3]
        if modes * agents > len(self._space.order):
            self._space = make_workspace(self._lattice, agents, modes)
        batch, layers = state.batch_size, len(self._lattice.durations)
        commands, self.expected_cost = np.zeros((batch, 2)), np.zeros(batch)
        plan = self.plan = np.zeros((batch, layers, 2))
        valued = self.value is not None and self.settings.value_weight > 0.0
        candidates = make_candidates(batch, self.settings.candidates * valued, layers)
        slots = self._geodesics.slots_of(worlds)
        fields, slots = self._crowding.add(
            worlds, prediction, float(self.times[-1]), self._geodesics.fields, slots
        )
        plan_worlds(
            worlds, slots, fields,
            np.ascontiguousarray(prediction.positions, dtype=np.float64),
            np.ascontiguousarray(prediction.deviations, dtype=np.float64),
            np.ascontiguousarray(prediction.weights, dtype=np.float64),
            self._lattice, self._costs, self._space, self.settings.usual_speed,
            self.settings.candidate_slack, candidates, commands, plan, self.expected_cost,
        )  # fmt: skip
        if self.value is not None and valued:
            ends = candidates.plans[:, :, -1]
            used = np.isfinite(candidates.totals)
            used &= used.sum(axis=1, keepdims=True) > 1  # between one there is no choice
            _, subgoals = self.ways_on(state, ends)
            horizon = Horizon(state, prediction, self.last_layer, ends, subgoals, used)
            self._choose(candidates, self.value.costs(horizon), used, state, commands, plan)
        return commands

    def ways_on(self, state: CrowdState, positions: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """
        Return distances to the goals around the obstacles, and goals in sight at that distance.

        :param positions: from where, m, (batch, positions, 2).
        :returns: m, (batch, positions), and m, (batch, positions, 2).
        """
        return ways_from(self._geodesics, state, positions)

    def _choose(
        self,
        candidates: Candidates,
        costs: np.ndarray,
        used: np.ndarray,
        state: CrowdState,
        commands: np.ndarray,
        plan: np.ndarray,
    ) -> None:
        """Replace commands and plans by those of the candidates that are cheapest in all."""
        totals = candidates.totals + self.settings.value_weight * costs
        worlds = np.flatnonzero(used.any(axis=1))
        best = np.where(used, totals, np.inf)[worlds].argmin(axis=1)
        chosen = candidates.plans[worlds, best]
        plan[worlds], self.expected_cost[worlds] = chosen, totals[worlds, best]
        moved = chosen[:, 0] - state.robot.position[worlds]
        commands[worlds] = moved / self._lattice.durations[0]

    def attention(self, state: CrowdState) -> np.ndarray | None:
        """Return how much the network looks at each agent, (batch, agents); None without one."""
        return self.value.attention(state) if self.value else None

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Forget the history of some worlds, of all where none are named."""
        self.predictor.reset(worlds)


def costs_of(settings: SearchConfig) -> Costs:
    """Return the settings of the costs."""
    values = dataclasses.asdict(settings)
    return Costs(**{name: values[name] for name in Costs._fields})
