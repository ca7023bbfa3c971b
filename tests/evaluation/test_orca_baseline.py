"""
The ORCA robot does about as well here as in the code of the founding report.

A world in which it does much better or worse would be another world. The figures are success
rates of an ORCA robot that nobody sees, measured with the report's code.
"""

import pytest

from socialnav_core.evaluation import evaluate
from socialnav_core.policies import OrcaPolicy
from socialnav_core.simulation import make_scenario

CASES = 4000
MEASURED_ON_500 = [
    ('simple', 0.0, 0.698),
    ('simple', 0.15, 0.912),
    ('hard', 0.0, 0.666),
    ('hard', 0.15, 0.800),
    ('crowd20', 0.0, 0.248),
    ('crowd20', 0.15, 0.584),
]
MEASURED_ON_200 = [
    ('curriculum-1.0', 0.0, 0.795),
    ('curriculum-1.5', 0.0, 0.765),
    ('curriculum-2.0', 0.0, 0.735),
    ('curriculum-2.5', 0.0, 0.685),
]


def success_rate(scenario, safety_space):
    return evaluate(
        OrcaPolicy(safety_space), make_scenario(scenario), CASES
    ).records.success.mean()


@pytest.mark.parametrize(('scenario', 'safety_space', 'expected'), MEASURED_ON_500)
def test_an_orca_robot_succeeds_as_often_as_in_the_report(scenario, safety_space, expected):
    assert success_rate(scenario, safety_space) == pytest.approx(expected, abs=0.07)


@pytest.mark.parametrize(('scenario', 'safety_space', 'expected'), MEASURED_ON_200)
def test_an_orca_robot_succeeds_as_often_among_large_obstacles(scenario, safety_space, expected):
    assert success_rate(scenario, safety_space) == pytest.approx(expected, abs=0.08)
