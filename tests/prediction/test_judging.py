"""Laws of judging predictions."""

import numpy as np
import pytest

from socialnav_core.config import ConfigError
from socialnav_core.config.recordings import read_tracks
from socialnav_core.evaluation.judgement import judge, LEVELS, MOTIONS, summarise, TIMES
from socialnav_core.evaluation.prediction import evaluate_prediction
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
    (result,) = evaluate_prediction(Straight(), 'hard', groups=1)
    np.testing.assert_allclose(result.error, result.constant_velocity)
    assert 0 < result.error[0] < result.error[-1]


def test_a_wide_deviation_holds_everybody_and_none_holds_nobody():
    (wide,) = evaluate_prediction(Straight(1e3), 'hard', groups=1)
    (narrow,) = evaluate_prediction(Straight(1e-9), 'hard', groups=1)
    assert wide.within_one == wide.within_two == [1.0] * 5
    assert max(narrow.within_one) < 0.5


def test_the_same_seed_judges_on_the_same_people_and_noise_makes_it_harder():
    (first,), (again,) = (evaluate_prediction(Straight(), 'hard', groups=1) for _ in range(2))
    (noisy,) = evaluate_prediction(Straight(), 'hard', groups=1, noise=True)
    assert first == again
    assert noisy.people == first.people and noisy.error[0] > first.error[0]


def measured(tracks, deviation=1.0):
    """Return the result of constant velocity on everybody of some tracks."""
    return summarise(judge(Straight(deviation), [track_moments(tracks)], 'recorded'), 'recorded')[
        0
    ]


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
    result = measured(tracks[3:, 1:])
    np.testing.assert_allclose(result.error, 0.0, atol=1e-9)
    curved = measured(tracks[:, :1])
    assert curved.error[-1] > 0.5 and len(curved.error) == len(TIMES)


def test_tracks_that_are_too_short_are_an_error(tracks):
    with pytest.raises(ConfigError, match='nobody is seen'):
        measured(tracks[:6])


def test_a_file_of_anything_else_is_refused(tmp_path):
    (tmp_path / 'text').write_text('no people here')
    with pytest.raises(ConfigError, match='line 1 needs four numbers'):
        read_tracks(tmp_path / 'text')


def gaussian_tracks(deviation, people=4000):
    """Return people who stand for two frames and then are off by a Gaussian, m."""
    draws = np.random.default_rng(0)
    tracks = np.zeros((10, people, 2))
    tracks[2:] = deviation * draws.standard_normal((people, 2))
    return tracks


def test_a_gaussian_of_the_predicted_deviation_is_where_it_should_be():
    result = measured(gaussian_tracks(0.5), 0.5)
    assert abs(result.within_one[-1] - 0.683) < 0.02 and abs(result.within_two[-1] - 0.954) < 0.01
    np.testing.assert_allclose(result.within_level[-1], LEVELS, atol=0.02)


def test_the_surprise_is_least_for_the_true_deviation_and_is_the_entropy_then():
    tracks = gaussian_tracks(0.5)
    found = {deviation: measured(tracks, deviation).surprise[-1] for deviation in (0.3, 0.5, 0.8)}
    assert min(found, key=found.get) == 0.5
    assert abs(found[0.5] - np.log(2 * np.pi * np.e * 0.25)) < 0.05


def test_people_are_told_apart_by_what_they_are_about_to_do():
    frames = np.arange(20.0)[:, None]
    walker = 0.4 * frames * [1.0, 0.0]
    turner = np.where(frames < 8, walker, [3.2, 0.0] + 0.4 * (frames - 8) * [0.0, 1.0])
    starter = np.where(frames < 8, 0.0, 0.4 * (frames - 8) * [0.0, 1.0])
    tracks = np.stack([walker, turner, starter, 0.0 * walker], axis=1)
    found = judge(Straight(), [track_moments(tracks)], 'all')
    names = np.array(MOTIONS)[found.motion].reshape(-1, 4)
    assert (names[0] == 'new').all()
    assert names[7].tolist() == ['walking', 'turning', 'starting', 'standing']


def test_the_motions_together_are_all_people(tracks):
    results = evaluate_prediction(Straight(), 'hard', groups=1, motions=True)
    assert results[0].motion == 'all' and len(results) > 3
    assert results[0].people == sum(result.people for result in results[1:])
    total = sum(result.people * result.error[2] for result in results[1:])
    np.testing.assert_allclose(total / results[0].people, results[0].error[2])
