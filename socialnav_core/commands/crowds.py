"""`socialnav crowds`: how the people of the simulator walk, beside real ones."""

import argparse
from typing import Any

from socialnav_core.commands.arguments import add_command, SEED, whole_number
from socialnav_core.config import ConfigError, CROWDS

EXAMPLES = """
social_force groups
--markdown"""

MEASURED = (
    'orca', 'social_force', 'headed_social_force', 'groups', 'stop_and_go', 'distracted',
    'non_reactive',
)  # fmt: skip
"""Crowds that can live in a corridor without ends."""


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'Measure how crowds walk in a corridor: speed by density, and lanes (some minutes).'
    parser = add_command(commands, 'crowds', run, summary, EXAMPLES)
    parser.add_argument(
        'crowds', metavar='CROWD', nargs='*', help=f'of {", ".join(MEASURED)} (all of them)'
    )
    parser.add_argument(
        '--seed', type=whole_number(*SEED), default=0, metavar='N', help='seed of the people (0)'
    )
    parser.add_argument('--markdown', action='store_true', help='print tables in Markdown')


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    from socialnav_core.evaluation.crowd_flow import measure_flows
    from socialnav_core.evaluation.crowd_report import flow_tables

    for crowd in given.crowds:
        if crowd not in MEASURED:
            other = ' lives in worlds of its own' if crowd in CROWDS else ' is none'
            raise ConfigError(f'crowd {crowd}{other}; there are: {", ".join(MEASURED)}')
    flows = list(measure_flows(given.crowds or MEASURED, seed=given.seed))
    print(flow_tables(flows, given.markdown))
