"""Tables as text and as Markdown, and the numbers in them."""

from collections.abc import Callable, Sequence

NOTHING = '-'
"""What stands where there is no number."""


def number(value: float | None, digits: int, unit: str = '') -> str:
    """
    Return a number as text, a dash for None.

    :param digits: after the point.
    :param unit: what follows the number after a space; empty for none.
    """
    if value is None:
        return NOTHING
    return f'{value:.{digits}f} {unit}' if unit else f'{value:.{digits}f}'


def text_table(rows: Sequence[Sequence[str]]) -> str:
    """Return rows of equally many cells as text in columns, the first row underlined."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = [aligned(row, widths) for row in rows]
    return '\n'.join([lines[0], aligned(['-' * width for width in widths], widths), *lines[1:]])


def aligned(
    cells: Sequence[str],
    widths: Sequence[int],
    justify: Callable[[str, int], str] = str.ljust,
) -> str:
    """
    Return cells side by side without blanks at the end.

    :param widths: of the columns, in characters.
    :param justify: fills a cell up to its width: str.ljust or str.rjust.
    """
    return '  '.join(map(justify, cells, widths)).rstrip()


def markdown_table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return rows of as many cells as the head as a table in Markdown."""
    lines = [f'| {" | ".join(cells)} |' for cells in rows]
    return '\n'.join([f'| {" | ".join(head)} |', '|---' * len(head) + '|', *lines])
