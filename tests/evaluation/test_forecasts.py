"""Laws of the errors by which the field measures predictions of recorded people."""

from pathlib import Path

import numpy as np
import pytest

from socialnav_core.config import ConfigError
from socialnav_core.config.recordings import read_tracks
from socialnav_core.evaluation.forecasts import forecast_errors, OBSERVED, PREDICTED
from socialnav_core.prediction.constant_velocity import ConstantVelocity

PEOPLE = Path(__file__).parents[1] / 'data' / 'recorded_people.txt'


def test_who_walks_straight_on_has_no_error_and_who_turns_has_a_known_one():
    time = 0.4 * np.arange(OBSERVED + PREDICTED)
    straight = np.stack([1.2 * time, 0.0 * time], axis=1)[:, None]
    assert forecast_errors(None, straight) == pytest.approx((0.0, 0.0, 1), abs=1e-9)
    turning = straight.copy()
    ahead = time[OBSERVED:] - time[OBSERVED - 1]
    turning[OBSERVED:, 0, 1] = 0.5 * ahead
    error = forecast_errors(None, turning)
    assert error.final == pytest.approx(0.5 * 4.8)
    assert error.average == pytest.approx(0.5 * ahead.mean())


def test_constant_velocity_is_the_same_by_name_and_by_predictor():
    tracks = read_tracks(PEOPLE)
    plain = forecast_errors(None, tracks)
    assert plain.stretches > 500 and 0.0 < plain.average < plain.final
    assert forecast_errors(ConstantVelocity(), tracks) == pytest.approx(plain)


def test_too_short_tracks_are_an_error():
    with pytest.raises(ConfigError, match='nobody is seen for 20 frames'):
        forecast_errors(None, read_tracks(PEOPLE)[:15])
