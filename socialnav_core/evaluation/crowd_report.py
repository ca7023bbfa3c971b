"""What was measured of crowds in a corridor, as tables."""

from collections.abc import Sequence

from socialnav_core.evaluation.crowd_flow import Flow, weidmann
from socialnav_core.tables import markdown_table, text_table

ONE_WAY = 'Speed one way, in units of what people prefer, by density:'
TWO_WAYS = 'Speed where half of them come the other way, and the order of lanes (0 to 1):'
OVERLAP = 'Share of people who overlap somebody where half of them come the other way:'
PEOPLE = 'people (Weidmann 1993)'


def flow_tables(flows: Sequence[Flow], markdown: bool = False) -> str:
    """
    Return the tables of some crowds.

    :param flows: each crowd one way and two ways, at the same densities.
    """
    densities = sorted({flow.density for flow in flows})
    crowds = list(dict.fromkeys(flow.crowd for flow in flows))
    known = {(flow.crowd, flow.two_ways, flow.density): flow for flow in flows}
    head = ['crowd', *(f'{density:g} /m2' for density in densities)]
    one = [[PEOPLE, *(f'{weidmann(density):.2f}' for density in densities)]]
    one += [[c, *(f'{known[c, False, d].speed:.2f}' for d in densities)] for c in crowds]
    two, overlap = [], []
    for crowd in crowds:
        row = [known[crowd, True, density] for density in densities]
        cells = [f'{f.speed:.2f}, {f.lanes_at_start:.2f} to {f.lanes:.2f}' for f in row]
        two.append([crowd, *cells])
        overlap.append([crowd, *(f'{flow.overlap:.2f}' for flow in row)])
    parts = ((ONE_WAY, one), (TWO_WAYS, two), (OVERLAP, overlap))
    return '\n\n'.join(f'{title}\n\n{shown(head, rows, markdown)}' for title, rows in parts)


def shown(head: Sequence[str], rows: Sequence[Sequence[str]], markdown: bool) -> str:
    """Return a table in Markdown or as text."""
    return markdown_table(head, rows) if markdown else text_table([head, *rows])
