"""How tests command a managed node."""

from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetState
from rcl_interfaces.msg import Parameter, ParameterValue, SetParametersResult
from rcl_interfaces.srv import SetParameters
import rclpy

TEXT, DOUBLE = 4, 3
"""Types of a ParameterValue."""


def state_of(graph, node='policy_node') -> str:
    """Return the state of a managed node."""
    return graph.ask(GetState, f'{node}/get_state', GetState.Request()).current_state.label


def change_state(graph, label, node='policy_node') -> bool:
    """Ask for a transition; return whether it was made."""
    request = ChangeState.Request(transition=Transition(label=label))
    return graph.call(ChangeState, f'{node}/change_state', request).success


def change_parameter(graph, name, node='policy_node', **value) -> SetParametersResult:
    """Change a parameter; the value is given as the fields of a ParameterValue."""
    request = SetParameters.Request()
    request.parameters = [Parameter(name=name, value=ParameterValue(**value))]
    return graph.call(SetParameters, f'{node}/set_parameters', request).results[0]


def change_parameters(graph, changes, node='policy_node') -> list[SetParametersResult]:
    """Change parameters, given as names and values, each for itself."""
    request = SetParameters.Request()
    request.parameters = [
        rclpy.parameter.Parameter(name, value=value).to_parameter_msg() for name, value in changes
    ]
    return graph.call(SetParameters, f'{node}/set_parameters', request).results
