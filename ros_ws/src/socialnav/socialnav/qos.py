"""Quality of service of every topic, in one place."""

from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy


def profile(depth: int, *, reliable: bool = True, latched: bool = False) -> QoSProfile:
    """
    Return a profile that keeps the last messages.

    :param latched: whether a subscriber that comes late gets the last messages.
    """
    reliability = ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT
    durability = DurabilityPolicy.TRANSIENT_LOCAL if latched else DurabilityPolicy.VOLATILE
    return QoSProfile(
        history=HistoryPolicy.KEEP_LAST,
        depth=depth,
        reliability=reliability,
        durability=durability,
    )


ODOMETRY = profile(10)
PEDESTRIANS = profile(10)
OBSTACLES = profile(1, latched=True)
OBSTACLES_INPUT = profile(16, latched=True)
"""What a reader of several publishers needs, whose latched lists come at once."""
GOAL = profile(10)
"""Volatile, because the goal tool of RViz publishes so and both ends must agree."""
MAP = profile(1, latched=True)
PLAN = profile(1)
"""Volatile, because planners publish so and a subscriber must not ask for more."""
MARKERS = profile(1)
EPISODE_RESULT = profile(10, latched=True)
CLOCK = profile(1, reliable=False)
SCAN = profile(5, reliable=False)
DETECTIONS = profile(10)
COMMAND = profile(1)
TRANSFORMS = profile(100)
STATIC_TRANSFORMS = profile(1, latched=True)
GOAL_REACHED = profile(1, latched=True)
STATE = profile(1, latched=True)
DIAGNOSTICS = profile(10)
ATTENTION = profile(1)
PREDICTED_PATH = profile(1)
SPEED_LIMIT = profile(10)
BOND = profile(5)

SENSOR_INPUT = profile(5, reliable=False)
"""What the policy reads in real time: any publisher matches, and old samples are worth nothing."""
LOCKSTEP_INPUT = profile(10)
"""What the policy reads in lockstep, where a lost message would stop the world."""
RECORDING = profile(1000)
"""For a listener that must not miss a step."""
LATCHED_RECORDING = profile(1000, latched=True)
"""The same, for topics that are latched."""
