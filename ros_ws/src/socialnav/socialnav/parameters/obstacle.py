"""Every parameter of the obstacle node."""

import dataclasses
import math

from socialnav.parameters.fields import parameter


@dataclasses.dataclass(frozen=True)
class ObstacleParameters:
    """What the obstacle node and its finder are told."""

    source: str = parameter('scan', 'where surfaces are found', choices=('scan', 'grid'))
    laser_x: float = parameter(
        0.0, 'place of the laser in base_link, forwards', 'm', (-10.0, 10.0)
    )
    laser_y: float = parameter(
        0.0, 'place of the laser in base_link, to the left', 'm', (-10.0, 10.0)
    )
    laser_yaw: float = parameter(
        0.0, 'direction of the laser in base_link, counter-clockwise',
        'rad', (-math.pi, math.pi),
    )  # fmt: skip
    planning_frame: str = parameter('odom', 'frame of odom, and of what is published')
    grid_frame: str = parameter(
        'odom', 'frame that a grid must be in; it coincides with planning_frame'
    )
    grid_threshold: int = parameter(
        65, 'smallest level of an occupied cell', '', (1, 100), live='yes'
    )
    grid_timeout: float = parameter(
        0.0, 'age of the grid at which nothing is published; 0: it does not age',
        's', (0.0, 3600.0), live='yes',
    )  # fmt: skip
    grid_rate: float = parameter(10.0, 'messages made of a grid per second', 'Hz', (0.1, 100.0))
    largest_circle: float = parameter(
        2.0, 'surfaces on a circle up to this radius become one disc; 0: none',
        'm', (0.0, 10.0), live='yes',
    )  # fmt: skip
    sectors: int = parameter(
        18, 'equal sectors around the robot, with at most one disc for other surfaces',
        '', (4, 720), live='yes',
    )  # fmt: skip
    disc_radius: float = parameter(0.3, 'radius of such a disc', 'm', (0.01, 2.0), live='yes')
    max_range: float = parameter(
        6.0, 'surfaces farther from the robot do not count', 'm', (0.1, 100.0), live='yes'
    )
    bounds: float = parameter(
        math.inf,
        'half-width of the square around the origin beyond which surfaces do not count; '
        '.inf: none',
        'm', (0.1, math.inf), live='yes',
    )  # fmt: skip
    people_margin: float = parameter(
        0.2, 'surfaces so near to the rim of a pedestrian are that pedestrian',
        'm', (0.0, 2.0), live='yes',
    )  # fmt: skip
    people_timeout: float = parameter(
        0.5, 'age of pedestrians at which they count as surfaces again',
        's', (0.0, 10.0), live='yes',
    )  # fmt: skip
    pose_timeout: float = parameter(
        0.2, 'longest time over which odom is interpolated or extrapolated', 's', (0.0, 2.0)
    )
