"""The simulator node under fire."""

import math
from pathlib import Path
import time

from geometry_msgs.msg import PoseStamped, Twist
from nav_msgs.msg import Odometry
import numpy as np
from std_srvs.srv import SetBool

from helpers.fuzzing import hostile_value, LIFETIME, Target
from helpers.graph import Graph
from helpers.hostile import Hostile
from helpers.robot import speed
from socialnav import qos
from socialnav.demo.children import command_line
from socialnav.parameters.fields import entries
from socialnav.parameters.simulator import SimulatorParameters
from socialnav_msgs.srv import StartEpisode

LIVE = [entry for entry in entries(SimulatorParameters) if entry.live != 'no']
GOOD = {'max_speed': 1.5, 'real_time_factor': 1.0}
FASTEST = SimulatorParameters.__dataclass_fields__['max_speed'].metadata['range'][1]
"""No parameter lets the base drive faster, m/s."""


class FuzzedSimulator:
    """Shoots at a simulator node for a while, and looks what its robot does."""

    def __init__(self, graph: Graph, seed: int, log: Path) -> None:
        """
        Start the node.

        :param log: file for its errors.
        """
        self.graph = graph
        self.hostile = Hostile(seed, lambda: graph.node.get_clock().now().nanoseconds)
        self.odometry: list[Odometry] = []
        graph.node.create_subscription(Odometry, 'odom', self.odometry.append, qos.ODOMETRY)
        self.publishers = {
            'cmd_vel': graph.node.create_publisher(Twist, 'cmd_vel', qos.COMMAND),
            'goal_pose': graph.node.create_publisher(PoseStamped, 'goal_pose', qos.GOAL),
        }
        graph.run(command_line('simulator_node', GOOD), log, LIFETIME)
        services = {'start_episode': StartEpisode, 'pause': SetBool}
        self.node = Target(graph, 'simulator_node', services)
        self.figures = self.node.figures
        self.recover()

    def round(self) -> None:
        """Shoot with everything, then see that the robot drives as it is told."""
        for attack in (self.messages, self.parameters, self.episodes, self.messages):
            attack()
            self.judge(FASTEST)
        self.recover()
        self.node.note_memory()

    def messages(self) -> None:
        """Send hostile commands and goals."""
        for _ in range(100):
            for name, kind in (('cmd_vel', Twist), ('goal_pose', PoseStamped)):
                message = self.hostile.changed(kind())
                if self.hostile.chance(0.1):
                    message = self.hostile.bytes_of(message)
                self.publishers[name].publish(message)
                self.figures.messages += 1
            self.graph.spin(0.005)
        self.node.call('get_parameters', self.node.clients['get_parameters'].srv_type.Request())

    def parameters(self) -> None:
        """Set parameters to whatever they can and cannot be."""
        for _ in range(6):
            entry = self.hostile.choice(LIVE)
            self.node.set_parameters({entry.name: hostile_value(self.hostile, entry)})

    def episodes(self) -> None:
        """Ask for episodes that there are and that there are not; stop time, or not."""
        for _ in range(4):
            request = StartEpisode.Request()
            request.scenario = self.hostile.choice(('hard', 'crowd20', 'hart', '', 'x' * 10_000))
            request.seed = self.hostile.choice((0, 7, 2**63, 2**64 - 1))
            request.case_index = self.hostile.choice((0, 3, 2**32 - 1))
            self.node.call('start_episode', request)
            self.node.call('pause', SetBool.Request(data=self.hostile.chance(0.5)))

    def judge(self, limit: float) -> None:
        """See that the robot was where a robot can be, not faster than the limit, m/s."""
        speeds = [speed(one.twist.twist) for one in self.odometry]
        places = [(one.pose.pose.position.x, one.pose.pose.position.y) for one in self.odometry]
        assert np.isfinite(places).all() and np.isfinite(speeds).all()
        assert max(speeds, default=0.0) <= limit + 1e-6, max(speeds)
        self.figures.fastest = max(self.figures.fastest, *speeds, 0.0)
        self.odometry.clear()

    def recover(self) -> None:
        """Begin an episode, and see that the robot drives as it is told, soon."""
        self.node.set_parameters({entry.name: entry.default for entry in LIVE} | GOOD)
        self.node.call('pause', SetBool.Request(data=False))
        answer = self.node.call('start_episode', StartEpisode.Request(scenario='hard', seed=1))
        assert answer.success, answer.message
        self.graph.spin(0.2)
        self.odometry.clear()
        began = time.monotonic()
        command = Twist()
        command.linear.x = 0.7

        def moves() -> bool:
            self.publishers['cmd_vel'].publish(command)
            self.graph.spin(0.03)
            latest = speed(self.odometry[-1].twist.twist) if self.odometry else 0.0
            return math.isclose(latest, 0.7, abs_tol=1e-6)

        self.graph.wait(moves, 'motion after a good command')
        self.figures.recoveries.append(time.monotonic() - began)
        self.judge(GOOD['max_speed'])
