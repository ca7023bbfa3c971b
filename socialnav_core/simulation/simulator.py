"""A batch of worlds that are stepped side by side."""

from collections.abc import Callable, Sequence
import dataclasses
from typing import Any

import numpy as np

from socialnav_core.config import ConfigError, require, require_choice, Scenario
from socialnav_core.config.ranges import Range, require_rule
from socialnav_core.memory import require_memory, worlds_bytes
from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.protocol import make_crowd
from socialnav_core.simulation.foresight import foresee
from socialnav_core.simulation.kinematics import kinematics_of, limits_of
from socialnav_core.simulation.motion import Motion, move_worlds, TIME_TOLERANCE
from socialnav_core.simulation.rewards import Outcome, reward_settings, step_outcomes
from socialnav_core.states import CrowdState

NONE, TIMEOUT = int(Outcome.NONE), int(Outcome.TIMEOUT)  # arrays compare with plain numbers faster
FASTEST = 1000.0
"""No number of a command is larger, m/s or rad/s: such a robot would leave any world at once."""
CROWD_PREFIX = 'crowd.'
WORLDS = Range(1, 10_000_000)
AUTORESETS = ('same_step', 'disabled')
LAYOUT_FIELDS = ('name', 'obstacle_radius_min', 'obstacle_radius_max', 'hardest_obstacle_ratio')

Step = tuple[CrowdState, np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]


