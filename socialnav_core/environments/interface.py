"""What an agent sees and does, as Gymnasium's spaces and as arrays of the simulator."""

import dataclasses
import math
from typing import Any

from gymnasium import spaces
import numpy as np

from socialnav_core.config import ConfigError, make_scenario, require, Scenario
from socialnav_core.config.mapping import replace
from socialnav_core.policies.value.observation import AGENT_FEATURES, observe, ROBOT_FEATURES
from socialnav_core.simulation import Outcome
from socialnav_core.simulation.kinematics import kinematics_of
from socialnav_core.states import CrowdState

Arrays = dict[str, np.ndarray]
INFO = ('case_index', 'time', 'clearance', 'pedestrian_clearance', 'path_length')
"""What of the simulator's info is passed on, SI units."""


@dataclasses.dataclass(frozen=True)
class Interface:
    """
    Turns states into observations and actions into commands.

    Everything is told in the frame of the robot whose x axis points at the goal. So an action
    means the same wherever the robot is: (1, 0) is straight to the goal.
    """

    scenario: Scenario
    """The world."""
    agents: int
    """Slots of an observation: the nearest people and obstacles, the others are not seen."""
    max_turn_rate: float
    """Turn rate of an action of 1, for a differential drive, rad/s."""

    @property
    def observation_space(self) -> spaces.Dict:
        """
        Return the space of an observation.

        robot is [goal distance, preferred speed, heading, radius, vx, vy], others [px, py, vx, vy,
        radius, distance, sum of radii] of each agent, mask tells which of these are real.
        """
        return spaces.Dict(
            {
                'robot': spaces.Box(-np.inf, np.inf, (ROBOT_FEATURES,), np.float32),
                'others': spaces.Box(-np.inf, np.inf, (self.agents, AGENT_FEATURES), np.float32),
                'mask': spaces.MultiBinary(self.agents),
            }
        )

    @property
    def action_space(self) -> spaces.Box:
        """
        Return the space of an action.

        Of a holonomic robot it is the velocity over its preferred speed, cut to length 1; of a
        differential drive the speed over its preferred speed and the turn rate over the largest.
        """
        low = np.array([0.0, -1.0] if self._has_heading else [-1.0, -1.0], np.float32)
        return spaces.Box(low, np.ones(2, np.float32), dtype=np.float32)

    def observe(self, state: CrowdState) -> Arrays:
        """Return the observations of worlds, arrays of their own, (batch, ...)."""
        motion = kinematics_of(self.scenario.kinematics)
        seen = observe(state.nearest(self.agents), motion)
        missing = ((0, 0), (0, self.agents - seen.mask.shape[1]))
        return {
            'robot': seen.robot,
            'others': np.pad(seen.others, (*missing, (0, 0))),
            'mask': np.pad(seen.mask, missing).astype(np.int8),
        }

    def command(self, state: CrowdState, action: np.ndarray) -> np.ndarray:
        """
        Return the commands of actions, float64 (batch, 2).

        :raises ValueError: for an action of another shape or one that is not finite.
        """
        action = np.asarray(action, dtype=np.float64)
        if action.shape != (state.batch_size, 2) or not np.isfinite(action).all():
            raise ValueError(f'action must be finite, ({state.batch_size}, 2), not {action}')
        space, speed = self.action_space, state.robot.preferred_speed[:, None]
        if self._has_heading:
            action = np.clip(action, space.low, space.high)
            return np.concatenate([action[:, :1] * speed, action[:, 1:] * self.max_turn_rate], 1)
        length = np.hypot(action[:, :1], action[:, 1:])
        velocity = action / np.maximum(length, 1.0) * speed
        ahead = state.robot.goal - state.robot.position
        distance = np.hypot(*ahead.T)[:, None]
        ahead = np.where(distance > 0.0, ahead / np.maximum(distance, 1e-12), (1.0, 0.0))
        left = np.stack([-ahead[:, 1], ahead[:, 0]], axis=1)
        return velocity[:, :1] * ahead + velocity[:, 1:] * left

    @property
    def _has_heading(self) -> bool:
        return kinematics_of(self.scenario.kinematics).has_heading


def make_interface(
    scenario: str | Scenario, settings: dict[str, Any], agents: int | None, max_turn_rate: float
) -> Interface:
    """
    Return the interface of a world.

    :param scenario: itself or its name.
    :param settings: of the scenario that differ.
    :param agents: slots of an observation; None: as many as the world has.
    :raises ConfigError: for an unknown scenario or setting, or no slot.
    """
    world = make_scenario(scenario) if isinstance(scenario, str) else scenario
    if not isinstance(world, Scenario):
        raise ConfigError(f'scenario must be a name or a Scenario, not {scenario!r}')
    world = replace(world, settings, 'scenario')
    slots = max(1, world.agents) if agents is None else agents
    require(slots >= 1, f'agents must be at least 1, not {agents}')
    require(0.0 < max_turn_rate < math.inf, 'max_turn_rate must be positive and finite')
    return Interface(world, slots, max_turn_rate)


def infos_of(info: dict[str, Any]) -> Arrays:
    """Return what is told of a step besides observation and reward, (batch,) each."""
    told = {name: info[name] for name in INFO}
    return told | {'outcome': info['outcome'], 'is_success': info['outcome'] == Outcome.GOAL}
