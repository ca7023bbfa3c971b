"""Parameters on the command line that are for another node than the one that is started."""

from collections.abc import Iterator
import itertools
from pathlib import Path
import re
from typing import Any

import yaml

VALUES = 'ros__parameters'
"""What marks the name before it, in a file of parameters, as that of a node."""
SHARED = '/**'
"""Every node."""
DEFAULTS = 'what it does not say has the default'


def unheard(arguments: list[str], node: str) -> list[str]:
    """
    Return a line for each file or parameter that tells a node nothing.

    :param arguments: of the program.
    :param node: its full name.
    """
    complaints = []
    for option, value in itertools.pairwise(ros_arguments(arguments)):
        if option == '--params-file':
            told, names = f'parameter file {value}', named_in(Path(value))
        elif option in ('-p', '--param') and ':' in (before := value.partition(':=')[0]):
            told, names = f'-p {value}', {absolute(before.rpartition(':')[0])}
        else:
            continue
        if not any(is_meant(name, node) for name in names):
            others = ', '.join(sorted(names)) or 'nobody'
            complaints.append(f'{told} is for {others}, not for {node}: {DEFAULTS}')
    return complaints


def ros_arguments(arguments: list[str]) -> Iterator[str]:
    """Yield the arguments between --ros-args and --."""
    ours = False
    for one in arguments:
        if one in ('--ros-args', '--'):
            ours = one == '--ros-args'
        elif ours:
            yield one


def named_in(path: Path) -> set[str]:
    """Return the nodes that a file of parameters names; rcl has refused one that is none."""
    try:
        content = yaml.safe_load(path.read_text())
    except (OSError, ValueError, yaml.YAMLError):
        return {SHARED}
    return set(names_below('', content))


def names_below(way: str, content: Any) -> Iterator[str]:
    """Yield the names below a namespace."""
    for key, value in content.items() if isinstance(content, dict) else ():
        if key == VALUES:
            yield absolute(way)
        else:
            yield from names_below(f'{way}/{str(key).lstrip("/")}', value)


def absolute(name: str) -> str:
    """Return a name from the root."""
    return '/' + name.lstrip('/')


def is_meant(name: str, node: str) -> bool:
    """
    Return whether a name in a file, with wildcards, is that of a node.

    :param node: its full name.
    """
    pattern = re.escape(name).replace(r'/\*\*', r'(/\w+)*').replace(r'/\*', r'(/\w+)')
    return re.fullmatch(pattern, node) is not None
