"""From ROS messages to CrowdState: pure functions that refuse what cannot be true."""

from collections.abc import Sequence
import dataclasses
import math

from geometry_msgs.msg import PoseStamped, Quaternion
from nav_msgs.msg import Odometry
import numpy as np
from std_msgs.msg import Header

from socialnav.messages.frames import Locate, not_asked
from socialnav.messages.stamps import nanoseconds_of
from socialnav.messages.texts import cut
from socialnav_core.sensing import HERE, Pose
from socialnav_core.simulation.kinematics.angles import rotated
from socialnav_core.states import Agents, CrowdState, Robot
from socialnav_msgs.msg import AgentStates

LONGEST_QUOTE = 60
"""Letters of a foreign text that are logged."""
LONGEST_REASON = 200
"""Letters of a reason of tf2, which may quote frames itself."""
LARGEST = 1e9
"""No number of a message is larger, m or m/s: squares of such numbers are numbers too."""


class ConversionError(ValueError):
    """A message that must not be used; the text names the input and what is wrong with it."""

    def __init__(self, text: str) -> None:
        """Keep the text, or the beginning of a very long one."""
        super().__init__(cut(text))


class FrameError(ConversionError):
    """A message in a frame of which nobody knows where it lies."""


@dataclasses.dataclass(frozen=True)
class RobotBody:
    """What no message says about the robot."""

    radius: float
    """Radius of the robot's disc, m."""
    preferred_speed: float
    """Speed that the robot would like to drive at, m/s."""
    bounds: float = math.inf
    """Half-width of the square around the origin that must not be left, m."""


def heading_of(name: str, rotation: Quaternion) -> float:
    """
    Return the heading of a unit quaternion, rad in [-pi, pi].

    :param name: the input, for the error.
    """
    x, y, z, w = rotation.x, rotation.y, rotation.z, rotation.w
    length = math.sqrt(x * x + y * y + z * z + w * w)
    if not abs(length - 1) < 0.01:
        raise ConversionError(f'{name}: orientation is no rotation (norm {length:.3g}, not 1)')
    return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def crowd_state(
    odometry: Odometry,
    goal: PoseStamped,
    pedestrians: AgentStates | Sequence[AgentStates],
    obstacles: AgentStates | Sequence[AgentStates] | None,
    body: RobotBody,
    frame: str,
    time: float = 0.0,
    locate: Locate = not_asked,
    base_frame: str = 'base_link',
) -> CrowdState:
    """
    Return the world as the messages tell it, in a frame, pedestrians first; batch of one.

    :param pedestrians: one list or several; all are as of the newest of them.
    :param obstacles: one list, several or none.
    :param time: since the start of the run, s.
    :param base_frame: frame of the robot.
    :raises ConversionError: a foreign frame, or a number that cannot be.
    """
    position, velocity, heading = robot_arrays(odometry, frame, locate, base_frame)
    walking = merged_arrays('pedestrians', each(pedestrians), frame, static=False, locate=locate)
    standing = merged_arrays('obstacles', each(obstacles), frame, static=True, locate=locate)
    agents = [np.concatenate(pair)[None] for pair in zip(walking, standing, strict=True)]
    return CrowdState(
        Robot(
            position=position[None],
            velocity=velocity[None],
            heading=np.array([heading]),
            radius=np.array([float(body.radius)]),
            preferred_speed=np.array([float(body.preferred_speed)]),
            goal=goal_array(goal, frame, locate)[None],
            turn_rate=np.array([float(odometry.twist.twist.angular.z)]),
        ),
        Agents(
            position=agents[0],
            velocity=agents[1],
            radius=agents[2],
            static=agents[3],
            valid=np.ones(agents[3].shape, dtype=bool),
        ),
        bounds=np.array([float(body.bounds)]),
        time=np.array([float(time)]),
    )


def robot_arrays(
    odometry: Odometry, frame: str, locate: Locate = not_asked, base_frame: str = 'base_link'
) -> tuple[np.ndarray, np.ndarray, float]:
    """
    Return position (2,) and velocity (2,) in the world, and heading.

    :param odometry: its twist is in the frame that its child_frame_id names.
    :param base_frame: frame of the robot.
    :raises ConversionError: a foreign frame, or a number that cannot be, the turn rate among them.
    """
    placement = placement_of('odom', odometry.header, frame, locate)
    pose, linear = odometry.pose.pose, odometry.twist.twist.linear
    heading = heading_of('odom', pose.orientation) + placement.heading
    position = finite('odom', 'position', [pose.position.x, pose.position.y])
    velocity = finite('odom', 'velocity', [linear.x, linear.y])
    finite('odom', 'turn rate', [odometry.twist.twist.angular.z])
    turned = placement.heading if twist_stands(odometry, base_frame) else heading
    return placement.placed(position), rotated(velocity, turned), heading


