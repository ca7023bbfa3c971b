"""Pictures show what was recorded, move for a reasonable time and stay small."""

import dataclasses
import sys

import numpy as np
from PIL import Image
import pytest

from socialnav_core.extras import MissingExtra
from socialnav_core.policies import OrcaPolicy, StraightLinePolicy
from socialnav_core.simulation import make_scenario
from socialnav_core.viewing import animation, record
from socialnav_core.viewing.plots import plot_recording, plot_recordings, time_marks


@pytest.fixture(scope='module')
def crowd():
    return record(OrcaPolicy(), make_scenario('crowd20'), seed=7, case_index=3, name='orca')


@pytest.fixture(scope='module')
def circle():
    return record(StraightLinePolicy(), make_scenario('circle'), seed=1, name='straight_line')


def test_a_gif_of_a_whole_time_limit_among_twenty_people_is_small_and_short(crowd, tmp_path):
    assert crowd.outcome == 'timeout'
    animation.write_gif(crowd, tmp_path / 'crowd.gif')
    assert (tmp_path / 'crowd.gif').stat().st_size < 1.5e6
    with Image.open(tmp_path / 'crowd.gif') as picture:
        seconds = 0.0
        for frame in range(picture.n_frames):
            picture.seek(frame)
            seconds += picture.info['duration'] / 1000
    assert 8 < seconds < 12.5


def test_the_robot_is_where_it_was(circle):
    frames = list(animation.frames(circle))
    orange = np.all(np.abs(frames[0].astype(int) - (0xF2, 0x8E, 0x1C)) < 12, axis=-1)
    rows, columns = np.nonzero(orange)
    height, width = orange.shape
    assert columns.mean() == pytest.approx(width / 2, abs=3)  # the robot starts at (0, -4)
    assert rows.mean() > 0.7 * height


def test_frames_differ_and_have_even_sides(circle):
    first, *_, last = animation.frames(circle)
    assert (first != last).any()
    assert first.shape[0] % 2 == first.shape[1] % 2 == 0


def test_a_world_without_agents_can_be_shown(circle, tmp_path):
    nobody = dataclasses.replace(
        circle,
        states=[s.with_agents(valid=np.zeros_like(s.agents.valid)) for s in circle.states],
    )
    plot_recording(nobody, tmp_path / 'nobody.png')
    animation.write_gif(nobody, tmp_path / 'nobody.gif')
    assert Image.open(tmp_path / 'nobody.png').size[0] > 500


def test_episodes_stand_side_by_side(circle, crowd, tmp_path):
    plot_recordings([circle], tmp_path / 'one.png')
    plot_recordings([circle, crowd], tmp_path / 'two.png')
    one, two = (Image.open(tmp_path / name).size for name in ('one.png', 'two.png'))
    assert two == (2 * one[0], one[1])


def test_time_marks_are_whole_seconds_and_the_end():
    marks = time_marks(np.arange(0, 10.75, 0.25))
    np.testing.assert_array_equal(marks * 0.25, [0, 2, 4, 6, 8, 10.5])


def test_without_ffmpeg_a_video_is_refused_with_the_way_out(crowd, tmp_path, monkeypatch):
    monkeypatch.setenv('PATH', str(tmp_path))
    monkeypatch.setitem(sys.modules, 'imageio_ffmpeg', None)
    with pytest.raises(MissingExtra, match=r'socialnav_core\[video\].*or write a .gif'):
        animation.write_mp4(crowd, tmp_path / 'crowd.mp4')
    assert not (tmp_path / 'crowd.mp4').exists()
