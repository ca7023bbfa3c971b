"""Stored worlds and what the shipped models do in them; run this file to store them anew."""

from pathlib import Path

import numpy as np

from socialnav_core.policies import load_policy
from socialnav_core.simulation import make_scenario, Simulator
from socialnav_core.states import CrowdState

STORED = Path(__file__).parent / 'data' / 'shipped_actions.npz'
MODELS = Path(__file__).parents[2] / 'models'
SCENARIOS = ('hard', 'crowd20', 'packed-2.5')
VARIANTS = {'plain': {'screening': False}, 'screened': {'screening': True}}
WORLDS, MOMENTS = 8, (0, 12, 24)


def stored_names():
    return sorted(path.parent.name for path in MODELS.glob('*/weights.safetensors'))


def stored_planners():
    return sorted(path.parent.name for path in MODELS.glob('*/planner.safetensors'))


def visited_states(scenario):
    """Return worlds as ORCA leaves them after some steps, one batch."""
    simulator = Simulator(make_scenario(scenario), WORLDS)
    state, policy, seen = simulator.reset(seed=5), load_policy('orca'), []
    for step in range(max(MOMENTS) + 1):
        if step in MOMENTS:
            seen.append(state.arrays())
        state, *_ = simulator.step(policy.act(state))
    return {name: np.concatenate([one[name] for one in seen]) for name in seen[0]}


def store():
    arrays = {}
    for scenario in SCENARIOS:
        fields = visited_states(scenario)
        arrays |= {f'{scenario}/state/{name}': array for name, array in fields.items()}
        state = CrowdState.from_arrays(fields)
        for model in stored_names():
            for variant, options in VARIANTS.items():
                action = load_policy(model, **options).decide(state).action
                arrays[f'{scenario}/{variant}/{model}'] = action.astype(np.int16)
        for model in stored_planners():
            arrays[f'{scenario}/planner/{model}'] = load_policy(model).act(state)
        arrays[f'{scenario}/orca'] = load_policy('orca').act(state)
    STORED.parent.mkdir(exist_ok=True)
    np.savez_compressed(STORED, **arrays)


if __name__ == '__main__':
    store()
