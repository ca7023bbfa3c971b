"""Laws of poses in time."""

import numpy as np
import pytest

from socialnav_core.sensing.poses import Motion, Pose, PoseHistory

SECOND = 10**9


def history(*entries, reach=1.0):
    """Return a history of (time s, x m, heading rad), moving at 1 m/s along x."""
    result = PoseHistory(reach)
    for time, x, heading in entries:
        motion = Motion(Pose(x, 0.0, heading), np.array([1.0, 0.0]), 0.2)
        result.store(int(time * SECOND), motion)
    return result


def test_a_point_ahead_of_a_robot_that_looks_left_is_to_the_left():
    points = Pose(1.0, 1.0, np.pi / 2).placed(np.array([[2.0, 0.0], [0.0, 1.0]]))
    np.testing.assert_allclose(points, [[1.0, 3.0], [0.0, 1.0]], atol=1e-12)


def test_poses_within_poses_agree_with_points_taken_in_two_steps():
    robot, laser = Pose(1.0, -2.0, 0.7), Pose(0.2, 0.1, -0.4)
    points = np.random.default_rng(0).normal(size=(5, 2))
    np.testing.assert_allclose(robot.of(laser).placed(points), robot.placed(laser.placed(points)))


def test_between_two_poses_the_pose_is_between_them():
    pose = history((0.0, 0.0, 0.0), (1.0, 2.0, 0.4)).at(SECOND // 4)
    assert (pose.x, pose.heading) == pytest.approx((0.5, 0.1))


def test_a_heading_turns_the_shorter_way():
    pose = history((0.0, 0.0, 3.1), (1.0, 0.0, -3.1)).at(SECOND // 2)
    assert abs((pose.heading - np.pi + np.pi) % (2 * np.pi) - np.pi) < 1e-9


def test_after_the_newest_pose_the_robot_goes_on_as_it_did():
    pose = history((1.0, 0.0, 0.0)).at(3 * SECOND // 2)
    assert (pose.x, pose.heading) == pytest.approx((0.5, 0.1))


@pytest.mark.parametrize('time', [0.5, 2.5])
def test_a_time_without_a_pose_near_it_has_none(time):
    assert history((1.0, 0.0, 0.0), reach=1.0).at(int(time * SECOND)) is None


def test_a_long_gap_is_not_bridged():
    assert history((1.0, 0.0, 0.0), (3.0, 5.0, 0.0), reach=1.0).at(2 * SECOND) is None


def test_a_clock_that_runs_backwards_empties_the_history():
    poses = history((5.0, 1.0, 0.0), (1.0, 2.0, 0.0))
    assert poses.at(SECOND).x == 2.0 and poses.at(5 * SECOND) is None
