"""
The tables of parameters in the package's README, written from the dataclasses.

`python -m socialnav.parameters.readme README.md` writes them into the file.
"""

import math
from pathlib import Path
import re
import sys
from typing import Any

from socialnav.parameters.fields import entries, Entry, Parameters
from socialnav.parameters.obstacle import ObstacleParameters
from socialnav.parameters.policy import PolicyParameters
from socialnav.parameters.simulator import SimulatorParameters
from socialnav.parameters.tracker import TrackerParameters

KINDS: dict[str, type[Parameters]] = {
    'simulator_node': SimulatorParameters,
    'policy_node': PolicyParameters,
    'obstacle_node': ObstacleParameters,
    'tracker_node': TrackerParameters,
}
"""What each node is told, by the heading of its section."""
HEADING = '| parameter | default | values | unit | live | meaning |\n|---|---|---|---|---|---|\n'


def with_tables(readme: str) -> str:
    """
    Return the text of a README with the table of each node as the dataclasses have it.

    :raises ValueError: a section or its table is missing.
    """
    for name, kind in KINDS.items():
        pattern = rf'^## {name}\n(?:(?!## ).*\n)*?({re.escape(HEADING)}(?:\|.*\n)*)'
        found = re.search(pattern, readme, re.MULTILINE)
        if found is None:
            raise ValueError(f'no table of parameters below the heading {name}')
        readme = readme[: found.start(1)] + table(kind) + readme[found.end(1) :]
    return readme


def table(kind: type[Parameters]) -> str:
    """Return the table of a node in Markdown."""
    return HEADING + ''.join(map(row, entries(kind)))


def row(entry: Entry) -> str:
    """Return the line of a parameter."""
    cells = (
        f'`{entry.name}`', shown(entry.default), values(entry), entry.unit or '-', entry.live,
        entry.description,
    )  # fmt: skip
    return f'| {" | ".join(cells)} |\n'


def values(entry: Entry) -> str:
    """Return what a parameter may be."""
    if entry.choices:
        return ', '.join(f'`{choice}`' for choice in entry.choices)
    if entry.range:
        return ' to '.join(map(shown, entry.range))
    return 'true, false' if isinstance(entry.default, bool) else 'text'


def shown(value: Any) -> str:
    """Return a value as YAML has it."""
    if isinstance(value, bool):
        return str(value).lower()
    if value == math.inf:
        return '.inf'
    return f'{value:g}' if isinstance(value, float) else str(value)


if __name__ == '__main__':
    path = Path(sys.argv[1])
    path.write_text(with_tables(path.read_text()))
