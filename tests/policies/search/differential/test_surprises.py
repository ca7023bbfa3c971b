"""Laws of what it costs that somebody may walk off anew."""

import numpy as np
import pytest

from socialnav_core.config import DifferentialConfig, SearchConfig
from socialnav_core.policies.search.differential.base import Base
from socialnav_core.policies.search.differential.policy import DifferentialSearchPolicy
from socialnav_core.policies.search.differential.surprises import (
    CELL,
    CONTACT_DISTANCE,
    HALF,
    SPEEDS,
    unavoidable,
)
from tests.policies.search.differential.differential_worlds import drive, facing
from tests.policies.search.search_worlds import discs, distance_to_goal, gaps


def table(reverse=0.0, acceleration=1.0):
    """Return the table of a base of 1 m/s."""
    base = Base(1.0, acceleration, 1.5, 2.0, reverse, 0.25)
    return unavoidable(base, 1.0, 0.25, 1.0)


def share(values, speed, ahead, aside=0.0):
    """Return how often somebody there, gap ahead of the rim, cannot be evaded at a speed."""
    place = ahead + np.copysign(CONTACT_DISTANCE, ahead)
    return values[round(speed * SPEEDS), HALF + round(place / CELL), round(aside / CELL)]


def test_who_is_far_away_surprises_nobody():
    values = table()
    assert share(values, 0.0, 1.5, aside=0.8) == 0.0 and share(values, 1.0, -1.5) == 0.0
    assert np.all((values >= 0.0) & (values <= 1.0))


def test_the_faster_a_robot_the_more_surprises_it_ahead_and_the_less_behind():
    values = table()
    ahead = [share(values, speed, 0.4) for speed in (0.25, 0.5, 1.0)]
    behind = [share(values, speed, -0.4) for speed in (0.25, 0.5, 1.0)]
    assert ahead == sorted(ahead) and ahead[0] < ahead[-1]
    assert behind == sorted(behind, reverse=True) and behind[0] > behind[-1]


@pytest.mark.parametrize('better', [{'reverse': 1.0}, {'acceleration': 4.0}])
def test_a_robot_that_can_do_more_evades_more(better):
    slow = {'reverse': SPEEDS // 2, 'acceleration': 0}[next(iter(better))]  # row of a standstill
    assert table(**better)[slow].sum() < table()[0].sum()


def test_it_keeps_farther_from_whoever_may_walk_off():
    state = facing(agents=discs((4.0, 0.5, 0.3)), goal=(8.0, 0.0), speed=1.0)
    nearest = []
    for surprises in (0.0, 2.0):
        own = DifferentialConfig(surprises=surprises)
        policy = DifferentialSearchPolicy(
            SearchConfig(kinematics='differential', differential=own)
        )
        states, _ = drive(policy, state)
        assert distance_to_goal(states[-1]) < 0.3
        nearest.append(min(gaps(each).min() for each in states))
    assert nearest[1] > nearest[0] + 0.05
