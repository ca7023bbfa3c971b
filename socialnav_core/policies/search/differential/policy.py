"""The search for a differential drive as a policy."""

import numpy as np

from socialnav_core.config import ConfigError, SearchConfig
from socialnav_core.finiteness import require_finite
from socialnav_core.policies.protocol import PolicyDescription
from socialnav_core.policies.search.differential.base import base_of
from socialnav_core.policies.search.differential.lattice import make_lattice, make_workspace
from socialnav_core.policies.search.differential.search import plan_worlds
from socialnav_core.policies.search.fields import GeodesicCache
from socialnav_core.policies.search.search_policy import costs_of
from socialnav_core.policies.search.worlds import Worlds, worlds_of
from socialnav_core.prediction import make_predictor, Predictor
from socialnav_core.simulation.kinematics import DifferentialDrive, Limits
from socialnav_core.states import CrowdState


class DifferentialSearchPolicy:
    """
    Plans some seconds ahead, along arcs that the base can drive, and takes the first step.

    docs/planning.md says how. Nothing but the predictor has a memory that changes a decision.
    """

    kinematics = 'differential'

    def __init__(
        self, settings: SearchConfig | None = None, predictor: Predictor | None = None
    ) -> None:
        """
        Choose settings.

        :param predictor: takes the place of the one that the settings name.
        :raises ConfigError: when the settings name no prediction, or another kind of robot.
        """
        self.settings = settings or SearchConfig(kinematics=self.kinematics)
        if self.settings.kinematics != self.kinematics:
            raise ConfigError(f'this search needs kinematics={self.kinematics}')
        self.predictor = predictor or make_predictor(self.settings.lookahead)
        self.plan: np.ndarray | None = None
        """Where the robots were meant to go at the last decision, m, (batch, layers, 2)."""
        self.expected_cost = np.empty(0)
        """What that was expected to cost, s, (batch,)."""
        self._prediction = type(predictor).__name__ if predictor else self.settings.lookahead
        self._costs = costs_of(self.settings)
        self._geodesics = GeodesicCache(self.settings)
        self._lattice = make_lattice(self.settings, self.settings.time_step)
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
        Return speeds and turn rates within the limits, (batch, 2).

        :param limits: of the robot; where they are infinite, those of the settings count.
        """
        require_finite(state)
        base = base_of(self.settings, limits)
        if base.period != self._lattice.durations[0]:
            self._lattice = make_lattice(self.settings, base.period)
            self._space = make_workspace(self._lattice, 0, 1)
        worlds = within_speed(worlds_of(state), base.speed)
        prediction = self.predictor.predict(state, self.times)
        modes, agents = prediction.positions.shape[1], prediction.positions.shape[3]
        if modes * agents > len(self._space.order):
            self._space = make_workspace(self._lattice, agents, modes)
        batch = state.batch_size
        commands, self.expected_cost = np.zeros((batch, 2)), np.zeros(batch)
        self.plan = np.zeros((batch, len(self._lattice.durations), 2))
        plan_worlds(
            worlds, present_motion(state), base, self._geodesics.slots_of(worlds),
            self._geodesics.fields,
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


def within_speed(worlds: Worlds, limit: float) -> Worlds:
    """Return worlds whose robots prefer no speed above a limit, m/s."""
    return worlds._replace(speed=np.minimum(worlds.speed, limit))


def present_motion(state: CrowdState) -> np.ndarray:
    """Return headings, rad, speeds, m/s, and turn rates, rad/s, (batch, 3)."""
    command = DifferentialDrive().present_command(state.robot)
    return np.concatenate([state.robot.heading[:, None], command], axis=1, dtype=np.float64)
