"""Plans of a global planner."""

from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path
from rclpy.serialization import serialize_message

from helpers.controllers import SECOND
from socialnav.messages.paths import read_path, ReadPath
from socialnav.messages.stamps import header_message


def plan_of(points, stamp=SECOND, frame='odom'):
    """Return a plan as planners publish it."""
    plan = Path(header=header_message(stamp, frame))
    for x, y in points:
        pose = PoseStamped()
        pose.pose.position.x, pose.pose.position.y = x, y
        plan.poses.append(pose)
    return plan


def read(plan: Path) -> ReadPath:
    """Return a plan as the policy reads it."""
    return read_path(serialize_message(plan))
