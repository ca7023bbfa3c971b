"""Measuring policies on given cases, and pictures of what they do."""

from socialnav_core.evaluation.comparison import Comparison, compare
from socialnav_core.evaluation.evaluate import EvaluationResult, evaluate
from socialnav_core.evaluation.recording import Recording, record

__all__ = ['Comparison', 'EvaluationResult', 'Recording', 'compare', 'evaluate', 'record']
