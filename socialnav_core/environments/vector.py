"""Many worlds side by side as one Gymnasium vector environment."""

import math
from typing import Any

from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.environments.interface import Arrays, infos_of, make_interface
from socialnav_core.simulation import Simulator


class SocialNavVectorEnv(VectorEnv[Arrays, np.ndarray, np.ndarray]):
    """
    The worlds of one `Simulator`, which steps them in one call.

    A world whose episode ends begins the next within the same step; `infos['final_obs']` holds
    what its robot saw last, a row for each world, and `infos['_final_obs']` tells whose.
    """

    metadata = {'render_modes': [], 'autoreset_mode': AutoresetMode.SAME_STEP}

    def __init__(
        self,
        num_envs: int = 64,
        scenario: str | Scenario = 'hard',
        split: str = 'train',
        agents: int | None = None,
        max_turn_rate: float = math.pi,
        **settings: Any,
    ) -> None:
        """
        Make the worlds; `reset` lays them out.

        Parameters are those of `SocialNavEnv`.

        :raises ConfigError: for what does not exist or makes no sense.
        """
        self._interface = make_interface(scenario, settings, agents, max_turn_rate)
        self._simulator = Simulator(self._interface.scenario, num_envs)
        self._split = split
        self.num_envs = num_envs
        self.single_observation_space = self._interface.observation_space
        self.single_action_space = self._interface.action_space
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Arrays, dict[str, Any]]:
        """
        Begin an episode in every world.

        :param seed: of the cases, which the worlds take one after the other; None draws one.
        """
        super().reset(seed=seed)
        drawn = int(self.np_random.integers(2**31))
        state = self._simulator.reset(drawn if seed is None else seed, self._split)
        return self._interface.observe(state), {'case_index': self._simulator.case_index}

    def step(
        self, actions: np.ndarray
    ) -> tuple[Arrays, np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        """Act for one time step in every world; see `gymnasium.vector.VectorEnv.step`."""
        command = self._interface.command(self._simulator.state, actions)
        state, reward, terminated, truncated, info = self._simulator.step(command)
        told: dict[str, Any] = dict(infos_of(info))
        ended = terminated | truncated
        if ended.any():
            told['final_obs'] = self._interface.observe(info['final_state'])
            told['_final_obs'] = ended
        return self._interface.observe(state), reward, terminated, truncated, told
