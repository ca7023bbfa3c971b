"""One-step look-ahead over an action set with a value network."""

from collections.abc import Callable
import dataclasses

import numpy as np
from torch import nn

from socialnav_core.config import ConfigError, PolicyConfig
from socialnav_core.policies.value.inference import ValueInference
from socialnav_core.policies.value.observation import observe, observe_candidates
from socialnav_core.policies.value.screening import safe_actions
from socialnav_core.simulation.kinematics import kinematics_of, Limits
from socialnav_core.simulation.rewards import Outcome, reward_settings, step_outcomes
from socialnav_core.states import CrowdState


@dataclasses.dataclass
class Decision:
    """What a look-ahead found out about every action of each world."""

    commands: np.ndarray
    """Candidate commands, float64 (batch, actions, 2)."""
    values: np.ndarray
    """Reward plus discounted value of the next state; -inf where screened, (batch, actions)."""
    action: np.ndarray
    """Index of the best action, (batch,)."""

    def command(self) -> np.ndarray:
        """Return the best commands, (batch, 2)."""
        return self.commands[np.arange(len(self.action)), self.action]

    def maximum(self) -> np.ndarray:
        """Return the values of the best actions, (batch,)."""
        return self.values[np.arange(len(self.action)), self.action]


class ValuePolicy:
    """
    Takes the action with the greatest r(s, a) + gamma ** (dt * v_pref) * V(s').

    s' is predicted: the robot does what the action says; pedestrians keep their velocity
    (constant_velocity) or do what the simulator knows that they will do (oracle). Where `limits`
    is set, the actions are what the robot can do until its next command.
    """

    def __init__(self, network: nn.Module, config: PolicyConfig, bfloat16: bool = False) -> None:
        """
        Combine a network with an action set.

        :param network: a value network; it may be trained between two decisions.
        :param config: action set, prediction, reward, screening.
        :param bfloat16: whether large batches are computed in bfloat16.
        """
        self.network = network
        self.config = config
        self.kinematics = config.kinematics
        self.motion = kinematics_of(config.kinematics)
        self.oracle: Callable[[], np.ndarray] | None = None
        self.limits: Limits | None = None
        self._inference = ValueInference(network, bfloat16)
        self._actions = self.motion.action_set(config)
        self._settings = reward_settings(config.reward, config.goal_tolerance)

    def act(self, state: CrowdState) -> np.ndarray:
        """
        Return the best commands, (batch, 2).

        :param state: the worlds as they are.
        :raises ConfigError: when the oracle is asked for and there is none.
        """
        return self.decide(state).command()

    def decide(self, state: CrowdState) -> Decision:
        """
        Value every action of each world.

        :param state: the worlds as they are.
        :raises ConfigError: when the oracle is asked for and there is none.
        """
        config = self.config
        velocities = self.predicted_velocities(state)
        wanted = self.motion.scale(self._actions, state.robot.preferred_speed)
        commands = self._reachable(state, wanted)
        displacement, velocity, heading = self.motion.move(
            state.robot.heading[:, None], commands, config.time_step
        )
        reward, outcome, _, _ = step_outcomes(
            state, displacement, velocities, config.time_step, self._settings
        )
        seen = observe_candidates(
            state,
            state.robot.position[:, None] + displacement,
            velocity,
            np.broadcast_to(heading, reward.shape),
            state.agents.position + velocities * config.time_step,
            velocities,
            self.motion,
        )
        going = outcome == Outcome.NONE
        world = np.nonzero(going)[0]
        discount = config.reward.discount ** (config.time_step * state.robot.preferred_speed)
        values = reward.astype(np.float32)
        if len(world):
            next_values = self._inference.values(
                seen.robot[going], seen.others[going], seen.mask[world]
            )
            values[going] += discount[world].astype(np.float32) * next_values
        if config.screening.enabled:
            safe = self._safe(state, commands, velocities, wanted)
            values[~safe & (outcome != Outcome.GOAL)] = -np.inf
        return Decision(commands, values, values.argmax(axis=1))

    def predicted_velocities(self, state: CrowdState) -> np.ndarray:
        """
        Return the velocities that the agents are taken to have next, m/s, (batch, agents, 2).

        :param state: the worlds as they are.
        :raises ConfigError: when the oracle is asked for and there is none.
        """
        if self.config.lookahead == 'constant_velocity':
            return state.agents.velocity
        if self.oracle is None:
            raise ConfigError('the oracle look-ahead exists in simulation only; '
                              'use constant_velocity')  # fmt: skip
        return self.oracle()

    def attention(self, state: CrowdState) -> np.ndarray:
        """
        Return how much the network looks at each agent, summing to 1, float32 (batch, agents).

        :param state: the worlds as they are.
        """
        return self._inference.attention(observe(state, self.motion))

    def reset(self) -> None:
        """Do nothing: a decision depends on the present state alone."""

    def _reachable(self, state: CrowdState, wanted: np.ndarray) -> np.ndarray:
        """Return the commands nearest to those wanted that the limits allow."""
        if self.limits is None:
            return wanted
        present = self.motion.present_command(state.robot)[:, None]
        return self.motion.reachable(wanted, present, self.limits, self.limits.period)

    def _safe(
        self, state: CrowdState, commands: np.ndarray, velocities: np.ndarray, wanted: np.ndarray
    ) -> np.ndarray:
        """Return which actions may be chosen, bool (batch, actions)."""
        return safe_actions(
            state, commands, velocities, self.motion, self.config.time_step,
            self.config.screening, self.config.lookahead == 'oracle', self.limits, wanted,
        )  # fmt: skip
