"""
Let a policy node drive among 30 agents for long, over the real middleware.

    source scripts/environment.bash && python benchmarks/ros/soak.py --minutes 30

Fails when its memory grows, or when it misses too many periods.
"""

import argparse
import os
import sys
import time

from latency import AGE, DELAY, TELLING
from rig import conditions, memory, Rig, UNCHECKED

from socialnav.demo.children import running_nodes
from socialnav.parameters import DEFAULT_MODEL

AGENTS = 30
FREQUENCY = 10.0
WARM_UP_SHARE, LONGEST_WARM_UP = 0.25, 60.0
"""Part of the time after which memory is measured first, and the longest such time, s."""
GROWTH = 5.0
"""What the allocator may add to the memory without a leak, MB."""


def main() -> int:
    """Drive, print what was measured and return 1 where it is not as it should be."""
    parser = argparse.ArgumentParser(description=__doc__.strip().splitlines()[0])
    parser.add_argument('--minutes', type=float, default=30.0, help='default: 30')
    parser.add_argument(
        '--model', default=DEFAULT_MODEL, help=f'as of policy_node (default: {DEFAULT_MODEL})'
    )
    parser.add_argument(
        '--missed', type=float, default=0.01, help='largest share of the periods (default: 0.01)'
    )
    options = parser.parse_args()
    duration = 60 * options.minutes
    values = {'model': options.model, 'max_agents': AGENTS, 'controller_frequency': FREQUENCY}
    rig = Rig(AGENTS)
    with running_nodes({'policy_node': UNCHECKED | values}, os.environ) as nodes:
        rig.wait(rig.drives, 'motion')
        growth, missed = soak(rig, nodes['policy_node'].pid, duration)
    rig.close()
    return int(growth > GROWTH or missed > options.missed)


def soak(rig: Rig, number: int, duration: float) -> tuple[float, float]:
    """Return by how much a policy node's memory grew, MB, and the share of missed periods."""
    warm_up = min(WARM_UP_SHARE * duration, LONGEST_WARM_UP)
    rig.spin(warm_up)
    first, began, count = memory(number), time.monotonic(), len(rig.commands)
    rig.spin(duration - warm_up)
    last, commands = memory(number), len(rig.commands) - count
    missed = 1 - commands / ((time.monotonic() - began) * FREQUENCY)
    rig.spin(TELLING)
    print(f'{duration / 60:g} minutes, {AGENTS} agents, {FREQUENCY:g} Hz; {conditions()}')
    print(f'memory: {first:.1f} MB after {warm_up:g} s, {last:.1f} MB at the end')
    print(f'missed: {missed:.2%} of the periods; told: {rig.facts["missed periods"]}')
    for name in (f'{one}, p{percent} [s]' for one in (DELAY, AGE) for percent in (50, 99)):
        print(f'{name}: {rig.facts[name]}')
    return last - first, missed


if __name__ == '__main__':
    sys.exit(main())
