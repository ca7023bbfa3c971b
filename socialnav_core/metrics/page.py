"""The table of metrics as text and as a page of the documentation."""

from socialnav_core.metrics.catalogue import METRICS
from socialnav_core.metrics.table import Metric
from socialnav_core.tables import markdown_table, NOTHING, text_table

COLUMNS = ('name', 'meaning', 'unit', 'average over', 'shown')
PAGE_COLUMNS = ('name', 'value in one episode', 'unit', 'average over', 'shown', 'source')
INTRODUCTION = """# Metrics

Written by `socialnav metrics --markdown` from the table in `socialnav_core/metrics`.

Every metric is a function of the trace of an episode: positions, velocities, commands and gaps in
each step. The name is the key of the figure in JSON. Figures are averages over what the fourth
column says; a value that does not exist, such as a gap to nobody, does not count, and a figure
without any value is `null` in JSON and `-` elsewhere. `all steps` is the share of the steps of all
episodes together. Gaps are measured between rims, and at any moment of a step.

A metric that is shown nowhere by itself is measured when its name follows `--metrics` in
`socialnav evaluate` or `socialnav compare`, or all are by `--metrics all`; with `--card` it then
gets a column of the model card.
"""


def text_list() -> str:
    """Return all metrics as a table of text."""
    rows = [
        (metric.name, metric.label.strip(), metric.unit or NOTHING, average(metric), shown(metric))
        for metric in METRICS.values()
    ]
    return text_table([COLUMNS, *rows])


def reference_page() -> str:
    """Return docs/metrics.md."""
    rows = [
        (
            f'`{metric.name}`', escaped(metric.formula), metric.unit or NOTHING, average(metric),
            shown(metric), metric.source,
        )
        for metric in METRICS.values()
    ]  # fmt: skip
    return f'{INTRODUCTION}\n{markdown_table(PAGE_COLUMNS, rows)}\n'


def average(metric: Metric) -> str:
    """Return over what a metric is averaged."""
    return metric.average.value


def shown(metric: Metric) -> str:
    """Return where a metric is shown without being asked for."""
    return ', '.join(sorted(place.value for place in metric.places)) or NOTHING


def escaped(formula: str) -> str:
    """Return a formula as it stands in a cell of a table in Markdown."""
    return formula.replace('|', '\\|')
