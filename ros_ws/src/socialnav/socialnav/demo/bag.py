"""What was heard on topics as a ROS 2 bag (MCAP), without rosbag2, which has no wheels."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from mcap.well_known import Profile, SchemaEncoding
from mcap.writer import Writer
from rclpy.serialization import serialize_message

from socialnav.messages.stamps import nanoseconds_of
from socialnav_core.viewing.bag import full_name
from socialnav_core.viewing.ros2msg import schema_of


class Bag:
    """A bag that is being written; messages are kept by the time of their stamps."""

    def __init__(self, writer: Writer) -> None:
        """
        Begin without a topic.

        :param writer: of the file; it has been started.
        """
        self._writer = writer
        self._channels: dict[str, int] = {}
        self._latest = 0

    def write(self, topic: str, message: Any) -> None:
        """
        Add a message.

        :param message: of a type that socialnav_core has the definition of.
        """
        if topic not in self._channels:
            self._channels[topic] = self._channel(topic, type(message))
        self._latest = stamp_of(message) or self._latest
        self._writer.add_message(
            self._channels[topic], self._latest, serialize_message(message), self._latest
        )

    def _channel(self, topic: str, kind: type) -> int:
        """Return the number of a new topic."""
        name = f'{kind.__module__.split(".")[0]}/{kind.__name__}'
        text = schema_of(name).encode()
        schema = self._writer.register_schema(full_name(name), SchemaEncoding.ROS2, text)
        return self._writer.register_channel(topic, 'cdr', schema)


def stamp_of(message: Any) -> int | None:
    """Return the time of a message or of its markers, ns, or None where it has none."""
    stamped = message.markers[0] if getattr(message, 'markers', None) else message
    header = getattr(stamped, 'header', None)
    return None if header is None else nanoseconds_of(header.stamp)


@contextmanager
def open_bag(path: Path) -> Iterator[Bag]:
    """
    Open a bag for writing; the file is there when all went well, and not at all otherwise.

    :param path: of the file, whose folder exists.
    :raises OSError: it cannot be written.
    """
    temporary = path.with_name(f'.{path.stem}.part{path.suffix}')
    try:
        with temporary.open('wb') as file:
            writer = Writer(file)
            writer.start(profile=Profile.ROS2, library='socialnav')
            yield Bag(writer)
            writer.finish()
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)
