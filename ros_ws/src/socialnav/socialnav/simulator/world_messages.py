"""A simulated world as the messages of its topics."""

import dataclasses
from typing import Any

from socialnav.messages.conversions import agents_message, goal_message, odometry_message
from socialnav.messages.stamps import header_message
from socialnav.simulator.world import Episode, World
from socialnav_msgs.msg import EpisodeResult


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
    """
    Return the messages that every state needs, by topic.

    :param world: as it is.
    :param nanoseconds: time of its state.
    :param frames: names of the frames.
    """
    state, rate = world.state, world.turn_rate
    return {
        'pedestrians': agents_message(state, False, nanoseconds, frames.odom),
        'odom': odometry_message(state, nanoseconds, frames.odom, frames.base, rate),
    }


def standing_messages(world: World, nanoseconds: int, frames: Frames) -> dict[str, Any]:
    """
    Return the messages of what stays as it is during an episode, by topic.

    :param world: as it is.
    :param nanoseconds: time of its state.
    :param frames: names of the frames.
    """
    return {
        'goal_pose': goal_message(world.state, nanoseconds, frames.odom),
        'obstacles': agents_message(world.state, True, nanoseconds, frames.odom),
    }


def result_message(episode: Episode, nanoseconds: int, frames: Frames) -> EpisodeResult:
    """
    Return how an episode ended.

    :param episode: the record.
    :param nanoseconds: time of its end.
    :param frames: names of the frames.
    """
    header = header_message(nanoseconds, frames.odom)
    return EpisodeResult(header=header, **dataclasses.asdict(episode))
