"""YAML as settings are written in: small, shallow, and every mistake told with its line."""

from collections.abc import Iterator, Mapping
import contextlib
from pathlib import Path
import stat
from typing import Any

import yaml

from socialnav_core.config.ranges import ConfigError, shown

LARGEST_FILE = 2**20
"""A file of settings is not larger than this, bytes."""
DEEPEST = 20
"""Lists and mappings are not nested deeper than this."""
MISTAKES = (ValueError, IndexError, TypeError, OverflowError, AttributeError, KeyError)
"""What PyYAML raises for values that do not fit their tag, such as `!!int ""`."""


class SettingsLoader(yaml.SafeLoader):
    """
    Reads plain values only.

    An alias could make a short text stand for a huge value, and of a key that is there twice the
    first value would be lost without a word: both are refused.
    """

    depth = 0

    def compose_node(self, parent: Any, index: Any) -> Any:
        """Return the next node of the tree."""
        event = self.peek_event()  # type: ignore[no-untyped-call]
        if isinstance(event, yaml.AliasEvent):
            raise mistake('aliases are not read; write the value out', event)
        if self.depth >= DEEPEST:
            raise mistake(f'nested deeper than {DEEPEST} levels', event)
        self.depth += 1
        node = super().compose_node(parent, index)  # type: ignore[no-untyped-call]
        self.depth -= 1
        return node

    def construct_object(self, node: Any, deep: bool = False) -> Any:
        """Return the value of a node."""
        try:
            return super().construct_object(node, deep)  # type: ignore[no-untyped-call]
        except MISTAKES as error:
            kind = str(node.tag).rpartition(':')[2]
            raise mistake(f'{shown(getattr(node, "value", ""))} is no {kind}', node) from error

    def construct_mapping(self, node: Any, deep: bool = False) -> Any:
        """Return the mapping of a node whose keys are all different."""
        keys = set()
        for key, _ in node.value:
            if key.value in keys and isinstance(key, yaml.ScalarNode):
                raise mistake(f'{shown(key.value)} is set twice', key)
            keys.add(key.value if isinstance(key, yaml.ScalarNode) else id(key))
        return super().construct_mapping(node, deep)


def mistake(problem: str, place: Any) -> yaml.MarkedYAMLError:
    """
    Return the error for something in a document.

    :param place: a node or an event.
    """
    return yaml.MarkedYAMLError(problem=problem, problem_mark=place.start_mark)


def parse_yaml(text: str, where: str) -> Any:
    """
    Return the value that a YAML text holds.

    :param where: what the text is, for messages: a file or an option.
    :raises ConfigError: when it holds none.
    """
    try:
        return yaml.load(text, SettingsLoader)  # noqa: S506, a SafeLoader
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line = f', line {mark.line + 1}' if mark and '\n' in text.strip() else ''
        problem = ' '.join(str(error.problem or error.context).split())
        raise ConfigError(f'{where}{line}: {problem[:200]}') from error
    except (yaml.YAMLError, *MISTAKES) as error:
        raise ConfigError(f'{where}: {" ".join(str(error).split())[:200]}') from error


def read_yaml(path: Path) -> dict[str, Any]:
    """
    Return the mapping that a YAML file holds.

    :raises ConfigError: when it cannot be read or holds no mapping.
    """
    values = parse_yaml(read_text(path), str(path))
    if not isinstance(values, dict):
        raise ConfigError(f'{path} must hold a mapping of settings')
    return values


def read_text(path: Path) -> str:
    """
    Return the text of a file of settings.

    :raises ConfigError: when it is no plain file, too large or no text.
    """
    try:
        status = path.stat()
        if not stat.S_ISREG(status.st_mode):  # a device or a pipe might never end
            raise ConfigError(f'{path} is no file')
        if status.st_size > LARGEST_FILE:
            raise ConfigError(f'{path} is larger than {LARGEST_FILE >> 20} MiB: no settings')
        return path.read_text(encoding='utf-8')
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, 'strerror', None) or 'it is no UTF-8 text'
        raise ConfigError(f'{path} cannot be read: {reason}') from error


@contextlib.contextmanager
def told_with_place(path: Path, assignments: Mapping[str, Any]) -> Iterator[None]:
    """
    Let an error about a setting name the file, and the line, that it was made in.

    :param assignments: settings that did not come from the file, by dotted name.
    """
    try:
        yield
    except ConfigError as error:
        if error.key in assignments:
            raise
        line = line_of(path, error.key)
        place = f'{path}, line {line}' if line else f'{path}'
        raise ConfigError(f'{place}: {error}', error.key) from error


def line_of(path: Path, key: str) -> int | None:
    """Return the line of a file that sets a key, counted from 1; None where there is none."""
    if not key:
        return None
    try:
        node = yaml.compose(read_text(path), SettingsLoader)
    except (ConfigError, yaml.YAMLError):
        return None
    line = None
    for section in key.split('.'):
        pairs = node.value if isinstance(node, yaml.MappingNode) else ()
        found = [pair for pair in pairs if pair[0].value == section]
        if not found:
            break
        line, node = found[0][0].start_mark.line + 1, found[0][1]
    return line
