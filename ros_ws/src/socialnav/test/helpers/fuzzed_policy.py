"""The policy node under fire."""

import pathlib
import time

from geometry_msgs.msg import PoseStamped, Twist
from lifecycle_msgs.srv import ChangeState, GetState
from nav_msgs.msg import OccupancyGrid, Path
import numpy as np
from rclpy.duration import Duration
from std_srvs.srv import Trigger

from helpers.fuzzing import hostile_value, LIFETIME, Target
from helpers.graph import Graph, UNSEEN_MATCH
from helpers.hostile import Hostile
from helpers.plans import plan_of
from helpers.robot import KINDS, Robot, speed
from helpers.worlds import messages_of, random_state
from socialnav import qos
from socialnav.demo.children import command_line
from socialnav.messages.occupancy import map_message
from socialnav.parameters.fields import entries
from socialnav.parameters.policy import PolicyParameters

LIVE = [
    entry for entry in entries(PolicyParameters)
    if entry.live != 'no' and entry.name not in ('model', 'device', 'threads')
]  # fmt: skip
GOOD = {'model': 'orca', 'max_speed': 0.9, 'use_map': False}
"""Parameters with which the node drives after each round."""
FASTEST = PolicyParameters.__dataclass_fields__['max_speed'].metadata['range'][1]
"""No parameter lets a robot drive faster, m/s."""
TRANSITIONS = ('configure', 'activate', 'deactivate', 'cleanup', 'nonsense', '')
IDS = tuple(one for one in range(256) if one not in (5, 6, 7))
"""Of transitions, without those that end the node for good."""
GOALS = 2000
"""Goals of a burst, which take a second."""
POSES = 100_000
ACKNOWLEDGED = Duration(seconds=10)
"""Longest time that long messages may be on their way."""


