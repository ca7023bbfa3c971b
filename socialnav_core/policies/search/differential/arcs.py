"""Whether an arc comes too near to an obstacle."""

from socialnav_core.compilation import inlined
from socialnav_core.policies.search.costs import length
from socialnav_core.simulation.rewards import swept_distance


@inlined
def arc_hits_disc(near_discs, count, move_x, move_y, half_x, half_y, bulge):  # type: ignore[no-untyped-def]
    """
    Return whether an arc comes too near to an obstacle; one that leaves it may.

    The chord decides where it is far enough away for the whole arc, otherwise the chords of its
    halves, from which the arc is a quarter as far away.

    :param move_x: of the chord, m.
    :param half_x: of the chord of the first half, m.
    :param bulge: greatest distance between the arc and its chord, m.
    """
    hit = False
    for i in range(count):
        x, y, keep = near_discs[i, 0], near_discs[i, 1], near_discs[i, 2]
        if swept_distance(x, y, -move_x, -move_y) < keep + bulge:
            hit |= chord_hits(x, y, half_x, half_y, keep, 0.25 * bulge)
            x, y = x - half_x, y - half_y
            hit |= chord_hits(x, y, move_x - half_x, move_y - half_y, keep, 0.25 * bulge)
    return hit


@inlined
def chord_hits(x, y, move_x, move_y, keep, bulge):  # type: ignore[no-untyped-def]
    """Return whether a chord comes too near to a disc, and nearer than it was."""
    least = swept_distance(x, y, -move_x, -move_y)
    return least < keep + bulge and least < length(x, y) - 1e-6
