"""Laws of the screening of actions."""

import numpy as np
import pytest

from socialnav_core.config import PolicyConfig, ScreeningConfig
from socialnav_core.policies.value.screening import safe_actions
from socialnav_core.simulation.kinematics import kinematics_of
from socialnav_core.states import Agents, CrowdState, Robot

SCREENING = ScreeningConfig(enabled=True)


def world(position, velocity=(0.0, 0.0), static=False, bounds=np.inf):
    """Return a robot of radius 0.3 at the origin and discs of radius 0.3."""
    position = np.array([position], float).reshape(1, -1, 2)
    count = position.shape[1]
    return CrowdState(
        Robot(
            position=np.zeros((1, 2)),
            velocity=np.zeros((1, 2)),
            heading=np.zeros(1),
            radius=np.array([0.3]),
            preferred_speed=np.ones(1),
            goal=np.array([[9.0, 0.0]]),
        ),
        Agents(
            position=position,
            velocity=np.broadcast_to(np.array(velocity, float), position.shape).copy(),
            radius=np.full((1, count), 0.3),
            static=np.full((1, count), static),
            valid=np.ones((1, count), bool),
        ),
        bounds=np.array([bounds], float),
        time=np.zeros(1),
    )


def safe(state, kinematics='holonomic', exact=False, config=SCREENING):
    """Return the safe commands, (n, 2), and whether each of all commands is."""
    motion = kinematics_of(kinematics)
    commands = motion.action_set(PolicyConfig(kinematics=kinematics))
    deviation = np.full(state.agents.valid.shape, 0.0 if exact else 0.1)
    mask = safe_actions(
        state, commands[None], state.agents.velocity, motion, 0.25, config, deviation
    )[0]
    return commands[mask], mask


def test_alone_everything_is_safe():
    state = world((5.0, 0.0)).with_agents(valid=np.zeros((1, 1), bool))
    assert safe(state)[1].all()


@pytest.mark.parametrize('kinematics', ['holonomic', 'differential'])
def test_driving_into_an_obstacle_is_not_safe_and_standing_still_is(kinematics):
    commands, mask = safe(world((0.8, 0.0), static=True), kinematics)
    assert mask[0] and not mask.all()
    assert not ((commands[:, 0] > 0.9) & (np.abs(commands[:, 1]) < 1e-9)).any()


def test_in_the_way_of_a_walker_standing_still_is_safe_only_while_there_is_a_way_out():
    assert safe(world((3.0, 0.0), velocity=(-1.0, 0.0)))[1][0]
    # 0.3 m of clearance, closing at 1 m/s: too late to step aside after the first action
    assert not safe(world((0.9, 0.0), velocity=(-1.0, 0.0)))[1][0]


def allows(state, command, **options):
    return any(np.allclose(command, one) for one in safe(state, **options)[0])


def test_who_stands_gets_more_room_than_an_obstacle():
    assert allows(world((1.0, 0.0), static=True), (1.0, 0.0))
    assert not allows(world((1.0, 0.0), static=False), (1.0, 0.0))


def test_who_is_too_near_already_may_be_left_but_not_approached():
    near = world((0.72, 0.0))
    assert allows(near, (-1.0, 0.0)) and allows(near, (0.0, 0.0))
    assert not allows(near, (0.37754067, 0.0))


def test_an_exact_prediction_needs_no_margin_for_people():
    assert allows(world((1.0, 0.0)), (1.0, 0.0), exact=True)


def test_walls_are_obstacles():
    commands, _ = safe(world((5.0, 5.0), static=True, bounds=0.5))
    assert np.abs(commands).max() * 0.25 <= 0.2 + 1e-9


def test_where_nothing_is_safe_something_can_still_be_chosen():
    ring = 0.61 * np.stack([np.cos(np.arange(12) / 2), np.sin(np.arange(12) / 2)], axis=-1)
    assert safe(world(ring))[1].any()
