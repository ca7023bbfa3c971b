"""The node that simulates a crowd and a robot, in real time or in lockstep with the policy."""

from collections import deque
import sys
from typing import Any

from geometry_msgs.msg import PoseStamped, Twist, TwistStamped
from nav_msgs.msg import OccupancyGrid, Odometry
import numpy as np
from rclpy.clock import Clock, ClockType
from rclpy.event_handler import PublisherEventCallbacks, QoSPublisherMatchedInfo
from rclpy.node import Node
from rclpy.parameter import Parameter
from rosgraph_msgs.msg import Clock as ClockMessage
from std_srvs.srv import SetBool
from visualization_msgs.msg import MarkerArray

from socialnav import qos
from socialnav.messages.commands import command_array, executed
from socialnav.messages.conversions import ConversionError, goal_array
from socialnav.messages.filling import filled
from socialnav.messages.occupancy import map_message
from socialnav.messages.sources import new_source
from socialnav.messages.stamps import nanoseconds_of, time_message
from socialnav.parameters.declaring import declare, updated
from socialnav.parameters.simulator import SimulatorParameters
from socialnav.running import run
from socialnav.simulator.settings import frames_of, scenario_named
from socialnav.simulator.simulated_sensors import SimulatedSensors
from socialnav.simulator.transform_publisher import transform_publisher
from socialnav.simulator.world import World
from socialnav.simulator.world_messages import moving_messages, standing_messages
from socialnav_core.messages import episode_result, world_markers
from socialnav_msgs.msg import AgentStates, EpisodeResult
from socialnav_msgs.srv import StartEpisode

OWN_GOALS = 100
"""Number of latest own goals that are recognised when they come back."""

TELLINGS = 5
"""Number of times that a new subscriber is told the goal."""
TELLING_PERIOD = 0.2
"""Time between them, s."""


