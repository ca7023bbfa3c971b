"""The report's tables with our figures beside the report's."""

from collections.abc import Iterable, Sequence

from founding_report.experiments import COLUMNS, Experiment
from founding_report.markdown import LOOKAHEAD_LABELS, number
from founding_report.measurements import LOOKAHEADS
from founding_report.report_figures import PARAMETERS, reported
from founding_report.rows import Row
from founding_report.summary import Summary
from founding_report.verdicts import rate_verdict, time_verdict
from socialnav_core.policies.value.checkpoint import build_network
from socialnav_core.tables import markdown_table

REPORTED = ('success', 'collision', 'time')
NAMES = {
    'success': 'Success',
    'collision': 'Collision',
    'time': 'Nav. time (s)',
}


def report_has_any(summaries: Sequence[Summary]) -> bool:
    """Return whether the report has a figure for any of the rows."""
    return any(reported(row.name, scenario) for row, scenario in rows_and_scenarios(summaries))


def report_table(experiment: Experiment, summaries: Sequence[Summary]) -> str:
    """Return a table in the layout of the report."""
    return (by_column if experiment.layout == COLUMNS else by_line)(summaries)


def by_column(summaries: Sequence[Summary]) -> str:
    """Return a table with a column for each row, as table II has it."""
    rows = {summary.row.name: summary.row for summary in summaries}
    head = ['', '', *(row.label for row in rows.values())]
    lines = [
        ['Parameters', 'report', *(f'{PARAMETERS[name]:,}' for name in rows)],
        ['', 'ours', *(f'{parameters(row):,}' for row in rows.values())],
    ]
    for scenario in unique(summary.scenario for summary in summaries):
        for figure in REPORTED:
            lines.append(
                [f'{NAMES[figure]}, `{scenario}`', 'report',
                 *(number(report_figure(name, scenario, figure), figure) for name in rows)]
            )  # fmt: skip
            for lookahead in LOOKAHEADS:
                ours = [find(summaries, name, scenario, lookahead).mean(figure) for name in rows]
                label = f'ours, {LOOKAHEAD_LABELS[lookahead]}'
                lines.append(['', label, *(number(mean, figure) for mean in ours)])
    return markdown_table(head, lines)


def by_line(summaries: Sequence[Summary]) -> str:
    """Return a table with a line for each row and scenario, as tables I and III have it."""
    head = ['Model', 'World']
    for figure in REPORTED:
        head += [f'{NAMES[figure]}: report', 'oracle', 'constant velocity']
    lines = []
    for row, scenario in rows_and_scenarios(summaries):
        cells = [row.label, f'`{scenario}`']
        for figure in REPORTED:
            cells.append(number(report_figure(row.name, scenario, figure), figure))
            for lookahead in LOOKAHEADS:
                mean = find(summaries, row.name, scenario, lookahead).mean(figure)
                cells.append(number(mean, figure))
        lines.append(cells)
    return markdown_table(head, lines)


def verdict_table(summaries: Sequence[Summary]) -> str:
    """Return every figure of the report with what ours is to it."""
    head = ['Model', 'World', 'Figure', 'Report', *(LOOKAHEAD_LABELS[each] for each in LOOKAHEADS)]
    lines = []
    for row, scenario in rows_and_scenarios(summaries):
        for figure in REPORTED:
            theirs = report_figure(row.name, scenario, figure)
            if theirs is None:
                continue
            found = [find(summaries, row.name, scenario, each) for each in LOOKAHEADS]
            lines.append(
                [row.label, f'`{scenario}`', NAMES[figure], number(theirs, figure),
                 *(f'{number(each.mean(figure), figure)}: {verdict(theirs, each, figure)}'
                   for each in found)]
            )  # fmt: skip
    return markdown_table(head, lines)


def verdict(theirs: float, ours: Summary, figure: str) -> str:
    """
    Return what our figure is to the report's.

    :param figure: success, collision or time.
    """
    if figure == 'time':
        return time_verdict(theirs, ours.mean(figure))
    rate = float(ours.values(figure).mean())
    return rate_verdict(theirs, rate, more_is_better=figure == 'success')


def report_figure(row: str, scenario: str, figure: str) -> float | None:
    """
    Return a figure of the report, None where it has none.

    :param figure: success, collision or time.
    """
    figures = reported(row, scenario)
    return None if figures is None else getattr(figures, figure)


def parameters(row: Row) -> int:
    """Return the number of parameters of a row's network."""
    network = build_network(row.resolved(0, quick=False).policy)
    return sum(parameter.numel() for parameter in network.parameters())


def find(summaries: Sequence[Summary], row: str, scenario: str, lookahead: str) -> Summary:
    """Return the figures of one row in one scenario with one look-ahead."""
    wanted = (row, scenario, lookahead)
    return next(
        each for each in summaries if (each.row.name, each.scenario, each.lookahead) == wanted
    )


def rows_and_scenarios(summaries: Sequence[Summary]) -> list[tuple[Row, str]]:
    """Return rows and scenarios in the order of the table, rows of one world side by side."""
    scenarios = unique(summary.scenario for summary in summaries)
    pairs = {(s.row.name, s.scenario): (s.row, s.scenario) for s in summaries}
    return sorted(pairs.values(), key=lambda pair: scenarios.index(pair[1]))


def unique(values: Iterable[str]) -> list[str]:
    """Return values without repetitions, in the order of their first appearance."""
    return list(dict.fromkeys(values))
