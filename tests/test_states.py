"""Laws of the state of a crowd."""

import numpy as np

from socialnav_core.policies import observe
from socialnav_core.simulation import make_scenario, Simulator
from socialnav_core.states import CrowdState, Observation


def crowd(*places, radius=0.3):
    """Return one world whose robot stands at the origin."""
    simulator = Simulator(make_scenario('crowd20'))
    state = simulator.reset(seed=1).with_robot(position=np.zeros((1, 2)))
    state.agents.position[0, : len(places)] = places
    state.agents.position[0, len(places) :] = 99.0
    state.agents.radius[:] = radius
    return state


def test_the_nearest_agents_are_kept_in_their_order():
    near = crowd((9.0, 0.0), (2.0, 0.0), (8.0, 0.0), (1.0, 0.0)).nearest(2)
    assert near.agents.position[0, :, 0].tolist() == [2.0, 1.0]


def test_the_rim_of_a_large_agent_counts_and_not_its_centre():
    state = crowd((3.0, 0.0), (2.0, 0.0))
    state.agents.radius[0, 0] = 2.0
    assert state.nearest(1).agents.radius[0].tolist() == [2.0]


def test_padding_is_never_near():
    state = crowd((1.0, 0.0), (2.0, 0.0))
    state.agents.valid[0, 0] = False
    assert state.nearest(1).agents.position[0, 0].tolist() == [2.0, 0.0]


def test_every_world_keeps_its_own_nearest():
    states = Simulator(make_scenario('hard'), 4).reset(seed=2)
    together = states.nearest(3).agents.position
    alone = [states.select(np.array([world])).nearest(3).agents.position for world in range(4)]
    np.testing.assert_array_equal(together, np.concatenate(alone))


def test_a_robot_as_an_agent_is_seen_behind_the_others():
    state = Simulator(make_scenario('hard'), 2).reset(seed=2)
    everybody = state.agents.append(state.robot.as_agents())
    assert everybody.count == state.agents.count + 1
    np.testing.assert_array_equal(everybody.position[:, -1], state.robot.position)
    assert everybody.valid[:, -1].all() and not everybody.static[:, -1].any()


def test_a_state_is_the_one_of_its_arrays():
    state = Simulator(make_scenario('hard'), 2).reset(seed=2)
    again = CrowdState.from_arrays(state.arrays())
    for name, array in state.arrays().items():
        assert again.arrays()[name] is array


def test_a_state_that_was_kept_without_turn_rates_turns_nowhere():
    arrays = Simulator(make_scenario('hard'), 2).reset(seed=2).arrays()
    del arrays['robot.turn_rate']
    np.testing.assert_array_equal(CrowdState.from_arrays(arrays).robot.turn_rate, np.zeros(2))


def test_a_copy_shares_no_memory():
    state = Simulator(make_scenario('hard'), 2).reset(seed=2)
    for name, array in state.copy().arrays().items():
        assert not np.shares_memory(array, state.arrays()[name])


def test_observations_joined_and_selected_are_the_ones_they_came_from():
    state = Simulator(make_scenario('hard'), 3).reset(seed=2)
    seen = observe(state)
    nobody = Observation.empty(state.agents.count)
    again = Observation.concatenate([nobody, seen, seen]).select(np.arange(6) >= 3)
    for name, array in vars(seen).items():
        found = getattr(again, name)
        assert found.dtype == array.dtype
        np.testing.assert_array_equal(found, array)
