"""A network that predicts people from what they and their neighbours did of late."""

from socialnav_core.prediction.learned.checkpoint import load_predictor
from socialnav_core.prediction.learned.predictor import LearnedPredictor

__all__ = ['LearnedPredictor', 'load_predictor']
