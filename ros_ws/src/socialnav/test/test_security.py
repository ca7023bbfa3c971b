"""The security policy permits what the nodes do, and the page says what the policy says."""

from importlib.util import find_spec
from pathlib import Path
from xml.etree import ElementTree

import pytest

PACKAGE = Path(__file__).parents[1]
PAGE = (PACKAGE.parents[2] / 'docs' / 'ros_security.md').read_text()
POLICY = ElementTree.parse(PACKAGE / 'config' / 'security_policy.xml')
NODES = {
    'simulator_node': {
        'publish_clock': True, 'publish_scan': True, 'publish_detections': True,
    },
    'policy_node': {'model': 'orca', 'use_map': True, 'use_sim_time': True},
    'obstacle_node': {'source': 'scan', 'use_sim_time': True},
    'tracker_node': {'use_sim_time': True},
}  # fmt: skip
OF_ANOTHER_SOURCE = {'obstacle_node': {'map'}}
KINDS = {
    'publisher': ('topics', 'publish'),
    'subscriber': ('topics', 'subscribe'),
    'service': ('services', 'reply'),
    'client': ('services', 'request'),
}
TRANSFORMS = {'tf', 'tf_static'}
LISTENING_WHEN_ASKED = ('policy_node', 'obstacle_node')
"""Nodes that hear transforms only when they must."""


def permitted(node, kind):
    """Return the names in the policy, sorted, of what a node may have."""
    tag, right = KINDS[kind]
    profile = POLICY.find(f".//profile[@node='{node}']")
    groups = [group for group in profile.findall(tag) if group.get(right) == 'ALLOW']
    return [name.text for group in groups for name in group]


def present(graph, node, kind):
    """Return the names of what a node has, as the policy writes them."""
    found = getattr(graph.node, f'get_{kind}_names_and_types_by_node')(node, '/')
    return {name.replace(f'/{node}/', '~/').removeprefix('/') for name, _ in found}


@pytest.mark.parametrize('node', NODES)
def test_the_policy_permits_a_node_what_it_has_and_no_more(graph, node):
    graph.start(node, **NODES[node])
    for kind in KINDS:
        wanted = set(permitted(node, kind)) - OF_ANOTHER_SOURCE.get(node, set())
        if find_spec('tf2_msgs') is None or node in LISTENING_WHEN_ASKED:
            wanted -= TRANSFORMS
        graph.wait(
            lambda kind=kind, wanted=wanted: (
                graph.node.get_node_names().count(node) and present(graph, node, kind) >= wanted
            ),
            f'{kind} of {node}',
        )
        assert present(graph, node, kind) == wanted


@pytest.mark.parametrize('node', NODES)
def test_the_page_lists_what_the_policy_permits(node):
    (row,) = (line for line in PAGE.splitlines() if line.startswith(f'| `{node}` |'))
    columns = [cell.strip() for cell in row.strip('|').split('|')][1:]
    for kind, cell in zip(('publisher', 'subscriber', 'service'), columns, strict=True):
        assert cell == ', '.join(f'`{name}`' for name in permitted(node, kind)), kind


def test_every_enclave_has_one_profile_of_its_name():
    for enclave in POLICY.iter('enclave'):
        (profile,) = enclave.iter('profile')
        assert enclave.get('path') == f'/socialnav/{profile.get("node")}'


def test_the_operator_asks_only_for_services_that_the_policy_node_serves():
    served = {name.replace('~', '/policy_node') for name in permitted('policy_node', 'service')}
    asked = set(permitted('operator', 'client'))
    assert asked and asked <= served
    assert not any('set_parameters' in name for name in asked)
