"""One-step look-ahead over an action set with a value network."""

import dataclasses

import numpy as np
from torch import nn

from socialnav_core.config import PolicyConfig
from socialnav_core.finiteness import require_finite
from socialnav_core.policies.protocol import PolicyDescription
from socialnav_core.policies.value.inference import ValueInference
from socialnav_core.policies.value.observation import observe, observe_candidates
from socialnav_core.policies.value.screening import safe_actions
from socialnav_core.prediction import make_predictor, Predictor
from socialnav_core.prediction.one_step import one_step
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

    s' is predicted: the robot does what the action says, pedestrians what the predictor says.
    """

    def __init__(self, network: nn.Module, config: PolicyConfig, bfloat16: bool = False) -> None:
        """
        Combine a network with an action set.

        :param network: a value network; it may be trained between two decisions.
        :param bfloat16: whether large batches are computed in bfloat16.
        """
        self.network = network
        self.config = config
        self.kinematics = config.kinematics
        self.motion = kinematics_of(config.kinematics)
        self.predictor = make_predictor(config.lookahead)
        self.plan = None
        self._inference = ValueInference(network, bfloat16)
        self._actions = self.motion.action_set(config)
        self._settings = reward_settings(config.reward, config.goal_tolerance)
        self._times = np.array([config.time_step])

    @property
    def description(self) -> PolicyDescription:
        """Return what results tell of this policy."""
        return PolicyDescription(
            name=self.config.network,
            kinematics=self.kinematics,
            prediction=self.config.lookahead,
            knowledge=self.predictor.knowledge,
            screening=self.config.screening.enabled,
            remembers=self.predictor.remembers,
        )

    def act(self, state: CrowdState, limits: Limits | None = None) -> np.ndarray:
        """
        Return the best commands, (batch, 2).

        :param limits: of the robot: actions are what it can do until its next command.
        :raises ConfigError: when the oracle is asked for and there is no simulator.
        """
        return self.decide(state, limits).command()

    def decide(
        self,
        state: CrowdState,
        limits: Limits | None = None,
        predictor: Predictor | None = None,
    ) -> Decision:
        """
        Value every action of each world.

        :param limits: see `act`.
        :param predictor: takes the place of the policy's own.
        :raises ConfigError: when the oracle is asked for and there is no simulator.
        """
        require_finite(state)
        config = self.config
        prediction = (predictor or self.predictor).predict(state, self._times)
        velocities, deviation = one_step(prediction, state, config.time_step)
        wanted = self.motion.scale(self._actions, state.robot.preferred_speed)
        commands = self._reachable(state, wanted, limits)
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
            safe = self._safe(state, commands, velocities, deviation, limits, wanted)
            values[~safe & (outcome != Outcome.GOAL)] = -np.inf
        return Decision(commands, values, values.argmax(axis=1))

    def attention(self, state: CrowdState) -> np.ndarray:
        """Return how much the network looks at each agent, float32 (batch, agents), sum 1."""
        return self._inference.attention(observe(state, self.motion))

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Forget what was seen of some worlds: only the predictor may have a memory."""
        self.predictor.reset(worlds)

    def _reachable(
        self, state: CrowdState, wanted: np.ndarray, limits: Limits | None
    ) -> np.ndarray:
        """Return the commands nearest to those wanted that the limits allow."""
        if limits is None:
            return wanted
        present = self.motion.present_command(state.robot)[:, None]
        return self.motion.reachable(wanted, present, limits, limits.period)

    def _safe(
        self,
        state: CrowdState,
        commands: np.ndarray,
        velocities: np.ndarray,
        deviation: np.ndarray,
        limits: Limits | None,
        wanted: np.ndarray,
    ) -> np.ndarray:
        """Return which actions may be chosen, bool (batch, actions)."""
        return safe_actions(
            state, commands, velocities, self.motion, self.config.time_step,
            self.config.screening, deviation, limits, wanted,
        )  # fmt: skip
