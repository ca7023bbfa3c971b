"""Laws of nodes that others start, and of the clock that they wait on."""

import os
import signal
import sys
import threading
import time

import pytest
import rclpy
from rclpy.clock import ClockType
from rclpy.parameter import Parameter

from socialnav.demo import children
from socialnav.realtime.clocks import pacing_clock

DEAF = """
import pathlib, signal, sys, time
for number in (signal.SIGINT, signal.SIGTERM):
    signal.signal(number, signal.SIG_IGN)
pathlib.Path(sys.argv[1]).touch()
time.sleep(120)
"""


def test_a_second_signal_during_the_end_leaves_no_node_behind(monkeypatch, tmp_path):
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background ignores it
    ready = tmp_path / 'ready'
    monkeypatch.setattr(children, 'PATIENCE', 0.5)
    monkeypatch.setattr(
        children, 'command_line', lambda *_: [sys.executable, '-c', DEAF, str(ready)]
    )
    again = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
    with pytest.raises(KeyboardInterrupt), children.running_nodes({'deaf': {}}, {}) as nodes:
        while not ready.exists():
            time.sleep(0.01)
        again.start()
        raise KeyboardInterrupt
    again.join()
    assert nodes['deaf'].poll() == -signal.SIGKILL
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


@pytest.mark.parametrize('simulated', [False, True])
def test_timers_wait_for_simulated_time_or_for_a_clock_that_nobody_sets(graph, simulated):
    parameter = Parameter('use_sim_time', value=simulated)
    node = rclpy.create_node('paced', parameter_overrides=[parameter])
    expected = ClockType.ROS_TIME if simulated else ClockType.STEADY_TIME
    assert pacing_clock(node).clock_type == expected
    node.destroy_node()
