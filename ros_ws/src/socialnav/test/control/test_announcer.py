"""Laws of what the log is told."""

import pytest

from socialnav.control.announcer import Announcer


class Log:
    """What was said, and a clock."""

    def __init__(self):
        self.lines, self.now = [], 100.0
        self.announcer = Announcer(self.lines.append, lambda: self.now)

    def tell(self, *texts, **options):
        """Say texts, a tenth of a second each."""
        for text in texts:
            self.announcer.tell(text, **options)
            self.now += 0.1


@pytest.fixture
def log():
    return Log()


def test_a_text_is_said_once_as_long_as_it_is_true(log):
    log.tell(*['no odom'] * 100)
    assert log.lines == ['no odom']


def test_what_becomes_true_within_the_pause_is_said_after_it(log):
    log.tell('no odom', *['odom from the future'] * 20)
    assert log.lines == ['no odom', 'odom from the future']


def test_what_was_true_for_a_moment_only_is_not_said_later(log):
    log.tell('no odom', 'no goal_pose', *['no odom'] * 20)
    assert log.lines == ['no odom']


def test_however_often_the_truth_changes_it_is_one_line_a_second_and_the_last_is_true(log):
    log.tell(*(f'reason {number % 7}' for number in range(100)), *['the truth'] * 20)
    assert len(log.lines) <= 13 and log.lines[-1] == 'the truth'


def test_that_all_is_well_is_said_only_after_something_was_wrong(log):
    log.tell(*['driving'] * 20, aloud=False)
    assert log.lines == []
    log.tell(*['no odom'] * 20)
    log.tell(*['driving'] * 20, aloud=False)
    assert log.lines == ['no odom', 'driving']
