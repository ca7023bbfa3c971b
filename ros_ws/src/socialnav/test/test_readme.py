"""The tables of the README are those of the code."""

from importlib.util import find_spec
from pathlib import Path
import re

import pytest
from rclpy.qos import DurabilityPolicy, ReliabilityPolicy

from socialnav.messages.detection_types import DETECTION_TYPES
from socialnav.parameters.fields import entries
from socialnav.parameters.readme import KINDS, with_tables

README = (Path(__file__).parents[1] / 'README.md').read_text()
OWN_TOPICS = ('/rosout', '/parameter_events')
OF_EVERY_NODE = ('rcl_interfaces/', 'lifecycle_msgs/', 'type_description_interfaces/')
NODES = {
    'simulator_node': {
        'publish_clock': True, 'publish_scan': True, 'publish_detections': True,
    },
    'policy_node': {'model': 'orca', 'use_map': True},
}  # fmt: skip
SOURCES = [
    ('obstacle_node', {'source': 'scan'}),
    ('obstacle_node', {'source': 'grid'}),
    *(
        pytest.param(
            'tracker_node',
            {'source': source},
            marks=pytest.mark.skipif(
                find_spec(kind.package) is None,
                reason=f'{kind.package} is not installed: no wheel has it',
            ),
        )
        for source, kind in DETECTION_TYPES.items()
    ),
]


def section(name):
    """Return the text below a heading of the second level."""
    return README.split(f'\n## {name}\n')[1].split('\n## ')[0]


def rows(text, first_column):
    """Return the cells of each row of the table with a heading, without the heading."""
    table = text.split(f'| {first_column} |')[1].split('\n\n')[0].splitlines()[2:]
    return [[cell.strip() for cell in row.strip('|').split('|')] for row in table]


def test_the_tables_of_parameters_are_written_from_the_code():
    assert with_tables(README) == README, 'make docs writes them'


@pytest.mark.parametrize('name', KINDS)
def test_the_readme_lists_every_parameter_with_its_range_and_meaning(name):
    listed = {cells[0].strip('`'): cells for cells in rows(section(name), 'parameter')}
    assert list(listed) == [entry.name for entry in entries(KINDS[name])]
    for entry in entries(KINDS[name]):
        _, default, values, unit, live, meaning = listed[entry.name]
        assert (unit, live, meaning) == (entry.unit or '-', entry.live, entry.description)
        if isinstance(entry.default, float):
            limits = [float(one.lstrip('.')) for one in values.split(' to ')]
            assert [float(default.lstrip('.')), *limits] == pytest.approx(
                [entry.default, *entry.range], rel=1e-5
            )


@pytest.mark.parametrize('change', ['| `seed` | 0 |', '| `threads` | 1 |', '| `sectors` | 18 |'])
def test_a_table_that_says_something_else_is_written_anew(change):
    assert change in README
    assert with_tables(README.replace(change, '| `nobody` | 7 |')) == README


def endpoints(graph, node):
    """Return (direction, topic, type, reliability, durability) of everything a node has."""
    found = set()
    for topic, _ in graph.node.get_topic_names_and_types():
        for direction, ends in (
            ('pub', graph.node.get_publishers_info_by_topic(topic)),
            ('sub', graph.node.get_subscriptions_info_by_topic(topic)),
        ):
            for end in ends:
                if end.node_name == node and topic not in OWN_TOPICS:
                    found.add(
                        (direction, topic, end.topic_type.replace('/msg/', '/'), *qos_of(end))
                    )
    return found


def qos_of(end):
    """Return reliability and durability in words."""
    reliable = end.qos_profile.reliability == ReliabilityPolicy.RELIABLE
    latched = end.qos_profile.durability == DurabilityPolicy.TRANSIENT_LOCAL
    return 'reliable' if reliable else 'best effort', 'latched' if latched else 'volatile'


def of_other_source(meaning, parameters):
    """Return whether a topic is there only with another source of measurements."""
    wanted = re.search(r'only with `source: (\w+)`', meaning)
    return wanted is not None and wanted[1] != parameters['source']


@pytest.mark.parametrize(('name', 'parameters'), [*NODES.items(), *SOURCES])
def test_the_readme_lists_every_topic_as_it_is(graph, name, parameters):
    expected = set()
    for direction, topic, kind, reliability, durability, text in rows(section(name), 'direction'):
        if of_other_source(text, parameters):
            continue
        wanted = re.search(r'where (\w+) is installed', text)
        if wanted and find_spec(wanted[1]) is None or 'without `autostart`' in text:
            continue
        full = topic.strip('`').replace('~', f'/{name}')
        full = full if full.startswith('/') else f'/{full}'
        expected.add((direction, full, kind, reliability, durability))
    graph.start(name, **parameters)
    graph.wait(lambda: len(endpoints(graph, name)) >= len(expected), 'topics')
    assert endpoints(graph, name) == expected


@pytest.mark.parametrize('name', NODES)
def test_the_readme_lists_every_service_as_it_is(graph, name):
    graph.start(name, **NODES[name])
    expected = {
        (f'/{name}{service.strip("`~")}', kind.replace('/', '/srv/'))
        for service, kind, _ in rows(section(name), 'service')
    }

    def services():
        return {
            (service, kinds[0])
            for service, kinds in graph.node.get_service_names_and_types()
            if service.startswith(f'/{name}/') and not kinds[0].startswith(OF_EVERY_NODE)
        }

    graph.wait(lambda: services() >= expected, 'services')
    assert services() == expected
