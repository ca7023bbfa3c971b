"""Trains and measures what is missing, several processes side by side."""

from collections.abc import Callable, Iterable, Sequence
import dataclasses
from pathlib import Path

from founding_report import measurements, runs
from founding_report.jobs import Job, run_jobs
from founding_report.measurements import Cases, Measurement
from founding_report.records import load_record, Record, write_record
from founding_report.rows import Row
from socialnav_core.config import ConfigError
from socialnav_core.policies.value.checkpoint import load_checkpoint

QUICK_EPISODES = 20


@dataclasses.dataclass(frozen=True)
class Request:
    """A run and the cases that it is to be measured in."""

    row: Row
    seed: int
    cases: tuple[Cases, ...]


@dataclasses.dataclass(frozen=True)
class Laboratory:
    """Where runs are kept and how they are made."""

    folder: Path
    """Holds runs/ROW/seed-N and logs/."""
    jobs: int = 1
    """Processes side by side."""
    device: str = 'cpu'
    """Where networks are trained: cpu or cuda."""
    quick: bool = False
    """Whether runs take seconds and learn nothing."""
    announce: Callable[[str], None] = print
    """Is told in one line what is done."""
    records: Path | None = None
    """Folder of records that stand for runs that are not here; None: there are none."""

    @property
    def episodes(self) -> int:
        """Return the number of test cases of a table."""
        return QUICK_EPISODES if self.quick else 500

    def run(self, row: Row, seed: int) -> Path:
        """Return the folder of a run."""
        return self.folder / 'runs' / row.run_name / f'seed-{seed}'

    def record(self, row: Row, seed: int) -> Record | None:
        """
        Return the record of a run that is not here, None where there is none.

        :raises ConfigError: when it has other settings than the row.
        """
        if self.records is None or runs.is_finished(self.run(row, seed)):
            return None
        path = record_path(self.records, row, seed)
        if not path.is_file():
            return None
        record = load_record(path)
        runs.require_same_settings(row, seed, record.config, self.quick, path)
        return record

    def training(self, row: Row, seed: int) -> runs.Training:
        """Return how a run went."""
        record = self.record(row, seed)
        return record.training if record else runs.training_of(self.run(row, seed))

    def provide(self, requests: Iterable[Request], train: bool = True) -> None:
        """
        Train and measure what is missing.

        :param requests: the first ones begin first.
        :param train: whether runs may be trained; otherwise all must be.
        :raises ConfigError: when a run has other settings than its row, or may not be trained.
        :raises JobError: when a process fails.
        """
        missing = [each for each in merged(requests) if not self._is_recorded(each)]
        for request in missing:
            folder = self.run(request.row, request.seed)
            if runs.is_finished(folder):
                found = load_checkpoint(folder)[1]
                runs.require_same_settings(request.row, request.seed, found, self.quick, folder)
            elif not train:
                raise ConfigError(f'{folder} is not trained; leave --no-train out')
        run_jobs([self._job(request) for request in missing], self.jobs, self.announce)

    def publish(self, request: Request, folder: Path) -> None:
        """Write the record of a run that is here into a folder of records."""
        run = self.run(request.row, request.seed)
        if runs.is_finished(run):
            write_record(record_path(folder, request.row, request.seed), run, request.cases)

    def _is_recorded(self, request: Request) -> bool:
        """Return whether a record stands for a run that is not here."""
        record = self.record(request.row, request.seed)
        return record is not None and record.covers(request.cases)

    def measurement(self, row: Row, seed: int, cases: Cases) -> Measurement:
        """Return a measurement that was provided."""
        record = self.record(row, seed)
        measurement = (
            record.measurement(cases) if record else measurements.load(self.run(row, seed), cases)
        )
        if measurement is None:
            raise ConfigError(f'{self.run(row, seed)} was not measured in {cases.name}')
        return measurement

    def _job(self, request: Request) -> Job:
        """Return the job that trains a run and then has it measured."""
        row, seed, folder = request.row, request.seed, self.run(request.row, request.seed)
        return Job(
            label=f'{row.run_name} seed {seed} trained',
            arguments=lambda: runs.train_arguments(row, seed, folder, self.quick, self.device),
            log=self.folder / 'logs' / f'{row.run_name}-{seed}.log',
            needed=lambda: not runs.is_finished(folder),
            finish=lambda seconds: runs.note_machine(folder, self.device, self.jobs),
            followers=tuple(self._measuring(request, cases) for cases in request.cases),
        )

    def _measuring(self, request: Request, cases: Cases) -> Job:
        """Return the job that measures a trained run."""
        name = request.row.run_name
        folder = self.run(request.row, request.seed)
        return Job(
            label=f'{name} seed {request.seed} measured in {cases.name}',
            arguments=lambda: measurements.evaluate_arguments(folder, cases),
            log=self.folder / 'logs' / f'{name}-{request.seed}-{cases.name}.log',
            needed=lambda: measurements.load(folder, cases) is None,
            finish=lambda seconds: measurements.keep(folder, cases),
        )


def merged(requests: Iterable[Request]) -> Sequence[Request]:
    """Return requests with those of the same run made one, lower seeds first."""
    cases: dict[tuple[str, int], dict[Cases, None]] = {}
    rows: dict[str, Row] = {}
    for request in requests:
        rows[request.row.run_name] = request.row
        cases.setdefault((request.row.run_name, request.seed), {}).update(
            dict.fromkeys(request.cases)
        )
    found = [Request(rows[name], seed, tuple(which)) for (name, seed), which in cases.items()]
    return sorted(found, key=lambda request: request.seed)


def record_path(folder: Path, row: Row, seed: int) -> Path:
    """Return the file of a record in a folder of records."""
    return folder / f'{row.run_name}-{seed}.json'
