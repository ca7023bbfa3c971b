"""Which node keeps a cell: a table of the cells of a layer that are taken."""

import math

from socialnav_core.compilation import inlined

MIDDLE = (1 << 15) + 0.5
"""Added to the numbers of cells along x and y: they are positive, and home is amid its cell."""
OFF_BORDERS = 0.75
"""Added to speeds and turn rates in cells: multiples of a half lie amid cells, not on borders."""
SPREAD = 0x9E3779B97F4A7C1
"""An odd number that spreads the numbers of cells over the table (Knuth, vol. 3, 6.4)."""


@inlined
def cell_number(lattice, base, trip, rate, x, y, heading, speed, turn_rate):  # type: ignore[no-untyped-def]
    """
    Return the number of the cell of a node.

    :param rate: cells in a metre.
    """
    number = int((x - trip.home_x) * rate + MIDDLE)
    number = (number << 16) | int((y - trip.home_y) * rate + MIDDLE)
    turned = int(math.floor(heading * (lattice.headings / (2.0 * math.pi)) + 0.5))
    number = number * lattice.headings + turned % lattice.headings
    fast = int(math.floor(speed / trip.speed * lattice.speeds + OFF_BORDERS)) + lattice.speeds
    number = number * (2 * lattice.speeds + 2) + fast
    turning = math.floor(turn_rate / base.turn_rate * (0.5 * lattice.turn_rates) + OFF_BORDERS)
    return number * (lattice.turn_rates + 3) + int(turning) + lattice.turn_rates // 2 + 1


@inlined
def place_of(cells, occupant, number):  # type: ignore[no-untyped-def]
    """Return the place of a cell in the table, or the empty one where it belongs."""
    last = occupant.size - 1  # the size is a power of two
    place = ((number * SPREAD) >> 20) & last
    while occupant[place] >= 0 and cells[place] != number:
        place = (place + 1) & last
    return place
