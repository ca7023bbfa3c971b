"""Laws of how lasers sit on the robot."""

import math

from geometry_msgs.msg import Quaternion, TransformStamped
import numpy as np
import pytest

from socialnav.messages.conversions import ConversionError
from socialnav.parameters.obstacle import ObstacleParameters
from socialnav.perception.lasers import Lasers, mounting_of
from socialnav.perception.obstacle_finder import no_transform

POINT = np.array([[2.0, 1.0]])
"""Ahead of a laser and to its left."""


def lasers(transform=no_transform, **values):
    return Lasers(ObstacleParameters(**values), transform)


def transform_of(roll=0.0, pitch=0.0, yaw=0.0):
    """Return a transform of a laser that sits 0.5 m ahead, turned by roll, pitch and yaw."""
    result = TransformStamped(child_frame_id='laser')
    result.transform.translation.x = 0.5
    (sr, cr), (sp, cp), (sy, cy) = (
        (math.sin(one / 2), math.cos(one / 2)) for one in (roll, pitch, yaw)
    )
    result.transform.rotation = Quaternion(
        x=sr * cp * cy - cr * sp * sy, y=cr * sp * cy + sr * cp * sy,
        z=cr * cp * sy - sr * sp * cy, w=cr * cp * cy + sr * sp * sy,
    )  # fmt: skip
    return result


@pytest.mark.parametrize(
    ('turn', 'place'),
    [
        ({}, (2.5, 1.0)),
        ({'roll': math.pi}, (2.5, -1.0)),
        ({'pitch': math.pi}, (-1.5, 1.0)),
        ({'yaw': math.pi}, (-1.5, -1.0)),
        ({'roll': math.pi, 'yaw': math.pi / 2}, (1.5, 2.0)),
    ],
)
def test_a_laser_sits_as_tf_has_it_also_upside_down(turn, place):
    told = lasers(lambda *_: transform_of(**turn), laser_pose='tf').mounting('scan', 'laser')
    np.testing.assert_allclose(told.placed(POINT), [place], atol=1e-9)


def test_a_tilted_laser_is_refused():
    with pytest.raises(ConversionError, match="laser of 'laser' is tilted"):
        mounting_of(transform_of(pitch=0.5))


def test_a_laser_of_which_tf_knows_nothing_is_refused_with_the_reason():
    with pytest.raises(ConversionError, match="in frame 'laser', but nobody tells"):
        lasers(laser_pose='tf').mounting('scan', 'laser')


def test_a_laser_sits_as_the_parameters_have_it_also_upside_down():
    told = lasers(laser_x=0.5, laser_yaw=math.pi, laser_upside_down=True)
    np.testing.assert_allclose(
        told.mounting('scan', 'laser').placed(POINT), [[-1.5, 1.0]], atol=1e-9
    )


def test_several_lasers_sit_as_their_frames_say():
    text = 'front 0.2 0 0; rear -0.2 0 3.14159265 upside_down'
    told = lasers(scan_topics='one two', laser_frames=text)
    np.testing.assert_allclose(told.mounting('one', 'front').placed(POINT), [[2.2, 1.0]])
    np.testing.assert_allclose(
        told.mounting('two', 'rear').placed(POINT), [[-2.2, 1.0]], atol=1e-6
    )
    with pytest.raises(ConversionError, match="in frame 'top', which laser_frames does not name"):
        lasers(laser_frames=text).mounting('scan', 'top')


def test_two_frames_on_one_topic_are_two_lasers_and_are_refused():
    told = lasers()
    told.mounting('scan', 'front')
    with pytest.raises(ConversionError, match="from frames 'front' and 'rear'"):
        told.mounting('scan', 'rear')


def test_a_scan_in_the_frame_of_the_robot_contradicts_a_laser_elsewhere():
    with pytest.raises(ConversionError, match="in frame 'base_link', but laser_x"):
        lasers(laser_x=0.2).mounting('scan', 'base_link')
    assert lasers().mounting('scan', 'base_link').placed(POINT).tolist() == POINT.tolist()


@pytest.mark.parametrize(
    ('values', 'reason'),
    [
        ({'scan_topics': ' '}, 'scan_topics must name topics'),
        ({'scan_topics': 'scan scan'}, 'scan_topics must name topics'),
        ({'scan_topics': 'one two'}, 'several scan_topics need'),
        ({'laser_frames': 'front 1 2'}, "laser_frames: 'front 1 2' must be"),
        ({'laser_frames': 'front 1 2 nan'}, 'laser_frames'),
        ({'laser_frames': 'front 1 2 3 hanging'}, 'laser_frames'),
    ],
)
def test_parameters_that_tell_too_little_are_refused(values, reason):
    with pytest.raises(ValueError, match=reason):
        lasers(**values)
