"""Grids of worlds as tables."""

from collections.abc import Callable, Sequence
from typing import Any

from socialnav_core.config.grid import GridConfig, Table, UNITS
from socialnav_core.evaluation.grid import Cell
from socialnav_core.evaluation.report import rate_text
from socialnav_core.metrics import METRICS
from socialnav_core.tables import markdown_table, NOTHING, number, text_table

UNPACKED = 'cannot be packed'
Rows = list[tuple[str, ...]]


def success_text(cell: Cell) -> str:
    """Return the success of a cell with its interval."""
    return rate_text(cell['success_rate'], cell['success_interval'])


def figure_of(name: str) -> Callable[[Cell], str]:
    """Return what writes the figure of a metric in a cell."""
    metric = METRICS[name]
    return lambda cell: number(cell.get(name), metric.digits)


COLUMNS: dict[str, Callable[[Cell], str]] = {
    'success': success_text,
    'collision': figure_of('collision_rate'),
    'time-out': figure_of('timeout_rate'),
    'time, s': figure_of('navigation_time_mean'),
    'within 0.2 m': figure_of('intrusion_rate'),
}
BOUND_COLUMNS: dict[str, Callable[[Cell], str]] = {
    'solvable': figure_of('solvable_rate'),
    'success where solvable': figure_of('solvable_success_rate'),
    'over bound, s': figure_of('time_over_bound'),
    'over comfortable, s': figure_of('time_over_comfortable_bound'),
}


def grid_text(config: GridConfig, model: str, cells: Sequence[Cell]) -> str:
    """Return all cells of a policy as tables of text."""
    parts = [f'{model}: {config.episodes} cases of {config.split} a world, seed {config.seed}']
    for table in config.tables:
        parts += ['', f'{table.name}:', '', text_table(table_rows(table, cells))]
    return '\n'.join(parts)


def grid_markdown(config: GridConfig, results: dict[str, list[Cell]]) -> str:
    """
    Return all cells of some policies in Markdown: each table with all policies.

    :param results: cells of each policy by its name.
    """
    parts = []
    for table in config.tables:
        parts.append(f'### {table.name.replace("_", " ").capitalize()}\n')
        for model, cells in results.items():
            head, *rows = table_rows(table, cells)
            parts.append(f'`{model}`\n\n{markdown_table(head, rows)}\n')
    return '\n'.join(parts)


def table_rows(table: Table, cells: Sequence[Cell]) -> Rows:
    """Return the names of the columns and a row for each cell of a table."""
    own = [cell for cell in cells if cell['table'] == table.name]
    columns = COLUMNS | (BOUND_COLUMNS if any('solvable_rate' in cell for cell in own) else {})
    head = tuple(axis_text(axis) for axis in table.axes)
    return [(*head, *columns), *(cell_row(cell, columns) for cell in own)]


def cell_row(cell: Cell, columns: dict[str, Callable[[Cell], str]]) -> tuple[str, ...]:
    """Return the values of the axes and the figures of a cell."""
    values = [value_text(value) for value in cell['values'].values()]
    if 'unpacked' in cell:
        return (*values, UNPACKED, *[NOTHING] * (len(columns) - 1))
    return (*values, *(text(cell) for text in columns.values()))


def axis_text(axis: str) -> str:
    """Return what an axis is called, with its unit."""
    name = axis.replace('_', ' ')
    return f'{name}, {UNITS[axis]}' if axis in UNITS else name


def value_text(value: Any) -> str:
    """Return a value of an axis as text."""
    if isinstance(value, str):
        return value
    return {True: 'yes', False: 'no'}[value] if isinstance(value, bool) else f'{value:g}'
