"""A robot freezes when it stands near a large obstacle until its time is up."""

import numpy as np
import pytest

from founding_report.figures import render_options
from founding_report.freezing import Found, standing_since, stands_near_obstacle
from founding_report.measurements import Cases
from founding_report.rows import ROWS
from socialnav_core.policies import ValuePolicy
from socialnav_core.policies.value.checkpoint import build_network
from socialnav_core.simulation import make_scenario
from socialnav_core.states import Agents, CrowdState, Robot
from socialnav_core.viewing import record, Recording
from socialnav_core.viewing.plots import plot_recordings


@pytest.fixture
def episode():
    """Return a function that makes an episode of a robot on a line beside one obstacle at 0."""

    def make(places, outcome='timeout', radius=1.0):
        states = [state(x, 0.25 * i, radius) for i, x in enumerate(places)]
        return Recording(states, 'hard', 0, 0, outcome, 'made up')

    return make


def state(x, time, radius):
    """Return a world with one obstacle at the origin and the robot at (x, 0)."""
    return CrowdState(
        Robot(
            position=np.array([[x, 0.0]]),
            velocity=np.zeros((1, 2)),
            heading=np.zeros(1),
            radius=np.full(1, 0.3),
            preferred_speed=np.ones(1),
            goal=np.array([[5.0, 0.0]]),
        ),
        Agents(
            position=np.zeros((1, 1, 2)),
            velocity=np.zeros((1, 1, 2)),
            radius=np.full((1, 1), radius),
            static=np.ones((1, 1), bool),
            valid=np.ones((1, 1), bool),
        ),
        bounds=np.full(1, 7.5),
        time=np.array([time]),
    )


ARRIVING = [-5 + 0.25 * i for i in range(14)]  # at -1.75 in the end
STANDING = [-1.6] * 40


def test_standing_at_a_large_obstacle_to_the_end_is_freezing(episode):
    recording = episode(ARRIVING + STANDING)
    assert standing_since(recording) == 13
    assert stands_near_obstacle(recording)


@pytest.mark.parametrize(
    'changes',
    [{'outcome': 'goal'}, {'radius': 0.3}, {'places': STANDING + ARRIVING},
     {'places': [place - 2 for place in ARRIVING + STANDING]}],
)  # fmt: skip
def test_arriving_small_obstacles_late_stops_and_far_places_are_not(episode, changes):
    assert not stands_near_obstacle(episode(**{'places': ARRIVING + STANDING} | changes))


def test_cases_of_one_figure_are_rendered_into_files_of_their_own(episode):
    recording, cases = episode(STANDING), Cases('hard', 'oracle')
    rows = (ROWS['sarl_unfolded'], ROWS['gat4sn_unfolded'])
    options = {
        render_options(Found(row, seed, cases, recording)) for row in rows for seed in (0, 1)
    }
    assert len({text.split('--out ')[1] for text in options}) == 4
    assert any(text.endswith('--out out/render/sarl_unfolded-1-hard-0.gif') for text in options)


def test_a_picture_with_attention_differs_from_one_without(tmp_path):
    config = ROWS['gat4sn'].resolved(0, quick=False).policy
    policy = ValuePolicy(build_network(config), config)
    recording = record(policy, make_scenario('hard'), name='gat4sn')
    plot_recordings([recording], tmp_path / 'plain.png')
    plot_recordings([recording], tmp_path / 'attention.png', attention_at=[3])
    plain, attention = ((tmp_path / f'{n}.png').read_bytes() for n in ('plain', 'attention'))
    assert plain != attention
    assert len(attention) < 300_000
