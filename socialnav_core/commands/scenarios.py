"""`socialnav scenarios`: which worlds there are."""

import argparse
from typing import Any

from socialnav_core.commands.arguments import add_command
from socialnav_core.config import Scenario
from socialnav_core.tables import text_table

EXAMPLES = """
hard
curriculum-1.5"""

COLUMNS = ('name', 'people', 'obstacles', 'radius (m)', 'width (m)', 'limit (s)', 'meaning')
EXAMPLE_RADIUS = '2.5'
AS_RECORDED = ('recorded', '0', '-', 'scene', '25')


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'List the scenarios and crowds, or print every setting of a scenario.'
    parser = add_command(commands, 'scenarios', run, summary, EXAMPLES)
    parser.add_argument(
        'scenario', metavar='NAME', nargs='?', help='print the settings of this one as YAML'
    )


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    from socialnav_core.config import CROWDS
    from socialnav_core.config.mapping import to_yaml
    from socialnav_core.simulation import make_scenario, SCENARIOS

    if given.scenario is not None:
        print(to_yaml(make_scenario(given.scenario)), end='')
        return
    rows: list[tuple[str, ...]] = [COLUMNS]
    for name, meaning in SCENARIOS.items():
        example = name.replace('-R', f'-{EXAMPLE_RADIUS}')
        of_file = name.endswith(':FILE')  # which says how many people there are, and where
        shown = AS_RECORDED if of_file else parameters(make_scenario(example), example != name)
        rows.append((name, *shown, meaning))
    print(text_table(rows))
    print()
    print(text_table([('crowd', 'meaning'), *CROWDS.items()]))


def parameters(scenario: Scenario, growing: bool) -> tuple[str, ...]:
    """
    Return the parameters in which scenarios differ, as text.

    :param growing: whether its largest obstacle radius is part of its name.
    """
    low, high = scenario.obstacle_radius_min, scenario.obstacle_radius_max
    largest = 'R' if growing else f'{high:g}'
    radius = f'{low:g}' if low == high else f'{low:g} - {largest}'
    return (
        str(scenario.pedestrians),
        str(scenario.obstacles),
        radius if scenario.obstacles else '-',
        f'{2 * scenario.bounds:g}',
        f'{scenario.time_limit:g}',
    )
