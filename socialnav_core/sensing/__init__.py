"""What a robot measures, and what it makes of it: scans to discs, detections to tracks."""

from socialnav_core.sensing.poses import HERE as HERE
from socialnav_core.sensing.poses import Pose as Pose
from socialnav_core.sensing.poses import PoseHistory as PoseHistory
from socialnav_core.sensing.ray_casting import beam_angles as beam_angles
from socialnav_core.sensing.ray_casting import cast_rays as cast_rays
from socialnav_core.sensing.scans import Geometry as Geometry
from socialnav_core.sensing.scans import Rays as Rays
from socialnav_core.sensing.scans import Readings as Readings
from socialnav_core.sensing.scans import scan_beams as scan_beams
from socialnav_core.sensing.sensors import DetectorSettings as DetectorSettings
from socialnav_core.sensing.sensors import ScannerSettings as ScannerSettings
from socialnav_core.sensing.sensors import Sensors as Sensors
from socialnav_core.sensing.surfaces import grid_returns as grid_returns
from socialnav_core.sensing.surfaces import pooled as pooled
from socialnav_core.sensing.surfaces import SurfaceSettings as SurfaceSettings
from socialnav_core.sensing.surfaces import surrounding_discs as surrounding_discs
from socialnav_core.sensing.tracking import Tracker as Tracker
from socialnav_core.sensing.tracking import TrackerSettings as TrackerSettings
from socialnav_core.sensing.tracking import Tracks as Tracks
