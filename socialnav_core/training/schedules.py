"""Settings that change while a run goes on, as functions of its progress."""

from socialnav_core.config import TrainingConfig


def learning_rate(config: TrainingConfig, position: int) -> float:
    """
    Return the learning rate: constant up to decay_start, then falling exponentially.

    :param position: iterations or episodes done, in the unit of the run's length.
    """
    begin = config.decay_start * config.length
    share = max(0.0, position - begin) / max(config.length - 1 - begin, 1)
    return exponential(config.learning_rate, config.final_learning_rate, share)


def epsilon(config: TrainingConfig, position: int) -> float:
    """
    Return the share of random actions: falling linearly, then constant.

    :param position: iterations or episodes done, in the unit of the run's length.
    """
    share = min(1.0, position / max(config.epsilon_share * config.length, 1))
    return config.epsilon_start + share * (config.epsilon_end - config.epsilon_start)


def exponential(start: float, end: float, share: float) -> float:
    """
    Return the point of an exponential curve.

    :param start: its value at share 0.
    :param end: its value at share 1, also later.
    """
    return start * (end / start) ** min(share, 1.0)
