"""Laws of what the demo starts."""

import pytest

from socialnav.demo.graph import node_parameters, node_topics
from socialnav.demo.run import parse
from socialnav.parameters.fields import entries
from socialnav.parameters.readme import KINDS


@pytest.mark.parametrize('flags', [[], ['--real-time'], ['--sensors']])
def test_every_parameter_that_is_given_exists(flags):
    for name, values in node_parameters(parse(flags)).items():
        assert values.keys() <= {entry.name for entry in entries(KINDS[name])} | {'use_sim_time'}


@pytest.mark.parametrize('flags', [['--real-time'], ['--sensors']])
def test_in_real_time_everybody_has_the_clock_of_the_simulator(flags):
    nodes = node_parameters(parse(flags))
    assert nodes.pop('simulator_node')['publish_clock']
    assert all(values['use_sim_time'] for values in nodes.values())


def test_a_world_that_runs_faster_is_told_as_often_in_its_own_time():
    fast = node_parameters(parse(['--real-time', '--real-time-factor', '2']))['simulator_node']
    assert fast['publish_rate'] / fast['real_time_factor'] == 20.0


def test_a_robot_that_measures_is_not_told_the_truth():
    options = parse(['--sensors'])
    renamed = node_topics(options)['simulator_node']
    assert {'pedestrians', 'obstacles'} == renamed.keys()
    assert not renamed.keys() & set(renamed.values())
    assert set(node_parameters(options)) == set(KINDS)


def test_a_demo_in_lockstep_has_two_nodes_with_the_usual_topics():
    options = parse([])
    assert set(node_parameters(options)) == {'simulator_node', 'policy_node'}
    assert node_topics(options) == {}
