"""Laws of judging predictions."""

import numpy as np
import pytest

from socialnav_core.config import ConfigError
from socialnav_core.config.recordings import read_tracks
from socialnav_core.evaluation.prediction import evaluate_prediction, measure_prediction, TIMES
from socialnav_core.evaluation.recorded_people import track_moments
from socialnav_core.prediction.protocol import Prediction


class Straight:
    """Predicts constant velocity with a deviation, and a second mode that never happens."""

    knowledge = 'deployable'
    remembers = False

    def __init__(self, deviation=1.0):
        self.deviation = deviation

    def predict(self, state, times):
        agents = state.agents
        there = agents.position[:, None] + agents.velocity[:, None] * times[:, None, None]
        modes = np.stack([there, there + 100.0], axis=1)
        weights = np.tile([1.0, 0.0], (state.batch_size, 1))
        return Prediction(modes, np.full(modes.shape[:-1], self.deviation), weights)

    def reset(self, worlds=None):
        pass


def test_constant_velocity_is_as_good_as_itself():
    result = evaluate_prediction(Straight(), 'hard', groups=1)
    np.testing.assert_allclose(result.error, result.constant_velocity)
    assert 0 < result.error[0] < result.error[-1]


def test_a_wide_deviation_holds_everybody_and_none_holds_nobody():
    wide = evaluate_prediction(Straight(1e3), 'hard', groups=1)
    narrow = evaluate_prediction(Straight(1e-9), 'hard', groups=1)
    assert wide.within_one == wide.within_two == [1.0] * 5
    assert max(narrow.within_one) < 0.5


def test_the_same_seed_judges_on_the_same_people_and_noise_makes_it_harder():
    first, again = (evaluate_prediction(Straight(), 'hard', groups=1) for _ in range(2))
    noisy = evaluate_prediction(Straight(), 'hard', groups=1, noise=True)
    assert first == again
    assert noisy.people == first.people and noisy.error[0] > first.error[0]


@pytest.fixture
def tracks(tmp_path):
    """Return the tracks of two people, of whom the second comes later and walks on straight."""
    lines = [f'{10 * frame} 1 {0.04 * frame**2} 0 0 0' for frame in range(16)]
    lines += [f'{10 * frame} 7 {0.3 * frame} {0.6 * frame} 9 9' for frame in range(3, 16)]
    path = tmp_path / 'people.txt'
    path.write_text('\n'.join(lines))
    return read_tracks(path)


def test_tracks_are_nan_where_nobody_was(tracks):
    assert tracks.shape == (16, 2, 2)
    assert np.isnan(tracks[:3, 1]).all() and np.isfinite(tracks[3:]).all()


def test_recorded_people_are_there_from_their_second_frame_on(tracks):
    valid = [state.agents.valid[0].tolist() for state, _ in track_moments(tracks)]
    assert valid[:4] == [[True, False]] * 3 + [[True, True]]


def test_recorded_people_who_walk_straight_on_are_predicted_by_constant_velocity(tracks):
    result = measure_prediction(Straight(), [track_moments(tracks[3:, 1:])], 'recorded')
    np.testing.assert_allclose(result.error, 0.0, atol=1e-9)
    curved = measure_prediction(Straight(), [track_moments(tracks[:, :1])], 'recorded')
    assert curved.error[-1] > 0.5 and len(curved.error) == len(TIMES)


def test_tracks_that_are_too_short_are_an_error(tracks):
    with pytest.raises(ConfigError, match='nobody is seen'):
        measure_prediction(Straight(), [track_moments(tracks[:6])], 'short')


def test_a_file_of_anything_else_is_refused(tmp_path):
    (tmp_path / 'text').write_text('no people here')
    with pytest.raises(ConfigError, match='line 1 needs four numbers'):
        read_tracks(tmp_path / 'text')
