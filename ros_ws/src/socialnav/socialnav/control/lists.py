"""Lists of agents that several publishers tell on one topic: the newest of each."""

from collections import Counter
from collections.abc import Sequence
import dataclasses
from typing import Any

from socialnav.messages.sources import node_of
from socialnav.messages.stamps import nanoseconds_of
from socialnav.messages.unread import content, Unread

MOST = 16
"""Number of publishers from which on somebody changes its name all the time."""


@dataclasses.dataclass
class Told:
    """The newest list of a publisher."""

    message: Any
    """The list; it may be unread."""
    first: int
    """Number of the first message that came from there."""
    latest: int
    """Number of the newest."""
    replaced: bool = False
    """Whether the list is that of a process that has been started anew since."""


class Lists:
    """
    What each publisher of a topic told last.

    A node that is started anew speaks under its old name as another process: what the former told
    is forgotten when it is too old, or when the former has left the graph. Of two processes of
    one name that speak in turn both count.
    """

    def __init__(self, topic: str) -> None:
        """Start without a list."""
        self.topic = topic
        self._told: dict[str, Told] = {}
        self._count = 0
        self._publishers: tuple[str, ...] = ()

    def store(self, source: str, message: Any) -> None:
        """
        Keep a list in place of the earlier one from there.

        :param source: who says it; empty for who does not tell.
        """
        self._count += 1
        former = self._told.pop(source, None)
        first = self._count if former is None else former.first
        self._told[source] = Told(message, first, self._count)
        if len(self._told) > MOST + 1:
            del self._told[next(iter(self._told))]

    def newest(self) -> Any:
        """Return the list that came last; None where there is none or it cannot be read."""
        return self._read(next(reversed(self._told.values()))) if self._told else None

    def all(self) -> list[Any]:
        """Return every list that counts; None in place of one that cannot be read."""
        self._disown()
        return [self._read(told) for told in self._told.values() if not told.replaced]

    def hear_of(self, publishers: Sequence[str]) -> None:
        """
        Take note of who publishes; forget processes that are gone while others go on.

        :param publishers: full names of their nodes.
        """
        self._publishers = tuple(publishers)
        for node, count in Counter(publishers).items():
            processes = [source for source in self._told if source and node_of(source) == node]
            for source in processes[: max(len(processes) - count, 0)]:  # the longest silent
                del self._told[source]
        named = Counter(node_of(source) for source in self._told if source)
        if publishers and not Counter(publishers) - named:  # whoever gave no name has left
            self._told.pop('', None)

    def complaint(self) -> str | None:
        """Return why not everybody who speaks is heard, or None."""
        if len(self._told) > MOST:
            return f'{self.topic}: lists of more than {MOST} sources'
        unheard, foreign = self._unheard()
        nameless = '' in self._told
        if unheard.total() <= foreign + nameless:
            return None
        names = ', '.join(sorted(unheard)[:MOST])
        if nameless:
            return f'{self.topic}: several publishers do not fill in their source: {names}'
        return f'{self.topic}: no list yet from {names}'

    def ages(self, now: int, timeout: float) -> list[tuple[str, float]]:
        """
        Return which node tells each list and how old that is, s; what cannot be read has no age.

        :param now: ns, on the clock of the stamps.
        :param timeout: age at which the list of a process that was started anew is forgotten, s;
            0: none.
        """
        ages = []
        for source, told in self._told.items():
            message = self._read(told)
            if message is None:
                continue
            age = (now - nanoseconds_of(message.header.stamp)) * 1e-9
            told.replaced = age > timeout > 0 and self._has_successor(source, told)
            if not told.replaced:
                ages.append((node_of(source), age))
        return ages

    def _read(self, told: Told) -> Any:
        """Return a list, read if it was not."""
        if isinstance(told.message, Unread):
            told.message = content(told.message)
        return told.message

    def _disown(self) -> None:
        """
        Take what cannot be read, and names a node that does not publish, for nobody's.

        Its name may be as wrong as the rest of it; it would count for ever under that.
        """
        for source, told in list(self._told.items()):
            if source and node_of(source) not in self._publishers and self._read(told) is None:
                nameless = self._told.get('', told)
                del self._told[source]
                self._told[''] = max(told, nameless, key=lambda one: one.latest)
        self._told = dict(sorted(self._told.items(), key=lambda pair: pair[1].latest))

    def _has_successor(self, source: str, told: Told) -> bool:
        """Return whether another process of the same node began after the last word of one."""
        node = node_of(source)
        return any(
            node == node_of(other) and source and one.first > told.latest
            for other, one in self._told.items()
        )

    def _unheard(self) -> tuple[Counter[str], int]:
        """Return publishers of whom there is no list, and the number of lists of others."""
        processes = Counter(node_of(source) for source in self._told if source)
        publishers = Counter(self._publishers)
        return publishers - processes, (processes - publishers).total()
