"""One world as a Gymnasium environment."""

import math
from typing import Any

import gymnasium
import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.environments.interface import Arrays, infos_of, make_interface
from socialnav_core.simulation import Simulator


class SocialNavEnv(gymnasium.Env[Arrays, np.ndarray]):
    """
    A robot among pedestrians; `Interface` tells what it sees and does.

    `reset(seed=7)` begins with case 0 of seed 7, each further `reset()` with the next case;
    `reset(seed=7, options={'case': 3})` chooses one. Rewards are those of the scenario. The
    episode is terminated at the goal or by a collision and truncated when its time is up.
    """

    metadata = {'render_modes': []}

    def __init__(
        self,
        scenario: str | Scenario = 'hard',
        split: str = 'train',
        agents: int | None = None,
        max_turn_rate: float = math.pi,
        **settings: Any,
    ) -> None:
        """
        Make the world; `reset` lays it out.

        :param scenario: name or settings of the world.
        :param split: of the cases: train, validation or test.
        :param agents: slots of an observation, for the nearest agents; None: for all.
        :param max_turn_rate: of a differential drive, rad/s.
        :param settings: of the scenario that differ, such as pedestrians=10.
        :raises ConfigError: for what does not exist or makes no sense.
        """
        self._interface = make_interface(scenario, settings, agents, max_turn_rate)
        self._simulator = Simulator(self._interface.scenario, autoreset='disabled')
        self._split = split
        self._case = 0
        self._seed: int | None = None
        self.observation_space = self._interface.observation_space  # type: ignore[assignment]
        self.action_space = self._interface.action_space

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Arrays, dict[str, Any]]:
        """
        Begin an episode and return what the robot sees.

        :param seed: of the cases; None goes on with those of the seed before.
        :param options: {'case': number}.
        """
        super().reset(seed=seed)
        if seed is not None:
            self._seed, self._case = seed, 0
        elif self._seed is None:
            self._seed = int(self.np_random.integers(2**31))
        case = int((options or {}).get('case', self._case))
        self._case = case + 1
        state = self._simulator.reset(self._seed, self._split, [case])
        return _first(self._interface.observe(state)), {'case_index': case}

    def step(self, action: np.ndarray) -> tuple[Arrays, float, bool, bool, dict[str, Any]]:
        """Act for one time step of the scenario; see `gymnasium.Env.step`."""
        state = self._simulator.state
        command = self._interface.command(state, np.asarray(action)[None])
        state, reward, terminated, truncated, info = self._simulator.step(command)
        told = {name: value[0].item() for name, value in infos_of(info).items()}
        seen = _first(self._interface.observe(state))
        return seen, float(reward[0]), bool(terminated[0]), bool(truncated[0]), told


def _first(arrays: Arrays) -> Arrays:
    """Return the first row of each array."""
    return {name: array[0] for name, array in arrays.items()}
