"""Laws of `ros2 node`."""

from command_line import output, refusal
import pytest

pytestmark = pytest.mark.usefixtures('talker')


def test_the_list_holds_the_nodes_but_not_the_command_itself() -> None:
    assert output('node', 'list') == '/crowd/talker\n'


def test_all_shows_hidden_nodes_too() -> None:
    assert '/crowd/talker' in output('node', 'list', '--all').splitlines()


def test_info_tells_what_a_node_offers_and_uses() -> None:
    text = output('node', 'info', '/crowd/talker')
    assert text.startswith(
        '/crowd/talker\n'
        '  Subscribers:\n    /heard: std_msgs/msg/String\n'
        '  Publishers:\n    /crowd/pose: geometry_msgs/msg/PoseStamped\n'
    )
    assert '/crowd/talker/get_parameters: rcl_interfaces/srv/GetParameters\n' in text
    assert text.endswith('  Service Clients:\n\n  Action Servers:\n\n  Action Clients:\n\n')


def test_info_of_an_unknown_node_is_refused() -> None:
    assert refusal('node', 'info', '/talker') == "Unable to find node '/talker'"
