"""Laws of the card of a learned prediction."""

from socialnav_core.training.prediction.model_card import limits


def result(crowd, error, noise=False):
    """Return a result whose constant velocity errs by half a metre after 3 s."""
    return {'crowd': crowd, 'noise': noise, 'error': [0.1, error], 'constant_velocity': [0.1, 0.5]}


def test_the_card_names_the_crowds_that_constant_velocity_predicts_better():
    text = limits([result('better', 0.4), result('worse', 0.6), result('noisy', 0.9, noise=True)])
    assert 'worse (+20%)' in text
    assert 'better (' not in text and 'noisy (' not in text


def test_the_card_says_nothing_where_there_is_none():
    assert 'Constant velocity' not in limits([result('better', 0.4)])
