"""A floor on which bases drive among walkers, each with a policy node, in a time of their own."""

import dataclasses
import math
import time

from geometry_msgs.msg import PoseStamped, Twist
from nav_msgs.msg import Odometry
import numpy as np
from rosgraph_msgs.msg import Clock
from std_msgs.msg import String

from helpers.base import Base, Build, Pose
from helpers.fuzzing import LIFETIME
from helpers.graph import Graph
from helpers.walkers import RADIUS, Walkers
from helpers.worlds import quaternion_of
from socialnav import qos
from socialnav.control.reasons import ARRIVED
from socialnav.demo.children import command_line
from socialnav.messages.stamps import header_message, time_message
from socialnav_msgs.msg import AgentState, AgentStates

STEP = 0.02
"""Time between two messages of odometry, s."""
PERIOD = 5
"""Number of such steps between two decisions, and between two lists of people."""
GOAL_PERIOD = 50
"""Number of them between two times that the goal is told, from the map to odometry."""
ANSWER = 0.05
"""Longest real time that is waited for a command before time goes on, s."""
PAUSE = 0.002
"""Real time between two steps, s: timers that come in a heap are not all called."""
ROBOT = 0.3
"""Radius, m."""
NEAR = 0.7
"""Largest distance to the goal on the map where a robot has arrived, m: odometry drifts."""


@dataclasses.dataclass
class Figures:
    """What became of the runs."""

    runs: int = 0
    """Goals that were set."""
    arrived: int = 0
    """Goals that were reached."""
    touched: int = 0
    """Runs in which a robot touched somebody."""
    times: list[float] = dataclasses.field(default_factory=list)
    """Time until the robot had arrived, s."""
    said: list[str] = dataclasses.field(default_factory=list)
    """What robots said that did not arrive."""


class Driven:
    """A base with a policy node in a namespace, and what both are told."""

    def __init__(self, graph: Graph, name: str, base: Base, goal: np.ndarray, **parameters):
        self.name, self.base, self.goal = name, base, goal
        self.answered, self.touches, self.began = False, False, 0.0
        self.state, self.log = '', []
        self.change, self.repeats = (lambda odometry: odometry), True
        build = base.build
        known = {
            'use_sim_time': True, 'require_obstacles': False, 'max_speed': build.speed,
            'planning_frame': f'{name}/odom', 'base_frame': f'{name}/base_link',
            'max_acceleration': build.acceleration, 'max_turn_rate': build.turn_rate,
            'max_angular_acceleration': build.turn_acceleration,
            'kinematics': 'differential' if build.differential else 'holonomic',
        }  # fmt: skip
        node = graph.node
        self.odom = node.create_publisher(Odometry, f'/{name}/odom', qos.ODOMETRY)
        self.people = node.create_publisher(AgentStates, f'/{name}/pedestrians', qos.PEDESTRIANS)
        self.goals = node.create_publisher(PoseStamped, f'/{name}/goal_pose', qos.GOAL)
        node.create_subscription(Twist, f'/{name}/cmd_vel', self._on_command, qos.COMMAND)
        node.create_subscription(String, f'/{name}/policy_node/state', self._on_state, qos.STATE)
        graph.run(
            command_line('policy_node', known | parameters, {'__ns': f'/{name}'}),
            lifetime=LIFETIME,
        )
        publishers = self.odom, self.people, self.goals
        graph.wait(lambda: all(one.get_subscription_count() for one in publishers), 'policy node')

    def _on_command(self, command: Twist) -> None:
        self.answered = True
        self.base.command(command.linear.x, command.linear.y, command.angular.z)

    def _on_state(self, state: String) -> None:
        self.state = state.data
        self.log.append(state.data)

    def tell_odometry(self, now: int) -> None:
        """Publish what the wheels tell."""
        base = self.base
        message = Odometry(header=header_message(now, f'{self.name}/odom'))
        message.child_frame_id = f'{self.name}/base_link'
        pose, twist = message.pose.pose, message.twist.twist
        pose.position.x, pose.position.y = map(float, base.told.place)
        pose.orientation = quaternion_of(base.told.heading)
        twist.linear.x, twist.linear.y = map(float, base.velocity)
        twist.angular.z = float(base.rate)
        self.odom.publish(self.change(message))

    def tell_people(self, now: int, position, velocity, radius) -> None:
        """Publish everybody else as seen from here."""
        message = AgentStates(header=header_message(now, f'{self.name}/odom'))
        for number, (place, speed, size) in enumerate(
            zip(position, velocity, radius, strict=True)
        ):
            agent = AgentState(id=number, radius=float(size))
            agent.position.x, agent.position.y = map(float, self.base.in_odom(place))
            agent.velocity.x, agent.velocity.y = map(float, self.base.turned_to_odom(speed))
            message.agents.append(agent)
        self.people.publish(message)

    def tell_goal(self, now: int) -> None:
        """Publish where the goal on the map is by odometry now."""
        message = PoseStamped(header=header_message(now, f'{self.name}/odom'))
        message.pose.position.x, message.pose.position.y = map(float, self.base.in_odom(self.goal))
        message.pose.orientation = quaternion_of(0.0)
        self.goals.publish(message)

    @property
    def distance(self) -> float:
        """Return how far from its goal the robot is, m."""
        return float(np.hypot(*(self.goal - self.base.pose.place)))


