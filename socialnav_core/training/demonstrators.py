"""Who shows the robot its way: ORCA, and ORCA with a defect of the founding report's code."""

import dataclasses

import numpy as np

from socialnav_core.config.training import ImitationConfig
from socialnav_core.policies import OrcaPolicy, Policy, PolicyDescription
from socialnav_core.simulation.kinematics import Limits
from socialnav_core.states import CrowdState


class StaleRadii:
    """
    ORCA that believes the radii of the first case in all cases that follow.

    The report's code handed radii to its planner once and later only positions and velocities.
    """

    predictor = None
    plan = None

    def __init__(self, planner: OrcaPolicy) -> None:
        """Remember nothing yet."""
        self._planner = planner
        self._radius: np.ndarray | None = None

    @property
    def description(self) -> PolicyDescription:
        """Return what results tell of this policy."""
        return dataclasses.replace(self._planner.description, remembers=True)

    def act(self, state: CrowdState, limits: Limits | None = None) -> np.ndarray:
        """
        Return the commands, (batch, 2).

        :param state: the first time, its world 0 has the case that is kept.
        """
        if self._radius is None:
            self._radius = state.agents.radius[0].copy()
        believed = np.broadcast_to(self._radius, state.agents.radius.shape)
        return self._planner.act(state.with_agents(radius=believed), limits)

    def attention(self, state: CrowdState) -> None:
        """Return nothing: everybody counts as they must."""

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Forget the radii, unless single worlds go on to other cases: that is the defect."""
        if worlds is None:
            self._radius = None


def make_demonstrator(settings: ImitationConfig) -> Policy:
    """Return who is imitated."""
    planner = OrcaPolicy(safety_space=settings.safety_space)
    return StaleRadii(planner) if settings.stale_radii else planner
