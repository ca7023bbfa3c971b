"""The success of some policies in a grid of worlds as a picture."""

from collections.abc import Sequence
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
LEFT, TOP = 1.0, 0.75
DARK = 0.45
"""Below this success the numbers are white."""


def plot_grid(config: GridConfig, results: dict[str, list[Cell]], path: Path) -> None:
    """
    Write the success in each cell, per cent, a row of tables for each policy.

    :param results: cells of each policy by its name.
    :param path: a picture in the format of its suffix.
    """
    shapes = [shape_of(table) for table in config.tables]
    widths = [LEFT + CELL[0] * shape[1] for shape in shapes]
    height = TOP + CELL[1] * max(shape[0] for shape in shapes)
    figure = Figure(figsize=(sum(widths) + 0.2, (height + 0.3) * len(results)), dpi=150)
    FigureCanvasAgg(figure)
    whole_width, whole_height = figure.get_size_inches()
    for row, (model, cells) in enumerate(results.items()):
        top = whole_height - row * (height + 0.3) - 0.5
        figure.text(0.1 / whole_width, (top + 0.25) / whole_height, model, weight='bold')
        left = 0.0
        for table, shape, width in zip(config.tables, shapes, widths, strict=True):
            across, down = CELL[0] * shape[1], CELL[1] * shape[0]
            box = (left + LEFT, top - down - 0.15, across, down)
            axes = figure.add_axes(
                (box[0] / whole_width, box[1] / whole_height,
                 box[2] / whole_width, box[3] / whole_height)
            )  # fmt: skip
            draw_table(axes, table, success_of(table, cells))
            left += width
    figure.savefig(path)


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
        axes.set_ylabel(axis_text(names[0]), labelpad=1, **small)
    axes.tick_params(length=0, pad=2)
