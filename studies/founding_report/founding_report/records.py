"""
What trained runs did, without their weights: small enough to be kept beside the pages.

A record lets a page be written again, or a further row or seed be added to it, without training
anything that was trained before.
"""

import dataclasses
import json
from pathlib import Path
from typing import Any

import yaml

from founding_report import measurements, runs
from founding_report.measurements import Cases, Measurement
from socialnav_core.config import Config, ConfigError
from socialnav_core.config.mapping import from_mapping, to_yaml
from socialnav_core.policies.value.checkpoint import load_checkpoint
from socialnav_core.storage import atomic_write

FOLDER = 'records'


@dataclasses.dataclass(frozen=True)
class Record:
    """A run that was trained and measured, here or elsewhere."""

    config: Config
    """All settings of the run."""
    training: runs.Training
    """How it went."""
    measured: dict[str, Any]
    """Contents of the files of measurements, by the names of the cases."""

    def covers(self, wanted: tuple[Cases, ...]) -> bool:
        """Return whether the run was measured in all of some cases."""
        return all(cases.name in self.measured for cases in wanted)

    def measurement(self, cases: Cases) -> Measurement | None:
        """Return a measurement, None where there is none."""
        values = self.measured.get(cases.name)
        return None if values is None else measurements.from_values(cases, values)


def write_record(path: Path, run: Path, wanted: tuple[Cases, ...]) -> None:
    """
    Write the record of a run; what an earlier one of the same weights has more of is kept.

    :param wanted: cases that it was measured in.
    """
    training = runs.training_of(run)
    found = {cases.name: measurements.values_of(run, cases) for cases in wanted}
    measured = {name: values for name, values in found.items() if values is not None}
    if path.is_file():
        earlier = load_record(path)
        if earlier.training.weights == training.weights:
            measured = earlier.measured | measured
    values = {
        'config': to_yaml(load_checkpoint(run)[1]),
        'training': dataclasses.asdict(training),
        'measured': dict(sorted(measured.items())),
    }
    path.parent.mkdir(parents=True, exist_ok=True)
    atomic_write(path, f'{json.dumps(values, separators=(",", ":"))}\n'.encode())


def load_record(path: Path) -> Record:
    """
    Return the record of a run.

    :raises ConfigError: when the file holds no record.
    """
    try:
        values = json.loads(path.read_text(encoding='utf-8'))
        training = runs.Training(**values['training'])
        config = from_mapping(Config, yaml.safe_load(values['config']))
        return Record(config, training, values['measured'])
    except (OSError, ValueError, KeyError, TypeError, yaml.YAMLError) as error:
        raise ConfigError(f'{path} holds no record of a run ({error}); remove it') from error
