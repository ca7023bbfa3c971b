"""What the demo prints and writes."""

import json
from pathlib import Path
from typing import Any

from socialnav_core.metrics import METRICS
from socialnav_core.metrics.table import finite_or_none
from socialnav_core.tables import aligned
from socialnav_msgs.msg import EpisodeResult

FIELDS = tuple(name for name in EpisodeResult.get_fields_and_field_types() if name != 'header')
MEASURED = {
    metric.key: metric
    for metric in METRICS.values()
    if metric.key is not None and metric.key in FIELDS
}
"""Metrics that the message has a field for, by the names of the fields."""
HEADINGS = (
    'episode', 'scenario', 'case', 'outcome', *(metric.column for metric in MEASURED.values()),
    'steps',
)  # fmt: skip
WIDTHS = (7, 14, 5, 13, *(max(8, len(metric.column)) for metric in MEASURED.values()), 5)


def row(number: int, result: EpisodeResult) -> str:
    """
    Return an episode as a line of the table.

    :param number: counted from 1.
    """
    cells = (
        str(number),
        result.scenario,
        str(result.case_index),
        result.outcome,
        *(metric.text(getattr(result, name)) for name, metric in MEASURED.items()),
        str(result.steps),
    )
    return aligned(cells, WIDTHS, str.rjust)


def heading() -> str:
    """Return the line above the episodes."""
    return aligned(HEADINGS, WIDTHS, str.rjust)


def summary(results: list[EpisodeResult]) -> str:
    """Return how many of at least one episode reached the goal, and how fast."""
    times = [result.time for result in results if result.outcome == 'goal']
    mean = f', {sum(times) / len(times):.2f} s on average' if times else ''
    return f'{len(times)} of {len(results)} reached the goal{mean}'


def record_of(result: EpisodeResult) -> dict[str, Any]:
    """Return an episode as JSON has it: null for an infinite clearance."""
    values = {name: getattr(result, name) for name in FIELDS}
    return values | {name: finite_or_none(values[name]) for name in MEASURED}


def write_json(results: list[EpisodeResult], path: Path) -> None:
    """Write all episodes as a list, in the order in which they ended."""
    path.write_text(json.dumps([record_of(result) for result in results], indent=2) + '\n')
