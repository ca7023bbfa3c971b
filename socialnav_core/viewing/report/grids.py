"""The file of a grid of worlds as a picture and as tables."""

import base64
import dataclasses
import json
from pathlib import Path
import tempfile
from typing import Any

import yaml

from socialnav_core.config import BoundConfig, ConfigError
from socialnav_core.config.grid import GridConfig, Table
from socialnav_core.config.mapping import from_mapping
from socialnav_core.config.scenarios import resolve_scenario
from socialnav_core.evaluation.grid import Cell
from socialnav_core.evaluation.grid_report import table_rows
from socialnav_core.viewing.heat_map import plot_grid

UNREADABLE = (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError,
              yaml.YAMLError)  # fmt: skip


@dataclasses.dataclass(frozen=True)
class Grid:
    """A policy in a grid of worlds."""

    model: str
    """Name of the policy."""
    config: GridConfig
    """The worlds."""
    cells: list[Cell]
    """What came of each."""

    @property
    def picture(self) -> str:
        """Return the heat map as the address of a PNG that holds it."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, 'grid.png')
            plot_grid(self.config, {self.model: self.cells}, path)
            data = path.read_bytes()
        return f'data:image/png;base64,{base64.b64encode(data).decode()}'

    @property
    def tables(self) -> dict[str, list[tuple[str, ...]]]:
        """Return the rows of each table, the names of the columns first, by its name."""
        return {
            table.name.replace('_', ' '): table_rows(table, self.cells)
            for table in self.config.tables
        }


def read_grid(path: Path) -> Grid:
    """
    Return the grid that `socialnav grid` wrote.

    :raises ConfigError: when it is something else, or not finished.
    """
    try:
        values = json.loads(path.read_text(encoding='utf-8'))
        grid = Grid(str(values['model']), config_of(values['grid']), list(values['cells']))
        expected = sum(len(rows) - 1 for rows in grid.tables.values())
    except UNREADABLE as error:
        raise ConfigError(
            f'{path} holds no grid: name a file that socialnav grid wrote'
        ) from error
    worlds = sum(cells_in(table) for table in grid.config.tables)
    if expected != worlds:
        raise ConfigError(
            f'{path} has {expected} of {worlds} worlds: finish it by socialnav grid {grid.model}'
        )
    return grid


def config_of(values: dict[str, Any]) -> GridConfig:
    """Return the grid of plain values; see `socialnav_core.config.grid.grid_mapping`."""
    return GridConfig(
        str(values['name']), int(values['episodes']), int(values['seed']), str(values['split']),
        from_mapping(BoundConfig, values['bound'], 'bound'),
        tuple(
            Table(
                str(table['name']), resolve_scenario(yaml.safe_load(table['world'])),
                {axis: tuple(along) for axis, along in table['axes'].items()},
            )
            for table in values['tables']
        ),
    )  # fmt: skip


def cells_in(table: Table) -> int:
    """Return how many worlds a table has."""
    count = 1
    for along in table.axes.values():
        count *= len(along)
    return count
