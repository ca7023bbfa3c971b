"""Whether a state holds numbers: a policy told of none would drive as fast as it can."""

import math

from socialnav_core.compilation import compiled, inlined
from socialnav_core.states import CrowdState

FIELDS = (
    'robot.position', 'robot.velocity', 'robot.heading', 'robot.radius', 'robot.preferred_speed',
    'robot.goal', 'bounds', 'agents.position', 'agents.velocity', 'agents.radius',
    'robot.turn_rate',
)  # fmt: skip
"""What is looked at, in the order in which the kernel numbers it."""
FIELD_COUNT = len(FIELDS)


def require_finite(state: CrowdState) -> None:
    """
    Raise a ValueError when the robot or a real agent of any world has a number that is none.

    Padding may hold anything, and bounds may be inf. The check takes about a microsecond.
    """
    robot, agents = state.robot, state.agents
    found = _first_fault(
        robot.position, robot.velocity, robot.heading, robot.radius, robot.preferred_speed,
        robot.goal, state.bounds, agents.position, agents.velocity, agents.radius, agents.valid,
        robot.turn_rate,
    )  # fmt: skip
    if found >= 0:
        world, field = divmod(found, FIELD_COUNT)
        raise ValueError(f'world {world} of the state: {FIELDS[field]} is not finite')


@inlined
def finite(number):  # type: ignore[no-untyped-def]
    """Return whether a number is one: infinity less infinity is none."""
    return number - number == 0.0


@compiled
def _first_fault(  # type: ignore[no-untyped-def]
    position, velocity, heading, radius, speed, goal, bounds,
    agent_position, agent_velocity, agent_radius, valid, turn_rate,
):  # fmt: skip
    """Return the first fault as world * FIELD_COUNT + field, -1 for none."""
    for world in range(bounds.shape[0]):
        first = world * FIELD_COUNT
        if not finite(position[world, 0] + position[world, 1]):
            return first
        if not finite(velocity[world, 0] + velocity[world, 1]):
            return first + 1
        if not finite(heading[world]):
            return first + 2
        if not finite(radius[world]):
            return first + 3
        if not finite(speed[world]):
            return first + 4
        if not finite(goal[world, 0] + goal[world, 1]):
            return first + 5
        if math.isnan(bounds[world]):
            return first + 6
        if not finite(turn_rate[world]):
            return first + 10
        for i in range(valid.shape[1]):
            if not valid[world, i]:
                continue
            if not finite(agent_position[world, i, 0] + agent_position[world, i, 1]):
                return first + 7
            if not finite(agent_velocity[world, i, 0] + agent_velocity[world, i, 1]):
                return first + 8
            if not finite(agent_radius[world, i]):
                return first + 9
    return -1
