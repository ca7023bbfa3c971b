"""Requests of a life cycle that rclpy leaves without an answer."""

from lifecycle_msgs.srv import ChangeState
from rclpy.impl.implementation_singleton import rclpy_implementation
from rclpy.lifecycle import LifecycleNode


def answer_every_transition(node: LifecycleNode) -> None:
    """
    Answer a request for a transition that the present state does not have: it has failed.

    rclpy raises there, so that whoever asked waits for ever; nothing that is public in it leads
    to its service.
    """
    service = node._service_change_state
    change = service.callback

    def answer(
        request: ChangeState.Request, response: ChangeState.Response
    ) -> ChangeState.Response:
        try:
            return change(request, response)
        except rclpy_implementation.RCLError:
            wanted, (_, state) = request.transition, node._state_machine.current_state
            text = f'refused: no transition {wanted.label or wanted.id!r} from {state}'
            node.get_logger().error(text, throttle_duration_sec=1.0)
            response.success = False
            return response

    service.callback = answer
