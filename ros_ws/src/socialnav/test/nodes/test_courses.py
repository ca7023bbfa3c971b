"""An independent base with a policy node arrives, whatever its wheels and its odometry do."""

from helpers import stops
from helpers.base import Build
from helpers.course import Course
from helpers.walkers import Walkers
import pytest

DIFFERENTIAL = pytest.mark.parametrize(
    'differential', [False, True], ids=['holonomic', 'differential']
)
RUNS = 17
"""Of each kind of base among each number of people: a hundred in all."""


def course(graph, people, robots, seed, differential):
    """Return a course with robots in namespaces of their own."""
    result = Course(graph, Walkers(people, 6.0, seed), seed)
    for number in range(robots):
        result.add(f'robot{number}', Build(differential=differential))
    return result


@DIFFERENTIAL
@pytest.mark.parametrize(
    ('people', 'runs'),
    [(2, 1)] + [pytest.param(one, RUNS, marks=pytest.mark.slow) for one in (0, 1, 10)],
)
@pytest.mark.timeout(1200)
def test_a_base_with_delay_and_slip_in_a_yawed_and_displaced_frame_arrives(
    graph, differential, people, runs
):
    figures = course(graph, people, 1, people, differential).run(runs)
    stops.measured.append(f'differential {differential}, {people} people: {figures}')
    assert figures.arrived == figures.runs == runs, figures


@pytest.mark.parametrize(
    'differential', [False, pytest.param(True, marks=pytest.mark.slow)],
    ids=['holonomic', 'differential'],
)  # fmt: skip
def test_two_robots_in_namespaces_see_each_other_as_people_and_change_places(graph, differential):
    both = course(graph, 0, 2, 3, differential)
    places = [one.base.pose.place for one in both.robots]
    for robot, goal in zip(both.robots, places[::-1], strict=True):
        both.send(robot, goal)
    assert both.until(lambda: all(one.distance < 0.7 for one in both.robots), 40.0)
    assert not any(one.touches for one in both.robots)
