"""An episode as a ROS 2 bag (MCAP), written without ROS."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from socialnav_core import messages
from socialnav_core.extras import extra
from socialnav_core.simulation.kinematics import kinematics_of
from socialnav_core.viewing.recording import Recording
from socialnav_core.viewing.ros2msg import schema_of

with extra('bag'):
    from mcap_ros2.writer import Writer

FRAME, BASE_FRAME = 'odom', 'base_link'
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
    """Write an episode as the topics of a simulator in lockstep and a robot that answers it."""
    with path.open('wb') as file, Writer(file) as writer:
        schemas = {
            kind: writer.register_msgdef(full_name(kind), schema_of(kind))
            for kind in dict.fromkeys(TYPES.values())
        }
        for topic, message, stamp in all_messages(recording):
            writer.write_message(f'/{topic}', schemas[TYPES[topic]], message, stamp)


def full_name(kind: str) -> str:
    """Return a type, `package/Type`, as bags name it."""
    return kind.replace('/', '/msg/')


def all_messages(recording: Recording) -> Iterator[tuple[str, messages.Message, int]]:
    """Yield topic, message and time, ns, of everything in an episode."""
    commands, kinematics = recording.commands or [], kinematics_of(recording.kinematics)
    for step, state in enumerate(recording.states):
        stamp = START + round(float(state.time[0]) * 1e9)
        yield 'goal_pose', messages.goal(state, stamp, FRAME), stamp
        yield 'obstacles', messages.agent_states(state, True, stamp, FRAME), stamp
        yield 'pedestrians', messages.agent_states(state, False, stamp, FRAME), stamp
        yield 'odom', messages.odometry(state, stamp, FRAME, BASE_FRAME), stamp
        tolerance = recording.goal_tolerance
        yield 'markers', messages.world_markers(state, tolerance, stamp, FRAME), stamp
        if step < len(commands):
            command = kinematics.to_base(commands[step], float(state.robot.heading[0]))
            twist = messages.twist(command, recording.kinematics)
            yield 'cmd_vel', messages.stamped_twist(twist, stamp, BASE_FRAME), stamp
    yield 'episode_result', messages.episode_result(end_of(recording), stamp, FRAME), stamp


def end_of(recording: Recording) -> messages.EpisodeEnd:
    """Return how an episode ended."""
    steps = np.diff(recording.robot_path, axis=0)
    return messages.EpisodeEnd(
        scenario=recording.scenario,
        seed=recording.seed,
        case_index=recording.case_index,
        outcome=recording.outcome,
        time=float(recording.times[-1]),
        path_length=float(np.hypot(steps[:, 0], steps[:, 1]).sum()),
        minimum_clearance=recording.minimum_clearance,
        steps=len(recording.states) - 1,
    )
