"""Episodes as moving pictures: GIF, and MP4 where ffmpeg is there."""

from collections.abc import Iterator
from pathlib import Path
import shutil
import subprocess
from typing import Any

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import EllipseCollection, LineCollection
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from matplotlib.quiver import Quiver
import numpy as np
from PIL import Image

from socialnav_core.config import ConfigError
from socialnav_core.extras import extra, MissingExtra
from socialnav_core.states import CrowdState
from socialnav_core.viewing import scene
from socialnav_core.viewing.recording import clearance, Recording, state_at

FRAME_RATE = 12.5
"""Frames per second; a GIF counts in hundredths of a second."""
LONGEST = 10.0
"""Longer episodes are shown faster, so that they last so many seconds."""
FINAL_HOLD = 1.6
"""How long the last frame stays, s."""
TRAIL = 2.0
"""How long the trails behind pedestrians reach back, s."""
DISCOMFORT = 0.2
"""Clearance that is shown in red below, m."""
_SHADES = 6
_TRAIL_PIECES = 8
_STANDING = 0.15  # m/s, below which no arrow is drawn
_DOTS_PER_INCH = 90


def write_gif(recording: Recording, path: Path) -> None:
    """Write an episode as an animated GIF of at most 12 s."""
    pictures = [Image.fromarray(frame) for frame in frames(recording)]
    indexed = [
        picture.quantize(palette=_palette(), dither=Image.Dither.NONE) for picture in pictures
    ]
    durations = [round(1000 / FRAME_RATE)] * (len(indexed) - 1) + [round(1000 * FINAL_HOLD)]
    indexed[0].save(
        path, 'GIF', save_all=True, append_images=indexed[1:], duration=durations, loop=0
    )


def write_mp4(recording: Recording, path: Path) -> None:
    """
    Write an episode as H.264 video.

    :raises MissingExtra: where there is no ffmpeg.
    :raises ConfigError: when it fails.
    """
    ffmpeg = find_ffmpeg()
    pictures = list(frames(recording))
    pictures += pictures[-1:] * round(FINAL_HOLD * FRAME_RATE)
    height, width, _ = pictures[0].shape
    source = ['-f', 'rawvideo', '-pix_fmt', 'rgb24', '-s', f'{width}x{height}']
    target = ['-c:v', 'libx264', '-pix_fmt', 'yuv420p', '-movflags', '+faststart', str(path)]
    command = [ffmpeg, '-loglevel', 'error', '-y', *source, '-r', str(FRAME_RATE), '-i', '-']
    done = subprocess.run(
        command + target, input=b''.join(picture.tobytes() for picture in pictures),
        stderr=subprocess.PIPE,
    )  # fmt: skip
    if done.returncode:
        message = ' '.join(done.stderr.decode(errors='replace').split())
        raise ConfigError(f'ffmpeg could not write {path}: {message}; write a .gif instead')


def find_ffmpeg() -> str:
    """
    Return the command of the system's ffmpeg, else the path of the one that imageio-ffmpeg brings.

    :raises MissingExtra: where there is neither.
    """
    if shutil.which('ffmpeg') is not None:
        return 'ffmpeg'
    try:
        with extra('video'):
            import imageio_ffmpeg
    except MissingExtra as error:
        raise MissingExtra(f'.mp4 needs ffmpeg; {error}, or write a .gif') from error
    return imageio_ffmpeg.get_ffmpeg_exe()


def frames(recording: Recording) -> Iterator[np.ndarray]:
    """Yield the frames of an episode, uint8, (height, width, 3), both even."""
    figure = Figure(figsize=(scene.WIDTH, scene.HEIGHT), dpi=_DOTS_PER_INCH, facecolor=scene.FLOOR)
    canvas = FigureCanvasAgg(figure)
    stage = Stage(figure, recording)
    canvas.draw()
    background = canvas.copy_from_bbox(figure.bbox)
    for time in frame_times(recording):
        canvas.restore_region(background)
        stage.show(time)
        yield np.array(canvas.buffer_rgba())[..., :3]


