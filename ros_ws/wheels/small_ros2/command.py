"""The command line: a module for each group, imported only when its group is called."""

import argparse
from importlib import import_module
import os
import signal
import sys

GROUPS = {
    'lifecycle': 'list managed nodes, show and change their states',
    'node': 'list the nodes of the graph, show what one offers and uses',
    'param': 'list, print, change, describe, dump and load parameters',
    'run': 'run an executable of a package',
    'service': 'list and call services',
    'topic': 'list, describe, print, measure and publish topics',
}
"""What each group does, by the name of its module, which has add_arguments(parser)."""

ABOUT = """\
A small stand-in for ros2cli, which is not among the ROS wheels. It knows the commands below,
spelled as ros2cli spells them. Where ROS 2 is installed, source that, and use its own ros2.
"""


class CommandError(Exception):
    """What the user asked for cannot be done; the text says why."""


def parse(arguments: list[str]) -> argparse.Namespace:
    """
    Return the parsed command line.

    :param arguments: without the name of the program.
    """
    parser = argparse.ArgumentParser(
        prog='ros2', description=ABOUT, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    groups = parser.add_subparsers(title='commands', metavar='GROUP', required=True)
    for name, summary in GROUPS.items():
        group = groups.add_parser(name, help=summary, description=f'{summary.capitalize()}.')
        if name in arguments[:1]:
            import_module(f'small_ros2.{name}').add_arguments(group)
    return parser.parse_args(arguments)


def main() -> int:
    """Run the command that was typed and return its exit status, which is ros2cli's."""
    sys.stdout.reconfigure(line_buffering=True)
    try:
        options = parse(sys.argv[1:])
        options.command(options)
    except CommandError as error:
        print(error, file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return int(signal.SIGINT)
    except BrokenPipeError:
        # Whoever read the output has gone; Python would complain when it flushes at the end.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 0
