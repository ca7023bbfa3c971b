"""Every parameter of the tracker node."""

import dataclasses

from socialnav.messages.detection_types import DETECTION_TYPES
from socialnav.parameters.fields import parameter


@dataclasses.dataclass(frozen=True)
class TrackerParameters:
    """What the tracker node is told."""

    source: str = parameter(
        'poses', 'type of detections, or the package that has it', choices=DETECTION_TYPES
    )
    planning_frame: str = parameter('odom', 'frame of odom, and of what is published')
    base_frame: str = parameter('base_link', 'frame of the robot: detections may be in it')
    pose_timeout: float = parameter(
        0.2, 'longest time over which odom is interpolated or extrapolated', 's', (0.0, 2.0)
    )
    pedestrian_radius: float = parameter(
        0.35, 'radius of everybody, with what the tracker may be wrong by',
        'm', (0.05, 2.0), live='yes',
    )  # fmt: skip
    confirmation_time: float = parameter(
        0.04, 'time over which a person must have been seen to walk; until then it stands',
        's', (0.0, 10.0), live='yes',
    )  # fmt: skip
    coast_time: float = parameter(
        0.5, 'time without a detection after which a track dies', 's', (0.0, 10.0), live='yes'
    )
    gate: float = parameter(
        4.0, 'standard deviations beyond which a detection is not of a track',
        '', (0.1, 100.0), live='yes',
    )  # fmt: skip
    detection_noise: float = parameter(
        0.05, 'standard deviation of a detection along each axis', 'm', (0.001, 2.0), live='yes'
    )
    acceleration_noise: float = parameter(
        0.5, 'how much people change their velocity: spectral density',
        'm^2/s^3', (0.001, 100.0), live='yes',
    )  # fmt: skip
    start_speed: float = parameter(
        1.0, 'standard deviation of the velocity of a new track along each axis',
        'm/s', (0.01, 10.0), live='yes',
    )  # fmt: skip
