"""
What the network sees of each person: their own frame, their motion and their nearest neighbours.

Training and inference call the same kernel.
"""

import math

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.prediction.learned.layout import (
    EDGE,
    INPUTS,
    LAG,
    LAGS,
    NEIGHBOURS,
    OWN,
    REACH,
)

STANDING = 0.03  # m/s; a slower velocity has no direction
LONGEST_APPROACH = 6.0  # s


@compiled
def person_features(position, lagged, known, radius, static, valid):  # type: ignore[no-untyped-def]
    """
    Return who is predicted, (people, 2) of world and slot, their features and their frames.

    The x axis of a person's frame lies along their velocity; of who stands, along their last
    known motion; of who was never seen to move, towards the nearest neighbour; else along the x
    axis of the world. A frame is (cosine, sine), (people, 2); features are float32.

    :param position: m, (batch, agents, 2).
    :param lagged: velocities and positions at the lags, (batch, LAGS, agents, MOTION).
    :param known: (batch, LAGS, agents).
    :param radius: m, (batch, agents).
    :param static: (batch, agents).
    :param valid: (batch, agents).
    """
    batch, agents = radius.shape
    count = 0
    for world in range(batch):
        for agent in range(agents):
            count += valid[world, agent] and not static[world, agent]
    people = np.empty((count, 2), np.int64)
    features = np.zeros((count, INPUTS), np.float32)
    frames = np.empty((count, 2))
    gaps = np.empty(agents)
    headings = np.empty((agents, 2))
    nearest = np.empty(NEIGHBOURS, np.int64)
    person = 0
    for world in range(batch):
        write_headings(lagged[world], known[world], static[world], headings)
        crowd = crowd_of(position[world], static[world], valid[world])
        for agent in range(agents):
            if static[world, agent] or not valid[world, agent]:
                continue
            find_nearest(position[world], radius[world], valid[world], agent, gaps, nearest)
            cosine, sine = headings[agent]
            if cosine == 0.0 and sine == 0.0:
                cosine, sine = towards(position[world], agent, nearest[0])
            people[person, 0], people[person, 1] = world, agent
            frames[person, 0], frames[person, 1] = cosine, sine
            write_own(lagged[world], known[world], radius[world], agent, cosine, sine,
                      features[person])  # fmt: skip
            write_past(lagged[world], known[world], agent, cosine, sine, features[person])
            write_crowd(position[world, agent], crowd, cosine, sine, features[person])
            for slot in range(NEIGHBOURS):
                if nearest[slot] < 0:
                    break
                begin = OWN + slot * EDGE
                write_edge(
                    position[world], lagged[world], radius[world], static[world], headings, agent,
                    nearest[slot], cosine, sine, features[person, begin : begin + EDGE],
                )  # fmt: skip
            person += 1
    return people, features, frames


@compiled
def write_headings(lagged, known, static, headings):  # type: ignore[no-untyped-def]
    """Write the direction of the last motion of each agent of a world, zero for none."""
    for agent in range(headings.shape[0]):
        headings[agent] = 0.0
        if static[agent]:
            continue
        for lag in range(LAGS):
            x, y = lagged[lag, agent, 0], lagged[lag, agent, 1]
            speed = math.sqrt(x * x + y * y)
            if known[lag, agent] and speed > STANDING:
                headings[agent, 0], headings[agent, 1] = x / speed, y / speed
                break


@compiled
def find_nearest(position, radius, valid, agent, gaps, nearest):  # type: ignore[no-untyped-def]
    """Write the agents whose rims are nearest, in order, then -1; `gaps` is room for (agents,)."""
    for other in range(len(gaps)):
        x = position[other, 0] - position[agent, 0]
        y = position[other, 1] - position[agent, 1]
        gaps[other] = math.sqrt(x * x + y * y) - radius[other] - radius[agent]
        if other == agent or not valid[other]:
            gaps[other] = np.inf
    for slot in range(len(nearest)):
        nearest[slot] = -1
        least = REACH
        for other in range(len(gaps)):
            if gaps[other] < least:
                nearest[slot], least = other, gaps[other]
        if nearest[slot] >= 0:
            gaps[nearest[slot]] = np.inf


@compiled
def towards(position, agent, other):  # type: ignore[no-untyped-def]
    """Return the direction to another agent; the x axis where there is none or it is here."""
    if other >= 0:
        x = position[other, 0] - position[agent, 0]
        y = position[other, 1] - position[agent, 1]
        distance = math.sqrt(x * x + y * y)
        if distance > 0.0:
            return x / distance, y / distance
    return 1.0, 0.0


@compiled
def write_own(lagged, known, radius, agent, cosine, sine, out):  # type: ignore[no-untyped-def]
    """Write the features of a person: speed, velocities, share of them that is known, radius."""
    x, y = lagged[0, agent, 0], lagged[0, agent, 1]
    out[0] = math.sqrt(x * x + y * y)
    share = 0.0
    for lag in range(LAGS):
        x, y = lagged[lag, agent, 0], lagged[lag, agent, 1]
        out[1 + 2 * lag] = x * cosine + y * sine
        out[2 + 2 * lag] = y * cosine - x * sine
        share += known[lag, agent] / LAGS
    out[1 + 2 * LAGS] = share
    out[2 + 2 * LAGS] = radius[agent]


