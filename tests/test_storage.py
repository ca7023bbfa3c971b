"""Laws of files that are written whole or not at all."""

import pytest

from socialnav_core.storage import atomic_write, written_whole


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
