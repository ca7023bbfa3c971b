"""Laws of questions whose answers get lost."""

from typing import Any

import pytest
from rcl_interfaces.srv import GetParameters, SetParameters
from rclpy.task import Future
from small_ros2 import clients
from small_ros2.command import CommandError


class Forgetful:
    """A node, and the client of a service whose first answer never comes."""

    srv_name = '/forgetful'

    def __init__(self) -> None:
        self.calls = 0

    def create_client(self, *_: Any) -> 'Forgetful':
        """Be the client too."""
        return self

    def destroy_client(self, _: 'Forgetful') -> None:
        """Nothing was made."""

    def service_is_ready(self) -> bool:
        """Be there."""
        return True

    def call_async(self, _: Any) -> Future:
        """Answer from the second call on."""
        self.calls += 1
        future = Future()
        if self.calls > 1:
            future.set_result('answer')
        return future


@pytest.fixture
def node(monkeypatch: pytest.MonkeyPatch) -> Forgetful:
    """Return a node whose clients are not waited for."""
    monkeypatch.setattr(clients, 'spin', lambda *_: None)
    return Forgetful()


def test_a_question_whose_answer_was_lost_is_asked_again(node: Any) -> None:
    assert clients.ask(node, GetParameters, '/a', 'get_parameters', None) == 'answer'
    assert node.calls == 2


def test_a_change_is_asked_for_once(node: Any) -> None:
    with pytest.raises(CommandError, match='did not answer within 10 s'):
        clients.ask(node, SetParameters, '/a', 'set_parameters', None)
    assert node.calls == 1
