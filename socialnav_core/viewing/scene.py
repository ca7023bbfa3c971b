"""What a picture of an episode and a moving one share: colours, ground, obstacles and header."""

import dataclasses
from typing import Any

from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PatchCollection
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Rectangle
import numpy as np

from socialnav_core.viewing.recording import figures, OUTCOMES, Recording

ROBOT = '#f28e1c'
ROBOT_EDGE = '#7a3e00'
GOAL = '#d7263d'
ALARM = '#e03131'
ATTENTION = '#9c1fb0'
OBSTACLE = '#b3b9c0'
OBSTACLE_EDGE = '#858d95'
WALL = '#4a5058'
FLOOR = '#ffffff'
OUTSIDE = '#eceae5'
GRID = '#e9e6df'
INK = '#24292f'
FAINT_INK = '#6b7280'
PEOPLE = ('#2f6fb5', '#2a9d8f', '#7d5bbe', '#4fa3d9', '#5f8f3e', '#b5568f', '#3d5a80', '#8a7a2f')

OUTCOME_COLOURS = {
    'goal': '#2b8a3e',
    'collision_pedestrian': '#c92a2a',
    'collision_obstacle': '#c92a2a',
    'out_of_bounds': '#c92a2a',
    'timeout': '#b36b00',
}

PALETTE = (
    ROBOT, ROBOT_EDGE, GOAL, ALARM, ATTENTION, OBSTACLE, OBSTACLE_EDGE, WALL, INK, FAINT_INK,
    *PEOPLE, *OUTCOME_COLOURS.values(),
)  # fmt: skip
"""All colours but the pale ones of the ground."""

WIDTH, HEIGHT = 6.4, 6.8
"""Size of the picture of one episode, inches."""


def world_axes(figure: Figure, recording: Recording, column: int = 0, columns: int = 1) -> Axes:
    """
    Return axes that show the walls, the obstacles, the start and the goal of an episode.

    :param figure: where they go, WIDTH inches for each column and HEIGHT inches high.
    :param column: which of the columns, from 0.
    """
    left, width = (column + 0.03) / columns, 0.94 / columns
    axes = figure.add_axes((left, 0.025, width, 0.94 * WIDTH / HEIGHT))
    half = view_half_width(recording)
    axes.set(xlim=(-half, half), ylim=(-half, half), aspect='equal', xticks=[], yticks=[])
    axes.set_facecolor(OUTSIDE)
    for spine in axes.spines.values():
        spine.set_visible(False)
    _draw_floor(axes, recording, half)
    _draw_obstacles(axes, recording)
    _draw_endpoints(axes, recording)
    return axes


def view_half_width(recording: Recording) -> float:
    """Return half the side of the square around the origin that shows the whole episode, m."""
    start = recording.states[0]
    bounds = float(start.bounds[0])
    if np.isfinite(bounds):
        return 1.03 * bounds
    people = recording.agent_paths[:, recording.ever_there].reshape(-1, 2)
    everywhere = np.concatenate([recording.robot_path, people, start.robot.goal])
    return float(np.nanmax(np.abs(everywhere))) + 1.0


def walkers(recording: Recording) -> np.ndarray:
    """Return which agents are pedestrians, those who come later too, bool, (agents,)."""
    return recording.ever_there & ~recording.states[0].agents.static[0]


def crash_ring(recording: Recording) -> Circle:
    """Return a ring around the robot's last position, invisible where it arrived."""
    radius = 1.9 * float(recording.states[-1].robot.radius[0])
    x, y = recording.robot_path[-1]
    colour = OUTCOME_COLOURS[recording.outcome]
    ring = Circle((x, y), radius, fill=False, edgecolor=colour, linewidth=2.4, zorder=9)
    ring.set_visible(recording.outcome != 'goal')
    return ring