def frame_times(recording: Recording) -> np.ndarray:
    """Return the moments that are shown, s, evenly spaced, the start and the end among them."""
    start, end = recording.times[[0, -1]]
    count = round(min(end - start, LONGEST) * FRAME_RATE) + 1
    return np.linspace(start, end, max(count, 2))


def _palette() -> Image.Image:
    """Return an image with the colours of the scene and their mixtures with that of the floor."""
    shares = np.linspace(0.0, 1.0, _SHADES, endpoint=False)[:, None]
    floor = np.array(to_rgb(scene.FLOOR))
    shades = [(1 - shares) * to_rgb(colour) + shares * floor for colour in scene.PALETTE]
    colours = np.concatenate(
        [[to_rgb(scene.FLOOR), to_rgb(scene.OUTSIDE), to_rgb(scene.GRID)], *shades]
    )
    image = Image.new('P', (1, 1))
    image.putpalette(np.rint(255 * colours).astype(np.uint8).tobytes())
    return image


class Stage:
    """The moving parts of an animation; the rest is drawn once."""

    def __init__(self, figure: Figure, recording: Recording) -> None:
        """Build the scene and everything that moves in it."""
        self.recording = recording
        self.speed = float(np.ptp(recording.times)) / LONGEST
        self.axes = axes = scene.world_axes(figure, recording)
        self.people = np.flatnonzero(scene.walkers(recording))
        colours = [scene.PEOPLE[person % len(scene.PEOPLE)] for person in range(len(self.people))]
        self.colours = np.array([to_rgb(colour) for colour in colours]).reshape(-1, 3)
        diameters = 2 * recording.states[0].agents.radius[0][self.people]
        self.discs = EllipseCollection(
            diameters, diameters, np.zeros_like(diameters), units='xy', facecolors=colours,
            edgecolors='white', linewidths=1.0, offsets=np.zeros((len(self.people), 2)),
            offset_transform=axes.transData, zorder=5,
        )  # fmt: skip
        self.trails = LineCollection([], linewidths=2.2, zorder=3.5)
        self.gaze = LineCollection([], zorder=3.2)
        self.path = LineCollection([], linewidths=2.6, colors=scene.ROBOT, zorder=4)
        everybody = np.zeros((len(self.people) + 1, 2))
        self.arrows = Quiver(
            axes, *everybody.T, *everybody.T, angles='xy', scale_units='xy', scale=1.0,
            units='inches', width=0.027, headwidth=4, headlength=4, headaxislength=3.6,
            color=scene.INK, zorder=7,
        )  # fmt: skip
        radius = float(recording.states[0].robot.radius[0])
        self.comfort = Circle((0, 0), radius + DISCOMFORT, fill=False, linewidth=1.1, zorder=5)
        self.robot = Circle(
            (0, 0), radius, facecolor=scene.ROBOT, edgecolor=scene.ROBOT_EDGE, zorder=6
        )
        self.ring = scene.crash_ring(recording)
        self.header = scene.Header(axes, recording)
        self.moving = [
            axes.add_collection(self.gaze, autolim=False),
            axes.add_collection(self.trails, autolim=False),
            axes.add_collection(self.path, autolim=False),
            axes.add_collection(self.discs, autolim=False),
            axes.add_patch(self.comfort),
            axes.add_patch(self.robot),
            axes.add_collection(self.arrows, autolim=False),
            axes.add_patch(self.ring),
            self.header.title,
            self.header.detail,
        ]
        for artist in self.moving:
            artist.set_animated(True)
        if recording.attention is not None:
            style: dict[str, Any] = {'fontsize': 8, 'color': scene.ATTENTION, 'ha': 'right'}
            axes.text(0.975, 0.035, 'attention', transform=axes.transAxes, **style)

    def show(self, time: float) -> None:
        """Draw the moving parts as they are at a moment, s."""
        state = state_at(self.recording, time)
        ended = time >= self.recording.times[-1]
        self.discs.set_offsets(self._places(state))
        self._place_robot(state)
        self._draw_trails(time)
        self._draw_arrows(state)
        self._draw_gaze(state, time)
        self._write_header(state, ended)
        for artist in self.moving:
            if artist is not self.ring or ended:
                self.axes.draw_artist(artist)

    def _places(self, state: CrowdState) -> np.ndarray:
        """Return where the people are, m, NaN where one is not there, (people, 2)."""
        agents = state.agents
        return np.where(agents.valid[0, :, None], agents.position[0], np.nan)[self.people]

    def _place_robot(self, state: CrowdState) -> None:
        """Move the robot and its circle of discomfort, red where somebody is inside."""
        self.robot.center = self.comfort.center = tuple(state.robot.position[0])
        near = clearance(state) < DISCOMFORT
        self.comfort.set_edgecolor(scene.ALARM if near else scene.FAINT_INK)
        self.comfort.set_linestyle('-' if near else (0, (2, 3)))

    def _draw_trails(self, time: float) -> None:
        """Draw where the pedestrians have just been, the longer ago the fainter, and the path."""
        recording = self.recording
        moments = np.linspace(max(time - TRAIL, recording.times[0]), time, _TRAIL_PIECES + 1)
        states = [state_at(recording, moment) for moment in moments]
        points = np.array([self._places(state) for state in states])
        segments = np.stack([points[:-1], points[1:]], axis=2)  # (pieces, people, 2, 2)
        colours = np.ones((*segments.shape[:2], 4))
        colours[..., :3] = self.colours
        colours[..., 3] = (0.6 * np.arange(1, _TRAIL_PIECES + 1) / _TRAIL_PIECES)[:, None]
        self.trails.set_segments(list(segments.reshape(-1, 2, 2)))
        self.trails.set_color(list(colours.reshape(-1, 4)))
        past = recording.robot_path[recording.times < time]
        self.path.set_segments([np.concatenate([past, states[-1].robot.position])])

    def _draw_arrows(self, state: CrowdState) -> None:
        """Draw the velocities as arrows from the centres, one metre for one metre per second."""
        tails = np.concatenate([np.nan_to_num(self._places(state)), state.robot.position])
        moves = np.concatenate([state.agents.velocity[0][self.people], state.robot.velocity])
        standing = np.linalg.norm(moves, axis=-1) < _STANDING
        standing[:-1] |= ~state.agents.valid[0][self.people]
        self.arrows.set_offsets(tails)
        self.arrows.set_UVC(*np.ma.masked_array(moves.T, np.tile(standing, (2, 1))))

    def _draw_gaze(self, state: CrowdState, time: float) -> None:
        """Draw a line to each agent, the wider the more the policy looks at it."""
        if self.recording.attention is None:
            return
        decision = int(np.searchsorted(self.recording.times, time, side='right')) - 1
        weights = self.recording.attention[min(decision, len(self.recording.attention) - 1)]
        seen = np.flatnonzero(state.agents.valid[0])
        robot = np.broadcast_to(state.robot.position, (len(seen), 2))
        shares = weights[seen]
        self.gaze.set_segments(list(np.stack([robot, state.agents.position[0][seen]], axis=1)))
        self.gaze.set_linewidth(list(1 + 7 * shares))
        self.gaze.set_color([(*to_rgb(scene.ATTENTION), 0.1 + 0.4 * share) for share in shares])

    def _write_header(self, state: CrowdState, ended: bool) -> None:
        """Say what time it is and how near somebody is, in the end how it went."""
        if ended:
            self.header.summarise()
            return
        gap = clearance(state)
        near = f'clearance {max(gap, 0.0):.2f} m' if np.isfinite(gap) else ''
        faster = f'   ({self.speed:.1f}x speed)' if self.speed > 1.05 else ''
        self.header.show(f'{state.time[0]:.1f} s', scene.INK, near + faster)
