"""Scans that cannot be, over the middleware."""

import math

from helpers.graph import open_graph
from helpers.sensing import AHEAD_OF_LASER, Sensing
import pytest
from rcl_interfaces.msg import Log

LIMITS = [
    ({'range_max': 0.0}, 'ranges from 0 to 0 m'),
    ({'range_min': 12.0}, 'ranges from 12 to 10 m'),
    ({'angle_increment': 0.001}, 'do not lead from'),
    ({'angle_max': 0.0}, 'do not lead from'),
    ({'angle_increment': 1.0}, 'more than a turn'),
    ({'angle_min': math.nan}, 'NaN or infinity'),
    ({'ranges': [math.nan] * 340 + [5.0] * 20}, '20 of 360 beams measured anything'),
    ({'ranges': [0.0] * 360}, '0 of 360 beams measured anything'),
    ({'ranges': []}, '0 of 0 beams measured anything'),
]


@pytest.fixture(scope='module')
def sensing():
    """Yield a node that all tests of impossible scans use in turn."""
    with open_graph() as graph:
        yield Sensing(graph)


@pytest.mark.parametrize(('fields', 'reason'), LIMITS, ids=[reason for _, reason in LIMITS])
def test_a_scan_that_cannot_be_is_not_answered_and_the_reason_is_told(sensing, fields, reason):
    sensing.changed()
    sensing.answer()
    sensing.changed(**fields)
    sensing.refuses(reason)
    sensing.lists.clear()
    sensing.robot.during(0.3, scan=AHEAD_OF_LASER)
    assert sensing.lists == []


def test_a_frame_name_of_a_megabyte_is_cut_in_the_log_and_in_diagnostics(sensing):
    sensing.changed()
    sensing.answer()
    log = sensing.graph.listen(Log, '/rosout')
    sensing.changed(header=sensing.robot.header(frame='x' * 10**6))
    words = sensing.refuses('characters more')
    sensing.robot.until(lambda: log, 'log', scan=AHEAD_OF_LASER)
    assert max(len(words), *(len(one.msg) for one in log)) < 1000