class FuzzedPolicy:
    """Shoots at a policy node for a while, and looks what it does."""

    def __init__(self, graph: Graph, seed: int, log: pathlib.Path) -> None:
        """
        Start the node.

        :param log: file for its errors.
        """
        self.graph, self.robot = graph, Robot(graph)
        self.hostile = Hostile(seed, self.robot.now)
        self.state = random_state(0)
        self.commands: list[Twist] = []
        graph.node.create_subscription(Twist, 'cmd_vel', self.commands.append, qos.COMMAND)
        extra = {'plan': (Path, qos.PLAN), 'map': (OccupancyGrid, qos.MAP)}
        self.publishers = self.robot.publishers | {
            name: graph.node.create_publisher(*kind[:1], name, kind[1])
            for name, kind in extra.items()
        }
        self.kinds = KINDS | extra
        graph.run(command_line('policy_node', GOOD), log, LIFETIME)
        managed = {'change_state': ChangeState, 'get_state': GetState, 'cancel_goal': Trigger}
        self.node = Target(graph, 'policy_node', managed)
        self.figures = self.node.figures
        self.recover()

    def round(self) -> None:
        """Shoot with everything, then see that a bad input stops it and good ones do not."""
        attacks = [self.messages, self.goals, self.parameters, self.transitions, self.long_lists]
        for number in self.hostile.generator.permutation(len(attacks)):
            attacks[number]()
            self.judge(FASTEST)
        self.recover()
        self.stand()
        self.recover()
        self.node.note_memory()

    def good(self) -> dict:
        """Return messages that are right."""
        messages = messages_of(self.state, self.robot.now())
        goal = self.state.robot.goal[0]
        messages['plan'] = plan_of([tuple(self.state.robot.position[0]), tuple(goal)])
        messages['map'] = map_message(self.state, self.robot.now(), 'odom')
        return messages

    def messages(self) -> None:
        """Send hostile messages of all kinds, among good ones."""
        for _ in range(25):
            for name, message in self.good().items():
                kind = self.hostile.generator.integers(5)
                if kind == 0:
                    message = self.hostile.bytes_of(message)
                elif kind == 1:
                    message = self.hostile.filled(self.kinds[name][0])
                elif kind < 4:
                    message = self.hostile.changed(message)
                self.publishers[name].publish(message)
                self.figures.messages += 1
            self.graph.spin(0.005)
        self.node.call('get_parameters', self.node.clients['get_parameters'].srv_type.Request())

    def goals(self) -> None:
        """Send goals at 2 kHz for a second, each of them new."""
        for number in range(GOALS // 10):
            for part in range(10):
                goal = PoseStamped()
                goal.header.frame_id = 'odom'
                goal.header.stamp.nanosec = number * 10 + part
                goal.pose.position.x = 5.0 + part
                self.publishers['goal_pose'].publish(goal)
            self.figures.messages += 10
            self.graph.spin(0.005)
        if self.node.state() in ('inactive', 'active'):  # only then there is the service
            self.graph.wait(self.node.clients['cancel_goal'].service_is_ready, 'cancel_goal')
            self.graph.spin(2 * UNSEEN_MATCH)
            self.node.call('cancel_goal', Trigger.Request())

    def parameters(self) -> None:
        """Set parameters to whatever they can and cannot be."""
        for _ in range(6):
            chosen = self.hostile.generator.choice(len(LIVE), 3, replace=False)
            entries = [LIVE[one] for one in chosen if LIVE[one].name not in ('model', 'device')]
            self.node.set_parameters(
                {one.name: hostile_value(self.hostile, one) for one in entries}
            )

    def transitions(self) -> None:
        """Ask for transitions in any order, of which most cannot be."""
        for _ in range(4):
            label = self.hostile.choice(TRANSITIONS)
            self.node.change_state(id=self.hostile.choice(IDS), label=label)

    def long_lists(self) -> None:
        """Send a plan, and lists of agents, that are far too long."""
        plan = plan_of([(0.0, 0.0)])
        plan.poses *= POSES
        self.publishers['plan'].publish(plan)
        crowd = self.good()['pedestrians']
        crowd.agents = crowd.agents[:1] * 20_000
        for name in ('pedestrians', 'obstacles'):
            self.publishers[name].publish(crowd)
        self.figures.messages += 3
        for name in ('plan', 'pedestrians', 'obstacles'):  # a request may get lost behind them
            self.publishers[name].wait_for_all_acked(ACKNOWLEDGED)
        self.node.call('get_parameters', self.node.clients['get_parameters'].srv_type.Request())

    def judge(self, limit: float) -> None:
        """See that no command was faster than the limit, m/s; forget them."""
        speeds = [speed(one) for one in self.commands]
        assert np.isfinite(speeds).all() and max(speeds, default=0.0) <= limit + 1e-6, max(speeds)
        self.figures.fastest = max(self.figures.fastest, *speeds, 0.0)
        self.commands.clear()

    def send(self, without: str = '', instead=None) -> None:
        """Send good inputs, one of them bad."""
        messages = self.good()
        for name in KINDS:
            self.publishers[name].publish(instead if name == without else messages[name])
        self.figures.messages += len(KINDS)

    def recover(self) -> None:
        """Make everything right again, and see that the robot drives soon."""
        defaults = {entry.name: entry.default for entry in LIVE} | GOOD
        if self.node.state() == 'active':
            self.node.change_state(label='deactivate')
        for transition in ('cleanup', 'configure'):
            self.send()  # obstacles are latched: those of a foreign source would count for ever
            self.node.set_parameters(defaults)
            self.node.change_state(label=transition)
        assert self.node.change_state(label='activate') and self.node.state() == 'active'
        self.graph.spin(0.3)  # the subscriptions are new: their ends must find each other
        self.commands.clear()
        began = time.monotonic()

        def moves() -> bool:
            self.send()
            self.graph.spin(0.03)
            return bool(self.commands) and speed(self.commands[-1]) > 0.1

        self.graph.wait(moves, 'motion after good inputs')
        self.figures.recoveries.append(time.monotonic() - began)
        self.judge(GOOD['max_speed'])

    def stand(self) -> None:
        """See that a bad input, be it sent again and again among good ones, stops the robot."""
        name, message = self.bad()
        began = time.monotonic()

        def stands() -> bool:
            self.send(name, message)
            self.graph.spin(0.03)
            latest = self.commands[-2:]
            return len(latest) == 2 and not any(map(speed, latest))

        self.commands.clear()
        self.graph.wait(stands, f'standstill with {name}: {message}'[:300])
        self.figures.stops.append(time.monotonic() - began)
        self.commands.clear()
        for _ in range(10):
            self.send(name, message)
            self.graph.spin(0.03)
        self.judge(0.0)

    def bad(self) -> tuple[str, object]:
        """Return an input that no robot may act on."""
        name = self.hostile.choice(('odom', 'pedestrians', 'obstacles', 'goal_pose'))
        message, value = self.good()[name], self.hostile.choice((np.nan, np.inf, -np.inf, 1e300))
        if self.hostile.chance(0.2):
            message.header.frame_id = self.hostile.choice(('map', '', 'x' * 10_000))
        elif name == 'odom':
            owner = self.hostile.choice((message.pose.pose.position, message.twist.twist.linear))
            setattr(owner, self.hostile.choice('xy'), value)
        elif name == 'goal_pose':
            message.pose.position.x = value
        else:
            setattr(self.hostile.choice(message.agents).position, self.hostile.choice('xy'), value)
        return name, message
