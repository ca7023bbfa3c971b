"""What a configured policy node does: inputs are stored, the timer decides."""

from collections.abc import Callable
import dataclasses
from functools import partial
import time
from typing import Any

from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import OccupancyGrid, Odometry, Path
from rclpy.lifecycle import LifecycleNode
from rclpy.qos import QoSProfile
from rclpy.subscription import Subscription
from rclpy.timer import Timer
from std_srvs.srv import Trigger

from socialnav import qos
from socialnav.control.controller import Controller
from socialnav.control.diagnostics import controller_facts
from socialnav.control.models import named_model, ready_policy
from socialnav.control.settings import controller_settings
from socialnav.control.speed_limit import limited, NO_LIMIT, SpeedLimit
from socialnav.messages.frames import not_asked
from socialnav.messages.reading import READERS
from socialnav.messages.transforms import Transforms
from socialnav.messages.unread import Unread
from socialnav.nav2.interface import is_installed, Nav2Interface
from socialnav.neighbours import concerns_of_base, concerns_of_input, rivals
from socialnav.parameters.policy import PolicyParameters
from socialnav.policy_outputs import PolicyOutputs
from socialnav.realtime.alarm import Alarm
from socialnav.realtime.clocks import pacing_clock
from socialnav.realtime.punctuality import Punctuality
from socialnav.realtime.watchdog import Watchdog
from socialnav.speakers import Speakers
from socialnav_msgs.msg import AgentStates

GOALS = ('goal_pose', 'plan')
"""Inputs that a path of follow_path takes the place of."""
NOBODY = 'goal_topics is false and nav2_msgs is not installed: nobody can give the robot a goal'


@dataclasses.dataclass(frozen=True)
class Pace:
    """What makes a driver in real time act while it drives."""

    timer: Timer
    """Calls for each decision."""
    expiry: Alarm
    """Rings when an input becomes too old."""
    watchdog: Watchdog
    """Barks when decisions stay away."""


