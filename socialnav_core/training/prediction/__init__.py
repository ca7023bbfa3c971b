"""Training of the learned prediction on mixed crowds."""

from socialnav_core.training.prediction.learning import train_prediction

__all__ = ['train_prediction']
