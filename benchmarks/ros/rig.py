"""A node that plays robot, sensors and crowd to a policy node, and notes what it answers."""

from collections.abc import Callable
import os
from pathlib import Path
import time

from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseStamped, Twist
from nav_msgs.msg import Odometry
import rclpy
from rclpy.executors import SingleThreadedExecutor

from socialnav import qos
from socialnav.demo.isolation import isolated_environment
from socialnav.messages.filling import filled
from socialnav_core.config import Scenario
from socialnav_core.messages import agent_states, goal, odometry
from socialnav_core.simulation import Simulator
from socialnav_core.states import CrowdState
from socialnav_msgs.msg import AgentStates

RATE = 19.9
"""Inputs published per second, Hz: within ten seconds one has come at any moment before a tick."""
WORLDS = 20
CHANGE = 0.5
"""Time after which the next world is shown, s."""
FRAME = 'odom'
DEADLINE = 60.0
"""Time that anything may take before the measurement is given up, s."""
PATIENCE = 0.01
"""Time that is waited for the next message, s."""
KINDS = {
    'odom': (Odometry, qos.ODOMETRY),
    'pedestrians': (AgentStates, qos.PEDESTRIANS),
    'goal_pose': (PoseStamped, qos.GOAL),
}
UNCHECKED = {'require_obstacles': False, 'progress_stop_timeout': 0.0}
"""Parameters of a policy node that is shown no obstacles, and worlds in turn: it gets nowhere."""


class Rig:
    """Publishes worlds with pedestrians in turn; a topic can be silenced."""

    def __init__(self, pedestrians: int) -> None:
        """Begin to publish when it is spun."""
        os.environ.update(isolated_environment(os.environ))
        rclpy.init()
        self.node = rclpy.create_node('rig')
        self.executor = SingleThreadedExecutor()
        self.executor.add_node(self.node)
        self.show(pedestrians)
        self.silent: set[str] = set()
        self.stamps: dict[str, int] = {}
        self.commands: list[tuple[float, bool]] = []
        self.facts: dict[str, str] = {}
        self.longest_pause = 0.0
        self.publishers = {
            name: self.node.create_publisher(kind, name, profile)
            for name, (kind, profile) in KINDS.items()
        }
        self.node.create_subscription(Twist, 'cmd_vel', self.on_command, qos.COMMAND)
        self.node.create_subscription(
            DiagnosticArray, '/diagnostics', self.on_diagnostics, qos.DIAGNOSTICS
        )
        self.node.create_timer(1 / RATE, self.publish)

    def show(self, pedestrians: int) -> None:
        """Publish other worlds from now on."""
        self.worlds = [world(pedestrians, case) for case in range(WORLDS)]

    def publish(self) -> None:
        """Publish the present world, but for what is silent."""
        now = self.node.get_clock().now().nanoseconds
        state = self.worlds[int(now * 1e-9 / CHANGE) % WORLDS]
        contents = {
            'odom': odometry(state, now, FRAME, 'base_link'),
            'pedestrians': agent_states(state, False, now, FRAME),
            'goal_pose': goal(state, now, FRAME),
        }
        for name in contents.keys() - self.silent:
            kind, _ = KINDS[name]
            self.publishers[name].publish(filled(kind, contents[name]))
            self.stamps[name] = now

    def give_up(self, name: str) -> None:
        """Publish on a topic no more."""
        if name in self.publishers:
            self.node.destroy_publisher(self.publishers.pop(name))

    def on_command(self, twist: Twist) -> None:
        """Note when a command came, s since the epoch, and whether the robot shall move."""
        moving = bool(twist.linear.x or twist.linear.y or twist.angular.z)
        self.commands.append((time.time(), moving))

    def on_diagnostics(self, message: DiagnosticArray) -> None:
        """Keep what the policy node tells of itself."""
        self.facts = {one.key: one.value for one in message.status[0].values}

    def spin(self, duration: float) -> None:
        """Publish and listen for some time, s."""
        end = time.monotonic() + duration
        while (left := end - time.monotonic()) > 0:
            self.executor.spin_once(timeout_sec=left)

    def wait(self, condition: Callable[[], bool], what: str) -> None:
        """
        Publish and listen until a condition holds; note how long this process stood still.

        :param what: the condition, in words.
        :raises RuntimeError: when that takes too long.
        """
        now = time.monotonic()
        end, self.longest_pause = now + DEADLINE, 0.0
        while not condition():
            if now > end:
                raise RuntimeError(f'no {what} within {DEADLINE:g} s')
            self.executor.spin_once(timeout_sec=PATIENCE)
            before, now = now, time.monotonic()
            self.longest_pause = max(self.longest_pause, now - before - PATIENCE)

    def drives(self) -> bool:
        """Return whether the newest command moves the robot."""
        return bool(self.commands) and self.commands[-1][1]

    def close(self) -> None:
        """Leave the graph."""
        self.executor.shutdown()
        self.node.destroy_node()
        rclpy.try_shutdown()


def world(pedestrians: int, case: int) -> CrowdState:
    """Return the start of an episode without obstacles, batch of one."""
    scenario = Scenario('rig', pedestrians=pedestrians, obstacles=0)
    return Simulator(scenario, batch_size=1).reset(seed=0, cases=[case])


def usage(rig: Rig, number: int, duration: float) -> float:
    """Return the share of one core that a process uses while the rig is spun for some time, s."""
    began, used = time.monotonic(), processor_time(number)
    rig.spin(duration)
    return (processor_time(number) - used) / (time.monotonic() - began)


def processor_time(number: int) -> float:
    """Return the processor time that a process has used, s."""
    fields = Path(f'/proc/{number}/stat').read_text().rpartition(')')[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf('SC_CLK_TCK')


def memory(number: int) -> float:
    """Return the memory that a process occupies, MB."""
    pages = int(Path(f'/proc/{number}/statm').read_text().split()[1])
    return pages * os.sysconf('SC_PAGE_SIZE') * 1e-6


def conditions() -> str:
    """Return what else the machine does, for the record."""
    one, five, _ = os.getloadavg()
    return f'{os.cpu_count()} cores, load {one:.1f} (1 min), {five:.1f} (5 min)'
