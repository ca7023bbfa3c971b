"""Trajectories as a picture: where the robot and the people around it went, and when."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patches import Circle
import matplotlib.patheffects as effects
import numpy as np

from socialnav_core.viewing import scene
from socialnav_core.viewing.recording import Recording

CROWD = 8
"""With more pedestrians than this their discs bear no times."""

_MARK_INTERVALS = (1.0, 2.0, 4.0, 5.0, 10.0)
_HALO = [effects.withStroke(linewidth=2.2, foreground=scene.FLOOR)]
_ATTENTION: dict[str, Any] = {'color': scene.ATTENTION, 'zorder': 7}


def plot_recording(recording: Recording, path: Path) -> None:
    """Write the trajectories of an episode as a picture in the format of the file's suffix."""
    plot_recordings([recording], path)


def plot_recordings(
    recordings: list[Recording], path: Path, attention_at: Sequence[int] | None = None
) -> None:
    """
    Write the trajectories of some episodes side by side in the format of the file's suffix.

    :param attention_at: for each recording the index of the state whose attention is drawn; None
        for no attention.
    """
    columns = len(recordings)
    figure = Figure(figsize=(scene.WIDTH * columns, scene.HEIGHT), dpi=160, facecolor=scene.FLOOR)
    FigureCanvasAgg(figure)
    for column, recording in enumerate(recordings):
        axes = scene.world_axes(figure, recording, column, columns)
        draw_trajectories(axes, recording)
        if attention_at is not None:
            draw_attention(axes, recording, attention_at[column])
        scene.Header(axes, recording).summarise()
    figure.savefig(path)


def draw_trajectories(axes: Axes, recording: Recording) -> None:
    """Draw all paths, with everybody's discs and the time at regular moments."""
    start = recording.states[0]
    marks = time_marks(recording.times)
    people = np.flatnonzero(scene.walkers(recording))
    crowded = len(people) > CROWD
    for person, agent in enumerate(people):
        path, colour = recording.agent_paths[:, agent], scene.PEOPLE[person % len(scene.PEOPLE)]
        there = marks[np.isfinite(path[marks, 0])]
        _draw_discs(axes, path[there], start.agents.radius[0, agent], colour, 0.04, 0.6)
        axes.add_collection(
            fading_path(path, colour, 1.4, 0.05, 0.4 if crowded else 0.75), autolim=False
        )
        if not crowded:
            _label(axes, path[there], recording.times[there], 6.5, colour)
    path = recording.robot_path
    axes.add_collection(fading_path(path, scene.ROBOT, 2.6, 0.55, 1.0), autolim=False)
    _draw_discs(axes, path[marks], start.robot.radius[0], scene.ROBOT, 0.3, 1.0)
    _label(axes, path[marks], recording.times[marks], 8.5, scene.ROBOT_EDGE)
    axes.add_patch(scene.crash_ring(recording))


def draw_attention(axes: Axes, recording: Recording, index: int) -> None:
    """
    Draw how much the policy looks at each agent: a line from the robot, and per cent.

    :param recording: of a policy that has attention.
    :param index: of a state but the last.
    """
    assert recording.attention is not None
    state, weights = recording.states[index], recording.attention[index]
    robot = state.robot.position[0]
    axes.add_patch(
        Circle(tuple(robot), float(state.robot.radius[0]), **_ATTENTION, fill=False, linewidth=2.2)
    )
    for agent in np.flatnonzero(state.agents.valid[0]):
        centre, share = state.agents.position[0, agent], float(weights[agent])
        axes.plot(*np.stack([robot, centre], axis=1), **_ATTENTION, linewidth=12 * share,
                  alpha=0.5, solid_capstyle='round')  # fmt: skip
        axes.add_patch(
            Circle(tuple(centre), float(state.agents.radius[0, agent]), **_ATTENTION, fill=False,
                   linewidth=1.4)
        )  # fmt: skip
        style: dict[str, Any] = {'ha': 'center', 'va': 'center', 'path_effects': _HALO}
        axes.text(centre[0], centre[1], f'{share:.0%}', color=scene.ATTENTION, fontsize=10,
                  weight='bold', zorder=10, **style)  # fmt: skip
    axes.text(0.97, 0.03, f'attention at {recording.times[index]:.3g} s', fontsize=10,
              color=scene.ATTENTION, ha='right', transform=axes.transAxes, zorder=10,
              path_effects=_HALO)  # fmt: skip


def time_marks(times: np.ndarray) -> np.ndarray:
    """Return indices of at most eight states at whole intervals of time, the last among them."""
    span = times[-1] - times[0]
    interval = next((step for step in _MARK_INTERVALS if span <= 7 * step), _MARK_INTERVALS[-1])
    moments = np.arange(times[0], times[-1] - 0.4 * interval, interval)
    return np.append(np.searchsorted(times, moments - 1e-9), len(times) - 1)


def fading_path(
    points: np.ndarray, colour: str, width: float, first: float, last: float
) -> LineCollection:
    """
    Return a path whose opacity goes from one value to another.

    :param points: (points, 2).
    :param width: of the line, points.
    :param first: opacity at the first point.
    :param last: opacity at the last point.
    """
    segments = np.stack([points[:-1], points[1:]], axis=1)
    lines = LineCollection(list(segments), colors=colour, linewidths=width, zorder=4)
    lines.set_alpha(list(np.linspace(first, last, len(segments))))
    lines.set_capstyle('butt')
    return lines


def _draw_discs(
    axes: Axes, centres: np.ndarray, radius: float, colour: str, first: float, last: float
) -> None:
    """Draw a disc at each centre, the later the more opaque."""
    style: dict[str, Any] = {'facecolor': colour, 'edgecolor': scene.FLOOR, 'linewidth': 0.8}
    for centre, alpha in zip(centres, np.linspace(first, last, len(centres)), strict=True):
        axes.add_patch(Circle(tuple(centre), float(radius), alpha=alpha, zorder=4.5, **style))


def _label(axes: Axes, positions: np.ndarray, times: np.ndarray, size: float, colour: str) -> None:
    """Write the times, but the first, on their discs."""
    style: dict[str, Any] = {'fontsize': size, 'color': colour, 'ha': 'center', 'va': 'center'}
    for (x, y), time in zip(positions[1:], times[1:], strict=True):
        axes.text(x, y, f'{time:.3g}', path_effects=_HALO, zorder=8, **style)
