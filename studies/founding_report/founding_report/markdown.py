"""Numbers and tables as Markdown."""

from decimal import Decimal, ROUND_HALF_UP

from socialnav_core.evaluation.statistics import Estimate
from socialnav_core.metrics import METRICS
from socialnav_core.tables import NOTHING

LOOKAHEAD_LABELS = {'oracle': 'oracle', 'constant_velocity': 'constant velocity'}
DIGITS = {'time': METRICS['navigation_time_mean'].digits}
"""Digits after the point; 3 for rates."""


def number(value: float | None, figure: str) -> str:
    """
    Return a number, halves rounded up, a dash for None.

    :param figure: what it is, which says how many digits it has.
    """
    if value is None:
        return NOTHING
    last_digit = Decimal(1).scaleb(-DIGITS.get(figure, 3))
    # Of the decimal number that people read: the double 13.645 is a little less than that.
    return str(Decimal(repr(float(value))).quantize(last_digit, ROUND_HALF_UP))


def estimate_text(estimate: Estimate | None, figure: str, sign: str = '') -> str:
    """
    Return a mean with its interval, a dash for None.

    :param figure: what it is, which says how many digits it has.
    :param sign: + where differences get a sign.
    """
    if estimate is None:
        return NOTHING
    form = f'{sign}.{DIGITS.get(figure, 3)}f'
    return f'{estimate.mean:{form}} [{estimate.low:{form}}, {estimate.high:{form}}]'


def p_value(value: float) -> str:
    """Return a probability with two significant digits."""
    return f'{value:.2g}'
