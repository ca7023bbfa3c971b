"""The node that drives a robot: odometry, pedestrians, obstacles and a goal in, velocity out."""

from functools import partial
import sys

from geometry_msgs.msg import PoseStamped, Twist, TwistStamped
from nav_msgs.msg import Odometry
from rclpy.duration import Duration
from rclpy.node import Node
from std_msgs.msg import Bool

from socialnav import qos
from socialnav.commands import stamped_twist_message, twist_message
from socialnav.controller import ARRIVED, Controller, Decision, NO_COMMAND
from socialnav.controller_settings import controller_settings
from socialnav.models import ready_policy
from socialnav.parameters import declare, POLICY_PARAMETERS
from socialnav.running import run
from socialnav.watchdog import Watchdog
from socialnav_msgs.msg import AgentStates

LAST_WORD = Duration(nanoseconds=500_000_000)
"""How long the node waits at its end for the last command to arrive."""


class PolicyNode(Node):
    """Stores what comes in, decides at each tick or complete state, publishes the command."""

    def __init__(self) -> None:
        """
        Load the model and start.

        :raises ValueError: a parameter or a model that cannot be used.
        """
        super().__init__('policy_node')
        self.values = declare(self, POLICY_PARAMETERS)
        self.add_post_set_parameters_callback(self.on_parameters)
        settings = controller_settings(self.values)
        self.lockstep = settings.lockstep
        self.stamped = settings.lockstep or self.values['enable_stamped_cmd_vel']
        self.controller = Controller(ready_policy(self.values, settings), settings)
        self.reason: str | None = None
        self.goal_reached: bool | None = None
        self.create_outputs()
        self.create_inputs()
        self.watchdog = None
        if not self.lockstep:
            self.create_timer(settings.period, self.on_tick)
            self.watchdog = Watchdog(settings.stall_timeout, self.on_stall)

    def create_outputs(self) -> None:
        """Make the publishers."""
        kind = TwistStamped if self.stamped else Twist
        self.commands = self.create_publisher(kind, 'cmd_vel', qos.COMMAND)
        self.arrivals = self.create_publisher(Bool, '~/goal_reached', qos.GOAL_REACHED)

    def create_inputs(self) -> None:
        """Make the subscriptions."""
        moving = qos.LOCKSTEP_INPUT if self.lockstep else qos.SENSOR_INPUT
        for name, kind, profile in (
            ('odom', Odometry, moving),
            ('pedestrians', AgentStates, moving),
            ('obstacles', AgentStates, qos.OBSTACLES),
            ('goal_pose', PoseStamped, qos.GOAL),
        ):
            self.create_subscription(kind, name, partial(self.on_input, name), profile)

    def on_parameters(self, parameters: list) -> None:
        """
        Use parameters that were changed.

        :param parameters: of rclpy.
        """
        self.values.update({one.name: one.value for one in parameters})
        self.controller.settings = controller_settings(self.values)
        if self.watchdog is not None:
            self.watchdog.timeout = self.controller.settings.stall_timeout

    def on_input(self, name: str, message: Odometry | AgentStates | PoseStamped) -> None:
        """
        Store a message; in lockstep, decide when it completes a state.

        :param name: its topic.
        :param message: the input.
        """
        self.controller.store(name, message)
        if self.lockstep and self.controller.take_complete_state():
            self.on_tick()

    def on_tick(self) -> None:
        """Decide."""
        self.publish(self.controller.decide(self.get_clock().now().nanoseconds))
        if self.watchdog is not None:
            self.watchdog.feed()

    def on_stall(self) -> None:
        """Stop the robot, in the watchdog's thread, while nothing else can."""
        self.publish(self.controller.stall())

    def publish(self, decision: Decision) -> None:
        """
        Publish a command, and say why the robot stands.

        :param decision: the command and its reason.
        """
        if decision.publish:
            self.send(decision)
        self.report(decision.reason)
        if self.goal_reached != self.controller.goal_reached:
            self.goal_reached = self.controller.goal_reached
            self.arrivals.publish(Bool(data=self.goal_reached))

    def report(self, reason: str | None) -> None:
        """
        Say why the robot stands, when that changes.

        :param reason: None while it drives.
        """
        if reason == ARRIVED != self.reason:
            self.get_logger().info(reason)
        elif reason not in (None, self.reason):
            self.get_logger().warning(f'standing: {reason}', throttle_duration_sec=1.0)
        self.reason = reason

    def send(self, decision: Decision) -> None:
        """
        Publish a command as the type that is wanted.

        :param decision: the command and, in lockstep, the state that it answers.
        """
        message = twist_message(decision.command, self.controller.settings.kinematics)
        if self.stamped:
            now = self.get_clock().now().nanoseconds
            stamp = decision.stamp if self.lockstep else now
            message = stamped_twist_message(message, stamp, self.values['base_frame'])
        self.commands.publish(message)

    def close(self) -> None:
        """Stop the robot: a zero command is the last one."""
        if self.watchdog is not None:
            self.watchdog.stop()
        self.send(Decision(NO_COMMAND))
        self.commands.wait_for_all_acked(LAST_WORD)


def main() -> None:
    """Run the node."""
    sys.exit(run(PolicyNode))