class Driver:
    """Stores what comes in, decides at each tick or complete state, publishes the command."""

    def __init__(
        self, node: LifecycleNode, parameters: PolicyParameters, on_change: Callable[[], None]
    ) -> None:
        """
        Load the model and listen.

        :param on_change: called when the reason for standing is another one.
        :raises ValueError: parameters or a model that cannot be used.
        """
        self.made_for = self.parameters = parameters
        if not (parameters.goal_topics or is_installed()):
            raise ValueError(NOBODY)
        self.limit = NO_LIMIT
        settings = controller_settings(parameters)
        self.transforms = Transforms(node)
        locate = not_asked if settings.lockstep else self.transforms.locate
        self.controller = Controller(ready_policy(settings), settings, locate=locate)
        self.running = False
        self.lockstep = settings.lockstep
        self.node = node
        self.pace: Pace | None = None
        self.punctuality = Punctuality(settings.period)
        self.outputs = PolicyOutputs(node, self.controller, on_change)
        self.create_inputs()
        self.nav2: Nav2Interface | None = None
        if is_installed() and not settings.lockstep:
            self.nav2 = Nav2Interface(
                node, self.controller, self.outputs.publish, self.use_limit,
                in_place=not parameters.goal_topics,
            )  # fmt: skip

    def create_inputs(self) -> None:
        """Make the subscriptions."""
        moving = qos.LOCKSTEP_INPUT if self.lockstep else qos.SENSOR_INPUT
        inputs = [
            ('odom', Odometry, moving),
            ('pedestrians', AgentStates, moving),
            ('obstacles', AgentStates, qos.OBSTACLES_INPUT),
        ]
        if self.lockstep or self.made_for.goal_topics:
            inputs.append(('goal_pose', PoseStamped, qos.GOAL))
        if not self.lockstep and self.made_for.goal_topics:
            inputs.append(('plan', Path, qos.PLAN))
        if self.controller.settings.use_map:
            inputs.append(('map', OccupancyGrid, qos.MAP))
        self.subscriptions = {name: self.create_input(name, *rest) for name, *rest in inputs}
        heard = list(self.subscriptions.values())
        self.speakers = Speakers(self.node, heard, self.controller.hear_of)
        self.cancelling = self.node.create_service(Trigger, '~/cancel_goal', self.on_cancel)

    def create_input(self, name: str, kind: type, profile: QoSProfile) -> Subscription:
        """Make a subscription; what comes often, or is long, is not read until it is wanted."""
        raw = kind in READERS and not self.lockstep
        callback = partial(self.on_input, name)
        if raw:
            callback = partial(self.on_unread, name, READERS[kind])
        return self.node.create_subscription(kind, name, callback, profile, raw=raw)

    def start(self, parameters: PolicyParameters) -> None:
        """Begin to drive."""
        self.use(parameters)
        self.running = True
        self.outputs.begin()
        self.controller.progress.begin()
        if self.nav2 is not None:
            self.nav2.follower.start()
        if not self.lockstep:
            settings, clock = self.controller.settings, pacing_clock(self.node)
            self.punctuality = Punctuality(settings.period)
            self.pace = Pace(
                timer=self.node.create_timer(settings.period, self.on_timer, clock=clock),
                expiry=Alarm(self.node, self.on_expiry, clock),
                watchdog=Watchdog(settings.stall_timeout, self.on_stall),
            )

    def use(self, parameters: PolicyParameters) -> None:
        """Use other parameters from now on."""
        self.parameters = parameters
        self.controller.settings = limited(controller_settings(parameters), self.limit)
        if self.pace is not None:  # another watchdog, which has not been fed by that
            former, timeout = self.pace.watchdog, self.controller.settings.stall_timeout
            former.stop()
            watchdog = Watchdog(timeout, self.on_stall, former.fed)
            self.pace = dataclasses.replace(self.pace, watchdog=watchdog)

    def use_limit(self, limit: SpeedLimit) -> None:
        """Drive no faster than that from now on."""
        self.limit = limit
        self.controller.settings = limited(controller_settings(self.parameters), limit)

    def stop(self) -> None:
        """Stop the robot: a zero command is the last one."""
        if not self.running:
            return
        self.running = False
        if self.nav2 is not None:
            self.nav2.follower.stop()
        if self.pace is not None:
            self.pace.watchdog.stop()
            self.node.destroy_timer(self.pace.timer)
            self.pace.expiry.close()
            self.pace = None
        self.outputs.end()

    def close(self) -> None:
        """Stop the robot and give up all topics."""
        self.stop()
        if self.nav2 is not None:
            self.nav2.close()
        for subscription in self.subscriptions.values():
            self.node.destroy_subscription(subscription)
        self.outputs.close()
        self.node.destroy_service(self.cancelling)
        self.transforms.close()

    def on_input(self, name: str, message: Any) -> None:
        """Store a message; in lockstep, decide when it completes a state."""
        if name in GOALS and self.nav2 is not None and self.nav2.follower.task is not None:
            text = f'ignored: {name}: a path of follow_path is being followed'
            self.node.get_logger().warning(text, throttle_duration_sec=10.0)
            return
        self.controller.store(name, message)
        if self.lockstep and self.controller.take_complete_state():
            self.on_state()

    def on_unread(self, name: str, read: Callable[[bytes], Any], data: bytes) -> None:
        """Store a message as it came."""
        self.on_input(name, Unread(read, data))

    def on_cancel(self, _: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        """Forget the goal; answer whether there was one."""
        if self.lockstep:
            response.message = 'in lockstep every state has its goal'
            return response
        response.success = self.controller.cancel_goal()
        response.message = 'cancelled' if response.success else 'there is no goal'
        return response

    def on_state(self) -> None:
        """Decide in lockstep."""
        if self.running:
            now = self.node.get_clock().now().nanoseconds
            self.outputs.publish(self.controller.decide(now))

    def on_timer(self) -> None:
        """
        Decide, unless the driver stopped meanwhile.

        rclpy's executor calls a timer twice where another one is set, or simulated time goes on,
        between the moment when it is due and its call; that moves it on by two periods.
        """
        pace = self.pace
        if pace is None:
            return
        lateness = (pace.timer.timer_period_ns - pace.timer.time_until_next_call()) * 1e-9
        if lateness < 0.0:
            pace.timer.reset()
            return
        self.on_tick(pace, lateness)
        if self.outputs.reason is None:  # only now: while a tick is due no alarm may be set
            pace.expiry.set(self.controller.time_left(self.node.get_clock().now().nanoseconds))

    def on_tick(self, pace: Pace, lateness: float) -> None:
        """
        Decide in real time.

        :param lateness: how long ago the tick was due, s.
        """
        now = self.node.get_clock().now().nanoseconds
        moment = pace.timer.clock.now().nanoseconds * 1e-9
        self.punctuality.tick(time.monotonic(), lateness, moment)
        self.speakers.look()
        decision = self.controller.decide(now)
        self.outputs.publish(decision)
        pace.watchdog.feed()
        drives = decision.reason is None
        ages = self.controller.input_ages(now) if drives else {}  # else nobody has read them
        self.punctuality.command(self.outputs.latest_command, ages)
        if self.nav2 is not None:
            self.nav2.follower.tick(decision, now)

    def on_expiry(self) -> None:
        """Stop the robot when an input has become too old: the next tick may be a period away."""
        pace = self.pace
        if pace is None or self.outputs.reason is not None:
            return
        now = self.node.get_clock().now().nanoseconds
        left = self.controller.time_left(now)
        if left < 0:
            self.outputs.publish(self.controller.decide(now))
        else:  # newer inputs have come
            pace.expiry.set(left)

    def on_stall(self) -> None:
        """Stop the robot, in the watchdog's thread, while nothing else can."""
        try:
            self.outputs.publish(self.controller.stall())
        except Exception as error:  # the thread must go on
            text = f'after a stop: {type(error).__name__}: {error}'
            self.node.get_logger().error(text, throttle_duration_sec=1.0)

    def facts(self) -> dict[str, str]:
        """Return what diagnostics tell."""
        ages = self.controller.input_ages(self.node.get_clock().now().nanoseconds)
        controller = self.controller
        model, plan = named_model(self.made_for), controller.plan.note
        idle = controller.progress.idle
        facts = controller_facts(model, plan, idle, ages, controller.tally)
        return facts | self.punctuality.facts()

    def concerns(self) -> list[str]:
        """Return what is wrong besides what makes the robot stand, as far as the graph tells."""
        outputs, node = self.outputs, self.node
        # without goals from topics nav2 sees to it that its nodes command the robot in turn
        others = rivals(node, outputs.commands) if self.made_for.goal_topics else []
        found = [f'cmd_vel has other publishers: {", ".join(others)}'] * bool(others)
        if self.nav2 is not None and (others := self.nav2.follower.rivals()):
            found.append(f'follow_path is offered by others too: {", ".join(others)}')
        driving = outputs.reason is None
        found += concerns_of_base(node, outputs.commands, outputs.stamped, driving)
        for name, heard in self.subscriptions.items():
            if outputs.reason == f'no {name}':
                found += concerns_of_input(node, heard, expected=name != 'goal_pose')
        return found + self.controller.concerns()