def twist_stands(odometry: Odometry, base_frame: str) -> bool:
    """
    Return whether the twist of odometry is in the frame of its pose, not in that of the robot.

    :param base_frame: frame of the robot; odometry that names none is taken to mean it.
    :raises ConversionError: any other frame.
    """
    frame = odometry.child_frame_id
    if frame in ('', base_frame):
        return False
    if frame == odometry.header.frame_id:
        return True
    known = f'the robot is {base_frame!r} (base_frame)'
    raise ConversionError(f'odom: the twist is in child_frame_id {quoted(frame)}, but {known}')


def goal_array(goal: PoseStamped, frame: str, locate: Locate = not_asked) -> np.ndarray:
    """Return the place to go to in a frame, (2,); the orientation of the goal means nothing."""
    placement = placement_of('goal_pose', goal.header, frame, locate, newest=True)
    position = [goal.pose.position.x, goal.pose.position.y]
    return placement.placed(finite('goal_pose', 'position', position))


def each(told: AgentStates | Sequence[AgentStates] | None) -> Sequence[AgentStates]:
    """Return lists of agents that may be one, several or none."""
    if told is None:
        return ()
    return [told] if isinstance(told, AgentStates) else told


def merged_arrays(
    name: str,
    messages: Sequence[AgentStates],
    frame: str,
    static: bool,
    locate: Locate = not_asked,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """
    Return the agents of several lists as agent_arrays() does, moved on to the newest stamp.

    :param name: the input, for errors.
    """
    if len(messages) == 1:
        return agent_arrays(name, messages[0], frame, static, locate)
    newest = max((nanoseconds_of(one.header.stamp) for one in messages), default=0)
    told = [agent_arrays(name, None, frame, static, locate)]
    for message in messages:
        position, velocity, *rest = agent_arrays(name, message, frame, static, locate)
        age = (newest - nanoseconds_of(message.header.stamp)) * 1e-9
        told.append((position + age * velocity, velocity, *rest))
    position, velocity, radius, standing = (
        np.concatenate(arrays) for arrays in zip(*told, strict=True)
    )
    return position, velocity, radius, standing


def agent_arrays(
    name: str,
    message: AgentStates | None,
    frame: str,
    static: bool,
    locate: Locate = not_asked,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """
    Return position (agents, 2), velocity (agents, 2), radius (agents,) and static (agents,).

    :param name: the input, for errors.
    :param static: whether they stand for ever; a velocity is not read then.
    """
    agents, placement = [], HERE
    if message is not None:
        agents = message.agents
        placement = placement_of(name, message.header, frame, locate, newest=static)
    position = finite(name, 'position', [(one.position.x, one.position.y) for one in agents])
    velocity = np.zeros((len(agents), 2))
    if not static:
        speeds = [(one.velocity.x, one.velocity.y) for one in agents]
        velocity = finite(name, 'velocity', speeds).reshape(-1, 2)
    radius = finite(name, 'radius', [one.radius for one in agents])
    if (radius < 0).any():
        raise ConversionError(f'{name}: negative radius ({radius.min():g} m)')
    position, velocity = placement.placed(position.reshape(-1, 2)), placement.turned(velocity)
    return position, velocity, radius, np.full(len(agents), static)


def placement_of(
    name: str, header: Header, frame: str, locate: Locate, newest: bool = False
) -> Pose:
    """
    Return where the frame of a message lies in the one that is wanted.

    :param name: the input, for the error.
    :param newest: whether the newest placement counts, since what the message tells stands still
        and may have been told long ago; otherwise that at its stamp.
    :raises FrameError: a frame that nobody knows.
    """
    if header.frame_id == frame:
        return HERE
    try:
        return locate(frame, header.frame_id, 0 if newest else nanoseconds_of(header.stamp))
    except LookupError as error:
        text = f'{name}: in frame {quoted(header.frame_id)}, but {str(error)[:LONGEST_REASON]}'
        raise FrameError(text) from error


def quoted(text: str) -> str:
    """Return a text of somebody else as it is logged: on one line, and not longer than that."""
    return repr(text if len(text) <= LONGEST_QUOTE else f'{text[:LONGEST_QUOTE]}...')


def finite(name: str, quantity: str, numbers: list | np.ndarray) -> np.ndarray:
    """
    Return numbers as float64; raise a ConversionError where one is not finite, or absurd.

    :param name: the input, for the error.
    :param quantity: what the numbers are, for the error.
    :param numbers: floats or pairs of them.
    """
    array = np.array(numbers, dtype=float)
    if not np.isfinite(array).all():
        raise ConversionError(f'{name}: {quantity} with NaN or infinity')
    if (np.abs(array) > LARGEST).any():
        raise ConversionError(f'{name}: {quantity} beyond {LARGEST:g}')
    return array
