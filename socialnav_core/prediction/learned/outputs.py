"""From what the network says at its own moments to positions in the world at any times."""

import math

import numpy as np

from socialnav_core.compilation import compiled
from socialnav_core.prediction.learned.layout import DOUBT, SCALE, STEP, STEPS

LEAST_LOGARITHM, GREATEST_LOGARITHM = -6.0, 6.0  # of a deviation, in units of SCALE
LEAST_DEVIATION = 1e-3  # m; also that of obstacles, so that whoever divides by one may


@compiled
def place(outputs, people, frames, velocity, times, positions, deviations):  # type: ignore[no-untyped-def]
    """
    Add the predicted motion of people to where they stand now.

    Between two moments of the network everything is linear, before the first one from nothing;
    after the last one it goes on as between the last two.

    :param outputs: of the network, (people, OUTPUTS).
    :param people: world and slot of each, (people, 2).
    :param frames: cosine and sine of each, (people, 2).
    :param velocity: m/s, (batch, agents, 2).
    :param times: from now, s, (steps,).
    :param positions: in and out, m, (batch, steps, agents, 2).
    :param deviations: out, m, (batch, steps, agents); of who is not predicted they stay.
    """
    residuals = np.zeros((STEPS + 1, 2))
    spread = np.zeros(STEPS + 1)
    for person in range(people.shape[0]):
        world, agent = people[person, 0], people[person, 1]
        for step in range(STEPS):
            x, y = outputs[person, 2 * step], outputs[person, 2 * step + 1]
            belief = SCALE[step] * (x * x + y * y) / (x * x + y * y + DOUBT * DOUBT)
            residuals[step + 1, 0], residuals[step + 1, 1] = belief * x, belief * y
            logarithm = min(max(outputs[person, 2 * STEPS + step], LEAST_LOGARITHM),
                            GREATEST_LOGARITHM)  # fmt: skip
            spread[step + 1] = math.exp(logarithm) * SCALE[step]
        cosine, sine = frames[person, 0], frames[person, 1]
        for index in range(len(times)):
            time = times[index]
            first = min(max(int(time / STEP), 0), STEPS - 1)
            share = time / STEP - first
            x = residuals[first, 0] + share * (residuals[first + 1, 0] - residuals[first, 0])
            y = residuals[first, 1] + share * (residuals[first + 1, 1] - residuals[first, 1])
            positions[world, index, agent, 0] += (
                x * cosine - y * sine + velocity[world, agent, 0] * time
            )
            positions[world, index, agent, 1] += (
                x * sine + y * cosine + velocity[world, agent, 1] * time
            )
            grown = spread[first] + share * (spread[first + 1] - spread[first])
            # extrapolated, a deviation that shrinks could fall below zero
            least = max(min(spread[first], spread[first + 1]), LEAST_DEVIATION)
            deviations[world, index, agent] = max(grown, least)
