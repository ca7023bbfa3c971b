"""Training of value networks: imitation, value learning, curriculum."""

from socialnav_core.config.reading import read_config
from socialnav_core.training.cards import write_card
from socialnav_core.training.interruption import TrainingInterrupted
from socialnav_core.training.model_card import add_result, write_model_card
from socialnav_core.training.value_learning import train

__all__ = [
    'TrainingInterrupted',
    'add_result',
    'read_config',
    'train',
    'write_card',
    'write_model_card',
]
