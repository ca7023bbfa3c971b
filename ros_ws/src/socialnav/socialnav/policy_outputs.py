"""What the policy node publishes about its decisions."""

from collections.abc import Callable
import time

from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Path
from rclpy.duration import Duration
from rclpy.lifecycle import LifecycleNode
from std_msgs.msg import Bool, String
from visualization_msgs.msg import MarkerArray

from socialnav import qos
from socialnav.control.announcer import Announcer
from socialnav.control.controller import Controller, Decision, NO_COMMAND
from socialnav.control.plan import FOLLOWED, NO_PLAN
from socialnav.control.reasons import ARRIVED, DRIVING, UNDECIDED
from socialnav.messages.filling import filled
from socialnav_core.messages import (
    attention_markers,
    planned_path,
    predicted_path,
    stamped_twist,
    twist,
)

STANDING = 'standing'
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
        self.concern: str | None = None
        self.goal_reached: bool | None = None
        self.latest_command = 0.0
        self.spokesman = Announcer(self.log)
        self.on_plan = Announcer(node.get_logger().warning)
        self.base_frame = controller.settings.base_frame
        self.lockstep = controller.settings.lockstep
        self.stamped = controller.settings.stamped
        create = node.create_lifecycle_publisher
        self.commands = create(TwistStamped if self.stamped else Twist, 'cmd_vel', qos.COMMAND)
        self.arrivals = create(Bool, '~/goal_reached', qos.GOAL_REACHED)
        self.states = create(String, '~/state', qos.STATE)
        self.attention = create(MarkerArray, '~/attention', qos.ATTENTION)
        self.path = create(Path, '~/predicted_path', qos.PREDICTED_PATH)

    def begin(self) -> None:
        """Tell everything anew."""
        self.reason, self.concern, self.goal_reached = UNDECIDED, None, None

    def end(self) -> None:
        """Stop the robot: a zero command is the last one."""
        self.send(Decision(NO_COMMAND))
        self.commands.wait_for_all_acked(LAST_WORD)

    def close(self) -> None:
        """Give up the topics."""
        everything = (self.commands, self.arrivals, self.states, self.attention, self.path)
        for publisher in everything:
            self.node.destroy_lifecycle_publisher(publisher)

    def publish(self, decision: Decision) -> None:
        """Publish a command, and say why the robot stands."""
        if decision.publish:
            self.send(decision)
        self.report(decision.reason, decision.concern)
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

    def report(self, reason: str | None, concern: str | None = None) -> None:
        """
        Say what the robot does, when that changes.

        :param reason: why it stands; None while it drives.
        :param concern: what is wrong though it drives.
        """
        changed = (reason, concern) != (self.reason, self.concern)
        self.reason, self.concern = reason, concern
        self.spokesman.tell(self.state, aloud=self.state != DRIVING)
        if changed:
            self.states.publish(String(data=self.state))
            self.on_change()

    @property
    def trouble(self) -> str | None:
        """Return why the robot stands, or what is wrong though it drives; None if nothing."""
        return self.reason or self.concern

    @property
    def state(self) -> str:
        """Return what the robot does, in words."""
        if self.reason in (None, ARRIVED):
            return self.reason or self.concern or DRIVING
        return f'{STANDING}: {self.reason}'

    def log(self, state: str) -> None:
        """Write a line about what the robot does."""
        logger = self.node.get_logger()
        if state in (DRIVING, ARRIVED):  # rclpy raises where one call logs at two severities
            logger.info(state)
        else:
            logger.warning(state)

    def report_plan(self, note: str) -> None:
        """Say why a plan is not followed, when that changes."""
        if note == FOLLOWED:
            self.on_plan.tell('the plan is followed', aloud=False)
        elif note != NO_PLAN:
            self.on_plan.tell(f'plan {note}; heading for the goal itself')

    def send(self, decision: Decision) -> None:
        """Publish a command as the type that is wanted."""
        kind, content = Twist, twist(decision.command, self.controller.settings.kinematics)
        content['angular']['z'] += decision.turn_rate
        if self.stamped:
            now = self.node.get_clock().now().nanoseconds
            stamp = decision.stamp if self.lockstep else now
            kind, content = TwistStamped, stamped_twist(content, stamp, self.base_frame)
        self.commands.publish(filled(kind, content))
        self.latest_command = time.monotonic()
