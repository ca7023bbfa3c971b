"""The tables of the README are those of the code."""

from importlib.util import find_spec
from pathlib import Path
import re

import pytest
from rclpy.qos import DurabilityPolicy, ReliabilityPolicy

from socialnav.messages.detection_types import DETECTION_TYPES
from socialnav.parameters import POLICY_PARAMETERS, SIMULATOR_PARAMETERS
from socialnav.perception.sensor_parameters import OBSTACLE_PARAMETERS, TRACKER_PARAMETERS

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


def shown(value):
    """Return a value as YAML has it."""
    if isinstance(value, bool):
        return str(value).lower()
    return f'{value:g}' if isinstance(value, float) else str(value)


def values_of(entry):
    """Return what the README says that a parameter may be."""
    if entry.choices:
        return ', '.join(f'`{choice}`' for choice in entry.choices)
    if entry.range:
        return ' to '.join(map(shown, entry.range))
    return 'true, false' if isinstance(entry.default, bool) else 'text'


@pytest.mark.parametrize(
    ('name', 'table'),
    [
        ('simulator_node', SIMULATOR_PARAMETERS), ('policy_node', POLICY_PARAMETERS),
        ('obstacle_node', OBSTACLE_PARAMETERS), ('tracker_node', TRACKER_PARAMETERS),
    ],
)  # fmt: skip
def test_the_readme_lists_every_parameter_as_it_is(name, table):
    expected = [
        [
            f'`{entry.name}`', shown(entry.default), values_of(entry), entry.unit or '-',
            entry.live, entry.description,
        ]
        for entry in table
    ]  # fmt: skip
    assert rows(section(name), 'parameter') == expected


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
        if 'where tf2_msgs is installed' in text and find_spec('tf2_msgs') is None:
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
