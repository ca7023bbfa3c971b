"""Every parameter of the nodes that turn measurements into obstacles and pedestrians."""

import math

from socialnav.messages.detection_types import DETECTION_TYPES
from socialnav.parameters import Entry

FRAME = Entry('planning_frame', 'odom', 'frame of odom, and of what is published')
POSE_TIMEOUT = Entry(
    'pose_timeout', 0.2, 'longest time over which odom is interpolated or extrapolated',
    's', (0.0, 2.0),
)  # fmt: skip

OBSTACLE_PARAMETERS = (
    Entry('source', 'scan', 'where surfaces are found', choices=('scan', 'grid')),
    Entry('laser_x', 0.0, 'place of the laser in base_link, forwards', 'm', (-10.0, 10.0)),
    Entry('laser_y', 0.0, 'place of the laser in base_link, to the left', 'm', (-10.0, 10.0)),
    Entry(
        'laser_yaw', 0.0, 'direction of the laser in base_link, counter-clockwise',
        'rad', (-math.pi, math.pi),
    ),
    FRAME,
    Entry('grid_frame', 'odom', 'frame that a grid must be in; it coincides with planning_frame'),
    Entry('grid_threshold', 65, 'smallest level of an occupied cell', '', (1, 100), live='yes'),
    Entry(
        'grid_timeout', 0.0, 'age of the grid at which nothing is published; 0: it does not age',
        's', (0.0, 3600.0), live='yes',
    ),
    Entry('grid_rate', 10.0, 'messages made of a grid per second', 'Hz', (0.1, 100.0)),
    Entry(
        'largest_circle', 2.0, 'surfaces on a circle up to this radius become one disc; 0: none',
        'm', (0.0, 10.0), live='yes',
    ),
    Entry(
        'sectors', 18, 'equal sectors around the robot, with at most one disc for other surfaces',
        '', (4, 720), live='yes',
    ),
    Entry('disc_radius', 0.3, 'radius of such a disc', 'm', (0.01, 2.0), live='yes'),
    Entry(
        'max_range', 6.0, 'surfaces farther from the robot do not count',
        'm', (0.1, 100.0), live='yes',
    ),
    Entry(
        'bounds', math.inf,
        'half-width of the square around the origin beyond which surfaces do not count',
        'm', (0.1, math.inf), live='yes',
    ),
    Entry(
        'people_margin', 0.2, 'surfaces so near to the rim of a pedestrian are that pedestrian',
        'm', (0.0, 2.0), live='yes',
    ),
    Entry(
        'people_timeout', 0.5, 'age of pedestrians at which they count as surfaces again',
        's', (0.0, 10.0), live='yes',
    ),
    POSE_TIMEOUT,
)  # fmt: skip

TRACKER_PARAMETERS = (
    Entry(
        'source', 'poses', 'type of detections, or the package that has it',
        choices=tuple(DETECTION_TYPES),
    ),
    FRAME,
    Entry('base_frame', 'base_link', 'frame of the robot: detections may be in it'),
    POSE_TIMEOUT,
    Entry(
        'pedestrian_radius', 0.35, 'radius of everybody, with what the tracker may be wrong by',
        'm', (0.05, 2.0), live='yes',
    ),
    Entry(
        'hits', 2, 'detections that confirm a track; others are not published',
        '', (1, 100), live='yes',
    ),
    Entry(
        'coast_time', 0.5, 'time without a detection after which a track dies',
        's', (0.0, 10.0), live='yes',
    ),
    Entry(
        'gate', 4.0, 'standard deviations beyond which a detection is not of a track',
        '', (0.1, 100.0), live='yes',
    ),
    Entry(
        'detection_noise', 0.05, 'standard deviation of a detection along each axis',
        'm', (0.001, 2.0), live='yes',
    ),
    Entry(
        'acceleration_noise', 0.5, 'how much people change their velocity: spectral density',
        'm^2/s^3', (0.001, 100.0), live='yes',
    ),
    Entry(
        'start_speed', 1.0, 'standard deviation of the velocity of a new track along each axis',
        'm/s', (0.01, 10.0), live='yes',
    ),
)  # fmt: skip
