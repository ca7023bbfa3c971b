"""Which case each world runs, how it began and how it has gone so far."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.simulation.case_queue import CaseQueue, queue_of
from socialnav_core.simulation.kinematics import kinematics_of
from socialnav_core.simulation.layout import layout_settings, packing_message, PackingError
from socialnav_core.simulation.motion import Moving, Records
from socialnav_core.simulation.random_streams import GOALS, LAYOUT, stream
from socialnav_core.simulation.recorded import robot_places
from socialnav_core.simulation.starts import lay_out, Starts
from socialnav_core.states import Agents, CrowdState, Robot

ARRAYS = (
    'goal', 'preferred_speed', 'goal_streams', 'case_index', 'steps', 'path_length',
    'minimum_clearance',
)  # fmt: skip


class Episodes:
    """
    The memory of a simulator: state, hidden state of the pedestrians, cases and their records.

    Idle worlds have the case -1.
    """

    def __init__(self, scenario: Scenario, batch_size: int) -> None:
        """Allocate; `begin` and `start` fill."""
        self.scenario = scenario
        self.state = empty_state(scenario, batch_size)
        self.goal = np.zeros((batch_size, scenario.agents, 2))
        self.preferred_speed = np.zeros((batch_size, scenario.agents))
        self.goal_streams = np.zeros((batch_size, scenario.pedestrians, 6), np.uint64)
        self.case_index = np.full(batch_size, -1)
        self.steps = np.zeros(batch_size, np.int64)
        self.path_length = np.zeros(batch_size)
        self.minimum_clearance = np.full(batch_size, np.inf)
        self.queue = queue_of(0, 'train', cases=())

    @property
    def active(self) -> np.ndarray:
        """Return whether a world runs, bool (batch,)."""
        return self.case_index >= 0

    def begin(
        self, seed: int, split: str, cases: Sequence[int] | np.ndarray | None = None
    ) -> None:
        """
        Choose what will be run; no world is started yet.

        :param seed: 0 <= seed < 2 ** 64.
        :param split: train, validation or test.
        :param cases: cases to run once each; None for 0, 1, 2, ... without end.
        :raises ValueError: for a seed, split or case that does not exist.
        """
        self.queue = queue_of(seed, split, cases)

    def start(self, worlds: np.ndarray) -> None:
        """
        Start the next cases in some worlds, or leave them idle when none is left.

        :param worlds: indices.
        :raises PackingError: when a layout does not fit.
        """
        self.stop(worlds)
        cases = self.queue.take(len(worlds))
        worlds = worlds[: len(cases)]
        self.steps[worlds] = 0
        self.path_length[worlds] = 0.0
        self.minimum_clearance[worlds] = np.inf
        self._lay_out(worlds, cases)
        self.case_index[worlds] = cases

    def stop(self, worlds: np.ndarray) -> None:
        """Leave worlds idle, given by their indices."""
        self.case_index[worlds] = -1

    def moving(self, until_decision: np.ndarray) -> Moving:
        """Return what a step changes; the time until decisions, s, (batch,), is not kept here."""
        robot, agents = self.state.robot, self.state.agents
        return Moving(
            robot.position, robot.velocity, robot.heading, robot.turn_rate, agents.position,
            agents.velocity, self.state.time, until_decision,
        )  # fmt: skip

    def records(self) -> Records:
        """Return what a step adds to."""
        return Records(self.steps, self.path_length, self.minimum_clearance)

    def summary(self) -> dict[str, Any]:
        """Return copies of the records: case_index, steps, time, path_length, clearance."""
        return {
            'case_index': self.case_index.copy(),
            'steps': self.steps.copy(),
            'time': self.state.time.copy(),
            'path_length': self.path_length.copy(),
            'minimum_clearance': self.minimum_clearance.copy(),
        }

    def arrays(self) -> dict[str, np.ndarray]:
        """Return everything, by name, without copying."""
        state = {f'state.{name}': array for name, array in self.state.arrays().items()}
        return state | {name: getattr(self, name) for name in ARRAYS} | self.queue.arrays()

    def restore(self, arrays: dict[str, np.ndarray]) -> None:
        """Take over copies of what `arrays` returns."""
        named = {name.removeprefix('state.'): array for name, array in arrays.items()}
        self.state = CrowdState.from_arrays(named).copy()
        for name in ARRAYS:
            setattr(self, name, arrays[name].copy())
        self.queue = CaseQueue.from_arrays(arrays)

    def _lay_out(self, worlds: np.ndarray, cases: np.ndarray) -> None:
        """Draw the layouts of cases."""
        state = self.state
        if self.scenario.layout == 'recorded':
            self._place_robots(worlds, cases)
        else:
            self._draw(worlds, cases)
        for array in (
            state.robot.velocity,
            state.robot.heading,
            state.robot.turn_rate,
            state.agents.velocity,
            state.time,
        ):
            array[worlds] = 0.0
        if kinematics_of(self.scenario.kinematics).has_heading:  # elsewhere it is arbitrary
            ahead = state.robot.goal[worlds] - state.robot.position[worlds]
            state.robot.heading[worlds] = np.arctan2(ahead[:, 1], ahead[:, 0])

    def _place_robots(self, worlds: np.ndarray, cases: np.ndarray) -> None:
        """Draw starts and goals among recorded people, whom the crowd puts into their places."""
        split, seed, robot = self.queue.split, self.queue.seed, self.state.robot
        for world, case in zip(worlds.tolist(), cases.tolist(), strict=True):
            places = robot_places(self.scenario, split, seed, case)
            robot.position[world], robot.goal[world] = places
        self.state.agents.radius[worlds] = self.scenario.pedestrian_radius
        self.preferred_speed[worlds] = self.scenario.pedestrian_speed

    def _draw(self, worlds: np.ndarray, cases: np.ndarray) -> None:
        """Draw where everybody is and wants to go."""
        split, seed, state = self.queue.split, self.queue.seed, self.state
        starts = Starts(
            state.robot.position, state.robot.goal, state.agents.position, state.agents.radius,
            self.preferred_speed, self.goal, self.goal_streams,
        )  # fmt: skip
        failed = lay_out(
            worlds, cases, stream(split, seed, 0, LAYOUT), stream(split, seed, 0, GOALS),
            layout_settings(self.scenario), starts,
        )  # fmt: skip
        if failed >= 0:
            raise PackingError(f'{packing_message(self.scenario)} (case {cases[failed]})')


def empty_state(scenario: Scenario, batch_size: int) -> CrowdState:
    """Return a state with everybody at the origin; radii of the agents are not set."""
    agents = scenario.agents
    static = np.arange(agents) >= scenario.pedestrians
    return CrowdState(
        Robot(
            position=np.zeros((batch_size, 2)),
            velocity=np.zeros((batch_size, 2)),
            heading=np.zeros(batch_size),
            radius=np.full(batch_size, scenario.robot_radius),
            preferred_speed=np.full(batch_size, scenario.robot_preferred_speed),
            goal=np.zeros((batch_size, 2)),
        ),
        Agents(
            position=np.zeros((batch_size, agents, 2)),
            velocity=np.zeros((batch_size, agents, 2)),
            radius=np.ones((batch_size, agents)),
            static=np.tile(static, (batch_size, 1)),
            valid=np.ones((batch_size, agents), bool),
        ),
        bounds=np.full(batch_size, scenario.bounds),
        time=np.zeros(batch_size),
    )
