"""The demonstrator plans with the radii that there are; on purpose, with those of one case."""

import numpy as np
import pytest

from socialnav_core.config.training import ImitationConfig
from socialnav_core.policies import OrcaPolicy
from socialnav_core.simulation import make_scenario, Simulator
from socialnav_core.training.demonstrators import make_demonstrator, StaleRadii


@pytest.fixture
def states():
    """Return two worlds of `hard` at their start, and two others."""
    simulator = Simulator(make_scenario('hard'), 2)
    return [simulator.reset(seed=1, split='train', cases=cases) for cases in ([0, 1], [2, 3])]


def test_stale_radii_are_those_of_the_first_case_until_a_reset(states):
    first, later = states
    stale, orca = StaleRadii(OrcaPolicy(0.15)), OrcaPolicy(0.15)
    believed = np.repeat(first.agents.radius[:1], 2, axis=0)
    for state in states:
        deceived = state.with_agents(radius=believed)
        np.testing.assert_array_equal(stale.act(state), orca.act(deceived))
    stale.reset()
    deceived = later.with_agents(radius=np.repeat(later.agents.radius[:1], 2, axis=0))
    np.testing.assert_array_equal(stale.act(later), orca.act(deceived))


def test_stale_radii_change_what_is_demonstrated(states):
    first, later = states
    stale = make_demonstrator(ImitationConfig(stale_radii=True))
    honest = make_demonstrator(ImitationConfig())
    np.testing.assert_array_equal(stale.act(first)[0], honest.act(first)[0])
    assert (stale.act(later) != honest.act(later)).any()
