"""Definitions of ROS 2 messages, so that a bag can be written where there is no ROS."""

from functools import cache
from importlib.resources import files

SEPARATOR = '=' * 80
"""Between a definition and those of the types in it, as bags want it."""


@cache
def definitions() -> dict[str, str]:
    """Return the fields of each type in ros2msg.txt, by `package/Type`."""
    text = files('socialnav_core.viewing').joinpath('ros2msg.txt').read_text()
    blocks = (block.split('\n', 1) for block in text.split('MSG: ')[1:])
    return {kind: fields.strip() for kind, fields in blocks}


def schema_of(kind: str) -> str:
    """Return the definition of a message, `package/Type`, with those of all types in it."""
    known = definitions()
    wanted = [kind]
    for name in wanted:  # grows while it is read
        fields = (line.split()[0].split('[')[0] for line in known[name].splitlines())
        wanted += [field for field in dict.fromkeys(fields) if field in known.keys() - {*wanted}]
    first, *others = wanted
    parts = [known[first], *(f'MSG: {name}\n{known[name]}' for name in others)]
    return f'\n{SEPARATOR}\n'.join(parts) + '\n'
