"""Laws of what ships: a change of the code does not change what a trained model does."""

import numpy as np
import pytest

from socialnav_core.policies import load_policy
from socialnav_core.states import CrowdState
from tests.policies.shipped_actions import SCENARIOS, STORED, stored_planners, VARIANTS

NEARLY_EQUAL = 1e-5  # values of two actions; processors differ in the last digits
ARRAYS = dict(np.load(STORED))
PLANNERS = sorted({name.split('/')[2] for name in ARRAYS if '/planner/' in name})
MODELS = sorted({name.split('/')[2] for name in ARRAYS if '/plain/' in name})


def test_every_shipped_planner_has_stored_commands():
    assert stored_planners() == PLANNERS


def stored_state(scenario):
    prefix = f'{scenario}/state/'
    stored = {name.removeprefix(prefix): array for name, array in ARRAYS.items()}
    return CrowdState.from_arrays(stored)


@pytest.mark.parametrize('variant', VARIANTS)
@pytest.mark.parametrize('scenario', SCENARIOS)
@pytest.mark.parametrize('model', MODELS)
def test_a_shipped_model_chooses_the_stored_actions(model, scenario, variant):
    stored = ARRAYS[f'{scenario}/{variant}/{model}']
    decision = load_policy(model, **VARIANTS[variant]).decide(stored_state(scenario))
    worlds = np.arange(len(stored))
    assert len(stored) == len(decision.action)
    assert (decision.values[worlds, stored] >= decision.maximum() - NEARLY_EQUAL).all()
    assert (decision.action == stored).mean() >= 0.95


@pytest.mark.parametrize('scenario', SCENARIOS)
@pytest.mark.parametrize('model', PLANNERS)
def test_a_shipped_planner_gives_the_stored_commands(model, scenario):
    stored = ARRAYS[f'{scenario}/planner/{model}']
    commands = load_policy(model).act(stored_state(scenario))
    assert (np.abs(commands - stored).max(axis=1) < 1e-6).mean() >= 0.9


@pytest.mark.parametrize('scenario', SCENARIOS)
def test_orca_gives_the_stored_commands(scenario):
    commands = load_policy('orca').act(stored_state(scenario))
    np.testing.assert_allclose(commands, ARRAYS[f'{scenario}/orca'], atol=1e-9)