@dataclasses.dataclass
class Header:
    """The lines above a picture: what is shown on the left, how it goes on the right."""

    axes: Axes
    """Axes of world_axes."""
    recording: Recording
    """The episode."""

    def __post_init__(self) -> None:
        """Write the policy, the scenario and the case; leave the right side empty."""
        recording = self.recording
        case = f'{recording.scenario}  ·  seed {recording.seed}, case {recording.case_index}'
        if recording.description and recording.description.knowledge:
            case += f'  ·  {recording.description.knowledge}'  # all that has room in a picture
        self._write(0.0, 1.055, recording.policy, fontsize=13, color=INK, weight='bold')
        self._write(0.0, 1.016, case, fontsize=9.5, color=FAINT_INK)
        self.title = self._write(1.0, 1.055, '', fontsize=13, ha='right', weight='bold')
        self.detail = self._write(1.0, 1.016, '', fontsize=9.5, color=FAINT_INK, ha='right')

    def show(self, title: str, colour: str, detail: str) -> None:
        """Set the two lines on the right: a coloured title and a detail below it."""
        self.title.set_text(title)
        self.title.set_color(colour)
        self.detail.set_text(detail)

    def summarise(self) -> None:
        """Say how the episode ended, when, and how near the robot came to anybody."""
        outcome = self.recording.outcome
        self.show(OUTCOMES[outcome], OUTCOME_COLOURS[outcome], figures(self.recording))

    def _write(self, x: float, y: float, text: str, **how: Any) -> Any:
        """Return a text at a place in the coordinates of the axes."""
        return self.axes.text(x, y, text, transform=self.axes.transAxes, **how)


def _draw_floor(axes: Axes, recording: Recording, half: float) -> None:
    """Draw the ground, a metre grid, a scale, and the walls where there are any."""
    bounds = float(recording.states[0].bounds[0])
    side = min(bounds, half)
    square: dict[str, Any] = {'xy': (-side, -side), 'width': 2 * side, 'height': 2 * side}
    axes.add_patch(Rectangle(**square, facecolor=FLOOR, zorder=0))
    if np.isfinite(bounds):
        axes.add_patch(Rectangle(**square, fill=False, edgecolor=WALL, linewidth=2.5, zorder=6))
    metres = np.arange(np.ceil(-side), side)
    ends = np.full_like(metres, side)
    upright = np.stack([np.c_[metres, -ends], np.c_[metres, ends]], axis=1)  # (lines, ends, 2)
    grid = [*upright, *upright[..., ::-1]]
    axes.add_collection(LineCollection(grid, colors=GRID, linewidths=0.6, zorder=1), autolim=False)
    x, y = 1 - np.ceil(side), -0.955 * side
    axes.plot([x, x + 1], [y, y], color=FAINT_INK, linewidth=2, solid_capstyle='butt', zorder=7)
    axes.text(x + 0.5, y + 0.012 * side, '1 m', fontsize=8, color=FAINT_INK, ha='center', zorder=7)


def _draw_obstacles(axes: Axes, recording: Recording) -> None:
    """Draw the static obstacles."""
    state = recording.states[0]
    obstacles = np.flatnonzero(state.agents.valid[0] & state.agents.static[0])
    discs = [
        Circle(tuple(state.agents.position[0, i]), state.agents.radius[0, i]) for i in obstacles
    ]
    style: dict[str, Any] = {'facecolor': OBSTACLE, 'edgecolor': OBSTACLE_EDGE, 'linewidth': 1.2}
    axes.add_collection(PatchCollection(discs, zorder=3, **style), autolim=False)


def _draw_endpoints(axes: Axes, recording: Recording) -> None:
    """Draw where the robot starts and its goal."""
    start = recording.states[0]
    centre, radius = tuple(start.robot.position[0]), float(start.robot.radius[0])
    dashes: dict[str, Any] = {'linestyle': (0, (3, 2)), 'linewidth': 1.2, 'zorder': 4}
    axes.add_patch(Circle(centre, radius, fill=False, edgecolor=ROBOT, **dashes))
    star: dict[str, Any] = {'marker': '*', 'markersize': 20, 'markeredgecolor': FLOOR}
    axes.plot(*start.robot.goal[0], color=GOAL, zorder=5, **star)