class Course:
    """Lets time go on when every robot has decided, and tells robots of each other as people."""

    def __init__(self, graph: Graph, walkers: Walkers, seed: int, half_width: float = 6.0) -> None:
        """
        Begin without a robot.

        :param half_width: of the square that goals are in, m.
        """
        self.graph, self.walkers, self.robots = graph, walkers, []
        self.random, self.half_width = np.random.default_rng(seed), half_width
        self.clock = graph.node.create_publisher(Clock, '/clock', qos.CLOCK)
        self.steps, self.figures = 500, Figures()

    def add(self, name: str, build: Build, **parameters):
        """Add a robot at a random place, with odometry that is yawed and displaced."""
        heading, yaw = self.random.uniform(-math.pi, math.pi, 2)
        origin = Pose(self.random.uniform(-50.0, 50.0, 2), yaw)
        base = Base(build, Pose(self._free_place(), heading), origin)
        robot = Driven(self.graph, name, base, base.pose.place, **parameters)
        self.robots.append(robot)
        return robot

    @property
    def now(self) -> float:
        """Return the time, s."""
        return self.steps * STEP

    def send(self, robot: Driven, goal: np.ndarray | None = None) -> None:
        """Give a robot a goal, far away and at random where none is said."""
        robot.goal = self._far_place(robot) if goal is None else goal
        robot.began, robot.touches, robot.state = self.now, False, ''
        robot.log.clear()
        robot.tell_goal(self._stamp())
        self.figures.runs += 1

    def advance(self) -> None:
        """Let a step pass."""
        self.steps += 1
        stamp, second = self._stamp(), self.steps % GOAL_PERIOD == 0
        people = self.steps % PERIOD == 0
        self.walkers.advance(STEP, np.array([one.base.pose.place for one in self.robots]))
        for robot in self.robots:
            robot.base.advance(STEP)
            robot.tell_odometry(stamp)
            if people:
                position, velocity, radius = self._others(robot)
                gaps = np.hypot(*(position - robot.base.pose.place).T) - radius - ROBOT
                robot.touches |= bool((gaps < 0).any())
                robot.tell_people(stamp, position, velocity, radius)
            if second and robot.repeats:
                robot.tell_goal(stamp)
        self.clock.publish(Clock(clock=time_message(stamp)))
        self._pause()
        if people:
            self._wait_for_answers()

    def until(self, condition, limit: float) -> bool:
        """Let time pass until a condition holds, for so long at most; return whether it did."""
        end = self.now + limit
        while not (met := condition()) and self.now < end:
            self.advance()
        return met

    def run(self, count: int, limit: float = 60.0) -> Figures:
        """
        Send every robot to so many goals, one after the other; return what became of that.

        :param limit: time after which a run has failed, s.
        """
        left = dict.fromkeys(self.robots, count)
        for robot in self.robots:
            self.send(robot)
        while left:
            self.advance()
            for robot in list(left):
                arrived = robot.state == ARRIVED
                if not arrived and self.now - robot.began < limit:
                    continue
                self._note(robot, arrived)
                left[robot] -= 1
                if left[robot]:
                    self.send(robot)
                else:
                    del left[robot]
        return self.figures

    def _note(self, robot: Driven, arrived: bool) -> None:
        """Note what became of a run."""
        if arrived and robot.distance < NEAR:
            self.figures.arrived += 1
            self.figures.times.append(self.now - robot.began)
        else:
            self.figures.said.append(f'{robot.distance:.1f} m away: {robot.state}')
        self.figures.touched += robot.touches

    def _pause(self) -> None:
        """Let nodes hear what was told before time goes on."""
        end = time.monotonic() + PAUSE
        while (left := end - time.monotonic()) > 0:
            self.graph.executor.spin_once(timeout_sec=left)

    def _wait_for_answers(self) -> None:
        """Wait until every robot has decided, or for some time: silence is an answer too."""
        end = time.monotonic() + ANSWER
        while not all(one.answered for one in self.robots) and time.monotonic() < end:
            self.graph.executor.spin_once(timeout_sec=0.01)
        for robot in self.robots:
            robot.answered = False

    def _others(self, robot: Driven):
        """Return position, velocity and radius of all but a robot, on the map."""
        others = [one.base for one in self.robots if one is not robot]
        places = [one.pose.place for one in others]
        ways = [one.pose.moved(one.velocity, 0.0, 1.0).place - one.pose.place for one in others]
        position = np.concatenate([self.walkers.position, np.reshape(places, (-1, 2))])
        velocity = np.concatenate([self.walkers.velocity, np.reshape(ways, (-1, 2))])
        radius = np.full(len(position), RADIUS)
        radius[len(self.walkers.position) :] = ROBOT
        return position, velocity, radius

    def _free_place(self) -> np.ndarray:
        """Return a place where nobody is, m, (2,)."""
        taken = [*self.walkers.position, *(one.base.pose.place for one in self.robots)]
        while True:
            place = self.random.uniform(-self.half_width, self.half_width, 2)
            if all(np.hypot(*(place - other)) > 1.5 for other in taken):
                return place

    def _far_place(self, robot: Driven) -> np.ndarray:
        """Return a place that is far from a robot, m, (2,)."""
        while True:
            place = self.random.uniform(-self.half_width, self.half_width, 2)
            if np.hypot(*(place - robot.base.pose.place)) > self.half_width:
                return place

    def _stamp(self) -> int:
        """Return the time, ns."""
        return round(self.now * 1e9)
