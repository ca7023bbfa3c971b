"""Whatever comes, nodes that measure go on, answer their services and take no more memory."""

from helpers.fuzz import Fuzzer, TOPICS
from helpers.managed import change_parameters
import psutil
import pytest
from rcl_interfaces.srv import GetParameters

NODES = {
    'scan': ('obstacle_node', {'source': 'scan'}, ['odom', 'pedestrians', 'scan']),
    'grid': ('obstacle_node', {'source': 'grid', 'grid_frame': 'odom'}, ['odom', 'map']),
    'detections': ('tracker_node', {}, ['odom', 'detections']),
}
ANSWER = 1.0
"""Longest time until an answer, s."""
GROWTH = 40.0
"""Memory that a node may take more after the first third of the messages, MB."""


def memory(process):
    """Return what a node that runs under a guard takes, MB."""
    (node,) = psutil.Process(process.pid).children()
    return node.memory_info().rss / 1e6


@pytest.mark.timeout(900)
@pytest.mark.parametrize(
    'duration', [4.0, pytest.param(120.0, marks=pytest.mark.slow)], ids=['short', 'long']
)
@pytest.mark.parametrize('kind', NODES)
def test_random_messages_neither_end_nor_hold_up_nor_fatten_a_node(graph, kind, duration):
    name, parameters, topics = NODES[kind]
    publishers = {
        topic: graph.node.create_publisher(TOPICS[topic][0], topic, TOPICS[topic][1])
        for topic in topics
    }
    process = graph.start(name, **parameters)
    graph.wait(lambda: all(one.get_subscription_count() for one in publishers.values()), 'node')
    change_parameters(graph, [('people_timeout', 0.4)] if name == 'obstacle_node' else [], name)
    client = graph.node.create_client(GetParameters, f'{name}/get_parameters')
    graph.wait(client.service_is_ready, 'service')
    fuzzer, sizes = Fuzzer(0), []
    for part in range(3):
        for _ in range(round(duration * 20 / 3)):
            for topic, publisher in publishers.items():
                publisher.publish(fuzzer.message(topic, graph.node.get_clock().now().nanoseconds))
            graph.spin(0.05)
        future = client.call_async(GetParameters.Request(names=['use_sim_time']))
        graph.wait(future.done, f'answer in part {part}', deadline=ANSWER)
        sizes.append(memory(process))
    assert process.poll() is None
    assert sizes[-1] - sizes[0] < GROWTH, f'memory {sizes} MB'
