"""Laws of files that are written whole or not at all."""

import errno

import numpy as np
import pytest
from safetensors import safe_open
from safetensors.numpy import save

from socialnav_core.storage import atomic_write, canonical, written_whole


def test_a_write_that_fails_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / 'file'
    atomic_write(path, b'old')
    monkeypatch.setattr('os.fsync', lambda _: (_ for _ in ()).throw(OSError('disk full')))
    with pytest.raises(OSError, match='disk full'):
        atomic_write(path, b'new')
    assert path.read_bytes() == b'old' and [p.name for p in tmp_path.iterdir()] == ['file']


def test_a_file_is_replaced_when_the_new_one_is_complete_and_not_before(tmp_path):
    path = tmp_path / 'picture.png'
    with written_whole(path) as temporary:
        temporary.write_text('old')
    with pytest.raises(OSError), written_whole(path) as temporary:
        temporary.write_text('ne')
        raise OSError('no space left')
    assert path.read_text() == 'old'
    assert list(tmp_path.iterdir()) == [path]
    assert temporary.suffix == path.suffix


def test_an_error_of_a_full_disk_names_the_file(tmp_path, monkeypatch):
    full = OSError(errno.ENOSPC, 'No space left on device')
    monkeypatch.setattr('os.fsync', lambda _: (_ for _ in ()).throw(full))
    with pytest.raises(OSError, match='No space left on device.*result.json'):
        atomic_write(tmp_path / 'result.json', b'new')


def test_an_error_about_another_file_keeps_its_name(tmp_path):
    with pytest.raises(FileNotFoundError, match='missing'), written_whole(tmp_path / 'new'):
        (tmp_path / 'missing').read_text()


def test_a_header_is_written_in_one_order(tmp_path):
    arrays = {'b': np.arange(3.0), 'a': np.ones((2, 2), np.float32)}
    metadata = {str(number): 'x' for number in range(20)}
    files = {canonical(save(arrays, metadata)) for _ in range(10)}
    assert len(files) == 1
    (tmp_path / 'file').write_bytes(files.pop())
    with safe_open(tmp_path / 'file', 'numpy') as file:
        assert file.metadata() == metadata
        assert all(np.array_equal(file.get_tensor(name), arrays[name]) for name in arrays)
