"""Laws of what a run reports while it goes on."""

import errno

import pytest

from socialnav_core.config import TrainingConfig
from socialnav_core.training.progress import COLUMNS, Progress


class FullDisk:
    """A board whose thread found no room, as TensorBoard's tells it."""

    def add_scalar(self, *_):
        raise OSError(errno.ENOSPC, 'No space left on device')

    close = add_scalar


def test_a_full_disk_under_the_events_of_tensorboard_is_named_by_their_files(tmp_path):
    progress = Progress(tmp_path, TrainingConfig(), 0, 0, visible=False)
    progress._board = FullDisk()
    for write in (lambda: progress.report(dict.fromkeys(COLUMNS, 1.0)), progress.__exit__):
        with pytest.raises(OSError, match='No space left') as error:
            write()
        assert error.value.filename == str(tmp_path / 'events.out.tfevents.*')
