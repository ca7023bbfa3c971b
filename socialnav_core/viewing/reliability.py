"""How often people are where a prediction says, as a picture."""

from collections.abc import Sequence
import math
from pathlib import Path
from typing import Any

from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from socialnav_core.evaluation.judgement import LEVELS, PredictionResult, TIMES

PANEL = 1.9  # inches
COLUMNS = 5
SMALL: dict[str, Any] = {'fontsize': 7}


def plot_reliability(results: Sequence[PredictionResult], path: Path) -> None:
    """
    Write a panel for each crowd: the share that a Gaussian has, and the share that was found.

    :param results: those of all motions are drawn, those of a single one are not.
    :param path: a picture in the format of its suffix.
    """
    drawn = [result for result in results if result.motion == 'all']
    columns = min(COLUMNS, len(drawn))
    rows = math.ceil(len(drawn) / columns)
    figure = Figure(figsize=(PANEL * columns, PANEL * rows + 0.3), dpi=100, layout='constrained')
    FigureCanvasAgg(figure)
    grid = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    for axes in grid.flat[len(drawn) :]:
        axes.set_visible(False)
    for axes, result in zip(grid.flat, drawn, strict=False):
        draw_panel(axes, result)
    handles, labels = grid[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc='outside upper center', ncols=len(labels), **SMALL)
    figure.supxlabel('share of a Gaussian', **SMALL)
    figure.supylabel('share of the errors found there', **SMALL)
    figure.savefig(path)


def draw_panel(axes: Axes, result: PredictionResult) -> None:
    """Draw the lines of a crowd, one for each time ahead, below the line of who is right."""
    axes.plot([0, 1], [0, 1], color='0.7', linewidth=1.0)
    for index, time in enumerate(TIMES):
        colour = colormaps['viridis'](0.9 * index / (len(TIMES) - 1))
        shares = result.within_level[index]
        axes.plot(LEVELS, shares, color=colour, linewidth=1.2, label=f'{time:g} s ahead')
    axes.set_title(result.crowd + ', noise' * result.noise, pad=2, **SMALL)
    axes.set(xlim=(0, 1), ylim=(0, 1), aspect='equal', xticks=(0, 0.5, 1), yticks=(0, 0.5, 1))
    axes.tick_params(labelsize=6, length=2)
