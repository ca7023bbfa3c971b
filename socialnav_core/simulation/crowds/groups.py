"""
People in groups of two to four who walk together, and push everybody else away.

Source: M. Moussaid, N. Perozo, S. Garnier, D. Helbing and G. Theraulaz, The walking behaviour of
pedestrian social groups and its impact on crowd dynamics, PLoS ONE 5(4), 2010. Members keep apart
by the forces of the crowd social_force.
"""

import math

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.forces import (
    limited,
    limited_accelerations,
    seen_agents,
    social_accelerations,
)
from socialnav_core.simulation.crowds.goals import renew_goals, velocities_to_goals
from socialnav_core.simulation.crowds.social_force import Force
from socialnav_core.simulation.crowds.social_force_kernel import HASTE, SUBSTEP
from socialnav_core.simulation.layout import GAP
from socialnav_core.simulation.random_streams import uniform

SIZES, SHARES = (2, 3, 4), (0.5, 0.3)
"""Sizes of groups, and the shares of the first of them; the last has the rest."""
LOOKING, STAYING = 4.0, 3.0
"""Braking per radian by which heads are turned, 1/s; acceleration to the middle, m/s^2."""
ARRIVED = 1.0
"""A group has arrived where one of them is so near to the goal, m."""
BESIDE = 0.3
"""Gap between members at the start, m."""
PLACES = 16
"""Directions from the first of a group in which the others look for a place."""


def make_crowd(scenario: Scenario, batch_size: int) -> 'GroupCrowd':
    """Return the crowd."""
    return GroupCrowd(batch_size, scenario.pedestrians)


class GroupCrowd:
    """Remembers who walks with whom."""

    def __init__(self, batch_size: int, people: int) -> None:
        """Make room; `reset` fills it."""
        self.leaders = np.tile(np.arange(people), (batch_size, 1))
        """First of the group of each person, (batch, people)."""

    def reset(self, episodes: Episodes, worlds: np.ndarray) -> None:
        """Draw the groups of some worlds, and put their members side by side."""
        people = self.leaders.shape[1]
        for world in worlds:
            first = 0
            while first < people:
                size = min(draw_size(episodes.goal_streams[world, first]), people - first)
                self.leaders[world, first : first + size] = first
                for member in range(first + 1, first + size):
                    place_beside(episodes, world, first, member)
                    episodes.goal[world, member] = episodes.goal[world, first]
                first += size

    def decide(self, episodes: Episodes, due: np.ndarray, velocities: np.ndarray) -> None:
        """Write the mean velocities of the coming step; see Crowd.decide."""
        people, agents = self.leaders.shape[1], episodes.state.agents
        preferred = velocities_to_goals(episodes, people)[due]
        others = seen_agents(episodes.state.select(due), episodes.scenario)
        begin = agents.position[due, :people]
        position, motion = begin, agents.velocity[due, :people]
        fastest = HASTE * episodes.preferred_speed[due, :people]
        same = self.leaders[due][:, :, None] == self.leaders[due][:, None]
        duration = episodes.scenario.time_step
        substeps = max(1, math.ceil(duration / SUBSTEP - 1e-9))
        for _ in range(substeps):
            force = (preferred - motion) / Force().relaxation
            force += social_accelerations(position, others, others.radius[:, :people], preferred)
            force += group_accelerations(position, motion, preferred, same)
            motion = limited(motion + duration / substeps * limited_accelerations(force), fastest)
            position = position + duration / substeps * motion
        velocities[due, :people] = (position - begin) / duration

    def renew_goals(self, episodes: Episodes) -> None:
        """Give another goal to the groups that have arrived; see Crowd.renew_goals."""
        people = self.leaders.shape[1]
        goal, position = episodes.goal[:, :people], episodes.state.agents.position[:, :people]
        near = np.linalg.norm(goal - position, axis=-1) < ARRIVED
        worlds = np.arange(len(near))[:, None]
        arrived = np.zeros_like(near)
        np.logical_or.at(arrived, (worlds, self.leaders), near)
        goal[arrived] = position[arrived]
        renew_goals(episodes)
        goal[:] = goal[worlds, self.leaders]

    def get_state(self) -> dict[str, np.ndarray]:
        """Return who walks with whom."""
        return {'leaders': self.leaders.copy()}

    def set_state(self, arrays: dict[str, np.ndarray]) -> None:
        """Go on from there."""
        self.leaders = arrays['leaders'].copy()


def draw_size(stream: np.ndarray) -> int:
    """Return the size of a group."""
    draw, size = uniform(stream, 0.0, 1.0), 0
    for size, share in zip(SIZES, SHARES, strict=False):
        if draw < share:
            return size
        draw -= share
    return SIZES[-1]


def place_beside(episodes: Episodes, world: int, first: int, member: int) -> None:
    """Put a member beside the first of a group; where there is no room they have to catch up."""
    agents, robot = episodes.state.agents, episodes.state.robot
    position, radius = agents.position[world], agents.radius[world]
    apart = radius[first] + radius[member] + BESIDE
    others = np.arange(len(radius)) != member
    for k in range(PLACES):
        angle = 2.0 * math.pi * k / PLACES
        place = position[first] + apart * np.array([math.cos(angle), math.sin(angle)])
        gaps = np.linalg.norm(position - place, axis=1) - radius - radius[member]
        way = np.linalg.norm(robot.position[world] - place)
        free = (gaps[others] > GAP - 1e-9).all() and way > radius[member] + (
            robot.radius[world] + GAP
        )
        if free and np.abs(place).max() < episodes.state.bounds[world] - radius[member]:
            position[member] = place
            return


def group_accelerations(
    position: np.ndarray, motion: np.ndarray, preferred: np.ndarray, same: np.ndarray
) -> np.ndarray:
    """
    Return what keeps groups together, m/s^2, (batch, people, 2).

    Who is far from the middle of their group is drawn there; who walks so far ahead that they
    would have to turn their head by more than a right angle to see it slows down.

    :param position: m, (batch, people, 2).
    :param motion: m/s, (batch, people, 2).
    :param preferred: m/s, (batch, people, 2).
    :param same: whether two are of one group, bool (batch, people, people).
    """
    size = same.sum(axis=2)
    others = np.maximum(size - 1, 1)[..., None]
    middle = (np.einsum('bij,bjk->bik', same.astype(float), position) - position) / others
    way = np.where((size > 1)[..., None], middle - position, 0.0)
    distance = np.linalg.norm(way, axis=-1)
    unit = way / np.maximum(distance, 1e-9)[..., None]
    whole = distance * (size - 1) / size  # to the middle of all, oneself among them
    drawn = np.where(whole > 0.5 * (size - 1), STAYING, 0.0)[..., None] * unit
    speed = np.linalg.norm(preferred, axis=-1)
    ahead = (unit * preferred).sum(axis=-1) / np.maximum(speed, 1e-9)
    turned = np.maximum(np.arccos(np.clip(ahead, -1.0, 1.0)) - 0.5 * math.pi, 0.0)
    looking = np.where((size > 1) & (distance > 0.0), turned, 0.0)
    return drawn - LOOKING * looking[..., None] * motion
