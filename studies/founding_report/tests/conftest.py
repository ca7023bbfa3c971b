"""Runs that were not trained but look so, with measurements that were made up."""

import json

import numpy as np
import pytest

from founding_report import measurements
from founding_report.laboratory import Laboratory
from socialnav_core.evaluation.statistics import wilson_interval
from socialnav_core.policies.value.checkpoint import build_network, save_weights
from socialnav_core.training.model_card import CARD_NAME
from socialnav_core.training.progress import COLUMNS, CSV_NAME


@pytest.fixture
def laboratory(tmp_path):
    """Return a laboratory in an empty folder."""
    return Laboratory(tmp_path / 'reproduce', announce=lambda line: None)


@pytest.fixture
def finished_run(laboratory):
    """Return a function that leaves a run of a row and seed as training does."""

    def make(row, seed, minutes=2.0):
        folder = laboratory.run(row, seed)
        config = row.resolved(seed, quick=False)
        save_weights(folder, build_network(config.policy), config)
        (folder / CARD_NAME).write_text('# card\n')
        values = dict.fromkeys(COLUMNS, 0) | {'seconds': 60 * minutes, 'episodes': 4000}
        rows = [','.join(COLUMNS), ','.join(str(values[name]) for name in COLUMNS)]
        (folder / CSV_NAME).write_text('\n'.join(rows) + '\n')
        return folder

    return make


@pytest.fixture
def measured():
    """Return a function that leaves a measurement of a run as `socialnav evaluate` does."""

    def make(folder, cases, outcomes, time=10.0):
        raw = measurements.raw_path(folder, cases)
        raw.parent.mkdir(parents=True, exist_ok=True)
        success = np.array([outcome == 'goal' for outcome in outcomes])
        summary = {
            'model': 'made up', 'scenario': cases.scenario, 'seed': 0, 'split': cases.split,
            'episodes': len(outcomes), 'lookahead': cases.lookahead, 'screening': False,
            'success_interval': list(wilson_interval(int(success.sum()), len(outcomes))),
            'success_rate': float(success.mean()), 'collision_rate': 0.0, 'timeout_rate': 0.0,
            'navigation_time_mean': time,
            'cases': [{'outcome': outcome, 'time': time} for outcome in outcomes],
        }  # fmt: skip
        raw.write_text(json.dumps(summary))
        measurements.keep(folder, cases)

    return make
