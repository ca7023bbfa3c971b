"""Laws of the grids on the page: what socialnav grid wrote is what is shown."""

import json

import pytest

from socialnav_core import cli
from socialnav_core.config import ConfigError
from socialnav_core.config.reading import read_grid_config
from socialnav_core.viewing.report.grids import read_grid


@pytest.fixture(scope='module')
def written(tmp_path_factory):
    out = tmp_path_factory.mktemp('grid')
    words = ['grid', 'straight_line', '--quick', '--episodes', '2', '--out', str(out)]
    assert cli.main(words) == 0
    return out / 'straight_line.json'


def test_a_grid_is_read_as_it_was_run(written):
    grid = read_grid(written)
    quick = read_grid_config('quick')
    assert grid.model == 'straight_line'
    assert (grid.config.tables, grid.config.bound) == (quick.tables, quick.bound)
    assert grid.picture.startswith('data:image/png;base64,')
    assert len(grid.tables['crowd']) == 1 + 4


@pytest.mark.parametrize('text', ['', '[]', '{}', '{"model": 3, "grid": {}, "cells": []}'])
def test_another_file_is_refused(text, tmp_path):
    file = tmp_path / 'other.json'
    file.write_text(text)
    with pytest.raises(ConfigError, match='holds no grid'):
        read_grid(file)


def test_an_unfinished_grid_says_how_to_finish_it(written, tmp_path):
    values = json.loads(written.read_text())
    values['cells'].pop()
    file = tmp_path / 'part.json'
    file.write_text(json.dumps(values))
    with pytest.raises(ConfigError, match='5 of 6 worlds: finish it by socialnav grid'):
        read_grid(file)
