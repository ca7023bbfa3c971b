"""Laws of run folders."""

import pytest

from socialnav_core.config import ConfigError
from socialnav_core.training.folder import prepare_folder


def test_missing_folder_is_made_with_its_parents(tmp_path):
    prepare_folder(tmp_path / 'a' / 'b', resume=False, overwrite=False)
    assert (tmp_path / 'a' / 'b').is_dir()


def test_folder_with_a_run_is_refused(tmp_path):
    (tmp_path / 'weights.safetensors').write_bytes(b'run')
    with pytest.raises(ConfigError, match='--overwrite'):
        prepare_folder(tmp_path, resume=False, overwrite=False)
    assert (tmp_path / 'weights.safetensors').read_bytes() == b'run'


def test_overwriting_removes_the_run_and_nothing_else(tmp_path):
    for name in ('weights.safetensors', 'progress.csv', 'notes.txt'):
        (tmp_path / name).write_text('text')
    prepare_folder(tmp_path, resume=False, overwrite=True)
    assert [path.name for path in tmp_path.iterdir()] == ['notes.txt']


def test_folder_without_a_run_is_never_overwritten(tmp_path):
    (tmp_path / 'README.md').write_text('of something else')
    with pytest.raises(ConfigError, match='no run'):
        prepare_folder(tmp_path, resume=False, overwrite=True)
    assert (tmp_path / 'README.md').exists()


def test_resuming_removes_what_a_killed_write_left(tmp_path):
    (tmp_path / '.training_state.safetensors.123').write_text('half')
    (tmp_path / 'training_state.safetensors').write_text('whole')
    prepare_folder(tmp_path, resume=True, overwrite=False)
    assert [path.name for path in tmp_path.iterdir()] == ['training_state.safetensors']


def test_file_in_the_place_of_the_folder_is_refused(tmp_path):
    (tmp_path / 'out').write_text('text')
    with pytest.raises(ConfigError, match='cannot be used'):
        prepare_folder(tmp_path / 'out', resume=False, overwrite=False)
