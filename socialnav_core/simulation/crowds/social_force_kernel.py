"""
People who push each other away.

Source: D. Helbing and P. Molnar, Social force model for pedestrian dynamics, Physical Review E 51,
1995, with forces that fall off with the distance of rims and act less from behind.
"""

import math

from socialnav_core.compilation import compiled

CONTACT = 40.0  # acceleration per metre of overlap, 1/s^2
GREATEST_ACCELERATION = 10.0  # m/s^2
HASTE = 1.3  # greatest speed in units of the preferred one
SUBSTEP = 0.05  # s


@compiled
def social_force_step(  # type: ignore[no-untyped-def]
    position, velocity, preferred, radius, speed, people, strength, reach, relaxation, behind,
    time_step, out,
):  # fmt: skip
    """
    Write the mean velocities of people over a time step.

    :param position: of people, then obstacles, m, (batch, agents, 2).
    :param velocity: m/s, (batch, agents, 2).
    :param preferred: m/s, (batch, agents, 2).
    :param radius: m, (batch, agents).
    :param speed: preferred speeds, m/s, (batch, agents).
    :param people: number of people.
    :param strength: acceleration at contact, m/s^2.
    :param reach: distance over which it falls to 1 / e, m.
    :param relaxation: time in which the preferred velocity is taken up, s.
    :param behind: share of the force of somebody straight behind.
    :param time_step: s.
    :param out: m/s, (batch, agents, 2).
    """
    substeps = max(1, math.ceil(time_step / SUBSTEP - 1e-9))
    duration = time_step / substeps
    for world in range(position.shape[0]):
        here, motion = position[world].copy(), velocity[world].copy()
        force = motion.copy()
        for _ in range(substeps):
            for i in range(people):
                force[i] = (preferred[world, i] - motion[i]) / relaxation
                heading = math.sqrt(preferred[world, i, 0] ** 2 + preferred[world, i, 1] ** 2)
                for j in range(here.shape[0]):
                    x, y = here[i, 0] - here[j, 0], here[i, 1] - here[j, 1]
                    distance = math.sqrt(x * x + y * y)
                    if i == j or distance == 0.0:
                        continue
                    gap = distance - radius[world, i] - radius[world, j]
                    push = strength * math.exp(-max(gap, 0.0) / reach)
                    if heading > 0.0:
                        ahead = -(x * preferred[world, i, 0] + y * preferred[world, i, 1])
                        ahead /= heading * distance
                        push *= behind + (1.0 - behind) * 0.5 * (1.0 + ahead)
                    push += CONTACT * max(-gap, 0.0)
                    force[i, 0] += push * x / distance
                    force[i, 1] += push * y / distance
            for i in range(people):
                limit(force[i], GREATEST_ACCELERATION)
                motion[i] += force[i] * duration
                limit(motion[i], HASTE * speed[world, i])
                here[i] += motion[i] * duration
        for i in range(people):
            out[world, i] = (here[i] - position[world, i]) / time_step


@compiled
def limit(vector, greatest):  # type: ignore[no-untyped-def]
    """Shorten a vector, (2,), in place where it is longer than this."""
    length = math.sqrt(vector[0] * vector[0] + vector[1] * vector[1])
    if length > greatest:
        vector *= greatest / length
