"""Laws of simulated sensors."""

import numpy as np
import pytest

from socialnav_core.config import ConfigError
from socialnav_core.sensing import DetectorSettings, ScannerSettings, Sensors
from socialnav_core.simulation import make_scenario, Simulator


def world(name='hard', case=0):
    return Simulator(make_scenario(name)).reset(seed=3, cases=[case])


def sensors(scanner=None, detector=None, seed=1, case=2):
    return Sensors(scanner or ScannerSettings(), detector or DetectorSettings(), seed, case)


def test_a_scan_turns_with_the_robot():
    state = world()
    ahead = sensors().scan(state)
    state.robot.heading[:] = np.pi / 2
    np.testing.assert_allclose(sensors().scan(state), np.roll(ahead, -90), atol=1e-6)


def test_what_is_beyond_the_range_is_free():
    state = world()
    far, near = sensors().scan(state), sensors(ScannerSettings(range=3.0)).scan(state)
    assert (far > 3.0).any() and (far <= 3.0).any()
    np.testing.assert_array_equal(near, np.where(far <= 3.0, far, np.inf))


def test_ranges_scatter_as_much_as_they_should():
    state = world()
    true = sensors().scan(state)
    noisy = sensors(ScannerSettings(noise=0.05))
    hit = np.isfinite(true)
    errors = np.concatenate([noisy.scan(state)[hit] - true[hit] for _ in range(20)])
    assert len(errors) > 1000
    assert errors.std() == pytest.approx(0.05, rel=0.1) and abs(errors.mean()) < 0.005


def test_everybody_who_walks_is_detected_and_nothing_else():
    state = world()
    found = sensors().detect(state)
    walking = state.agents.position[0][~state.agents.static[0]]
    assert found.shape == (5, 2)
    assert sorted(found.tolist()) == sorted(walking.tolist())


def test_as_many_are_missed_as_should_be():
    state = world('crowd20')
    detector = sensors(detector=DetectorSettings(missed=0.3))
    counts = [len(detector.detect(state)) for _ in range(200)]
    assert np.mean(counts) == pytest.approx(14.0, abs=0.6)


def test_whoever_is_hidden_is_not_detected_where_occlusion_counts():
    state = world()
    walking = np.flatnonzero(~state.agents.static[0])
    state.robot.position[:], state.agents.position[:] = 0.0, 50.0
    state.agents.position[0, walking[0]], state.agents.position[0, walking[1]] = (
        (2.0, 0.0),
        (4.0, 0.0),
    )
    state.agents.radius[:] = 0.3
    assert len(sensors().detect(state)) == 5
    seen = sensors(detector=DetectorSettings(occlusion=True)).detect(state)
    assert seen.tolist() == [[2.0, 0.0]]


def test_the_same_seed_and_case_have_the_same_faults_and_others_have_others():
    state = world()
    faults = ScannerSettings(noise=0.1), DetectorSettings(noise=0.1)
    first, same, other = (sensors(*faults, case=case) for case in (5, 5, 6))
    np.testing.assert_array_equal(first.scan(state), same.scan(state))
    np.testing.assert_array_equal(first.detect(state), same.detect(state))
    assert not np.array_equal(sensors(*faults, case=5).scan(state), other.scan(state))


def test_a_scan_does_not_change_what_is_detected():
    state = world()
    faults = ScannerSettings(noise=0.1), DetectorSettings(noise=0.1)
    alone, both = sensors(*faults), sensors(*faults)
    both.scan(state)
    np.testing.assert_array_equal(alone.detect(state), both.detect(state))


@pytest.mark.parametrize(
    'faults', [{'noise': -1.0}, {'noise': np.nan}, {'beams': 0}, {'range': np.inf}]
)
def test_a_scanner_that_cannot_be_is_refused(faults):
    with pytest.raises(ConfigError, match=next(iter(faults))):
        ScannerSettings(**faults)
    with pytest.raises(ConfigError, match='missed'):
        DetectorSettings(missed=1.5)
