"""A policy in every world of a grid, cell by cell, so that it can be stopped and goes on."""

from collections.abc import Callable, Iterator
import dataclasses
import itertools
from typing import Any

from socialnav_core.config.grid import GridConfig, observation_of, Table, world_of
from socialnav_core.evaluation.known_bounds import with_bounds
from socialnav_core.evaluation.run import evaluate, EvaluationResult
from socialnav_core.metrics import BOUND_METRICS
from socialnav_core.policies.loading import has_setting, load_policy
from socialnav_core.simulation import PackingError

SHARED = ('time_step', 'goal_tolerance')
"""Settings of a world that a policy is told where it has them too."""
Cell = dict[str, Any]
"""Plain values: table, values of the axes, and the figures, or why there are none."""


def cells_of(config: GridConfig) -> Iterator[tuple[Table, dict[str, Any]]]:
    """Yield every cell: its table, and the value of each axis."""
    for table in config.tables:
        for along in itertools.product(*table.axes.values()):
            yield table, dict(zip(table.axes, along, strict=True))


def run_grid(
    model: str,
    config: GridConfig,
    bound: bool,
    known: list[Cell],
    keep: Callable[[list[Cell]], None],
    progress: Callable[[int], None] = lambda count: None,
) -> list[Cell]:
    """
    Return all cells of a policy.

    :param bound: whether to measure against the bound of each case.
    :param known: cells of an earlier run, which are not run again.
    :param keep: is given all cells so far after each.
    :param progress: is told how many cells are done.
    """
    cells = list(known)
    there = {cell_key(cell) for cell in known}
    for table, values in cells_of(config):
        cell: Cell = {'table': table.name, 'values': values}
        if cell_key(cell) not in there:
            cells.append(cell | run_cell(model, table, values, config, bound))
            keep(cells)
        progress(1)
    return cells


def cell_key(cell: Cell) -> tuple[Any, ...]:
    """Return what tells one cell from another."""
    return cell['table'], *cell['values'].items()


def run_cell(
    model: str, table: Table, values: dict[str, Any], config: GridConfig, bound: bool
) -> Cell:
    """
    Return the figures of a policy in one world, driven as it drives, or that it is too full.

    :param values: of each axis of the table.
    """
    scenario = world_of(table, values)
    settings = {
        name: getattr(scenario, name) for name in SHARED if has_setting(model, name)
    }  # fmt: skip
    policy = load_policy(model, **settings | table.changes(values, 'policy'))
    scenario = dataclasses.replace(scenario, kinematics=policy.description.kinematics)
    try:
        result = evaluate(
            policy, scenario, config.episodes, config.seed, config.split, name=model,
            observation=observation_of(table, values),
        )  # fmt: skip
        if bound:
            result = with_bounds(result, scenario, config.bound)
    except PackingError as error:
        return {'unpacked': str(error)}
    return figures(result, bound)


def figures(result: EvaluationResult, bound: bool) -> Cell:
    """Return what is kept of a cell."""
    cell = {
        'episodes': result.episodes,
        'success_interval': list(result.success_interval),
        **result.summary(BOUND_METRICS if bound else ()),
    }
    if bound and cell['solvable_rate']:
        cell['solvable_success_interval'] = list(result.interval('solvable_success_rate'))
    return cell