class SimulatorNode(Node):
    """Publishes the world and drives its robot as commanded."""

    def __init__(self) -> None:
        """
        Begin the first episode.

        :raises ValueError: a parameter that cannot be used.
        """
        super().__init__('simulator_node')
        self.settings = declare(self, SimulatorParameters)
        self.add_post_set_parameters_callback(self.on_parameters)
        self.lockstep, self.frames = self.settings.lockstep, frames_of(self.settings)
        self.own_goals: deque[int] = deque(maxlen=OWN_GOALS)
        self.world = World(
            scenario_named(self.settings.scenario, self.settings),
            self.settings.seed,
            self.settings.episodes,
            self.get_clock().now().nanoseconds,
        )
        self.world.command_timeout = self.settings.cmd_vel_timeout
        self.source = new_source(self.get_fully_qualified_name())
        self.create_outputs()
        self.create_inputs()
        self.create_pace()
        self.publish_state()

    def create_outputs(self) -> None:
        """Make the publishers."""
        goal_events = PublisherEventCallbacks(matched=self.on_goal_subscriber)
        self.outputs = {
            'goal_pose': self.create_publisher(
                PoseStamped, 'goal_pose', qos.GOAL, event_callbacks=goal_events
            ),
            'obstacles': self.create_publisher(AgentStates, 'obstacles', qos.OBSTACLES),
            'pedestrians': self.create_publisher(AgentStates, 'pedestrians', qos.PEDESTRIANS),
            'odom': self.create_publisher(Odometry, 'odom', qos.ODOMETRY),
            'map': self.create_publisher(OccupancyGrid, 'map', qos.MAP),
        }
        self.markers = self.create_publisher(MarkerArray, 'markers', qos.MARKERS)
        self.results = self.create_publisher(EpisodeResult, 'episode_result', qos.EPISODE_RESULT)
        self.sensors = SimulatedSensors(self, self.settings)
        self.transforms = transform_publisher(self, self.frames, self.stamp())
        self.clocks = None
        if self.settings.publish_clock:
            self.clocks = self.create_publisher(ClockMessage, '/clock', qos.CLOCK)

    def create_inputs(self) -> None:
        """Make subscriptions and services."""
        if self.settings.stamped:
            self.create_subscription(TwistStamped, 'cmd_vel', self.on_stamped, qos.COMMAND)
        else:
            self.create_subscription(Twist, 'cmd_vel', self.on_command, qos.COMMAND)
        self.create_subscription(PoseStamped, 'goal_pose', self.on_goal, qos.GOAL)
        self.create_service(StartEpisode, '~/start_episode', self.on_start_episode)
        self.create_service(SetBool, '~/pause', self.on_pause)

    def create_pace(self) -> None:
        """Make the timers: a tick is a step, or in lockstep a look for a lost message."""
        steady = Clock(clock_type=ClockType.STEADY_TIME)
        callback = self.on_no_answer if self.lockstep else self.on_tick
        self.pace = self.create_timer(self.settings.timer_period, callback, clock=steady)
        self.tellings = TELLINGS
        self.teller = self.create_timer(TELLING_PERIOD, self.on_telling, clock=steady)

    def on_parameters(self, changes: list[Parameter]) -> None:
        """Use parameters that were changed."""
        self.settings = updated(self.settings, changes)
        self.world.command_timeout = self.settings.cmd_vel_timeout

    def on_tick(self) -> None:
        """Let time pass."""
        if not self.world.standing:
            self.world.advance(self.settings.tick_duration)
            self.publish_advance()

    def on_no_answer(self) -> None:
        """Publish the state again: it or its answer may have been lost, or nobody was there."""
        if not self.world.standing:
            self.publish_state()

    def on_stamped(self, message: TwistStamped) -> None:
        """Take a command with a time, in lockstep that of the state that it answers."""
        self.on_command(message.twist, nanoseconds_of(message.header.stamp))

    def on_command(self, message: Twist, stamp: int = 0) -> None:
        """
        Take a command in base_link; in lockstep, let the world advance.

        :param stamp: time of the state that it answers, ns.
        """
        try:
            command = self.executed(command_array(message, self.world.scenario.kinematics))
        except ConversionError as error:
            self.get_logger().warning(f'ignored: {error}', throttle_duration_sec=1.0)
            return
        if not self.lockstep:
            self.world.drive(command)
        elif self.world.answer(command, stamp):
            self.pace.reset()
            self.publish_advance()

    def executed(self, command: np.ndarray) -> np.ndarray:
        """Return what the base makes of a command, (2,); say where that is another one."""
        limits = self.settings.limits
        result = executed(command, self.world.scenario.kinematics, limits)
        if (result != command).any():
            text = f'cmd_vel is beyond {limits.speed:g} m/s or {limits.turn_rate:g} rad/s: limited'
            self.get_logger().warning(text, throttle_duration_sec=1.0)
        return result

    def on_goal(self, message: PoseStamped) -> None:
        """Send the robot to a goal that somebody else set, in either frame since they coincide."""
        if nanoseconds_of(message.header.stamp) in self.own_goals:
            return
        frame = message.header.frame_id
        try:
            wanted = frame if frame == self.frames.map else self.frames.odom
            self.world.set_goal(goal_array(message, wanted))
        except ConversionError as error:
            self.get_logger().warning(f'ignored: {error}', throttle_duration_sec=1.0)
            return
        if not self.lockstep:
            self.publish(standing_messages(self.world, self.stamp(), self.frames))

    def on_goal_subscriber(self, event: QoSPublisherMatchedInfo) -> None:
        """Tell a newcomer the goal, which is volatile."""
        if event.current_count_change > 0:
            self.tellings = TELLINGS
            self.teller.reset()

    def on_telling(self) -> None:
        """Publish the goal again: the first time, a newcomer may not be ready to hear it."""
        self.tellings -= 1
        if self.tellings <= 0:
            self.teller.cancel()
        if self.lockstep:
            self.on_no_answer()
        else:
            self.outputs['goal_pose'].publish(self.goal)

    def on_start_episode(
        self, request: StartEpisode.Request, response: StartEpisode.Response
    ) -> StartEpisode.Response:
        """Begin a case at once; answer whether it exists."""
        try:
            name = request.scenario or self.world.scenario.name
            scenario = scenario_named(name, self.settings)
            self.world.begin(scenario, request.seed, request.case_index)
        except ValueError as error:
            response.success, response.message = False, str(error)
            return response
        response.success, response.message = True, f'case {request.case_index} has begun'
        self.publish_state()
        return response

    def on_pause(self, request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
        """Stop time where the request is true; let it go on otherwise."""
        self.world.paused = request.data
        response.success, response.message = True, 'paused' if request.data else 'running'
        return response

    def stamp(self) -> int:
        """Return the time of the present state, ns."""
        now = self.get_clock().now().nanoseconds
        return self.world.clock if self.settings.simulated_time else now

    def publish_advance(self) -> None:
        """Publish what the latest advance led to."""
        stamp = self.publish_state()
        if self.world.episode is not None:
            result = episode_result(self.world.episode, stamp, self.frames.odom)
            self.results.publish(filled(EpisodeResult, result))
            if self.world.done:
                self.get_logger().info('all episodes are done')

    def publish_state(self) -> int:
        """Publish the present state and return its stamp."""
        state, stamp = self.world.state, self.stamp()
        if self.clocks is not None:
            self.clocks.publish(ClockMessage(clock=time_message(stamp)))
        if self.world.fresh:
            self.publish({'map': map_message(state, stamp, self.frames.map)})
        if self.world.fresh or self.lockstep:
            self.publish(standing_messages(self.world, stamp, self.frames))
        moving = moving_messages(self.world, stamp, self.frames)
        self.publish(moving)
        self.sensors.publish(self.world, stamp)
        if self.transforms is not None:
            self.transforms.publish(moving['odom'])
        if self.markers.get_subscription_count():
            tolerance = self.world.scenario.goal_tolerance
            markers = world_markers(state, tolerance, stamp, self.frames.odom)
            self.markers.publish(filled(MarkerArray, markers))
        return stamp

    def publish(self, messages: dict[str, Any]) -> None:
        """Publish messages by topic; remember goals, which come back."""
        if 'goal_pose' in messages:
            self.goal = messages['goal_pose']
            self.own_goals.append(nanoseconds_of(self.goal.header.stamp))
        for name, message in messages.items():
            if isinstance(message, AgentStates):
                message.source = self.source
            self.outputs[name].publish(message)

    def close(self) -> None:
        """Do nothing: a simulator has no last word."""


def main() -> None:
    """Run the node."""
    sys.exit(run(SimulatorNode))
