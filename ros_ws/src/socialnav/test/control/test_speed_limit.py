"""Laws of limits of speed that others set."""

import dataclasses
import math

from helpers.controllers import SETTINGS
import pytest

from socialnav.control.speed_limit import complaint, limited, NO_LIMIT, SpeedLimit

FAST = dataclasses.replace(SETTINGS, max_speed=2.0, preferred_speed=1.0)


@pytest.mark.parametrize(
    ('limit', 'speeds'),
    [
        (NO_LIMIT, (2.0, 1.0)),
        (SpeedLimit(0.0, percentage=True), (2.0, 1.0)),
        (SpeedLimit(1.5), (1.5, 1.0)),
        (SpeedLimit(0.4), (0.4, 0.4)),
        (SpeedLimit(9.0), (2.0, 1.0)),
        (SpeedLimit(25.0, percentage=True), (0.5, 0.5)),
        (SpeedLimit(150.0, percentage=True), (2.0, 1.0)),
        (SpeedLimit(1e-9), (1e-3, 1e-3)),
    ],
)
def test_a_limit_bounds_what_is_driven_and_what_is_preferred(limit, speeds):
    settings = limited(FAST, limit)
    assert (settings.max_speed, settings.preferred_speed) == speeds


@pytest.mark.parametrize('value', [-0.1, math.nan, math.inf])
def test_what_is_no_speed_is_complained_of(value):
    assert complaint(SpeedLimit(value)) and complaint(SpeedLimit(1.0)) is None
