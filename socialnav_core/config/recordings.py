"""
Recorded people as their files hold them, and every mistake in one told with its line.

Files hold a line a person and annotated frame, `frame person x y ...` in metres, as the recordings
of ETH and UCY (Pellegrini et al. 2009, Lerner et al. 2007) are passed on; what follows is left
aside.
"""

import functools
import hashlib
import math
from pathlib import Path
from typing import NamedTuple

import numpy as np

from socialnav_core.config.ranges import ConfigError, shown

INTERVAL = 0.4
"""Time between two annotated frames in the recordings of ETH and UCY, s."""
LONGEST_GAP = 2.0
"""Who is not annotated for longer has gone, s."""
FASTEST = 12.0
"""Nobody runs faster, m/s: whoever does has jumped."""
HURRY, HURRIED = 4.0, 0.9
"""Where one step in ten is faster than this, m/s, not all of them can be jumps."""
SMALLEST = 2.0
"""People move about in a square at least so wide, m."""
LARGEST_FILE = 2**26
"""Bytes."""
LARGEST_TABLE = 50_000_000
"""Frames times people."""


class Row(NamedTuple):
    """A line of a file."""

    frame: float
    person: float
    x: float
    y: float
    line: int
    """Its number, from 1."""


def read_tracks(path: Path | str, interval: float = INTERVAL) -> np.ndarray:
    """
    Return where each person was in each frame, m, NaN where they were not, (frames, people, 2).

    The array is shared and cannot be written.

    :param interval: between two frames, s; only implausible speeds are found by it.
    :raises ConfigError: for a file that holds no recorded people, with the line where that shows.
    """
    return tracks_of(str(path), file_digest(path), interval)


def file_digest(path: Path | str) -> str:
    """
    Return the SHA-256 of a file of recorded people.

    :raises ConfigError: when it cannot be read.
    """
    return hashlib.sha256(read_bytes(Path(path))).hexdigest()


@functools.lru_cache(maxsize=16)
def tracks_of(path: str, digest: str, interval: float) -> np.ndarray:
    """Return the tracks of a file whose digest is known; see `read_tracks`."""
    rows = read_rows(Path(path))
    numbers = np.array([row[:4] for row in rows])
    frames = frames_of(numbers[:, 0])
    names, people = np.unique(numbers[:, 1], return_inverse=True)
    if (frames.max() + 1) * len(names) > LARGEST_TABLE:
        raise ConfigError(
            f'{path}: frames {numbers[:, 0].min():g} to {numbers[:, 0].max():g} of {len(names)} '
            'people are too many; cut the recording into several files'
        )
    require_plausible(path, rows, frames, people, interval)
    tracks = np.full((frames.max() + 1, len(names), 2), np.nan)
    tracks[frames, people] = numbers[:, 2:]
    tracks.flags.writeable = False
    return tracks


def frames_of(numbers: np.ndarray) -> np.ndarray:
    """
    Return the index of the frame of each line, from 0, int64 (lines,).

    Frames are numbered as in the video, some apart, a few of them off by one. Where nobody was
    seen, numbers are left out.

    :param numbers: of the frames as they stand in the file, (lines,).
    """
    known, places = np.unique(numbers, return_inverse=True)
    if len(known) == 1:
        return np.zeros(len(numbers), np.int64)
    steps = np.diff(known)
    apart = np.maximum(np.rint(steps / np.median(steps)), 1.0)  # of each to the one before
    index = np.concatenate([[0.0], np.cumsum(apart)])
    return np.minimum(index, LARGEST_TABLE).astype(np.int64)[places]


def read_bytes(path: Path) -> bytes:
    """Return what a file holds; see `file_digest`."""
    try:
        if not path.is_file():
            raise ConfigError(f'{path} is no file of recorded people: there is no such file')
        if path.stat().st_size > LARGEST_FILE:
            raise ConfigError(
                f'{path} is larger than {LARGEST_FILE >> 20} MiB; cut the recording into several '
                'files'
            )
        return path.read_bytes()
    except OSError as error:
        raise ConfigError(f'{path} cannot be read: {error.strerror}') from error


def read_rows(path: Path) -> list[Row]:
    """Return the lines of a file, which hold finite numbers and follow in time."""
    try:
        text = read_bytes(path).decode('utf-8')
    except UnicodeDecodeError as error:
        raise ConfigError(f'{path} holds no recorded people: it is no UTF-8 text') from error
    rows: list[Row] = []
    latest: dict[float, float] = {}
    for number, line in enumerate(text.splitlines(), 1):
        words = line.partition('#')[0].split()
        if not words:
            continue
        row = row_of(words, number, f'{path}, line {number}')
        before = latest.get(row.person, -math.inf)
        if row.frame <= before:
            raise ConfigError(
                f'{path}, line {number}: person {row.person:g} is in frame {row.frame:g} '
                + ('twice' if row.frame == before else f'after frame {before:g}: time goes back')
                + '; columns must be frame, person, x, y'
            )
        latest[row.person] = row.frame
        rows.append(row)
    if not rows:
        raise ConfigError(f'{path} holds no recorded people: it is empty')
    return rows


def row_of(words: list[str], number: int, where: str) -> Row:
    """
    Return what the words of a line say.

    :param where: the line, for messages.
    """
    if len(words) < 4:
        raise ConfigError(
            f'{where} needs four numbers, frame person x y, separated by blanks; it has '
            f'{len(words)} columns'
        )
    try:
        frame, person, x, y = map(float, words[:4])
    except ValueError:
        wrong = next(word for word in words[:4] if not is_number(word))
        raise ConfigError(f'{where}: {shown(wrong)} is no number') from None
    if not all(map(math.isfinite, (frame, person, x, y))):
        raise ConfigError(f'{where}: {" ".join(words[:4])} must be finite numbers')
    return Row(frame, person, x, y, number)


def is_number(word: str) -> bool:
    """Return whether a word can be read as a number."""
    try:
        float(word)
    except ValueError:
        return False
    return True


def require_plausible(
    path: str, rows: list[Row], frames: np.ndarray, people: np.ndarray, interval: float
) -> None:
    """Raise a ConfigError where no people move like that."""
    place = np.array([(row.x, row.y) for row in rows])
    width = float(np.ptp(place, axis=0).max())
    if width < SMALLEST:
        raise ConfigError(
            f'{path}: all people stay within {width:.3g} m; positions must be in metres'
        )
    order = np.lexsort((frames, people))
    duration = np.diff(frames[order]) * interval
    same = (np.diff(people[order]) == 0) & (duration <= LONGEST_GAP + interval)
    way = np.linalg.norm(np.diff(place[order], axis=0), axis=1)
    speed = way[same] / duration[same]
    usual = float(np.quantile(speed, HURRIED)) if len(speed) else 0.0
    if usual > HURRY:
        raise ConfigError(
            f'{path}: one step in ten is faster than {usual:.3g} m/s; positions must be in metres '
            f'and frames {interval:g} s apart (scenario.recording.interval)'
        )
    worst = int(speed.argmax()) if len(speed) else 0
    if len(speed) and speed[worst] > FASTEST:
        row = rows[order[1:][same][worst]]
        raise ConfigError(
            f'{path}, line {row.line}: person {row.person:g} jumps by {way[same][worst]:.3g} m in '
            f'{duration[same][worst]:.3g} s'
        )
