"""A simulated world as the messages of its topics."""

import dataclasses
from typing import Any

from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Odometry

from socialnav.messages.filling import filled
from socialnav.simulator.world import World
from socialnav_core.messages import agent_states, goal, odometry
from socialnav_msgs.msg import AgentStates


@dataclasses.dataclass(frozen=True)
class Frames:
    """Names of the frames; map and odom coincide in the simulator."""

    map: str
    """Frame of the map."""
    odom: str
    """Frame of everything else."""
    base: str
    """Frame of the robot."""


def moving_messages(world: World, nanoseconds: int, frames: Frames) -> dict[str, Any]:
    """Return the messages that every state needs, by topic."""
    state, now = world.state, (nanoseconds, frames.odom)
    return {
        'pedestrians': filled(AgentStates, agent_states(state, False, *now)),
        'odom': filled(Odometry, odometry(state, *now, frames.base)),
    }


def standing_messages(world: World, nanoseconds: int, frames: Frames) -> dict[str, Any]:
    """Return the messages of what stays as it is during an episode, by topic."""
    state, now = world.state, (nanoseconds, frames.odom)
    return {
        'goal_pose': filled(PoseStamped, goal(state, *now)),
        'obstacles': filled(AgentStates, agent_states(state, True, *now)),
    }
