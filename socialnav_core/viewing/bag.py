"""An episode as a ROS 2 bag (MCAP), written without ROS."""

from collections.abc import Iterator
from pathlib import Path

from socialnav_core.extras import extra
from socialnav_core.viewing import bag_messages as messages
from socialnav_core.viewing.bag_markers import world_markers
from socialnav_core.viewing.recording import Recording
from socialnav_core.viewing.ros2msg import schema_of

with extra('bag'):
    from mcap_ros2.writer import Writer

START = 10**9
"""Time of the first state, ns; a stamp of zero means to many tools that there is none."""
TYPES = {
    'pedestrians': 'socialnav_msgs/AgentStates',
    'obstacles': 'socialnav_msgs/AgentStates',
    'odom': 'nav_msgs/Odometry',
    'goal_pose': 'geometry_msgs/PoseStamped',
    'cmd_vel': 'geometry_msgs/TwistStamped',
    'markers': 'visualization_msgs/MarkerArray',
    'episode_result': 'socialnav_msgs/EpisodeResult',
}
"""Type of each topic."""


def write_bag(recording: Recording, path: Path) -> None:
    """
    Write an episode as the topics of a simulator in lockstep and a robot that answers it.

    :param recording: made by `record`.
    :param path: file to write.
    """
    with path.open('wb') as file, Writer(file) as writer:
        schemas = {
            kind: writer.register_msgdef(full_name(kind), schema_of(kind))
            for kind in dict.fromkeys(TYPES.values())
        }
        for topic, message, stamp in all_messages(recording):
            writer.write_message(f'/{topic}', schemas[TYPES[topic]], message, stamp)


def full_name(kind: str) -> str:
    """
    Return a type as bags name it.

    :param kind: `package/Type`.
    """
    return kind.replace('/', '/msg/')


def all_messages(recording: Recording) -> Iterator[tuple[str, messages.Message, int]]:
    """
    Yield topic, message and time, ns, of everything in an episode.

    :param recording: made by `record`.
    """
    commands, differential = recording.commands or [], recording.kinematics == 'differential'
    for step, state in enumerate(recording.states):
        stamp = START + round(float(state.time[0]) * 1e9)
        turn_rate = float(commands[step - 1][1]) if differential and step else 0.0
        yield 'goal_pose', messages.goal(state, stamp), stamp
        yield 'obstacles', messages.agent_states(state, True, stamp), stamp
        yield 'pedestrians', messages.agent_states(state, False, stamp), stamp
        yield 'odom', messages.odometry(state, turn_rate, stamp), stamp
        yield 'markers', world_markers(state, recording.goal_tolerance, stamp), stamp
        if step < len(commands):
            heading = float(state.robot.heading[0])
            command = messages.command(commands[step], heading, recording.kinematics, stamp)
            yield 'cmd_vel', command, stamp
    yield 'episode_result', messages.episode_result(recording, stamp), stamp
