"""
Let an independent base drive to goal after goal, among people who walk, with a policy node.

    source scripts/environment.bash && python benchmarks/ros/courses.py --runs 34

The base has delay, slip and odometry in a yawed and displaced frame. Both kinds of base drive with
nobody, one and ten people. Fails when a run does not arrive.
"""

import argparse
import os
from pathlib import Path
import sys

import numpy as np

from socialnav.demo.isolation import isolated_environment
from socialnav_core.evaluation.statistics import wilson_interval

TOOLS = Path(__file__).parents[2] / 'ros_ws' / 'src' / 'socialnav' / 'test'
PEOPLE = (0, 1, 10)


def main() -> int:
    """Drive, print what became of it and return 1 where a robot did not arrive."""
    parser = argparse.ArgumentParser(description=__doc__.strip().splitlines()[0])
    parser.add_argument('--runs', type=int, default=17, help='of each world (default: 17)')
    parser.add_argument('--seed', type=int, default=0, help='of goals and people (default: 0)')
    options = parser.parse_args()
    os.environ.update(isolated_environment(os.environ))
    sys.path.insert(0, str(TOOLS))
    print('| base | people | arrived | touched | median time |\n|---|---|---|---|---|')
    arrived = [
        row(differential, people, options.runs, options.seed)
        for differential in (False, True)
        for people in PEOPLE
    ]
    total, count = sum(arrived), len(arrived) * options.runs
    low, high = wilson_interval(total, count)
    print(f'{total} of {count} arrived (95 %: {low:.3f} to {high:.3f})')
    return int(total < count)


def row(differential: bool, people: int, runs: int, seed: int) -> int:
    """Drive in one world, print a line of the table and return how many runs arrived."""
    from helpers.base import Build
    from helpers.course import Course
    from helpers.graph import open_graph
    from helpers.walkers import Walkers

    with open_graph() as graph:
        course = Course(graph, Walkers(people, 6.0, seed), seed)
        course.add('robot', Build(differential=differential))
        figures = course.run(runs)
    kind = ('holonomic', 'differential')[differential]
    time = np.median(figures.times or [np.nan])
    print(
        f'| {kind} | {people} | {figures.arrived} of {runs} | {figures.touched} | {time:.1f} s |'
    )
    for text in figures.said:
        print(f'  not arrived: {text}')
    sys.stdout.flush()
    return figures.arrived


if __name__ == '__main__':
    sys.exit(main())
