"""Where people will be: one protocol, and its members by name."""

from collections.abc import Callable

from socialnav_core.config import require_choice
from socialnav_core.prediction.constant_velocity import ConstantVelocity
from socialnav_core.prediction.oracle import Oracle
from socialnav_core.prediction.protocol import Prediction, Predictor


def shipped_prediction() -> Predictor:
    """
    Return the learned prediction that ships, without history.

    :raises CheckpointError: when its files are missing or damaged.
    """
    from socialnav_core.prediction.learned import load_predictor  # compiles, which others need not

    return load_predictor()


PREDICTIONS: dict[str, Callable[[], Predictor]] = {
    'constant_velocity': ConstantVelocity,
    'learned': shipped_prediction,
    'oracle': Oracle,
}
"""What makes each prediction that a look-ahead can be given by name."""


def make_predictor(name: str) -> Predictor:
    """
    Return a predictor without history.

    :raises ConfigError: for a name that is not in PREDICTIONS.
    """
    require_choice('lookahead', name, tuple(PREDICTIONS))
    return PREDICTIONS[name]()


def knowledge_of(name: str) -> str:
    """Return what a prediction knows, as `Predictor.knowledge` says; see `make_predictor`."""
    return make_predictor(name).knowledge


__all__ = [
    'PREDICTIONS',
    'ConstantVelocity',
    'Oracle',
    'Prediction',
    'Predictor',
    'knowledge_of',
    'make_predictor',
]
