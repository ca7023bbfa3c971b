"""Laws of the types of detections; objects with the fields of a type stand for its messages."""

from importlib.util import find_spec
from types import SimpleNamespace as Fields

from geometry_msgs.msg import Point, Pose, PoseArray
from helpers.graph import DEADLINE
import numpy as np
import pytest

from socialnav.messages.conversions import ConversionError
from socialnav.messages.detection_types import DETECTION_TYPES, message_class
from socialnav.messages.sensor_messages import detection_points
from socialnav.messages.stamps import header_message
from socialnav.perception.locating import Locator
from socialnav_msgs.msg import AgentState, AgentStates

SOMEBODY, ELSEWHERE = Pose(position=Point(x=1.0, y=2.0)), Pose(position=Point(x=9.0, y=9.0))
ROBOT, CAR = 2, 6
HEADER = header_message(10**9, 'odom')
MESSAGES = {
    'poses': PoseArray(header=HEADER, poses=[SOMEBODY]),
    'agents': AgentStates(header=HEADER, agents=[AgentState(position=SOMEBODY.position)]),
    'people_msgs': Fields(
        header=HEADER, people=[Fields(name='a', position=SOMEBODY.position, velocity=Point(x=1.0))]
    ),
    'hunav_msgs': Fields(
        header=HEADER,
        agents=[
            Fields(id=0, type=1, position=SOMEBODY),
            Fields(id=1, type=ROBOT, position=ELSEWHERE),
        ],
    ),
    'vision_msgs': Fields(
        header=HEADER, detections=[Fields(results=[], bbox=Fields(center=SOMEBODY), id='a')]
    ),
    'derived_object_msgs': Fields(
        header=HEADER,
        objects=[
            Fields(id=0, classification=4, pose=SOMEBODY),
            Fields(id=1, classification=CAR, pose=ELSEWHERE),
        ],
    ),
}


def read(source, message):
    """Return the points of a message in the frame of odom."""
    locator = Locator('odom', 'base_link', 0.2)
    return detection_points(message, DETECTION_TYPES[source], locator.frame)


@pytest.mark.parametrize('source', DETECTION_TYPES)
def test_people_are_where_the_message_says_and_nothing_else_is_one(source):
    np.testing.assert_array_equal(read(source, MESSAGES[source]), [[1.0, 2.0]])


@pytest.mark.parametrize('field', ['people', 'agents', 'detections', 'objects'])
def test_a_message_about_nobody_has_no_points(field):
    empty = Fields(header=HEADER, **{field: []})
    sources = [name for name, message in MESSAGES.items() if hasattr(message, field)]
    assert sources and all(read(source, empty).shape == (0, 2) for source in sources)


def test_a_place_that_cannot_be_is_refused():
    lost = Fields(header=HEADER, people=[Fields(position=Point(x=float('nan')))])
    with pytest.raises(ConversionError, match='detections: position with NaN'):
        read('people_msgs', lost)


@pytest.mark.parametrize(('source', 'kind'), [('poses', PoseArray), ('agents', AgentStates)])
def test_the_class_of_a_type_is_that_of_its_package(source, kind):
    assert message_class(DETECTION_TYPES[source]) is kind


@pytest.mark.skipif(find_spec('people_msgs') is not None, reason='people_msgs is installed')
def test_a_package_that_is_not_installed_is_one_line_and_exit_code_1(graph):
    process = graph.start('tracker_node', source='people_msgs')
    _, errors = process.communicate(timeout=DEADLINE)
    assert process.returncode == 1
    assert errors == (
        'tracker_node: source people_msgs needs the package of this name: install and source it\n'
    )
