"""Laws of reading recorded people."""

import itertools
from pathlib import Path

import numpy as np
import pytest

from socialnav_core.config import ConfigError, make_scenario
from socialnav_core.config.appearances import appearances_of, REST, slots_of
from socialnav_core.config.mapping import replace
from socialnav_core.config.recordings import frames_of, INTERVAL, read_tracks
from socialnav_core.config.scenarios import changes_of, resolve_scenario
from tests.recorded_people import lines

PEOPLE = Path(__file__).parents[1] / 'data' / 'recorded_people.txt'
WALK = [f'{10 * frame} 1 {0.5 * frame} 0' for frame in range(60)]


def written(tmp_path, *rows):
    """Return a file of some lines."""
    path = tmp_path / 'people.txt'
    path.write_text('\n'.join(rows))
    return path


def changed(line, text):
    """Return the lines of somebody who walks, one of them another."""
    return [*WALK[:line], text, *WALK[line + 1 :]]


def test_the_synthetic_recording_is_what_its_script_writes():
    assert PEOPLE.read_text().splitlines() == list(lines())


@pytest.mark.parametrize(
    ('rows', 'told'),
    [
        ([], 'it is empty'),
        (['# a comment alone'], 'it is empty'),
        (changed(3, '30 1 1.5'), 'line 4 needs four numbers, frame person x y'),
        (changed(3, '30,1,1.5,0'), 'line 4 needs four numbers'),
        (changed(3, '30 1 x 0'), "line 4: 'x' is no number"),
        (changed(3, '30 1 nan 0'), 'line 4: 30 1 nan 0 must be finite'),
        (changed(3, '30 1 1e999 0'), 'line 4: .* must be finite'),
        (changed(3, '15 1 1.5 0'), 'person 1 is in frame 15 after frame 20: time goes back'),
        (changed(3, '20 1 1.5 0'), 'line 4: person 1 is in frame 20 twice'),
        (changed(3, '30 1 31.5 0'), 'line 4: person 1 jumps by 30.5 m in 0.4 s'),
        ([f'{10 * k} 1 {50 * k} 0' for k in range(12)], 'in metres and frames 0.4 s apart'),
        ([f'{10 * k} 1 {0.0005 * k} 0' for k in range(12)], 'stay within 0.0055 m'),
        ([*WALK, *(f'{2**60} {k} 1 1' for k in range(100, 200))], '101 people are too many'),
    ],
)  # fmt: skip
def test_a_mistake_in_a_recording_is_told_in_one_line_with_its_place(tmp_path, rows, told):
    with pytest.raises(ConfigError, match=told) as caught:
        read_tracks(written(tmp_path, *rows))
    assert '\n' not in str(caught.value) and str(tmp_path) in str(caught.value)


def test_what_is_no_text_or_not_there_is_refused(tmp_path):
    (tmp_path / 'picture').write_bytes(b'\xff\xd8\xff\xe0' * 10)
    with pytest.raises(ConfigError, match='no UTF-8 text'):
        read_tracks(tmp_path / 'picture')
    for path in (tmp_path / 'nothing', tmp_path):
        with pytest.raises(ConfigError, match='no such file'):
            read_tracks(path)


def test_frames_that_are_one_off_and_breaks_between_scenes_keep_all_lines_apart():
    frames = np.array([780, 786, 792, 845, 851, 857, 947, 953, 960, 965.0])
    index = frames_of(frames)
    assert (np.diff(index) >= 1).all() and index[:3].tolist() == [0, 1, 2]
    assert index[3] - index[2] == 9 and np.diff(index[3:6]).tolist() == [1, 1]


def test_further_columns_blank_lines_and_comments_are_left_aside(tmp_path):
    rows = [f'{row} 9 9 # seen' for row in WALK]
    tracks = read_tracks(written(tmp_path, '# people', '', *rows))
    np.testing.assert_allclose(tracks[:, 0, 0], 0.5 * np.arange(60))


def test_a_slot_rests_between_two_people_and_holds_one_at_a_time():
    tracks = read_tracks(PEOPLE)
    taken = appearances_of(tracks, INTERVAL)
    assert len(taken) > 60
    for slot in range(slots_of(tracks, INTERVAL)):
        spans = sorted((a.frames[0], a.frames[-1]) for a in taken if a.slot == slot)
        gaps = [(after[0] - before[1]) * INTERVAL for before, after in itertools.pairwise(spans)]
        assert min(gaps, default=REST) >= REST - 1e-9


def test_who_is_missing_for_long_is_another_appearance_and_a_short_gap_is_none(tmp_path):
    kept = [row for k, row in enumerate(WALK) if k not in (3, 4)]
    apart = [f'{10 * k} 1 {0.5 * k} 0' for k in (*range(4), *range(10, 30))]
    for rows, expected in ((kept, 1), (apart, 2)):
        assert len(appearances_of(read_tracks(written(tmp_path, *rows)), INTERVAL)) == expected


def test_a_scenario_of_a_recording_is_made_by_the_name_of_the_file():
    world = make_scenario(f'recorded:{PEOPLE}')
    assert world.crowd == world.layout == 'recorded' and not world.robot_visible
    assert world.pedestrians == slots_of(read_tracks(PEOPLE), INTERVAL)
    reactive = make_scenario(f'recorded_reactive:{PEOPLE}')
    assert reactive.robot_visible and reactive.crowd == 'recorded_reactive'
    assert changes_of(world) == {}
    assert changes_of(replace(world, {'time_limit': 20})) == {'time_limit': 20.0}


def test_another_frame_rate_makes_as_many_slots_as_it_needs():
    name = f'recorded:{PEOPLE}'
    dense = resolve_scenario({'name': name, 'recording': {'interval': 0.2}})
    tracks = read_tracks(PEOPLE)
    assert dense.pedestrians == slots_of(tracks, 0.2) > make_scenario(name).pedestrians


def test_recorded_people_are_not_mixed_with_anything_else():
    world = make_scenario(f'recorded:{PEOPLE}')
    for settings, told in (
        ({'robot_visible': True}, 'robot_visible must be false with the crowd recorded'),
        ({'crowd': 'orca'}, 'need the layout recorded'),
        ({'obstacles': 3}, 'obstacles must be 0'),
    ):
        with pytest.raises(ConfigError, match=told):
            replace(world, settings)
    with pytest.raises(ConfigError, match='need the layout recorded'):
        replace(make_scenario('hard'), {'crowd': 'recorded'})
