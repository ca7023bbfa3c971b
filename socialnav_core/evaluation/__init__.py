"""Measuring policies on given cases, and pictures of what they do."""

from socialnav_core.evaluation.comparison import compare, Comparison
from socialnav_core.evaluation.evaluate import evaluate, EvaluationResult
from socialnav_core.evaluation.recording import record, Recording

__all__ = ['Comparison', 'EvaluationResult', 'Recording', 'compare', 'evaluate', 'record']
