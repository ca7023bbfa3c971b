"""What the demo prints and writes."""

import json
import math
from pathlib import Path
from typing import Any

from socialnav_msgs.msg import EpisodeResult

FIELDS = (
    'scenario', 'seed', 'case_index', 'outcome', 'time', 'path_length', 'minimum_clearance',
    'steps',
)  # fmt: skip
HEADINGS = ('episode', 'scenario', 'case', 'outcome', 'time', 'path', 'clearance', 'steps')
WIDTHS = (7, 14, 5, 13, 8, 8, 9, 5)


def row(number: int, result: EpisodeResult) -> str:
    """
    Return an episode as a line of the table.

    :param number: counted from 1.
    :param result: how it ended.
    """
    cells = (
        str(number),
        result.scenario,
        str(result.case_index),
        result.outcome,
        f'{result.time:.2f} s',
        f'{result.path_length:.2f} m',
        f'{result.minimum_clearance:.2f} m',
        str(result.steps),
    )
    return aligned(cells)


def aligned(cells: tuple[str, ...]) -> str:
    """
    Return cells side by side.

    :param cells: one for each heading.
    """
    return '  '.join(cell.rjust(width) for cell, width in zip(cells, WIDTHS, strict=True))


def table(results: list[EpisodeResult]) -> str:
    """
    Return all episodes and a summary.

    :param results: in the order in which they ended; at least one.
    """
    lines = [aligned(HEADINGS), *(row(number, one) for number, one in enumerate(results, 1))]
    times = [result.time for result in results if result.outcome == 'goal']
    mean = f', {sum(times) / len(times):.2f} s on average' if times else ''
    return '\n'.join([*lines, f'{len(times)} of {len(results)} reached the goal{mean}'])


def record_of(result: EpisodeResult) -> dict[str, Any]:
    """
    Return an episode as JSON has it: null for an infinite clearance.

    :param result: how it ended.
    """
    values = {name: getattr(result, name) for name in FIELDS}
    clearance = values['minimum_clearance']
    return values | {'minimum_clearance': clearance if math.isfinite(clearance) else None}


def write_json(results: list[EpisodeResult], path: Path) -> None:
    """
    Write all episodes as a list.

    :param results: in the order in which they ended.
    :param path: file to write.
    """
    path.write_text(json.dumps([record_of(result) for result in results], indent=2) + '\n')
