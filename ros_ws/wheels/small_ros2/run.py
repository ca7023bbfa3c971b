"""`ros2 run`: replace this process by an executable of a package."""

import argparse
import os
from pathlib import Path
import sys

from small_ros2.command import CommandError


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the group."""
    parser.add_argument('package_name', help='name of the package')
    parser.add_argument('executable_name', help='name of its executable')
    parser.add_argument('argv', nargs=argparse.REMAINDER, help='arguments of the executable')
    parser.set_defaults(command=run)


def run(options: argparse.Namespace) -> None:
    """Become the executable: signals reach it, and the shell sees its exit status."""
    path = executable(package_prefix(options.package_name), options)
    sys.stdout.flush()
    try:
        os.execv(path, [str(path), *options.argv])
    except OSError as error:
        raise CommandError(f'{path} cannot be started: {error.strerror}') from error


def package_prefix(package: str) -> Path:
    """
    Return the folder that a package is installed in.

    :raises CommandError: when no sourced workspace has it.
    """
    for prefix in filter(None, os.environ.get('AMENT_PREFIX_PATH', '').split(os.pathsep)):
        marker = Path(prefix) / 'share' / 'ament_index' / 'resource_index' / 'packages' / package
        if package and marker.is_file():
            return Path(prefix)
    raise CommandError(f"Package '{package}' not found")


def executable(prefix: Path, options: argparse.Namespace) -> Path:
    """
    Return the path of an executable; of several in subfolders none is chosen.

    :raises CommandError: when there is not exactly one.
    """
    folder = prefix / 'lib' / options.package_name
    found = [
        Path(root) / options.executable_name
        for root, _, files in os.walk(folder)
        if options.executable_name in files
        and os.access(Path(root) / options.executable_name, os.X_OK)
    ]
    if not found:
        raise CommandError('No executable found')
    if len(found) > 1:
        raise CommandError('\n- '.join(['Multiple executables found:', *map(str, sorted(found))]))
    return found[0]
