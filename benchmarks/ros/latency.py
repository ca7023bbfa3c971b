"""
Measure how soon commands leave after their tick, and what the nodes use, over the middleware.

    source scripts/environment.bash && python benchmarks/ros/latency.py

Delays and ages are those that the policy node measures and tells in /diagnostics. A delay counts
from when the timer was due to the end of the publish call; an age is that of the older one of odom
and pedestrians then. Usage is processor time per time, of one core.
"""

import argparse
from collections.abc import Iterator
from contextlib import contextmanager
import os

from rig import conditions, KINDS, Rig, UNCHECKED, usage

from socialnav.demo.children import running_nodes
from socialnav.parameters import DEFAULT_MODEL
from socialnav_core.tables import markdown_table

AGENTS = (5, 10, 30)
MAX_AGENTS = 30
WARM_UP = 3.0
"""Time before the processor time is counted, s."""
TELLING = 1.5
"""Time after which the node has told of its latest commands, s."""
DELAY, AGE = 'tick to command', 'age of inputs at command'


def main() -> None:
    """Measure and print two tables."""
    parser = argparse.ArgumentParser(description=__doc__.strip().splitlines()[0])
    parser.add_argument('--seconds', type=float, default=100.0, help='for each row (default: 100)')
    parser.add_argument(
        '--model', default=DEFAULT_MODEL, help=f'as of policy_node (default: {DEFAULT_MODEL})'
    )
    parser.add_argument(
        '--agents', type=int, nargs='+', default=AGENTS, help='a row each (default: 5 10 30)'
    )
    options = parser.parse_args()
    rig = Rig(options.agents[0])
    before = conditions()
    busy = [driving(rig, options, agents) for agents in options.agents]
    idle = idling(rig, options)
    rig.close()
    print(f'\n{before}; {conditions()} at the end\n')
    head = ['agents', 'tick to command, median', '99 %', 'age of inputs, median', '99 %', 'usage']
    print(markdown_table(head, busy), markdown_table(['idle at 10 Hz', 'usage'], idle), sep='\n\n')


@contextmanager
def policy_node(rig: Rig, options: argparse.Namespace, **parameters: object) -> Iterator[int]:
    """
    Run a policy node; yield the number of its process.

    :param rig: forgets what an earlier node has commanded.
    :param parameters: besides the model.
    """
    rig.spin(TELLING)
    rig.commands.clear()
    values = UNCHECKED | {'model': options.model, 'max_agents': MAX_AGENTS} | parameters
    with running_nodes({'policy_node': values}, os.environ) as nodes:
        yield nodes['policy_node'].pid


def driving(rig: Rig, options: argparse.Namespace, agents: int) -> list[str]:
    """Return the row of a node that drives in a crowd."""
    rig.show(agents)
    rig.silent.clear()
    with policy_node(rig, options) as number:
        rig.wait(rig.drives, 'motion')
        rig.spin(WARM_UP)
        used = usage(rig, number, options.seconds)
        rig.spin(TELLING)
    times = [
        f'{1e3 * float(rig.facts[f"{name}, p{percent} [s]"]):.1f} ms'
        for name in (DELAY, AGE)
        for percent in (50, 99)
    ]
    return [str(agents), *times, f'{used:.1%}']


def idling(rig: Rig, options: argparse.Namespace) -> list[list[str]]:
    """Return the rows of nodes that have nothing to drive for."""
    rows = []
    for what, silent in (
        ('policy node without inputs', set(KINDS)),
        ('policy node without a goal, 5 pedestrians at 20 Hz', {'goal_pose'}),
    ):
        rig.silent = silent
        rig.show(5)
        with policy_node(rig, options, stop_publish_timeout=0.0) as number:
            rig.wait(lambda: bool(rig.commands), 'commands')
            rig.spin(WARM_UP)
            rows.append([what, f'{usage(rig, number, options.seconds / 2):.1%}'])
    rig.silent = set(KINDS)
    with running_nodes({'simulator_node': {}}, os.environ) as nodes:
        rig.spin(2 * WARM_UP)
        used = usage(rig, nodes['simulator_node'].pid, options.seconds / 2)
    return [*rows, ['simulator node, `hard` at 20 Hz', f'{used:.1%}']]


if __name__ == '__main__':
    main()