class Simulator:
    """
    Worlds of one scenario, a robot, pedestrians and obstacles in each.

    A world that ends starts its next case within the same step (autoreset same_step, as in
    Gymnasium) or stays as it ended until `reset` (disabled). A world without a case left is idle:
    nothing in it moves, its rewards are zero and it ends no more.
    """

    def __init__(
        self, scenario: Scenario, batch_size: int = 1, autoreset: str = 'same_step'
    ) -> None:
        """
        Make worlds; `reset` lays them out.

        :param autoreset: same_step or disabled.
        :raises ConfigError: for a batch without worlds or an unknown autoreset.
        """
        require_rule(int, WORLDS, batch_size, 'batch_size')
        require_memory(worlds_bytes(batch_size, scenario), f'{batch_size} worlds')
        require_choice('autoreset', autoreset, AUTORESETS)
        self.scenario = scenario
        self.kinematics = kinematics_of(scenario.kinematics)
        self._limits = limits_of(scenario)
        self.batch_size = batch_size
        self.autoreset = autoreset
        self._episodes = Episodes(scenario, batch_size)
        self._crowd = make_crowd(scenario, batch_size)
        self._decided = np.zeros((batch_size, scenario.agents, 2))
        self._until_decision = np.zeros(batch_size)
        self._settings = reward_settings(scenario.reward, scenario.goal_tolerance)
        self._scenario_of: Callable[[int], Scenario] | None = None
        self._begun = False

    @property
    def state(self) -> CrowdState:
        """Return a copy of the present state."""
        return self._episodes.state.copy()

    @property
    def case_index(self) -> np.ndarray:
        """Return the case that each world runs, -1 where it is idle, (batch,)."""
        return self._episodes.case_index.copy()

    @property
    def active(self) -> np.ndarray:
        """Return whether a world runs, bool (batch,)."""
        return self._episodes.active

    def reset(
        self, seed: int = 0, split: str = 'test', cases: Sequence[int] | np.ndarray | None = None
    ) -> CrowdState:
        """
        Start an episode in every world and return the state.

        :param seed: of the cases; case i of a seed is the same problem for everybody.
        :param split: train, validation or test; splits share no case.
        :param cases: cases to run once each, in this order; None for 0, 1, 2, ... without end.
        :raises PackingError: when a layout does not fit into the world.
        :raises ValueError: for a seed, split or case that does not exist.
        """
        self._episodes.begin(seed, split, cases)
        self._begun = True
        self._start(np.arange(self.batch_size))
        return self.state

    def step(self, command: np.ndarray) -> Step:
        """Advance by the scenario's time step: `advance(command, scenario.time_step)`."""
        return self.advance(command, self.scenario.time_step)

    def advance(self, command: np.ndarray, duration: float) -> Step:
        """
        Advance all worlds; return state, reward, terminated, truncated and info.

        Rewards are float64, the two flags bool, (batch,). info holds arrays (batch,) of the step
        that was made: outcome (codes of Outcome), case_index, active, clearance and
        pedestrian_clearance (least gap during the step, m, inf where there is nobody), and of the
        episode so far: steps, time, path_length, minimum_clearance; and final_state, the
        CrowdState before finished worlds were started again.

        :param command: (vx, vy) in the world frame or (speed, turn rate), (batch, 2); the robot
            follows it as far as the scenario's limits allow.
        :param duration: at most the scenario's time step, s; pedestrians decide only at multiples
            of the time step since the episode began.
        :raises ValueError: for a command of another shape, or one that is not finite or absurd;
            for another duration; before the first `reset`.
        """
        command = self._executable(self._checked(command, duration), duration)
        velocities, episodes, scenario = self._decide(), self._episodes, self.scenario
        displacement, robot_velocity, heading = self.kinematics.move(
            episodes.state.robot.heading, command, duration
        )
        judged = step_outcomes(
            episodes.state, displacement[:, None], velocities, duration, self._settings
        )
        reward, outcome, clearance, pedestrian_clearance = (array.reshape(-1) for array in judged)
        active = self.active
        turn_rate = self.kinematics.turn_rates(command)
        motion = Motion(displacement, robot_velocity, heading, turn_rate, velocities)
        moving = episodes.moving(self._until_decision)
        move_worlds(
            active, tuple(motion), duration, clearance, scenario.time_limit, tuple(moving),
            tuple(episodes.records()), reward, outcome,
        )  # fmt: skip
        if scenario.renew_goals:
            self._crowd.renew_goals(episodes)
        info = episodes.summary() | {
            'outcome': outcome,
            'active': active,
            'clearance': clearance,
            'pedestrian_clearance': pedestrian_clearance,
        }
        truncated = outcome == TIMEOUT
        ended = outcome != NONE
        state = info['final_state'] = self.state
        if ended.any():
            self._end(np.flatnonzero(ended))
            state = self.state
        return state, reward, ended & ~truncated, truncated, info

    def next_agent_velocities(self) -> np.ndarray:
        """
        Return what the agents will do in the coming step, m/s, (batch, agents, 2).

        This is the oracle prediction: no robot has it.

        :raises ConfigError: when pedestrians see the robot, since it then depends on the command.
        """
        require(
            not self.scenario.robot_visible,
            'the oracle look-ahead needs robot_visible: false; use constant_velocity',
        )
        return self._decide().copy()

    def foresee(self, steps: int) -> np.ndarray:
        """
        Return where agents would be after each of the next steps, m, (batch, steps, agents, 2).

        Only metrics may know: nobody changes their mind or is replaced on the way there.
        """
        return foresee(self._episodes, self._crowd, steps)

    def set_goal(self, world: int, goal: Sequence[float] | np.ndarray) -> None:
        """
        Give the robot of a world another goal, m, (2,).

        :raises ValueError: for a world that does not exist or a goal that is not finite.
        """
        place = np.asarray(goal, dtype=np.float64)
        if not 0 <= world < self.batch_size:
            raise ValueError(f'world must lie in [0, {self.batch_size}), not {world}')
        if place.shape != (2,) or not np.isfinite(place).all():
            raise ValueError(f'goal must be two finite numbers, not {goal}')
        self._episodes.state.robot.goal[world] = place

    def change_scenario(
        self, scenario: Scenario, scenario_of: Callable[[int], Scenario] | None = None
    ) -> None:
        """
        Use other obstacle radii for the episodes that begin from now on.

        :param scenario: differs from the present one in its name and obstacle radii only.
        :param scenario_of: returns the scenario of an episode, which differs in no more either,
            for its number since `reset` (the case, where cases are endless); None: all alike.
        :raises ConfigError: when it differs in more.
        """
        same = {name: getattr(self.scenario, name) for name in LAYOUT_FIELDS}
        if dataclasses.replace(scenario, **same) != self.scenario:
            raise ConfigError('change_scenario: only names and obstacle radii may differ')
        self.scenario = self._episodes.scenario = scenario
        self._scenario_of = scenario_of

    def get_state(self) -> dict[str, np.ndarray]:
        """Return all that is needed to go on from here, as arrays of their own."""
        arrays = {'decided': self._decided, 'until_decision': self._until_decision}
        crowd = {CROWD_PREFIX + name: array for name, array in self._crowd.get_state().items()}
        everything = arrays | self._episodes.arrays() | crowd
        return {name: array.copy() for name, array in everything.items()}

    def set_state(self, arrays: dict[str, np.ndarray]) -> None:
        """
        Go on from where `get_state` was called, with the same scenario and batch size.

        :raises ValueError: for the state of other worlds; the present one then stays.
        """
        own = {name: array.shape for name, array in self.get_state().items()}
        for name, shape in own.items():
            if name not in arrays:
                raise ValueError(f'this is no state of such worlds: {name} is missing')
            if name != 'cases' and arrays[name].shape != shape:
                raise ValueError(
                    f'this is the state of other worlds: {name} is {arrays[name].shape}, '
                    f'not {shape}'
                )
        self._begun = True
        self._decided = arrays['decided'].copy()
        self._until_decision = arrays['until_decision'].copy()
        self._episodes.restore(arrays)
        self._crowd.set_state({
            name.removeprefix(CROWD_PREFIX): array
            for name, array in arrays.items()
            if name.startswith(CROWD_PREFIX)
        })  # fmt: skip

    def _checked(self, command: np.ndarray, duration: float) -> np.ndarray:
        """Return the command as float64, or raise ValueError."""
        if not self._begun:
            raise ValueError('the worlds are not laid out yet: call reset first')
        if not 0.0 < duration <= self.scenario.time_step + TIME_TOLERANCE:
            raise ValueError(
                'duration must be above 0 and at most the time step, '
                f'{self.scenario.time_step:g} s, not {duration}'
            )
        command = np.asarray(command, dtype=np.float64)
        if command.shape != (self.batch_size, 2):
            raise ValueError(f'command must be ({self.batch_size}, 2), not {command.shape}')
        given = np.abs(command[self._episodes.active])
        if not (given <= FASTEST).all():
            absurd = (
                f'beyond {FASTEST:g} m/s or rad/s' if np.isfinite(given).all() else 'not finite'
            )
            raise ValueError(f'command is {absurd}')
        return command

    def _executable(self, command: np.ndarray, duration: float) -> np.ndarray:
        """Return what the robots make of a command within the limits of the scenario."""
        if self._limits is None:
            return command
        present = self.kinematics.present_command(self._episodes.state.robot)
        return self.kinematics.reachable(command, present, self._limits, duration)

    def _decide(self) -> np.ndarray:
        """Return the velocities of the agents, decided again in the worlds where that is due."""
        due = self._episodes.active & (self._until_decision <= TIME_TOLERANCE)
        if due.any():
            self._crowd.decide(self._episodes, due, self._decided)
            self._until_decision[due] = self.scenario.time_step
        return self._decided

    def _end(self, worlds: np.ndarray) -> None:
        """Start the next cases of worlds that ended, or leave them idle."""
        if self.autoreset == 'same_step':
            self._start(worlds)
        else:
            self._episodes.stop(worlds)

    def _start(self, worlds: np.ndarray) -> None:
        """Lay out the next cases."""
        self._until_decision[worlds] = 0.0
        self._decided[worlds] = 0.0
        if self._scenario_of is None:
            self._episodes.start(worlds)
        else:
            for world in worlds:
                self._episodes.scenario = self._scenario_of(self._episodes.queue.taken)
                self._episodes.start(np.array([world]))
        self._crowd.reset(self._episodes, worlds[self._episodes.active[worlds]])
