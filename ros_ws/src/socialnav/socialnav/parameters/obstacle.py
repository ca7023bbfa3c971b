"""Every parameter of the obstacle node."""

import dataclasses
import math

from socialnav.parameters.fields import parameter

MEANINGS = ('free', 'failed', 'near')


@dataclasses.dataclass(frozen=True)
class ObstacleParameters:
    """What the obstacle node and its finder are told."""

    source: str = parameter('scan', 'where surfaces are found', choices=('scan', 'grid'))
    scan_topics: str = parameter(
        'scan', 'topics of scans, with spaces between; obstacles are those of all of them'
    )
    laser_pose: str = parameter(
        'parameters', 'who tells how lasers sit: laser_x and so on, or tf',
        choices=('parameters', 'tf'),
    )  # fmt: skip
    laser_frames: str = parameter(
        '',
        'how several lasers sit, by their frames: `front 0.2 0 0; rear -0.2 0 3.14 upside_down`',
    )
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
    laser_upside_down: bool = parameter(
        False, 'whether the laser hangs, so that it turns the other way round'
    )
    inf_is: str = parameter(
        'free',
        'what inf in a scan means: nothing up to range_max, no measurement, something near',
        choices=MEANINGS, live='yes',
    )  # fmt: skip
    nan_is: str = parameter('failed', 'what NaN means', choices=MEANINGS, live='yes')
    zero_is: str = parameter('failed', 'what 0 means', choices=MEANINGS, live='yes')
    range_max_is: str = parameter(
        'failed', 'what range_max and more, but not inf, means', choices=MEANINGS, live='yes'
    )
    valid_beams: float = parameter(
        0.1, 'share of the beams below which a scan is refused', '', (0.0, 1.0), live='yes'
    )
    footprint_radius: float = parameter(
        0.0, 'surfaces nearer to the centre of base_frame are the robot itself',
        'm', (0.0, 5.0), live='yes',
    )  # fmt: skip
    base_frame: str = parameter('base_link', 'frame of the robot')
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
