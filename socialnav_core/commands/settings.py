"""`socialnav settings`: what can be set, and to what."""

import argparse
from typing import Any

from socialnav_core.commands.arguments import add_command

EXAMPLES = """
> docs/settings.md"""


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'Print every setting with its default, its range and what it means, in Markdown.'
    add_command(commands, 'settings', run, summary, EXAMPLES)


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    from socialnav_core.config.page import settings_page

    print(settings_page(), end='')
