"""What a run reports while it goes on: progress.csv, TensorBoard and a bar."""

from collections.abc import Sequence
import csv
from pathlib import Path
import sys
from typing import Any, TextIO

from socialnav_core.config import TrainingConfig
from socialnav_core.extras import extra, MissingExtra
from socialnav_core.progress import progress_bar
from socialnav_core.storage import named_errors

CSV_NAME = 'progress.csv'
EVENTS = 'events.out.tfevents.*'
"""Files of TensorBoard."""
COLUMNS = (
    'iteration', 'decisions', 'episodes', 'success_rate', 'collision_rate', 'mean_time', 'loss',
    'learning_rate', 'epsilon', 'obstacle_radius', 'decisions_per_second', 'seconds',
    'processor_seconds',
)  # fmt: skip


class Progress:
    """The open reports of a run."""

    def __init__(
        self, folder: Path, config: TrainingConfig, first: int, position: int, visible: bool
    ) -> None:
        """
        Open the reports and drop what they hold of iterations that will be repeated.

        :param first: iterations that are done already.
        :param position: the same in the unit of the length.
        """
        self._unit = 'episodes' if config.episodes else 'iteration'
        self._position = position
        self._file = open_csv(folder / CSV_NAME, first, COLUMNS)
        self._rows = csv.DictWriter(self._file, COLUMNS)
        self._events = folder / EVENTS
        with named_errors(self._events):
            self._board = open_board(folder, first, visible)
        self._bar = progress_bar(config.length, 'value learning', self._unit, position, visible)

    def __enter__(self) -> 'Progress':
        """Return itself; the reports are open already."""
        return self

    def __exit__(self, *error: object) -> None:
        """Close the reports."""
        self._bar.close()
        with named_errors(self._events):
            if self._board is not None:
                self._board.close()
        self._file.close()

    def report(self, row: dict[str, float]) -> None:
        """
        Add the numbers of an iteration.

        :param row: a number for each of COLUMNS.
        """
        with named_errors(self._file.name):
            self._rows.writerow({name: f'{value:.6g}' for name, value in row.items()})
            self._file.flush()
        if self._board is not None:
            with named_errors(self._events):  # of an earlier row: it writes in a thread
                for name in COLUMNS[1:]:
                    self._board.add_scalar(name, row[name], int(row['iteration']))
        self._bar.set_postfix_str(
            f'{row["decisions_per_second"]:.0f} decisions/s, success {row["success_rate"]:.3f}'
        )
        position = int(row[self._unit])
        self._bar.update(position - self._position)
        self._position = position


def open_board(folder: Path, first: int, visible: bool) -> Any:
    """
    Return TensorBoard's events opened for more, or None where TensorBoard is not installed.

    :param first: iterations whose events are kept.
    """
    try:
        with extra('train'):
            from torch.utils.tensorboard import SummaryWriter
    except MissingExtra as error:
        if visible:
            print(f'no curves for TensorBoard, only {CSV_NAME}: {error}', file=sys.stderr)
        return None
    return SummaryWriter(str(folder), purge_step=first + 1 if first else None)


def open_csv(path: Path, first: int, columns: Sequence[str]) -> TextIO:
    """
    Return the report opened for more rows, with a header and those of the first iterations only.

    :param first: iterations whose rows are kept.
    :param columns: names of all columns; the first one counts the iterations.
    """
    rows = []
    if first and path.is_file():
        with path.open(newline='', encoding='utf-8') as file:
            rows = [row for row in csv.DictReader(file) if int(row[columns[0]]) <= first]
    file = path.open('w', newline='', encoding='utf-8')
    writer = csv.DictWriter(file, columns)
    writer.writeheader()
    writer.writerows(rows)
    file.flush()
    return file
