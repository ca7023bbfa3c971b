"""
Measure how long a robot drives on when its inputs stop, over the real middleware.

    source scripts/environment.bash && python benchmarks/ros/stop_times.py

A time counts from the stamp of the last message of the input, or from when the simulator is
killed, to the arrival of the first zero command. Fails when one is beyond input_timeout and a
period. Where the measuring process itself stood still for too long to tell, the stop is repeated
and counted so.

Like the base of a robot, the measuring process hears nothing from the process that is killed: one
that does may stand still for a second, since a process that dies while it publishes holds up the
shared memory of Fast DDS for those it publishes to.
"""

import argparse
from collections.abc import Callable
from itertools import takewhile
import os
import random
import signal
import sys
import time

import numpy as np
from rig import conditions, KINDS, Rig, UNCHECKED

from socialnav.demo.children import Nodes, running_nodes
from socialnav_core.tables import markdown_table

INPUT_TIMEOUT, PERIOD = 0.5, 0.1
LIMIT = INPUT_TIMEOUT + PERIOD
LONGEST_PAUSE = 0.02
"""Time for which the measuring process may stand still, s."""
ZEROS = 3
"""Zero commands in succession that are a stop; a single one may have been for another reason."""
PEDESTRIANS = 5
POLICY = UNCHECKED | {
    'input_timeout': INPUT_TIMEOUT,
    'controller_frequency': 1 / PERIOD,
    'model': 'straight_line',  # it never chooses to stand
}


def main() -> int:
    """Measure, print a table and return 1 where the robot once drove on for too long."""
    parser = argparse.ArgumentParser(description=__doc__.strip().splitlines()[0])
    parser.add_argument('--repetitions', type=int, default=100, help='of each stop (default: 100)')
    options = parser.parse_args()
    rig = Rig(PEDESTRIANS)
    before = conditions()
    with running_nodes({'policy_node': POLICY}, os.environ):
        times = {
            f'`{name}` stops': repeat(options.repetitions, lambda name=name: silence(rig, name))
            for name in ('odom', 'pedestrians')
        }
        times['simulator killed'] = repeat(options.repetitions, lambda: kill_simulator(rig))
    with running_nodes({'policy_node': POLICY | {'use_sim_time': True}}, os.environ):
        times['simulator killed, and its clock'] = repeat(
            options.repetitions, lambda: kill_simulator(rig, publish_clock=True)
        )
    rig.close()
    print(f'\n{before}; {conditions()} at the end\n\n{table(times)}')
    return int(any(beyond(measured) for measured, _ in times.values()))


def beyond(times: list[float]) -> int:
    """Return how many times, s, are beyond the limit."""
    return sum(one > LIMIT for one in times)


def repeat(repetitions: int, measure: Callable[[], float | None]) -> tuple[list[float], int]:
    """
    Return the times of some stops, s, and how many could not be measured.

    :param measure: stops once; returns None where the machine stood still.
    :raises RuntimeError: when it does so most of the time.
    """
    times: list[float] = []
    for attempt in range(2 * repetitions + 2):
        if (duration := measure()) is not None:
            times.append(duration)
        if len(times) == repetitions:
            return times, attempt + 1 - repetitions
    raise RuntimeError('this machine is too busy to measure anything')


def silence(rig: Rig, name: str) -> float | None:
    """Return how long the robot drove on after the last message of a topic, s."""
    rig.silent.clear()
    rig.wait(rig.drives, 'motion')
    rig.spin(random.uniform(0.1, 0.1 + 2 * PERIOD))  # at any moment of a period
    rig.silent.add(name)
    duration = until_zero(rig, lambda: rig.stamps[name])
    rig.silent.clear()
    return duration


def kill_simulator(rig: Rig, **parameters: object) -> float | None:
    """
    Return how long the robot drove on after its simulator was killed, s.

    :param parameters: of the simulator, besides the scenario.
    """
    rig.silent.update(KINDS)
    rig.give_up('pedestrians')  # else its silence, too, stops the robot
    rig.wait(lambda: not rig.drives(), 'standstill')
    values = {'scenario': 'simple'} | parameters
    with running_nodes({'simulator_node': values}, os.environ) as nodes:
        rig.wait(rig.drives, 'motion')
        rig.spin(random.uniform(0.1, 0.1 + 2 * PERIOD))
        killed = time.time_ns()
        kill(nodes)
        return until_zero(rig, lambda: killed)


def kill(nodes: Nodes) -> None:
    """Kill nodes at once."""
    for node in nodes.values():
        node.send_signal(signal.SIGKILL)


def until_zero(rig: Rig, last: Callable[[], int]) -> float | None:
    """
    Return the time from a moment to the first of the last zero commands, s, if it is known.

    :param last: returns the moment, ns; the last message may still be under way now.
    """
    rig.commands.clear()
    rig.wait(lambda: len(standing(rig)) >= ZEROS, 'zero commands')
    if rig.longest_pause > LONGEST_PAUSE:
        return None
    return standing(rig)[0] - last() * 1e-9


def standing(rig: Rig) -> list[float]:
    """Return when the zero commands came after which there was no other, s."""
    latest = takewhile(lambda command: not command[1], reversed(rig.commands))
    return [moment for moment, _ in latest][::-1]


def table(times: dict[str, tuple[list[float], int]]) -> str:
    """
    Return a table in Markdown.

    :param times: s, and how many were repeated, by what stopped.
    """
    head = ['what stops', 'times', 'median', '99 %', 'longest', 'limit', 'beyond', 'repeated']
    rows = []
    for name, (values, repeated) in times.items():
        middle, high = np.percentile(values, [50, 99])
        numbers = (f'{one:.3f} s' for one in (middle, high, max(values), LIMIT))
        rows.append([name, str(len(values)), *numbers, str(beyond(values)), str(repeated)])
    return markdown_table(head, rows)


if __name__ == '__main__':
    sys.exit(main())
