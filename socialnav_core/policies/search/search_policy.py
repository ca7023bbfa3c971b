"""The search as a policy."""

import dataclasses

import numpy as np

from socialnav_core.config import ConfigError, SearchConfig
from socialnav_core.policies.protocol import PolicyDescription
from socialnav_core.policies.search.costs import Costs
from socialnav_core.policies.search.fields import GeodesicCache
from socialnav_core.policies.search.lattice import make_lattice, make_workspace
from socialnav_core.policies.search.search import plan_worlds
from socialnav_core.policies.search.worlds import worlds_of
from socialnav_core.prediction import make_predictor, Predictor
from socialnav_core.simulation.kinematics import Limits
from socialnav_core.states import CrowdState


class SearchPolicy:
    """
    Plans some seconds ahead among predicted people and takes the first step.

    docs/planning.md says how. Nothing but the predictor has a memory that changes a decision.
    """

    kinematics = 'holonomic'

    def __init__(
        self, settings: SearchConfig | None = None, predictor: Predictor | None = None
    ) -> None:
        """
        Choose settings.

        :param predictor: takes the place of the one that the settings name.
        :raises ConfigError: when the settings name no prediction, or another kind of robot.
        """
        self.settings = settings or SearchConfig()
        if self.settings.kinematics != self.kinematics:
            raise ConfigError(f'this search needs kinematics={self.kinematics}')
        self.predictor = predictor or make_predictor(self.settings.lookahead)
        self.plan: np.ndarray | None = None
        """Where the robots were meant to go at the last decision, m, (batch, layers, 2)."""
        self.expected_cost = np.empty(0)
        """What that was expected to cost, s, (batch,)."""
        self._prediction = type(predictor).__name__ if predictor else self.settings.lookahead
        self._lattice = make_lattice(self.settings)
        self._costs = costs_of(self.settings)
        self._geodesics = GeodesicCache(self.settings)
        self._space = make_workspace(self._lattice, 0, 1)

    @property
    def description(self) -> PolicyDescription:
        """Return what results tell of this policy."""
        return PolicyDescription(
            name='search',
            kinematics=self.kinematics,
            prediction=self._prediction,
            knowledge=self.predictor.knowledge,
            remembers=self.predictor.remembers,
        )

    @property
    def times(self) -> np.ndarray:
        """Return when the positions of the plan are meant to be reached, s ahead, (layers,)."""
        return np.cumsum(self._lattice.durations)

    def act(self, state: CrowdState, limits: Limits | None = None) -> np.ndarray:
        """
        Return the commands, (batch, 2).

        :param limits: not used: the search has no inertia.
        """
        worlds = worlds_of(state)
        prediction = self.predictor.predict(state, self.times)
        modes, agents = prediction.positions.shape[1], prediction.positions.shape[3]
        if modes * agents > len(self._space.order):
            self._space = make_workspace(self._lattice, agents, modes)
        batch = state.batch_size
        commands, self.expected_cost = np.zeros((batch, 2)), np.zeros(batch)
        self.plan = np.zeros((batch, len(self._lattice.durations), 2))
        plan_worlds(
            worlds, self._geodesics.slots_of(worlds), self._geodesics.fields,
            np.ascontiguousarray(prediction.positions, dtype=np.float64),
            np.ascontiguousarray(prediction.deviations, dtype=np.float64),
            np.ascontiguousarray(prediction.weights, dtype=np.float64),
            self._lattice, self._costs, self._space, commands, self.plan, self.expected_cost,
        )  # fmt: skip
        return commands

    def attention(self, state: CrowdState) -> None:
        """Return nothing: people count by where they will be."""

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Forget the history of some worlds, of all where none are named."""
        self.predictor.reset(worlds)


def costs_of(settings: SearchConfig) -> Costs:
    """Return the settings of the costs."""
    values = dataclasses.asdict(settings)
    return Costs(**{name: values[name] for name in Costs._fields})
