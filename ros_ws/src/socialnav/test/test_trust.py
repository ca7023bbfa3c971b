"""The measurements of `benchmarks/ros` as tests: each fails where what it finds is too much."""

from pathlib import Path
import re
import subprocess
import sys

from helpers import stops
import pytest

BENCHMARKS = Path(__file__).resolve().parents[4] / 'benchmarks' / 'ros'


def measure(name, *options, longest=120):
    """Run a measurement; it must find everything as it should be."""
    command = [sys.executable, str(BENCHMARKS / f'{name}.py'), *map(str, options)]
    result = subprocess.run(command, capture_output=True, text=True, timeout=longest, check=False)
    print(result.stdout)
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


@pytest.mark.parametrize(
    'repetitions',
    [1, pytest.param(100, marks=[pytest.mark.slow, pytest.mark.timeout(1800)])],
)
def test_a_robot_stops_within_the_timeout_and_a_period_after_its_last_input(repetitions):
    table = measure('stop_times', '--repetitions', repetitions, longest=1800)
    rows = re.findall(rf'^\| [^|]+ \| {repetitions} \|', table, re.MULTILINE)
    assert len(rows) == 4
    stops.measured.append(table.strip())


@pytest.mark.parametrize(
    ('minutes', 'missed'),
    [
        (0.25, 0.2),  # so few periods are soon missed on a busy machine
        pytest.param(30, 0.01, marks=[pytest.mark.slow, pytest.mark.timeout(2400)]),
    ],
)
def test_a_robot_drives_for_long_without_missing_periods_or_using_more_memory(minutes, missed):
    options = ('--minutes', minutes, '--missed', missed)
    assert 'memory' in measure('soak', *options, longest=2400)


@pytest.mark.slow
def test_latencies_are_measured_for_every_size_of_a_crowd():
    text = measure('latency', '--seconds', 10, longest=280)
    assert [line.split('|')[1].strip() for line in text.splitlines() if ' ms |' in line] == [
        '5', '10', '30',
    ]  # fmt: skip
