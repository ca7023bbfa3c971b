"""Parameters that cannot be, at the start and while the robot drives."""

import math

from driving import Drive
from managed import change_parameters
import pytest
import rclpy
from rclpy.parameter import Parameter
from worlds import random_state

from socialnav.parameters import declare, ParameterError, POLICY_PARAMETERS, SIMULATOR_PARAMETERS

WRONG_TYPE = {bool: 'yes', int: 0.5, float: 'much', str: 7}


def impossible(entry):
    """Return values that a parameter cannot have."""
    if entry.choices:
        return ['nonsense', '']
    if not entry.range:
        return []
    low, high = entry.range
    if isinstance(entry.default, int):
        return [low - 1, high + 1]
    return [low - 1.0, math.nan, -math.inf] + ([high + 1.0] if high < math.inf else [])


def test_a_value_that_cannot_be_is_refused_while_the_robot_drives_on(graph):
    drive, state = Drive(graph).start(), random_state(0)
    drive.moves(state)
    changes = [
        (entry.name, value)
        for entry in POLICY_PARAMETERS
        for value in (*impossible(entry), WRONG_TYPE[type(entry.default)])
    ]
    results = change_parameters(graph, changes)
    accepted = [one for one, result in zip(changes, results, strict=True) if result.successful]
    assert accepted == []
    assert all('\n' not in result.reason for result in results)
    drive.moves(state)


@pytest.mark.parametrize('table', [POLICY_PARAMETERS, SIMULATOR_PARAMETERS])
def test_a_node_does_not_start_with_a_value_that_cannot_be(graph, table):
    for entry in table:
        for number, value in enumerate([*impossible(entry), WRONG_TYPE[type(entry.default)]]):
            node = rclpy.create_node(
                f'start_{entry.name}_{number}',
                parameter_overrides=[Parameter(entry.name, value=value)],
            )
            with pytest.raises(ParameterError, match=entry.name) as error:
                declare(node, (entry,))
            assert '\n' not in str(error.value)
            node.destroy_node()