@compiled
def write_past(lagged, known, agent, cosine, sine, out):  # type: ignore[no-untyped-def]
    """
    Write what the positions say of the motion, and how much the velocities jitter.

    The mean velocities since the lags come less the present one: both err on their own, so that
    together they tell noise from turning. Jitter is the root mean square of second differences.
    """
    begin = 3 + 2 * LAGS
    now = lagged[0, agent]
    jitter, count = 0.0, 0
    for lag in range(1, LAGS):
        if not known[lag, agent]:
            continue
        past = lagged[lag, agent]
        x = (now[2] - past[2]) / (lag * LAG) - now[0]
        y = (now[3] - past[3]) / (lag * LAG) - now[1]
        out[begin + 2 * lag - 2] = x * cosine + y * sine
        out[begin + 2 * lag - 1] = y * cosine - x * sine
        if lag > 1 and known[lag - 1, agent]:
            nearer, nearest = lagged[lag - 1, agent], lagged[lag - 2, agent]
            x = past[0] - 2.0 * nearer[0] + nearest[0]
            y = past[1] - 2.0 * nearer[1] + nearest[1]
            jitter += x * x + y * y
            count += 1
    out[begin + 2 * LAGS - 2] = 2.0 * math.sqrt(jitter / max(count, 1))


@compiled
def crowd_of(position, static, valid):  # type: ignore[no-untyped-def]
    """Return the centre of the people of a world, m, their distance to it, m, and their number."""
    x, y, square, count = 0.0, 0.0, 0.0, 0
    for agent in range(len(static)):
        if valid[agent] and not static[agent]:
            x, y, count = x + position[agent, 0], y + position[agent, 1], count + 1
    if count:
        x, y = x / count, y / count
    for agent in range(len(static)):
        if valid[agent] and not static[agent]:
            square += (position[agent, 0] - x) ** 2 + (position[agent, 1] - y) ** 2
    return x, y, math.sqrt(square / max(count, 1)), count


@compiled
def write_crowd(position, crowd, cosine, sine, out):  # type: ignore[no-untyped-def]
    """Write where the centre of the crowd is, how wide it is and how many they are."""
    x, y = crowd[0] - position[0], crowd[1] - position[1]
    distance = math.sqrt(x * x + y * y)
    scale = 0.2 * min(1.0, REACH / max(distance, REACH))  # who is far off is no farther than that
    out[OWN - 4] = scale * (x * cosine + y * sine)
    out[OWN - 3] = scale * (y * cosine - x * sine)
    out[OWN - 2] = 0.2 * min(crowd[2], REACH)
    out[OWN - 1] = 0.05 * min(crowd[3], 40)


@compiled
def write_edge(  # type: ignore[no-untyped-def]
    position, lagged, radius, static, headings, agent, other, cosine, sine, out
):
    """Write the features of a neighbour, in the person's frame and of about unit size."""
    x = position[other, 0] - position[agent, 0]
    y = position[other, 1] - position[agent, 1]
    reach = radius[other] + radius[agent]
    gap = math.sqrt(x * x + y * y) - reach
    out[0] = 0.5 * (x * cosine + y * sine)
    out[1] = 0.5 * (y * cosine - x * sine)
    out[2] = gap
    out[3] = 0.2 / (0.1 + max(gap, 0.0))
    out[4] = radius[other]
    out[5] = static[other]
    out[6] = 1.0  # somebody is there
    if not static[other]:
        for sample in range(3):  # now, 0.5 s and 1 s ago
            along, across = lagged[2 * sample, other, 0], lagged[2 * sample, other, 1]
            out[7 + 2 * sample] = along * cosine + across * sine
            out[8 + 2 * sample] = across * cosine - along * sine
        out[13] = headings[other, 0] * cosine + headings[other, 1] * sine
        out[14] = headings[other, 1] * cosine - headings[other, 0] * sine
    # closest approach if both keep their velocities
    relative_x, relative_y = -lagged[0, agent, 0], -lagged[0, agent, 1]
    if not static[other]:
        relative_x += lagged[0, other, 0]
        relative_y += lagged[0, other, 1]
    square = relative_x * relative_x + relative_y * relative_y
    time = 0.0
    if square > 1e-6:
        time = min(max(-(x * relative_x + y * relative_y) / square, 0.0), LONGEST_APPROACH)
    closest_x, closest_y = x + time * relative_x, y + time * relative_y
    out[15] = 0.25 * time
    out[16] = math.sqrt(closest_x * closest_x + closest_y * closest_y) - reach
    out[17] = (relative_x * y - relative_y * x) / (math.sqrt(square) + 0.1)
