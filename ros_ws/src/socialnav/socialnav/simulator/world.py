"""The simulated world behind the topics: case after case, on one clock, in either mode of time."""

from typing import Any

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.messages import EpisodeEnd
from socialnav_core.simulation import Outcome, Simulator
from socialnav_core.simulation.kinematics import kinematics_of

BREAK = 10**9
"""Simulated time between two episodes, ns: longer than any step, so that a listener sees it."""
TIME_TOLERANCE = 1e-9
CASES = 2**32
"""Number of cases of a seed; the first one follows the last."""


class World:
    """
    One world that runs the test cases of a seed.

    The state in which an episode ends stays for one advance, so that everybody sees it; the next
    advance begins the following case. `episode` tells how it ended, None until then; `fresh` is
    whether the state is the first of its episode.
    """

    def __init__(self, scenario: Scenario, seed: int, episodes: int, clock: int) -> None:
        """
        Begin case 0.

        :param episodes: number of episodes until the world stands; 0 for no end.
        :param clock: simulated time at the start, ns.
        """
        self.clock = clock
        self.fresh = True
        self.episode: EpisodeEnd | None = None
        self.paused = False
        self.command_timeout = np.inf
        self._episodes = episodes
        self.begin(scenario, seed, 0)

    def begin(self, scenario: Scenario, seed: int, case_index: int) -> None:
        """
        Begin a case, whatever goes on; count the episodes from here.

        :raises ConfigError: agents that do not fit into the world; the present case goes on.
        """
        simulator = Simulator(scenario, batch_size=1, autoreset='disabled')
        simulator.reset(seed=seed, split='test', cases=[case_index])
        self.scenario, self.seed, self._simulator = scenario, seed, simulator
        self._finished = 0
        self._start(case_index)

    @property
    def done(self) -> bool:
        """Return whether all episodes have been run."""
        return 0 < self._episodes <= self._finished

    @property
    def standing(self) -> bool:
        """Return whether time stands still."""
        return self.paused or self.done

    def set_goal(self, goal: np.ndarray) -> None:
        """Send the robot to another goal, m, (2,)."""
        self._simulator.set_goal(0, goal)
        self.state = self._simulator.state

    def drive(self, command: np.ndarray) -> None:
        """
        Take a command for the robot, valid until the next or until it is too old.

        :param command: (vx, vy) in base_link or speed and turn rate, (2,).
        """
        self._command, self._command_clock = command, self.clock

    def answer(self, command: np.ndarray, stamp: int) -> bool:
        """
        Advance one step if a command answers the present state; return whether it did.

        :param command: (vx, vy) in base_link or speed and turn rate, (2,).
        :param stamp: time of the state that it answers, ns.
        """
        if self.standing or stamp != self.clock:
            return False
        self.drive(command)
        self.advance(self.scenario.time_step)
        return True

    def advance(self, duration: float) -> None:
        """
        Let time pass; after the end of an episode, begin the next instead.

        :param duration: simulated time, s; an episode may end before it is over.
        """
        if self.standing:
            return
        if self.episode is not None:
            self._start((self.episode.case_index + 1) % CASES)
            return
        while duration > TIME_TOLERANCE and self.episode is None:
            piece = min(duration, self._until_decision())
            self._step(piece)
            duration -= piece

    def _until_decision(self) -> float:
        """Return the time until pedestrians decide again, s."""
        step = self.scenario.time_step
        left = step - float(self.state.time[0]) % step
        return left if left > TIME_TOLERANCE else step

    def _step(self, duration: float) -> None:
        """Advance the simulator by a time without a decision of pedestrians inside."""
        command = self._world_command()
        self.state, _, terminated, truncated, info = self._simulator.advance(
            command[None], duration
        )
        self.fresh = False
        self.clock += round(duration * 1e9)
        if terminated[0] or truncated[0]:
            self.episode = self._ended(info)
            self._finished += 1

    def _world_command(self) -> np.ndarray:
        """Return the command in the simulator's terms: zero when it is too old."""
        if (self.clock - self._command_clock) * 1e-9 > self.command_timeout:
            return np.zeros(2)
        heading = float(self.state.robot.heading[0])
        return kinematics_of(self.scenario.kinematics).from_base(self._command, heading)

    def _ended(self, info: dict[str, Any]) -> EpisodeEnd:
        """Return the record of the episode that the latest step ended."""
        return EpisodeEnd(
            scenario=self.scenario.name,
            seed=self.seed,
            case_index=int(info['case_index'][0]),
            outcome=Outcome(int(info['outcome'][0])).name.lower(),
            time=float(info['time'][0]),
            path_length=float(info['path_length'][0]),
            minimum_clearance=float(info['minimum_clearance'][0]),
            steps=int(info['steps'][0]),
        )

    def _start(self, case_index: int) -> None:
        """Lay out a case."""
        self.state = self._simulator.reset(seed=self.seed, split='test', cases=[case_index])
        self.case_index = case_index
        self.episode, self.fresh = None, True
        self.clock += BREAK
        self.drive(np.zeros(2))
