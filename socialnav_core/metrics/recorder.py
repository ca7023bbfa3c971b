"""Keep the trace of episodes that run side by side."""

from typing import Any, NamedTuple

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.metrics.records import EpisodeRecords
from socialnav_core.states import CrowdState

ROOM = 128
"""States that there is room for at first; the room doubles when an episode needs more."""
AT_THE_END = {
    'case_index': np.int64, 'outcome': np.int8, 'time': float, 'path_length': float,
    'minimum_clearance': float, 'steps': np.int64,
}  # fmt: skip
"""Records that the simulator itself keeps, with their types; they are copied at the end."""


STATE_COLUMNS: dict[str, Any] = {'moment': 0, 'position': slice(1, 3), 'velocity': slice(3, 5)}
STEP_COLUMNS: dict[str, Any] = {
    'command': slice(5, 7), 'clearance': 7, 'pedestrian_clearance': 8, 'time_to_collision': 9,
    'foreseen_distance': 10,
}  # fmt: skip
WIDTH = 11
"""Numbers kept of a state and the step that led to it, side by side in one line of the cache."""


class Bodies(NamedTuple):
    """A CrowdState for compiled functions: the robots, then whom they meet."""

    moment: np.ndarray
    position: np.ndarray
    velocity: np.ndarray
    radius: np.ndarray
    goal: np.ndarray
    others_position: np.ndarray
    others_velocity: np.ndarray
    others_radius: np.ndarray
    static: np.ndarray
    valid: np.ndarray


class EpisodeRecorder:
    """
    Hears of every step and gives the records of the cases 0 to episodes - 1, case i in row i.

    A step is written by one compiled function: evaluation must not wait for its own notes.
    """

    def __init__(self, episodes: int, goal_tolerance: float) -> None:
        """
        Make room for so many cases.

        :param goal_tolerance: distance at which the goal counts as reached, m.
        """
        self._goal_tolerance = goal_tolerance
        self._straight_path = np.zeros(episodes)
        self._ends = {name: np.zeros(episodes, kind) for name, kind in AT_THE_END.items()}
        self._trace = np.empty((episodes, ROOM, WIDTH))  # memory counts when it is written

    def add(
        self,
        before: CrowdState,
        command: np.ndarray,
        info: dict[str, Any],
        ended: np.ndarray,
        foreseen: np.ndarray | None = None,
    ) -> None:
        """
        Take in a step of all worlds.

        :param before: their state when the policy was asked.
        :param command: what it chose, (batch, 2).
        :param info: of Simulator.step.
        :param ended: indices of the worlds whose episodes the step ended.
        :param foreseen: least distance to where people would be, m, (batch,); None: not asked.
        """
        self._make_room(int(info['steps'].max()) + 1)
        foreseen = np.full(len(command), np.nan) if foreseen is None else foreseen
        _write_step(
            self._trace, self._straight_path, self._goal_tolerance, info['active'],
            info['case_index'], info['steps'], bodies(before), bodies(info['final_state']),
            command, info['clearance'], info['pedestrian_clearance'], foreseen,
        )  # fmt: skip
        if len(ended):
            cases = info['case_index'][ended]
            for name, values in self._ends.items():
                values[cases] = info[name][ended]

    def records(self) -> EpisodeRecords:
        """Return the records, when all episodes have ended."""
        steps = self._ends['steps']
        states = self._trace[:, : int(steps.max()) + 1]
        states[np.arange(states.shape[1]) > steps[:, None]] = np.nan
        return EpisodeRecords(
            **self._ends,
            straight_path=self._straight_path,
            bound=np.full(len(steps), np.nan),
            comfortable_bound=np.full(len(steps), np.nan),
            **{name: states[..., columns] for name, columns in STATE_COLUMNS.items()},
            **{name: states[:, 1:, columns] for name, columns in STEP_COLUMNS.items()},
        )

    def _make_room(self, states: int) -> None:
        """Double the room until it suffices for a number of states."""
        episodes, room, _ = self._trace.shape
        while room < states:
            wider = np.empty((episodes, 2 * room, WIDTH))
            wider[:, :room] = self._trace
            self._trace, room = wider, 2 * room


def bodies(state: CrowdState) -> Bodies:
    """Return a state as compiled functions take it."""
    robot, agents = state.robot, state.agents
    return Bodies(
        state.time, robot.position, robot.velocity, robot.radius, robot.goal, agents.position,
        agents.velocity, agents.radius, agents.static, agents.valid,
    )  # fmt: skip


@compiled
def _write_step(  # type: ignore[no-untyped-def]
    trace, straight_path, goal_tolerance, active, cases, steps, before, after, command,
    clearance, pedestrian_clearance, foreseen,
):  # fmt: skip
    """Write a step of the active worlds into their cases' rows, (episodes, states, WIDTH)."""
    for world in range(len(active)):
        if not active[world]:
            continue
        case, state = cases[world], steps[world]
        if state == 1:
            _write_state(trace[case, 0], before, world)
            x = before.goal[world, 0] - before.position[world, 0]
            y = before.goal[world, 1] - before.position[world, 1]
            straight_path[case] = max(np.sqrt(x * x + y * y) - goal_tolerance, 0.0)
        row = trace[case, state]
        _write_state(row, after, world)
        row[5], row[6] = command[world, 0], command[world, 1]
        row[7], row[8] = clearance[world], pedestrian_clearance[world]
        row[9], row[10] = time_to_collision(after, world), foreseen[world]


@compiled
def _write_state(row, state, world):  # type: ignore[no-untyped-def]
    """Write the state of a robot into the columns of STATE_COLUMNS."""
    row[0] = state.moment[world]
    row[1], row[2] = state.position[world, 0], state.position[world, 1]
    row[3], row[4] = state.velocity[world, 0], state.velocity[world, 1]


@compiled
def time_to_collision(state, world):  # type: ignore[no-untyped-def]
    """
    Return when the robot would touch a pedestrian if all kept their velocities, s.

    It is zero where they overlap already and inf where they never touch: the least t >= 0 with
    |p + v t| = r over the pedestrians.

    :param state: Bodies.
    """
    least = np.inf
    for i in range(state.others_radius.shape[1]):
        if state.static[world, i] or not state.valid[world, i]:
            continue
        x = state.others_position[world, i, 0] - state.position[world, 0]
        y = state.others_position[world, i, 1] - state.position[world, 1]
        reach = state.others_radius[world, i] + state.radius[world]
        gap = x * x + y * y - reach * reach
        if gap <= 0.0:
            return 0.0
        u = state.others_velocity[world, i, 0] - state.velocity[world, 0]
        v = state.others_velocity[world, i, 1] - state.velocity[world, 1]
        closing = -(x * u + y * v)
        discriminant = closing * closing - (u * u + v * v) * gap
        if closing > 0.0 and discriminant >= 0.0:
            # the smaller root, written so that the difference of two like numbers is avoided
            least = min(least, gap / (closing + np.sqrt(discriminant)))
    return least
