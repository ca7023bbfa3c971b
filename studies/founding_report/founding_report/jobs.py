"""Commands of `socialnav` as processes side by side, each with what follows it."""

from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
import dataclasses
import os
from pathlib import Path
import subprocess
import sys
import threading
import time

from socialnav_core.commands.arguments import CommandFailure
from socialnav_core.termination import terminated_like_interrupted

PROGRAM = (sys.executable, '-m', 'socialnav_core.cli')
ENVIRONMENT = {
    'OMP_NUM_THREADS': '1',
    'MALLOC_MMAP_THRESHOLD_': '1073741824',
    'MALLOC_TRIM_THRESHOLD_': '4294967296',
    'MALLOC_TOP_PAD_': '268435456',
}
"""One thread a process; glibc keeps freed memory, which halves the time of large batches."""

STOP_SECONDS = 60.0
"""How long a process may take to save itself when it is told to stop, s."""


class JobError(CommandFailure):
    """Processes that failed; its text names their logs."""


@dataclasses.dataclass(frozen=True)
class Job:
    """A command that is run if it is needed when its turn comes, and the jobs after it."""

    label: str
    """What is done, for the line that says that it is done."""
    arguments: Callable[[], list[str]]
    """Returns the arguments of socialnav."""
    log: Path
    """File for everything that it says."""
    needed: Callable[[], bool]
    """Returns whether it is still to be done."""
    finish: Callable[[float], None]
    """Is called with the seconds that the process took, when it succeeded."""
    followers: tuple['Job', ...] = ()
    """Jobs that can begin when it is done."""


class Processes:
    """The processes that run now, so that they can be told to stop."""

    def __init__(self) -> None:
        """Run nothing yet."""
        self.stopping = False
        self._lock = threading.Lock()
        self._running: set[subprocess.Popen[bytes]] = set()

    def run(self, job: Job) -> float:
        """
        Run a job and return the seconds that it took; zero where it was not needed.

        :raises JobError: when its process fails.
        """
        if not job.needed():
            return 0.0
        started = time.perf_counter()
        job.log.parent.mkdir(parents=True, exist_ok=True)
        with job.log.open('ab') as log:
            process = self._start([*PROGRAM, *job.arguments()], log)
            code = process.wait()
        with self._lock:
            self._running.discard(process)
        if code:
            raise JobError(f'{job.label} failed, see {job.log}: {last_line(job.log)}')
        seconds = time.perf_counter() - started
        job.finish(seconds)
        return seconds

    def stop(self) -> None:
        """Tell all processes to save themselves and to end, and wait for that."""
        with self._lock:
            self.stopping = True
            running = list(self._running)
        for process in running:
            process.terminate()
        for process in running:
            try:
                process.wait(STOP_SECONDS)
            except subprocess.TimeoutExpired:
                process.kill()

    def _start(self, command: list[str], log: object) -> 'subprocess.Popen[bytes]':
        """Return a new process, out of reach of the terminal's Ctrl-C: it is told to stop once."""
        with self._lock:
            if self.stopping:
                raise JobError('stopped before it began')
            process = subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=log, stderr=log,  # type: ignore[call-overload]
                env=os.environ | ENVIRONMENT, start_new_session=True,
            )  # fmt: skip
            self._running.add(process)
            return process


def run_jobs(jobs: Sequence[Job], side_by_side: int, announce: Callable[[str], None]) -> None:
    """
    Run jobs and all that follows them; one that fails stops only its followers.

    :param jobs: in the order in which they begin.
    :param side_by_side: processes at once.
    :param announce: is told in one line what is done.
    :raises JobError: after all others are done, when some failed.
    """
    processes = Processes()
    failures: list[str] = []
    pool = ThreadPoolExecutor(side_by_side)
    try:
        with terminated_like_interrupted():
            waiting = {pool.submit(processes.run, job): job for job in jobs}
            while waiting:
                for future in wait(waiting, return_when=FIRST_COMPLETED).done:
                    job = waiting.pop(future)
                    if succeeded(future, job, failures, announce):
                        waiting |= {pool.submit(processes.run, job): job for job in job.followers}
    except BaseException:
        pool.shutdown(wait=False, cancel_futures=True)
        processes.stop()
        raise
    pool.shutdown()
    if failures:
        raise JobError('; '.join(failures))


def succeeded(
    future: 'Future[float]', job: Job, failures: list[str], announce: Callable[[str], None]
) -> bool:
    """
    Return whether a job succeeded, and say so.

    :param failures: gets a line when it failed.
    """
    try:
        seconds = future.result()
    except (JobError, OSError, ValueError) as error:
        failures.append(str(error))
        announce(str(error))
        return False
    if seconds:
        announce(f'{job.label}: {seconds:.0f} s')
    return True


def last_line(log: Path) -> str:
    """Return the last line that a process wrote into its log."""
    lines = log.read_text(encoding='utf-8', errors='replace').strip().splitlines()
    return lines[-1] if lines else 'it said nothing'
