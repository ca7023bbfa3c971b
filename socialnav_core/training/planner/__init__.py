"""Training of the value network at the horizon of the search."""

from socialnav_core.training.planner.learning import train_planner

__all__ = ['train_planner']
