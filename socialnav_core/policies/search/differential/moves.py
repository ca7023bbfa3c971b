"""The speeds and turn rates that a differential drive tries from a node."""

import math

from socialnav_core.compilation import inlined

SAME = 1e-6
"""Numbers nearer to each other than this are one, m/s or rad/s."""


@inlined
def added(numbers, count, number):  # type: ignore[no-untyped-def]
    """Write a number behind others unless it is among them; return how many there are."""
    for i in range(count):
        if abs(numbers[i] - number) < SAME:
            return count
    numbers[count] = number
    return count + 1


@inlined
def write_speeds(base, preferred, speed, duration, fine, speeds):  # type: ignore[no-untyped-def]
    """
    Write the speeds to try, m/s; return their number.

    The fastest and the slowest in reach, the present one, and with `fine` those half-way.
    """
    change = base.acceleration * duration
    least, most = -base.reverse * preferred, preferred
    low = min(max(speed - change, least), speed + change)
    high = max(min(speed + change, most), speed - change)
    low, high = min(low, high), max(low, high)
    kept = min(max(speed, low), high)
    speeds[0] = high
    count = added(speeds, 1, kept)
    count = added(speeds, count, low)
    if fine:
        count = added(speeds, count, 0.5 * (low + kept))
        count = added(speeds, count, 0.5 * (high + kept))
    return count


@inlined
def write_turns(base, turn_rate, error, duration, lag, fine, turns):  # type: ignore[no-untyped-def]
    """
    Write the turn rates to try, rad/s; return their number.

    The one that turns towards the way to the goal, the present one, straight on, the ends of what
    is in reach, and with `fine` those half-way.

    :param error: from the heading to the way to the goal, rad.
    """
    change = base.angular_acceleration * duration
    low, high = max(turn_rate - change, -base.turn_rate), min(turn_rate + change, base.turn_rate)
    wanted = turn_rate_towards(base, turn_rate, error, duration, lag)
    turns[0] = min(max(wanted, low), high)
    count = added(turns, 1, turn_rate)
    count = added(turns, count, low)
    count = added(turns, count, high)
    if low < 0.0 < high:
        count = added(turns, count, 0.0)
    if fine:
        count = added(turns, count, 0.5 * (low + turn_rate))
        count = added(turns, count, 0.5 * (high + turn_rate))
    return count


@inlined
def turn_rate_towards(base, turn_rate, error, duration, lag):  # type: ignore[no-untyped-def]
    """
    Return the turn rate at the end of a layer from which an even slowing ends the error, rad/s.

    With w the present rate, w' the wanted one, a the angular acceleration, T the duration and
    k the lag: (w + k (w' - w)) T + w'^2 / (2 a) = error.
    """
    change = base.angular_acceleration * duration * lag
    left = error - (1.0 - lag) * turn_rate * duration
    wanted = math.sqrt(change * change + 2.0 * base.angular_acceleration * abs(left)) - change
    return math.copysign(wanted, left)
