"""What operators see of a node that answers what is measured."""

import time

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from rclpy.clock import Clock, ClockType
from rclpy.node import Node

from socialnav import qos
from socialnav.messages.stamps import header_message
from socialnav.messages.texts import cut

PERIOD = 1.0
"""Time between two diagnoses, s."""
SILENCE = 2.0
"""Time without an answer that is told, s."""


class Health:
    """Logs what cannot be used, and publishes every second how the node is."""

    def __init__(self, node: Node) -> None:
        """Begin to publish."""
        self.node = node
        self.problems: dict[str, str] = {}
        self.note: str | None = None
        self.answers, self.refusals = 0, 0
        self.answered = -SILENCE
        self.publisher = node.create_publisher(DiagnosticArray, '/diagnostics', qos.DIAGNOSTICS)
        node.create_timer(PERIOD, self.diagnose, clock=Clock(clock_type=ClockType.STEADY_TIME))

    def good(self, source: str) -> None:
        """Forget what was wrong with a source of measurements."""
        self.problems.pop(source, None)

    def answer(self) -> None:
        """Count an answer."""
        self.answers += 1
        self.answered = time.monotonic()

    def bad(self, source: str, reason: str) -> None:
        """Say why what a source measured cannot be used."""
        self.problems[source] = cut(reason)
        self.refusals += 1
        self.node.get_logger().warning(cut(reason), throttle_duration_sec=1.0)

    def advise(self, note: str | None) -> None:
        """Say what should be set otherwise, when that changes; None for nothing."""
        if note is not None and self.note is None:
            self.node.get_logger().warning(note)
        self.note = note

    def words(self) -> str | None:
        """Return what is wrong, or None."""
        if self.problems:
            return '; '.join(self.problems.values())
        if time.monotonic() - self.answered > SILENCE:
            return 'nothing to answer'
        return self.note

    def diagnose(self) -> None:
        """Publish how the node is."""
        words = self.words()
        facts = {'answers': str(self.answers), 'refused': str(self.refusals)}
        status = DiagnosticStatus(
            level=DiagnosticStatus.OK if words is None else DiagnosticStatus.WARN,
            name=self.node.get_name(),
            message=words or 'working',
            values=[KeyValue(key=key, value=value) for key, value in facts.items()],
        )
        now = self.node.get_clock().now().nanoseconds
        message = DiagnosticArray(header=header_message(now, ''), status=[status])
        self.publisher.publish(message)
