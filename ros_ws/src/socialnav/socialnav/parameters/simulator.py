"""Every parameter of the simulator node, and what follows from them."""

import dataclasses
import math

from socialnav.parameters.fields import parameter
from socialnav_core.config import KINEMATICS
from socialnav_core.simulation.kinematics import Limits

REPEAT_PERIOD = 0.5
"""Time without an answer after which a state in lockstep is published again, s."""


@dataclasses.dataclass(frozen=True)
class SimulatorParameters:
    """What the simulator node, its world and its sensors are told."""

    scenario: str = parameter('hard', 'world to simulate; `socialnav scenarios` lists them')
    seed: int = parameter(0, 'seed of the test cases 0, 1, 2, ...', '', (0, 10**9))
    episodes: int = parameter(
        0, 'episodes to run before the world stands; 0: endless', '', (0, 10**6)
    )
    lockstep: bool = parameter(False, 'one step of the world per command instead of real time')
    real_time_factor: float = parameter(
        1.0, 'simulated time per real time', '', (0.01, 100.0), live='yes'
    )
    publish_rate: float = parameter(
        20.0, 'states published per second (real time)', 'Hz', (1.0, 1000.0)
    )
    cmd_vel_timeout: float = parameter(
        0.5, 'simulated time without a command after which the robot brakes',
        's', (0.05, 10.0), live='yes',
    )  # fmt: skip
    max_speed: float = parameter(
        3.0, 'the base drives no faster, whatever it is commanded',
        'm/s', (0.01, 100.0), live='yes',
    )  # fmt: skip
    max_turn_rate: float = parameter(
        10.0, 'the base turns no faster, whatever it is commanded',
        'rad/s', (0.0, 100.0), live='yes',
    )  # fmt: skip
    kinematics: str = parameter('holonomic', 'how the robot moves', choices=KINEMATICS)
    robot_visible: bool = parameter(False, 'whether pedestrians see the robot and avoid it')
    enable_stamped_cmd_vel: bool = parameter(
        False, 'TwistStamped instead of Twist; lockstep always does'
    )
    publish_clock: bool = parameter(
        False, 'publish /clock and stamp everything with simulated time'
    )
    publish_scan: bool = parameter(False, 'publish what a laser scanner on the robot measures')
    scan_beams: int = parameter(360, 'beams of the scanner, all around', '', (1, 100_000))
    scan_range: float = parameter(10.0, 'longest range of the scanner', 'm', (0.1, 1000.0))
    scan_noise: float = parameter(0.0, 'standard deviation of a range', 'm', (0.0, 10.0))
    publish_detections: bool = parameter(False, 'publish where a detector sees pedestrians')
    detection_noise: float = parameter(
        0.0, 'standard deviation of a detection along each axis', 'm', (0.0, 10.0)
    )
    missed_detections: float = parameter(
        0.0, 'probability that a pedestrian is missed', '', (0.0, 1.0)
    )
    detection_occlusion: bool = parameter(
        False, 'detect only whom some beam of the scanner reaches'
    )
    map_frame: str = parameter('map', 'frame of the map; it coincides with odom_frame')
    odom_frame: str = parameter('odom', 'frame of everything else')
    base_frame: str = parameter('base_link', 'frame of the robot')

    @property
    def limits(self) -> Limits:
        """Return what the base can do; it changes its velocity at once."""
        return Limits(self.max_speed, math.inf, self.max_turn_rate, self.publish_period)

    @property
    def simulated_time(self) -> bool:
        """Return whether stamps are simulated time; otherwise they are the computer's."""
        return self.lockstep or self.publish_clock

    @property
    def stamped(self) -> bool:
        """Return whether commands are TwistStamped."""
        return self.lockstep or self.enable_stamped_cmd_vel

    @property
    def publish_period(self) -> float:
        """Return the real time between two states that are published, s."""
        return 1 / self.publish_rate

    @property
    def timer_period(self) -> float:
        """Return the real time between two ticks, s."""
        return REPEAT_PERIOD if self.lockstep else self.publish_period

    @property
    def tick_duration(self) -> float:
        """Return the simulated time of a tick, s."""
        return self.publish_period * self.real_time_factor
