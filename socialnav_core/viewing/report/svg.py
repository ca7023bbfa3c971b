"""Plots as SVG that stands in a page and takes the page's colours."""

from collections.abc import Iterator
import contextlib
import io
import re
from typing import Any

from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

INK = '#010203'
"""Stands for the colour of the page's text, which is another one in the dark."""
SIZE = (5.0, 3.3)
"""Inches, of 72 units of the picture; text stays readable at the width of a phone."""
COLOURS = ('#2f7ec7', '#c65a11', '#8a5fd0', '#1f8a5b', '#c8437a', '#7a7f1e', '#b3423f', '#4a7f8c')
"""Of the policies; each stands out from white and from the dark ground, 3 : 1 or more."""
LINES: tuple[Any, ...] = ('-', '--', '-.', ':', (0, (5, 1, 1, 1)))
"""Of the policies, so that nobody needs to tell colours apart."""
STYLE: dict[Any, Any] = {
    'svg.fonttype': 'none', 'font.family': 'sans-serif', 'font.size': 11, 'text.color': INK,
    'text.parse_math': False,  # names may hold a dollar
    'axes.edgecolor': INK, 'axes.labelcolor': INK, 'xtick.color': INK, 'ytick.color': INK,
    'axes.facecolor': 'none', 'figure.facecolor': 'none', 'savefig.facecolor': 'none',
    'axes.spines.top': False, 'axes.spines.right': False, 'axes.grid': True, 'grid.color': INK,
    'grid.alpha': 0.15, 'legend.frameon': False, 'legend.fontsize': 10, 'lines.linewidth': 2.2,
}  # fmt: skip


class Plot:
    """A figure with one pair of axes, and the SVG of it when it is drawn."""

    def __init__(self, figure: Figure) -> None:
        """Begin with an empty pair of axes."""
        self.figure = figure
        self.axes: Axes = figure.add_subplot()
        self.svg = ''


@contextlib.contextmanager
def plot(name: str, alternative: str) -> Iterator[Plot]:
    """
    Give axes to draw on, and turn them into SVG in the end.

    :param name: differs between the plots of a page: names of parts within are made from it.
    :param alternative: what the plot shows, for those who do not see it.
    """
    with rc_context(STYLE | {'svg.hashsalt': name}):
        drawn = Plot(Figure(figsize=SIZE, layout='constrained'))
        yield drawn
        FigureCanvasSVG(drawn.figure)
        file = io.StringIO()
        drawn.figure.savefig(file, format='svg')
    drawn.svg = inlined(file.getvalue(), alternative)


def inlined(text: str, alternative: str) -> str:
    """Return the SVG of a file as an element of a page, without what only files need."""
    text = text[text.index('<svg') :]
    text = re.sub(r'<metadata>.*?</metadata>', '', text, flags=re.DOTALL)
    text = re.sub(r' xmlns(:\w+)?="[^"]*"', '', text).replace('xlink:href', 'href')
    text = re.sub(r'<g id="[^"]*"', '<g', text)  # the same in every plot
    text = re.sub(r' width="[\d.]+pt"| height="[\d.]+pt"', '', text, count=2)
    text = text.replace(INK, 'currentColor')
    label = escaped(alternative)
    return text.replace('<svg', f'<svg class="plot" role="img" aria-label="{label}"', 1).strip()


def escaped(text: str) -> str:
    """Return a text as the value of an attribute."""
    for sign, name in {'&': '&amp;', '"': '&quot;', '<': '&lt;', '>': '&gt;'}.items():
        text = text.replace(sign, name)
    return text
