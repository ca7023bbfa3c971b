"""Laws of the text of messages."""

from diagnostic_msgs.msg import DiagnosticStatus
from geometry_msgs.msg import Point, PoseArray
import pytest
from sensor_msgs.msg import Image, LaserScan
from small_ros2.command import CommandError
from small_ros2.messages import message_class, message_text
from std_msgs.msg import String
import yaml


def test_numbers_that_are_not_finite_can_be_read_back() -> None:
    fields = yaml.safe_load(message_text(Point(x=float('inf'), y=float('nan')), None))
    assert fields['x'] == float('inf')
    assert fields['y'] != fields['y']


@pytest.mark.parametrize('message', [LaserScan(ranges=[0.5] * 200), Image(data=[1] * 200)])
def test_only_what_is_too_long_is_cut(message: LaserScan | Image) -> None:
    field = 'ranges' if isinstance(message, LaserScan) else 'data'
    assert len(yaml.safe_load(message_text(message, None))[field]) == 200
    assert len(yaml.safe_load(message_text(message, 200))[field]) == 200
    shown = yaml.safe_load(message_text(message, 10))[field]
    assert (len(shown), shown[-1]) == (11, '...')


def test_long_words_are_cut_and_long_lines_are_not_broken() -> None:
    words = 'word ' * 100
    assert yaml.safe_load(message_text(String(data=words), 7)) == {'data': 'word wo...'}
    assert message_text(String(data=words.strip()), None).count('\n') == 1


def test_a_byte_is_a_character() -> None:
    fields = yaml.safe_load(message_text(DiagnosticStatus(level=b'\x02'), None))
    assert fields['level'] == '\x02'


def test_an_empty_array_is_shown_as_one() -> None:
    assert message_text(PoseArray(), None).endswith('poses: []\n')


@pytest.mark.parametrize('name', ['std_msgs/msg/Nothing', 'nothing/msg/String', 'String', ''])
def test_a_class_that_is_not_there_is_refused(name: str) -> None:
    with pytest.raises(CommandError, match='is invalid'):
        message_class(name)


def test_a_class_is_found_with_and_without_the_word_msg() -> None:
    assert message_class('std_msgs/msg/String') is message_class('std_msgs/String') is String
