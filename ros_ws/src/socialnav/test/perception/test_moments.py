"""Laws of the times for which detections count."""

import pytest

from socialnav.messages.conversions import ConversionError
from socialnav.perception.moments import Moments
from socialnav.perception.rate import Rate

SECOND = 10**9


class Clocks:
    """Moments with a steady clock that a test sets."""

    def __init__(self):
        self.now = 0.0
        self.moments = Moments(lambda: self.now)

    def take(self, stamp, after=0.1):
        """Take a stamp, s, a time after the one before; return its moment, s, or why not."""
        self.now += after
        try:
            return self.moments.take(int(stamp * SECOND)) / SECOND
        except ConversionError as error:
            return str(error)


def test_stamps_that_go_on_count_as_they_are():
    clocks = Clocks()
    assert [clocks.take(one) for one in (5.0, 5.1, 5.1, 6.5)] == [5.0, 5.1, 5.1, 6.5]


def test_a_detector_that_is_a_little_slower_is_heard_with_the_newest_and_a_late_one_is_not():
    clocks = Clocks()
    clocks.take(5.0)
    assert clocks.take(4.85) == 5.0
    assert clocks.take(4.5) == 'detections 0.50 s older than the newest'


def test_detections_without_a_stamp_are_refused():
    assert Clocks().take(0.0) == 'detections without a stamp'


@pytest.mark.parametrize('step', [-3600.0, 3600.0])
def test_a_clock_that_is_set_once_is_followed(step):
    clocks = Clocks()
    for number in range(5):
        clocks.take(5000.0 + 0.1 * number)
    assert clocks.take(5000.0 + step) == 5000.0 + step
    assert clocks.take(5000.5 + step) == 5000.5 + step


def test_of_two_detectors_whose_clocks_differ_none_is_believed_until_one_of_them_is_alone():
    clocks = Clocks()
    answers = [clocks.take(5000.0 + number / 10 + 3600 * (number % 2)) for number in range(50)]
    assert all('not in step' in str(one) for one in answers[2:])
    alone = [clocks.take(5010.0 + number / 10) for number in range(60)]
    assert 'not in step' in str(alone[1])
    assert alone[-1] == pytest.approx(5015.9)


def test_a_long_pause_is_no_step_of_the_clock():
    clocks = Clocks()
    clocks.take(5.0)
    assert clocks.take(65.0, after=60.0) == 65.0
    assert clocks.take(125.0, after=60.0) == 125.0
    assert clocks.take(125.1) == 125.1


def complaint(interval, coast_time=0.5, count=8):
    rate = Rate()
    for number in range(count):
        rate.take(10.0 + number * interval)
    return rate.complaint(coast_time)


def test_detections_rarer_than_the_coast_time_are_a_complaint_and_others_are_none():
    assert 'every 0.60 s' in complaint(0.6) and 'set coast_time to 1.2' in complaint(0.6)
    assert complaint(0.4) is None
    assert complaint(0.6, coast_time=1.0) is None
    assert complaint(0.6, count=3) is None
