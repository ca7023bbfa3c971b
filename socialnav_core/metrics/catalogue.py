"""All metrics, and the choice of some of them."""

from collections.abc import Iterable

from socialnav_core.config import ConfigError
from socialnav_core.config.mapping import hint
from socialnav_core.metrics import bound, efficiency, outcomes, people, smoothness
from socialnav_core.metrics.table import Metric, Place

METRICS: dict[str, Metric] = {
    metric.name: metric
    for entries in (outcomes, efficiency, people, smoothness, bound)
    for metric in entries.METRICS
}
"""All metrics by name, in the order in which they are shown."""

BOUND_METRICS = tuple(metric.name for metric in bound.METRICS)
"""Names of those that need the bound of each case."""

EVERY = 'all'
"""Stands for the names of all metrics."""


def chosen(further: Iterable[str] = ()) -> list[Metric]:
    """
    Return the metrics that have a place of their own, and those that are asked for by name.

    :param further: names, or `all`.
    :raises ConfigError: for a name that no metric has.
    """
    names = set(further)
    for name in sorted(names - {EVERY}):
        if name not in METRICS:
            raise ConfigError(f'unknown metric {name!r}; {hint(name, METRICS)}')
    return [
        metric
        for metric in METRICS.values()
        if metric.places or metric.name in names or EVERY in names
    ]


def shown_in(place: Place, measured: Iterable[str]) -> list[Metric]:
    """
    Return the metrics that a table shows: those that belong there, and what was asked for besides.

    :param measured: names of the metrics that there are figures of; others are left aside.
    """
    names = set(measured)
    return [
        metric
        for metric in METRICS.values()
        if place in metric.places or (not metric.places and metric.name in names)
    ]
