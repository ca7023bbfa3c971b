"""Parameters that cannot be, at the start and while the robot drives."""

import math

from helpers.driving import Drive
from helpers.faults import FAULTS
from helpers.managed import change_parameters, change_state
from helpers.worlds import random_state
import pytest
import rclpy
from rclpy.parameter import Parameter

from socialnav.parameters.declaring import declare, ParameterError
from socialnav.parameters.fields import entries
from socialnav.parameters.policy import PolicyParameters
from socialnav.parameters.readme import KINDS

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


def refusals(graph, node):
    """Try to give every parameter of a node what it cannot be; return why it was refused."""
    changes = [
        (entry.name, value)
        for entry in entries(KINDS[node])
        for value in (*impossible(entry), WRONG_TYPE[type(entry.default)])
    ]
    results = change_parameters(graph, changes, node)
    accepted = [one for one, result in zip(changes, results, strict=True) if result.successful]
    assert accepted == []
    return [result.reason for result in results]


def test_a_value_that_cannot_be_is_refused_while_the_robot_drives_on(graph):
    drive, state = Drive(graph).start(), random_state(0)
    drive.moves(state)
    reasons = refusals(graph, 'policy_node')
    assert any(FAULTS['impossible value'].said in reason for reason in reasons)
    assert all('\n' not in reason for reason in reasons)
    drive.moves(state)
    assert change_state(graph, 'deactivate')
    assert not any('deactivate it first' in reason for reason in refusals(graph, 'policy_node'))


@pytest.mark.parametrize('node', ['simulator_node', 'obstacle_node', 'tracker_node'])
def test_a_value_that_cannot_be_is_refused_by_each_other_node(graph, node):
    graph.start(node)
    assert all('\n' not in reason for reason in refusals(graph, node))


@pytest.mark.parametrize('node', KINDS)
def test_a_node_does_not_start_with_a_value_that_cannot_be(graph, node):
    for entry in entries(KINDS[node]):
        for number, value in enumerate([*impossible(entry), WRONG_TYPE[type(entry.default)]]):
            created = rclpy.create_node(
                f'start_{entry.name}_{number}',
                parameter_overrides=[Parameter(entry.name, value=value)],
            )
            with pytest.raises(ParameterError, match=entry.name) as error:
                declare(created, KINDS[node])
            assert '\n' not in str(error.value)
            created.destroy_node()


def test_a_parameter_that_does_not_exist_is_refused_but_for_those_of_every_node(graph):
    for name in ('use_sim_time', 'qos_overrides./odom.subscription.depth', 'max_sped'):
        overrides = [Parameter(name, value=True)]
        created = rclpy.create_node('start_with_another', parameter_overrides=overrides)
        if name == 'max_sped':
            with pytest.raises(ParameterError, match='did you mean max_speed'):
                declare(created, PolicyParameters)
        else:
            declare(created, PolicyParameters)
        created.destroy_node()
