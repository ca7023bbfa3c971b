"""
People of all speeds and sizes who change their minds; whoever arrives is replaced by a new one.

This is the crowd in which CrowdNav++ (Liu et al. 2023, Intention Aware Robot Crowd Navigation with
Attention-Based Interaction Graph) and its successors are tested, with ORCA as their motion.
"""

import math

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.config import require, Scenario
from socialnav_core.simulation.births import draw_other_goal, draw_person, draw_place
from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.goals import velocities_to_goals
from socialnav_core.simulation.crowds.orca import RADIUS_PADDING, RECIPROCAL
from socialnav_core.simulation.crowds.orca_kernel import Bodies, Foresight, orca_step
from socialnav_core.simulation.layout import PackingError
from socialnav_core.simulation.random_streams import uniform

PERIOD = 5.0
"""Every so often some people get another goal, s."""
CHANGE = 0.5
"""Probability that somebody does."""
WALKING_SPEED = 1.0
"""What people prefer, m/s; their own speed only limits it."""
NEAREST_SHARE = 0.5
"""People notice others within orca.neighbor_distance times U(this, 1)."""


def make_crowd(scenario: Scenario, batch_size: int) -> 'ChangingCrowd':
    """
    Return the crowd.

    :raises ConfigError: for a scenario in which it cannot live.
    """
    require(not scenario.robot_visible, 'the crowd changing does not see the robot')
    return ChangingCrowd(batch_size, scenario.pedestrians)


class ChangingCrowd:
    """Remembers from how far each person notices others."""

    def __init__(self, batch_size: int, people: int) -> None:
        """Make room; `reset` fills it."""
        self._reach = np.zeros((batch_size, people))

    def reset(self, episodes: Episodes, worlds: np.ndarray) -> None:
        """Draw how far the people of some worlds see; all of a world see equally far."""
        farthest = episodes.scenario.orca.neighbor_distance
        for world in worlds if self._reach.shape[1] else ():
            stream = episodes.goal_streams[world, -1]
            self._reach[world] = uniform(stream, NEAREST_SHARE * farthest, farthest)

    def decide(self, episodes: Episodes, due: np.ndarray, velocities: np.ndarray) -> None:
        """Write the velocities that avoid everybody who is noticed; see Crowd.decide."""
        scenario, agents = episodes.scenario, episodes.state.agents
        orca = scenario.orca
        preferred = velocities_to_goals(
            episodes, agents.count, np.full_like(agents.radius, WALKING_SPEED)
        )
        bodies = Bodies(
            position=agents.position,
            velocity=agents.velocity,
            preferred_velocity=preferred,
            radius=agents.radius + (RADIUS_PADDING + orca.safety_space),
            max_speed=episodes.preferred_speed,
            valid=agents.valid,
            responsibility=np.where(agents.static, orca.static_responsibility, RECIPROCAL),
            neighbor_distance=self._reach,
        )
        foresight = Foresight(orca.max_neighbors, orca.time_horizon, scenario.time_step)
        orca_step(bodies, foresight, due, scenario.pedestrians, velocities)

    def renew_goals(self, episodes: Episodes) -> None:
        """
        Give some people other goals where it is time, and replace whoever has arrived.

        :raises PackingError: when there is no room for a goal or a person.
        """
        state, scenario = episodes.state, episodes.scenario
        robot = np.concatenate([state.robot.position, state.robot.goal], axis=1)
        if not _renew(
            episodes.active, state.time, scenario.time_step, scenario.circle_radius,
            scenario.orca.neighbor_distance, robot, state.robot.radius, state.agents.position,
            state.agents.velocity, state.agents.radius, episodes.preferred_speed, episodes.goal,
            self._reach, episodes.goal_streams,
        ):  # fmt: skip
            raise PackingError(
                f'scenario {scenario.name}: no room for another person or goal on the circle of '
                f'{scenario.circle_radius:g} m; lower pedestrians or raise circle_radius'
            )

    def get_state(self) -> dict[str, np.ndarray]:
        """Return how far everybody sees."""
        return {'reach': self._reach.copy()}

    def set_state(self, arrays: dict[str, np.ndarray]) -> None:
        """Go on from there."""
        self._reach = arrays['reach'].copy()


@compiled
def _renew(  # type: ignore[no-untyped-def]
    active, time, time_step, circle, farthest, robot, robot_radius, position, velocity, radius,
    speed, goal, reach, streams,
):  # fmt: skip
    """Change goals and replace people in the active worlds; return whether there was room."""
    people = streams.shape[1]
    for world in range(active.size):
        if not active[world]:
            continue
        here, aims, sizes = position[world], goal[world], radius[world]
        me, own_radius = robot[world], robot_radius[world]
        since = time[world] - PERIOD * math.floor(time[world] / PERIOD + 1e-9)
        if since < time_step - 1e-9 and time[world] > 0.5 * PERIOD:
            for i in range(people):
                stream = streams[world, i]
                if uniform(stream, 0.0, 1.0) < CHANGE and not draw_other_goal(
                    stream, circle, me, own_radius, here, aims, sizes, people, i, speed[world, i]
                ):
                    return False
        latest = -1
        for i in range(people):
            x, y = aims[i, 0] - here[i, 0], aims[i, 1] - here[i, 1]
            if x * x + y * y >= sizes[i] * sizes[i]:
                continue
            stream = streams[world, i]
            old = sizes[i]
            draw_person(stream, speed[world], sizes, i)
            size, sizes[i] = sizes[i], old  # whoever leaves still takes up their own room
            if not draw_place(
                stream, circle, me, own_radius, here, aims, sizes, people, people, i, size
            ):
                return False
            sizes[i] = size
            velocity[world, i, 0] = velocity[world, i, 1] = 0.0
            reach[world, i] = -1.0
            latest = i
        if latest >= 0:  # those who come in the same step see equally far
            seen = uniform(streams[world, latest], NEAREST_SHARE * farthest, farthest)
            for i in range(people):
                if reach[world, i] < 0.0:
                    reach[world, i] = seen
    return True
