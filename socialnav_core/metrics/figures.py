"""Figures of some episodes, all together and one by one."""

from collections.abc import Iterable
from typing import Any

from socialnav_core.metrics.catalogue import chosen
from socialnav_core.metrics.records import EpisodeRecords
from socialnav_core.metrics.table import finite_or_none
from socialnav_core.simulation import Outcome


def summarise(records: EpisodeRecords, further: Iterable[str] = ()) -> dict[str, float | None]:
    """
    Return the figure of each metric by name; None where no episode has a value.

    The rates of success, collision (walls included) and time-out add up to one.

    :param records: at least one episode.
    :param further: names of metrics besides those that are always measured, or `all`.
    """
    return {metric.name: metric.figure(records) for metric in chosen(further)}


def case_mappings(records: EpisodeRecords, further: Iterable[str] = ()) -> list[dict[str, Any]]:
    """
    Return a mapping of plain values for each episode, fit for JSON.

    :param further: names of metrics besides those that are always measured, or `all`.
    """
    columns = {metric.key: metric.values(records) for metric in chosen(further) if metric.key}
    return [
        {
            'case_index': int(records.case_index[i]),
            'outcome': outcome_name(records.outcome[i]),
            **{key: finite_or_none(values[i]) for key, values in columns.items()},
            'steps': int(records.steps[i]),
        }
        for i in range(len(records.case_index))
    ]


def outcome_name(outcome: int) -> str:
    """Return the name of a code of Outcome in files, such as goal or collision_obstacle."""
    return Outcome(int(outcome)).name.lower()
