"""What the policy node publishes about its decisions."""

from collections.abc import Callable
import contextlib
import time

from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Path
from rclpy.duration import Duration
from rclpy.lifecycle import LifecycleNode
from std_msgs.msg import Bool
from visualization_msgs.msg import MarkerArray

from socialnav import qos
from socialnav.control.controller import Controller, Decision, NO_COMMAND
from socialnav.control.plan import FOLLOWED, NO_PLAN
from socialnav.control.reasons import ARRIVED, UNDECIDED
from socialnav.messages.filling import filled
from socialnav_core.messages import (
    attention_markers,
    planned_path,
    predicted_path,
    stamped_twist,
    twist,
)

LAST_WORD = Duration(nanoseconds=500_000_000)
"""How long it is waited at the end for the last command to arrive."""


class PolicyOutputs:
    """Publishers, silent unless the node is active, and what they have told already."""

    def __init__(
        self, node: LifecycleNode, controller: Controller, on_change: Callable[[], None]
    ) -> None:
        """
        Make the publishers.

        :param on_change: called when the reason for standing is another one.
        """
        self.node = node
        self.controller = controller
        self.on_change = on_change
        self.reason: str | None = UNDECIDED
        self.goal_reached: bool | None = None
        self.latest_command = 0.0
        self.plan_note = NO_PLAN
        self.base_frame = controller.settings.base_frame
        self.lockstep = controller.settings.lockstep
        self.stamped = controller.settings.stamped
        create = node.create_lifecycle_publisher
        self.commands = create(TwistStamped if self.stamped else Twist, 'cmd_vel', qos.COMMAND)
        self.arrivals = create(Bool, '~/goal_reached', qos.GOAL_REACHED)
        self.attention = create(MarkerArray, '~/attention', qos.ATTENTION)
        self.path = create(Path, '~/predicted_path', qos.PREDICTED_PATH)

    def begin(self) -> None:
        """Tell everything anew."""
        self.reason, self.goal_reached = UNDECIDED, None

    def end(self) -> None:
        """Stop the robot: a zero command is the last one."""
        self.send(Decision(NO_COMMAND))
        self.commands.wait_for_all_acked(LAST_WORD)

    def close(self) -> None:
        """Give up the topics."""
        for publisher in (self.commands, self.arrivals, self.attention, self.path):
            self.node.destroy_lifecycle_publisher(publisher)

    def publish(self, decision: Decision) -> None:
        """Publish a command, and say why the robot stands."""
        if decision.publish:
            self.send(decision)
        self.report(decision.reason)
        self.report_plan(self.controller.plan.note)
        if self.goal_reached != self.controller.goal_reached:
            self.goal_reached = self.controller.goal_reached
            self.arrivals.publish(Bool(data=self.goal_reached))
        if decision.reason is None:
            self.show()

    def show(self) -> None:
        """Publish what the policy looks at and is about to do, where somebody listens."""
        intention, settings = self.controller.intention, self.controller.settings
        now, frame = self.node.get_clock().now().nanoseconds, settings.planning_frame
        if intention is None:
            return
        if self.path.get_subscription_count():
            if intention.plan is not None:
                path = planned_path(intention.state, intention.plan, now, frame)
            else:
                motion = (intention.state, intention.command, settings.kinematics)
                path = predicted_path(*motion, now, frame)
            self.path.publish(filled(Path, path))
        if self.attention.get_subscription_count():
            weights = self.controller.attention()
            if weights is not None:
                markers = attention_markers(intention.state, weights, now, frame)
                self.attention.publish(filled(MarkerArray, markers))

    def rivals(self) -> list[str]:
        """Return the other publishers of commands, by their nodes."""
        ends = self.node.get_publishers_info_by_topic(self.commands.topic_name)
        names = [f'{one.node_namespace.rstrip("/")}/{one.node_name}' for one in ends]
        with contextlib.suppress(ValueError):
            names.remove(self.node.get_fully_qualified_name())
        return sorted(names)

    def report(self, reason: str | None) -> None:
        """Say why the robot stands, when that changes; the reason is None while it drives."""
        if reason == ARRIVED != self.reason:
            self.node.get_logger().info(reason)
        elif reason not in (None, self.reason):
            self.node.get_logger().warning(f'standing: {reason}', throttle_duration_sec=1.0)
        if reason != self.reason:
            self.reason = reason
            self.on_change()

    def report_plan(self, note: str) -> None:
        """Say why a plan is not followed, when that changes."""
        if note not in (NO_PLAN, FOLLOWED, self.plan_note):
            text = f'{note}; heading for the goal itself'
            self.node.get_logger().warning(text, throttle_duration_sec=1.0)
        self.plan_note = note

    def send(self, decision: Decision) -> None:
        """Publish a command as the type that is wanted."""
        kind, content = Twist, twist(decision.command, self.controller.settings.kinematics)
        if self.stamped:
            now = self.node.get_clock().now().nanoseconds
            stamp = decision.stamp if self.lockstep else now
            kind, content = TwistStamped, stamped_twist(content, stamp, self.base_frame)
        self.commands.publish(filled(kind, content))
        self.latest_command = time.monotonic()
