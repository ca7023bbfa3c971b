"""Measuring policies on given cases, and comparing them."""

from socialnav_core.evaluation.comparison import compare, Comparison
from socialnav_core.evaluation.known_bounds import find_bounds, with_bounds
from socialnav_core.evaluation.run import evaluate, EvaluationResult

__all__ = [
    'Comparison', 'EvaluationResult', 'compare', 'evaluate', 'find_bounds', 'with_bounds',
]  # fmt: skip
