"""Trains and measures what is missing, several processes side by side."""

from collections.abc import Callable, Iterable, Sequence
import dataclasses
from pathlib import Path

from socialnav_core.config import ConfigError
from socialnav_core.reproduction import measurements, runs
from socialnav_core.reproduction.jobs import Job, run_jobs
from socialnav_core.reproduction.measurements import Cases, Measurement
from socialnav_core.reproduction.rows import Row

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

    @property
    def episodes(self) -> int:
        """Return the number of test cases of a table."""
        return QUICK_EPISODES if self.quick else 500

    def run(self, row: Row, seed: int) -> Path:
        """
        Return the folder of a run.

        :param row: what is trained.
        :param seed: of the run.
        """
        return self.folder / 'runs' / row.name / f'seed-{seed}'

    def provide(self, requests: Iterable[Request], train: bool = True) -> None:
        """
        Train and measure what is missing.

        :param requests: the first ones begin first.
        :param train: whether runs may be trained; otherwise all must be.
        :raises ConfigError: when a run has other settings than its row, or may not be trained.
        :raises JobError: when a process fails.
        """
        requests = merged(requests)
        for request in requests:
            folder = self.run(request.row, request.seed)
            if runs.is_finished(folder):
                runs.require_same_settings(request.row, request.seed, folder, self.quick)
            elif not train:
                raise ConfigError(f'{folder} is not trained; leave --no-train out')
        run_jobs([self._job(request) for request in requests], self.jobs, self.announce)

    def measurement(self, row: Row, seed: int, cases: Cases) -> Measurement:
        """
        Return a measurement that was provided.

        :param row: what was trained.
        :param seed: of the run.
        :param cases: which ones.
        """
        measurement = measurements.load(self.run(row, seed), cases)
        if measurement is None:
            raise ConfigError(f'{self.run(row, seed)} was not measured in {cases.name}')
        return measurement

    def _job(self, request: Request) -> Job:
        """Return the job that trains a run and then has it measured."""
        row, seed, folder = request.row, request.seed, self.run(request.row, request.seed)
        return Job(
            label=f'{row.name} seed {seed} trained',
            arguments=lambda: runs.train_arguments(row, seed, folder, self.quick, self.device),
            log=self.folder / 'logs' / f'{row.name}-{seed}.log',
            needed=lambda: not runs.is_finished(folder),
            finish=lambda seconds: runs.note_machine(folder, self.device, self.jobs),
            followers=tuple(self._measuring(request, cases) for cases in request.cases),
        )

    def _measuring(self, request: Request, cases: Cases) -> Job:
        """Return the job that measures a trained run."""
        name, folder = f'{request.row.name}-{request.seed}', self.run(request.row, request.seed)
        return Job(
            label=f'{request.row.name} seed {request.seed} measured in {cases.name}',
            arguments=lambda: measurements.evaluate_arguments(folder, cases),
            log=self.folder / 'logs' / f'{name}-{cases.name}.log',
            needed=lambda: measurements.load(folder, cases) is None,
            finish=lambda seconds: measurements.keep(folder, cases),
        )


def merged(requests: Iterable[Request]) -> Sequence[Request]:
    """
    Return requests with those of the same run made one, lower seeds first.

    :param requests: in any order.
    """
    cases: dict[tuple[str, int], dict[Cases, None]] = {}
    rows: dict[str, Row] = {}
    for request in requests:
        rows[request.row.name] = request.row
        cases.setdefault((request.row.name, request.seed), {}).update(dict.fromkeys(request.cases))
    found = [Request(rows[name], seed, tuple(which)) for (name, seed), which in cases.items()]
    return sorted(found, key=lambda request: request.seed)
