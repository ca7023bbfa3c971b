"""Which case each world runs, how it began and how it has gone so far."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.config import Scenario
from socialnav_core.simulation.kinematics import kinematics_of
from socialnav_core.simulation.layout import (
    layout_settings,
    packing_message,
    PackingError,
    sample_layout,
)
from socialnav_core.simulation.random_streams import GOALS, LAYOUT, SPLITS, stream
from socialnav_core.states import Agents, CrowdState, Robot

ENDLESS = -1
ARRAYS = (
    'goal', 'preferred_speed', 'goal_streams', 'case_index', 'steps', 'path_length',
    'minimum_clearance', 'counters', 'cases',
)  # fmt: skip


class Episodes:
    """
    The memory of a simulator: state, hidden state of the pedestrians, cases and their records.

    Idle worlds have the case -1.
    """

    def __init__(self, scenario: Scenario, batch_size: int) -> None:
        """
        Allocate; `begin` and `start` fill.

        :param scenario: numbers of agents, layout.
        :param batch_size: number of worlds.
        """
        self.scenario = scenario
        self.state = empty_state(scenario, batch_size)
        self.goal = np.zeros((batch_size, scenario.agents, 2))
        self.preferred_speed = np.zeros((batch_size, scenario.agents))
        self.goal_streams = np.zeros((batch_size, scenario.pedestrians, 6), np.uint64)
        self.case_index = np.full(batch_size, -1)
        self.steps = np.zeros(batch_size, np.int64)
        self.path_length = np.zeros(batch_size)
        self.minimum_clearance = np.full(batch_size, np.inf)
        self.cases = np.empty(0, np.int64)
        # next case, number of cases or ENDLESS, split, seed (two words, so that it survives int64)
        self.counters = np.zeros(5, np.int64)

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
        if not 0 <= seed < 2**64:
            raise ValueError(f'seed must lie in [0, 2^64), not {seed}')
        if split not in SPLITS:
            raise ValueError(f'split must be one of {", ".join(SPLITS)}, not {split!r}')
        self.cases = np.array([] if cases is None else cases, dtype=np.int64)
        if ((self.cases < 0) | (self.cases >= 2**32)).any():
            raise ValueError('cases must lie in [0, 2^32)')
        count = ENDLESS if cases is None else len(self.cases)
        self.counters[:] = 0, count, SPLITS[split], seed & 0xFFFFFFFF, seed >> 32

    def start(self, worlds: np.ndarray) -> None:
        """
        Start the next cases in some worlds, or leave them idle when none is left.

        :param worlds: indices.
        :raises PackingError: when a layout does not fit.
        """
        self.stop(worlds)
        first, count = self.counters[:2]
        if count != ENDLESS:
            worlds = worlds[: max(0, count - first)]
        numbers = np.arange(first, first + len(worlds))
        cases = numbers if count == ENDLESS else self.cases[numbers]
        self.counters[0] += len(worlds)
        self.steps[worlds] = 0
        self.path_length[worlds] = 0.0
        self.minimum_clearance[worlds] = np.inf
        self._lay_out(worlds, cases)
        self.case_index[worlds] = cases

    def stop(self, worlds: np.ndarray) -> None:
        """
        Leave worlds idle.

        :param worlds: indices.
        """
        self.case_index[worlds] = -1

    def moving_arrays(self) -> tuple[np.ndarray, ...]:
        """Return what a step changes of the state, in the order of `move_worlds`."""
        state = self.state
        return (
            state.robot.position, state.robot.velocity, state.robot.heading, state.agents.position,
            state.agents.velocity, state.time,
        )  # fmt: skip

    def records(self) -> tuple[np.ndarray, ...]:
        """Return what a step adds to the records, in the order of `move_worlds`."""
        return self.steps, self.path_length, self.minimum_clearance

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
        return state | {name: getattr(self, name) for name in ARRAYS}

    def restore(self, arrays: dict[str, np.ndarray]) -> None:
        """
        Take over copies of everything.

        :param arrays: as returned by `arrays`.
        """
        named = {name.removeprefix('state.'): array for name, array in arrays.items()}
        self.state = CrowdState.from_arrays(named).copy()
        for name in ARRAYS:
            setattr(self, name, arrays[name].copy())

    def _lay_out(self, worlds: np.ndarray, cases: np.ndarray) -> None:
        """Draw the layouts of cases."""
        split = list(SPLITS)[self.counters[2]]
        seed = int(self.counters[3]) | int(self.counters[4]) << 32
        state = self.state
        failed = lay_out(
            worlds, cases, stream(split, seed, 0, LAYOUT), stream(split, seed, 0, GOALS),
            layout_settings(self.scenario), state.robot.position, state.robot.goal,
            state.agents.position, state.agents.radius, self.preferred_speed, self.goal,
            self.goal_streams,
        )  # fmt: skip
        if failed >= 0:
            raise PackingError(f'{packing_message(self.scenario)} (case {cases[failed]})')
        for array in (
            state.robot.velocity,
            state.robot.heading,
            state.agents.velocity,
            state.time,
        ):
            array[worlds] = 0.0
        if kinematics_of(self.scenario.kinematics).has_heading:  # elsewhere it is arbitrary
            ahead = state.robot.goal[worlds] - state.robot.position[worlds]
            state.robot.heading[worlds] = np.arctan2(ahead[:, 1], ahead[:, 0])


def empty_state(scenario: Scenario, batch_size: int) -> CrowdState:
    """
    Return a state with everybody at the origin; radii of pedestrians and obstacles are not set.

    :param scenario: numbers of agents, robot, walls.
    :param batch_size: number of worlds.
    """
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


@compiled
def lay_out(  # type: ignore[no-untyped-def]
    worlds, cases, layout_stream, goal_stream, settings, robot_position, robot_goal, position,
    radius, speed, goal, goal_streams,
):  # fmt: skip
    """
    Draw the start of a case in each of some worlds; return the first that failed, or -1.

    :param worlds: indices.
    :param cases: as many case numbers.
    :param layout_stream: stream of the layout of case 0, uint64 (6,).
    :param goal_stream: stream of the goals of pedestrian 0 in case 0, uint64 (6,).
    :param settings: of layout_settings.
    :param robot_position: out, (batch, 2), m.
    :param robot_goal: out, (batch, 2), m.
    :param position: out, (batch, agents, 2), m.
    :param radius: out, (batch, agents), m.
    :param speed: out, (batch, agents), m/s; obstacles have none.
    :param goal: out, (batch, agents, 2), m.
    :param goal_streams: out, uint64 (batch, pedestrians, 6).
    """
    robot = np.empty(4)
    pedestrians = goal_streams.shape[1]
    for n in range(len(worlds)):
        world = worlds[n]
        draws = layout_stream.copy()
        draws[2] = np.uint64(cases[n])
        if not sample_layout(
            draws, pedestrians, settings, robot, position[world], radius[world], speed[world],
            goal[world],
        ):  # fmt: skip
            return n
        robot_position[world] = robot[:2]
        robot_goal[world] = robot[2:]
        for i in range(pedestrians):
            goal_streams[world, i] = goal_stream
            goal_streams[world, i, 2] = np.uint64(cases[n])
            goal_streams[world, i, 4] = np.uint64(i)
    return -1
