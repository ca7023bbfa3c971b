"""The success of some policies in a grid of worlds as a picture."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
import numpy as np

from socialnav_core.config.grid import GridConfig, Table
from socialnav_core.evaluation.grid import Cell
from socialnav_core.evaluation.grid_report import axis_text, value_text

CELL = (0.5, 0.3)  # inches
LEFT, HEAD, LABELS, MARGIN = 0.6, 0.4, 0.45, 0.1  # inches
DARK = 0.45
"""Below this success the numbers are white."""


def plot_grid(config: GridConfig, results: dict[str, list[Cell]], path: Path) -> None:
    """
    Write the success in each cell, per cent, a row of tables for each policy.

    :param results: cells of each policy by its name.
    :param path: a picture in the format of its suffix.
    """
    places = list(placed(config.tables))
    width = max(left + CELL[0] * shape_of(table)[1] for table, left, _ in places)
    height = HEAD + max(down + CELL[1] * shape_of(table)[0] for table, _, down in places) + LABELS
    figure = Figure(figsize=(width + MARGIN, height * len(results)), dpi=150)
    FigureCanvasAgg(figure)
    size = np.tile(figure.get_size_inches(), 2)
    for row, (model, cells) in enumerate(results.items()):
        top = size[1] - row * height
        figure.text(MARGIN / size[0], (top - 0.5 * HEAD) / size[1], model, weight='bold')
        for table, left, down in places:
            rows, columns = shape_of(table)
            bottom = top - HEAD - down - CELL[1] * rows
            box = np.array([left, bottom, CELL[0] * columns, CELL[1] * rows])
            axes = figure.add_axes(tuple(box / size))
            draw_table(axes, table, success_of(table, cells))
    figure.savefig(path)


def placed(tables: Sequence[Table]) -> Iterator[tuple[Table, float, float]]:
    """Yield each table, how far from the left and how far down; those of one row share columns."""
    height = CELL[1] * max(shape_of(table)[0] for table in tables)
    left, down, width = LEFT, 0.0, 0.0
    for table in tables:
        rows, columns = shape_of(table)
        if down > 0.0 and (rows > 1 or down + CELL[1] * rows > height):
            left, down, width = left + width, 0.0, 0.0
        yield table, left, down
        width = max(width, CELL[0] * columns + LEFT)
        down += CELL[1] * rows + LABELS


def shape_of(table: Table) -> tuple[int, int]:
    """Return the numbers of rows and columns of a table; one axis alone goes to the right."""
    counts = [len(along) for along in table.axes.values()]
    return (counts[0], counts[1]) if len(counts) == 2 else (1, counts[0])


def success_of(table: Table, cells: Sequence[Cell]) -> np.ndarray:
    """Return the success in each cell, NaN where there is none, (rows, columns)."""
    own = [cell.get('success_rate', np.nan) for cell in cells if cell['table'] == table.name]
    return np.array(own, float).reshape(shape_of(table))


def draw_table(axes: Axes, table: Table, success: np.ndarray) -> None:
    """Draw the cells of a table with their numbers; what cannot be packed stays grey."""
    small: dict[str, Any] = {'fontsize': 7}
    axes.set_facecolor('0.8')
    axes.imshow(success, cmap='viridis', vmin=0.0, vmax=1.0, aspect='auto')
    for (row, column), rate in np.ndenumerate(success):
        text = f'{100 * rate:.1f}' if np.isfinite(rate) else 'full'
        axes.text(
            column, row, text, ha='center', va='center', **small,
            color='white' if rate < DARK else 'black',
        )  # fmt: skip
    names, along = list(table.axes), [list(map(value_text, each)) for each in table.axes.values()]
    axes.set_xticks(range(success.shape[1]), along[-1], **small)
    axes.set_xlabel(axis_text(names[-1]), labelpad=1, **small)
    axes.set_yticks(range(success.shape[0]) if len(names) == 2 else [])
    if len(names) == 2:
        axes.set_yticklabels(along[0], **small)
        axes.set_ylabel(axis_text(names[0]), labelpad=3, **small)
    axes.tick_params(length=0, pad=2)
