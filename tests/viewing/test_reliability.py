"""Laws of the picture of reliability."""

import dataclasses

from PIL import Image
import pytest

from socialnav_core.evaluation.judgement import LEVELS, PredictionResult, TIMES
from socialnav_core.viewing.reliability import plot_reliability

LISTS = [[0.1] * len(TIMES)] * 5
RESULT = PredictionResult('hard', False, 'all', 7, *LISTS, [list(LEVELS)] * len(TIMES))


def size_of(results, tmp_path):
    """Return the width and height of the picture of some results."""
    plot_reliability(results, tmp_path / 'picture.png')
    with Image.open(tmp_path / 'picture.png') as picture:
        return picture.size


@pytest.mark.parametrize('crowds', [1, 3])
def test_each_crowd_has_a_panel(crowds, tmp_path):
    one, _ = size_of([RESULT], tmp_path)
    width, _ = size_of([RESULT] * crowds, tmp_path)
    assert width == crowds * one


def test_many_crowds_go_into_rows(tmp_path):
    _, row = size_of([RESULT] * 5, tmp_path)
    _, rows = size_of([RESULT] * 6, tmp_path)
    assert rows > 1.5 * row


def test_single_motions_are_not_drawn(tmp_path):
    motion = dataclasses.replace(RESULT, motion='turning')
    assert size_of([RESULT, motion], tmp_path) == size_of([RESULT], tmp_path)


def test_lines_that_differ_are_drawn_apart(tmp_path):
    sure = dataclasses.replace(RESULT, within_level=[[0.1] * len(LEVELS)] * len(TIMES))
    for name, result in (('right', RESULT), ('sure', sure)):
        plot_reliability([result], tmp_path / f'{name}.png')
    assert (tmp_path / 'right.png').read_bytes() != (tmp_path / 'sure.png').read_bytes()
