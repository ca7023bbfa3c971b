"""Settings that change while a run goes on, as functions of its progress."""

from socialnav_core.config import TrainingConfig


def learning_rate(config: TrainingConfig, iteration: int) -> float:
    """
    Return the learning rate: constant up to decay_start, then falling exponentially.

    :param config: start, end and the share of the run with the first.
    :param iteration: 0 ... iterations - 1.
    """
    begin = config.decay_start * config.iterations
    share = max(0.0, iteration - begin) / max(config.iterations - 1 - begin, 1)
    return exponential(config.learning_rate, config.final_learning_rate, share)


def epsilon(config: TrainingConfig, iteration: int) -> float:
    """
    Return the share of random actions: falling linearly, then constant.

    :param config: start, end and the share of the run after which the end is reached.
    :param iteration: 0 ... iterations - 1.
    """
    share = min(1.0, iteration / max(config.epsilon_share * config.iterations, 1))
    return config.epsilon_start + share * (config.epsilon_end - config.epsilon_start)


def exponential(start: float, end: float, share: float) -> float:
    """
    Return the point of an exponential curve.

    :param start: its value at share 0.
    :param end: its value at share 1, also later.
    :param share: of the way.
    """
    return start * (end / start) ** min(share, 1.0)
