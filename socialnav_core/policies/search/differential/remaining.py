"""How long a differential drive still needs from a node to the goal."""

import math

from socialnav_core.compilation import inlined


@inlined
def angle_between(from_x, from_y, to_x, to_y):  # type: ignore[no-untyped-def]
    """Return the angle from one vector to another, rad, counter-clockwise."""
    return math.atan2(from_x * to_y - from_y * to_x, from_x * to_x + from_y * to_y)


@inlined
def driving_time(base, preferred, left, speed):  # type: ignore[no-untyped-def]
    """
    Return the time for a straight way from a speed on, at most at the preferred one, s.

    :param left: length of the way, m.
    """
    lacking = (preferred * preferred - speed * speed) / (2.0 * base.acceleration)
    if left < lacking:
        gained = math.sqrt(speed * speed + 2.0 * base.acceleration * left)
        return (gained - speed) / base.acceleration
    missing = max(preferred - speed, 0.0)
    return left / preferred + missing * missing / (2.0 * base.acceleration * preferred)


@inlined
def turning_time(base, preferred, share, left, error, turn_rate):  # type: ignore[no-untyped-def]
    """
    Return the time that a turn costs, s; never less than nothing.

    On the spot it is |e| / w. On an arc the robot nears the goal meanwhile: (|e| - sin |e|) / w,
    where the goal is farther away than the arc is wide. A turn under way ends only after
    w |w| / (2 a).

    :param error: from the heading to the way, rad.
    """
    error -= turn_rate * abs(turn_rate) / (2.0 * base.angular_acceleration)
    error = min(abs(error), math.pi + 0.5)
    wide = min(1.0, left * base.turn_rate / (2.0 * preferred))
    return (error - share * wide * math.sin(error)) / base.turn_rate
