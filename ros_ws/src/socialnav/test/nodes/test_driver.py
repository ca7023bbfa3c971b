"""Laws of when a driver in real time decides, with the executor that the nodes have."""

import time

import pytest
from rclpy.experimental import EventsExecutor
from rclpy.lifecycle import LifecycleNode

from socialnav.driver import Driver
from socialnav.parameters.policy import PolicyParameters

PERIOD = 0.4


class Ticking:
    """A driver that decides nothing, and how late each of its ticks was."""

    def __init__(self):
        self.node = LifecycleNode('driving')
        parameters = PolicyParameters(model='orca', controller_frequency=1 / PERIOD)
        self.driver = Driver(self.node, parameters, lambda: None)
        self.executor = EventsExecutor()
        self.executor.add_node(self.node)
        self.lateness = []
        self.driver.on_tick = lambda _, lateness: self.lateness.append(lateness)
        self.driver.start(parameters)

    def spin(self, duration):
        """Serve the driver for some time."""
        end = time.monotonic() + duration
        while time.monotonic() < end:
            self.executor.spin_once(timeout_sec=0.01)

    def close(self):
        """Give up everything."""
        self.driver.close()
        self.executor.shutdown()
        self.node.destroy_node()


@pytest.fixture
def ticking(graph):
    """Yield a driver that nobody serves but the test."""
    ticking = Ticking()
    yield ticking
    ticking.close()


def test_ticks_keep_their_period_though_alarms_are_set_while_one_is_due(ticking):
    ticking.spin(0.5 * PERIOD)
    time.sleep(PERIOD)
    for _ in range(3):
        ticking.driver.pace.expiry.set(60.0)
    ticking.spin(5 * PERIOD)
    assert len(ticking.lateness) >= 5
    assert min(ticking.lateness) >= 0.0


def test_a_driver_that_was_stopped_does_not_decide_though_a_tick_is_due(ticking):
    time.sleep(1.2 * PERIOD)
    ticking.driver.stop()
    ticking.driver.on_input('odom', None)
    ticking.spin(PERIOD)
    assert not ticking.lateness
