"""`socialnav metrics`: what is measured, and how."""

import argparse
from typing import Any

from socialnav_core.commands.arguments import add_command

EXAMPLES = """
--markdown > docs/metrics.md"""


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'List the metrics that evaluate and compare can measure.'
    parser = add_command(commands, 'metrics', run, summary, EXAMPLES)
    parser.add_argument(
        '--markdown', action='store_true', help='print docs/metrics.md: with formulas and sources'
    )


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    from socialnav_core.metrics.page import reference_page, text_list

    print(reference_page() if given.markdown else text_list(), end='' if given.markdown else '\n')
