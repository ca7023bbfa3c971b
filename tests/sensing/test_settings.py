"""Laws of the settings of what a robot senses, and of what it can do."""

import dataclasses
import math

import pytest

from socialnav_core.config import ConfigError
from socialnav_core.config.ranges import hints_of, rules_of
from socialnav_core.sensing import (
    DetectorSettings,
    Readings,
    ScannerSettings,
    SurfaceSettings,
    TrackerSettings,
)
from socialnav_core.simulation.kinematics import Limits

SETTINGS = [
    ScannerSettings(), DetectorSettings(), SurfaceSettings(), TrackerSettings(), Readings(),
    Limits(1.0, 1.0, 1.0, 0.1),
]  # fmt: skip


@pytest.mark.parametrize('settings', SETTINGS, ids=lambda one: type(one).__name__)
def test_every_setting_has_a_rule_and_nonsense_is_refused_by_its_name(settings):
    kind = type(settings)
    for name, hint in hints_of(kind).items():
        if hint is bool:
            continue
        assert name in rules_of(kind)
        for value in (math.nan, -math.inf, -1, 'much', None):
            with pytest.raises(ConfigError, match=name):
                dataclasses.replace(settings, **{name: value})
