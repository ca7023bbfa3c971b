"""What the simulator makes of its parameters."""

from socialnav.parameters.simulator import SimulatorParameters
from socialnav.simulator.world_messages import Frames
from socialnav_core.config import Scenario
from socialnav_core.sensing import DetectorSettings, ScannerSettings
from socialnav_core.simulation import resolve_scenario


def scenario_named(name: str, parameters: SimulatorParameters) -> Scenario:
    """
    Return a world with the robot that is wanted.

    :raises ConfigError: when there is none of that name.
    """
    return resolve_scenario(
        {
            'name': name,
            'kinematics': parameters.kinematics,
            'robot_visible': parameters.robot_visible,
        }
    )


def frames_of(parameters: SimulatorParameters) -> Frames:
    """Return the names of the frames."""
    return Frames(parameters.map_frame, parameters.odom_frame, parameters.base_frame)


def scanner_of(parameters: SimulatorParameters) -> ScannerSettings:
    """Return what the scanner is like."""
    return ScannerSettings(parameters.scan_beams, parameters.scan_range, parameters.scan_noise)


def detector_of(parameters: SimulatorParameters) -> DetectorSettings:
    """Return what the detector is like."""
    return DetectorSettings(
        parameters.detection_noise, parameters.missed_detections, parameters.detection_occlusion
    )
