"""Random messages of every kind: right ones, NaN, infinities, empty and huge ones, bare bytes."""

import array
import math

from geometry_msgs.msg import Pose, PoseArray
from nav_msgs.msg import OccupancyGrid, Odometry
import numpy as np
from sensor_msgs.msg import LaserScan

from helpers.worlds import messages_of, random_state
from socialnav import qos
from socialnav.messages.stamps import header_message
from socialnav_msgs.msg import AgentState, AgentStates

ODD = (0.0, -0.0, -1.0, 1e-300, 1e300, -1e300, math.nan, math.inf, -math.inf, 1.0, 3.0)
ODD_SINGLE = tuple(one for one in ODD if abs(one) < 3e38 or not math.isfinite(one))
FRAMES = ('odom', 'base_link', 'map', '', 'x' * 100_000)
SIZES = (0, 1, 2, 7, 360, 20_000)
TOPICS = {
    'odom': (Odometry, qos.ODOMETRY),
    'pedestrians': (AgentStates, qos.PEDESTRIANS),
    'scan': (LaserScan, qos.SCAN),
    'map': (OccupancyGrid, qos.MAP),
    'detections': (PoseArray, qos.DETECTIONS),
}


class Fuzzer:
    """Random messages that a seed decides."""

    def __init__(self, seed):
        self.random = np.random.default_rng(seed)

    def number(self, odd=ODD):
        """Return a number that is odd one time in four."""
        if self.random.random() < 0.25:
            return float(self.random.choice(odd))
        return float(self.random.normal(scale=3.0))

    def header(self, now):
        """Return a header with any stamp and frame, mostly good ones."""
        if self.random.random() < 0.7:
            return header_message(now, 'odom')
        stamps = (0, 1, now - 10**9, now + 10**9, now - 3600 * 10**9, 2**31 * 10**9 - 1)
        return header_message(
            int(self.random.choice(np.array(stamps, dtype=np.int64))),
            str(self.random.choice(FRAMES)),
        )

    def message(self, topic, now):
        """Return a message of a topic, or bytes that are none."""
        if self.random.random() < 0.05:
            return self.random.bytes(int(self.random.integers(4, 200)))
        message = getattr(self, topic)(now)
        if topic != 'odom' or self.random.random() < 0.3:
            message.header = self.header(now)
        return message

    def odom(self, now):
        """Return a right odometry, mostly; the others are of no use without it."""
        message = messages_of(random_state(0), now)['odom']
        if self.random.random() < 0.3:
            message.pose.pose.position.x = self.number()
            message.pose.pose.orientation.w = self.number()
            message.twist.twist.linear.x = self.number()
        return message

    def pedestrians(self, now):
        """Return some people, sometimes very many, from any source."""
        count = int(self.random.choice([0, 1, 5, 50, 2000]))
        message = AgentStates(source=f'/node:{self.random.integers(20)}')
        for _ in range(count):
            agent = AgentState(radius=abs(self.number()))
            agent.position.x, agent.position.y = self.number(), self.number()
            agent.velocity.x = self.number()
            message.agents.append(agent)
        return message

    def scan(self, now):
        """Return a scan of any size with numbers of any kind, sometimes right ones."""
        beams = int(self.random.choice(SIZES))
        ranges = self.random.uniform(0.0, 12.0, beams).astype(np.float32)
        odd = self.random.random(beams) < self.random.choice([0.0, 0.3, 1.0])
        ranges[odd] = self.random.choice(np.array(ODD_SINGLE), odd.sum())
        step = 2 * math.pi / max(beams, 1)
        message = LaserScan(
            angle_min=-math.pi, angle_max=math.pi - step, angle_increment=step, range_max=10.0,
            ranges=array.array('f', ranges.tobytes()),
        )  # fmt: skip
        if self.random.random() < 0.3:
            fields = ['angle_min', 'angle_max', 'angle_increment', 'range_min', 'range_max']
            setattr(message, str(self.random.choice(fields)), self.number(ODD_SINGLE))
        return message

    def map(self, now):
        """Return a grid, small or as large as a floor at 2 cm, whose sizes may not fit."""
        width, height = (int(self.random.choice([0, 1, 50, 600])) for _ in range(2))
        levels = self.random.integers(-1, 101, width * height).astype(np.int8)
        message = OccupancyGrid(data=array.array('b', levels.tobytes()))
        message.info.width, message.info.height = width, height + int(self.random.random() < 0.1)
        message.info.resolution = float(self.random.choice([0.02, 0.05, 1e-30, math.nan, 0.0]))
        message.info.origin.orientation.w = 1.0
        message.info.origin.position.x = self.number()
        return message

    def detections(self, now):
        """Return where people are said to be, sometimes very many."""
        count = int(self.random.choice([0, 1, 5, 50, 299, 2000]))
        message = PoseArray()
        for x, y in [(self.number(), self.number()) for _ in range(count)]:
            pose = Pose()
            pose.position.x, pose.position.y = x, y
            message.poses.append(pose)
        return message
