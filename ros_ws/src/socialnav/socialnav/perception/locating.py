"""Where the robot was when something was measured, told by odom alone."""

from nav_msgs.msg import Odometry
from std_msgs.msg import Header

from socialnav.messages.conversions import ConversionError, robot_arrays
from socialnav.messages.stamps import nanoseconds_of
from socialnav_core.sensing import HERE, Pose, PoseHistory
from socialnav_core.sensing.poses import Motion


class Locator:
    """The way of the robot through the planning frame."""

    def __init__(self, planning_frame: str, base_frame: str, timeout: float) -> None:
        """
        Start without a pose.

        :param planning_frame: frame of odom.
        :param timeout: longest time over which a pose is interpolated or extrapolated, s.
        """
        self.planning_frame, self.base_frame = planning_frame, base_frame
        self.latest = 0
        self._history = PoseHistory(timeout)

    def store(self, odometry: Odometry) -> None:
        """
        Keep a pose.

        :raises ConversionError: a pose in another frame, or one that cannot be.
        """
        position, velocity, heading = robot_arrays(odometry, self.planning_frame)
        pose = Pose(float(position[0]), float(position[1]), heading)
        self.latest = nanoseconds_of(odometry.header.stamp)
        self._history.store(self.latest, Motion(pose, velocity, odometry.twist.twist.angular.z))

    def base(self, stamp: int) -> Pose:
        """
        Return where the robot was at a time, ns.

        :raises ConversionError: where no odom is near enough.
        """
        pose = self._history.at(stamp)
        if pose is None:
            raise ConversionError(
                f'no odom within {self._history.reach:g} s: where the robot was is unknown'
            )
        return pose

    def frame(self, header: Header) -> Pose:
        """
        Return where the frame of a message was.

        :raises ConversionError: a frame that is neither that of odom nor that of the robot.
        """
        if header.frame_id == self.planning_frame:
            return HERE
        if header.frame_id == self.base_frame:
            return self.base(nanoseconds_of(header.stamp))
        raise ConversionError(
            f'detections: in frame {header.frame_id!r}, but they must be in '
            f'{self.planning_frame!r} or {self.base_frame!r}'
        )
