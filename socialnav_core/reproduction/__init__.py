"""The founding report's tables and figures again: trained, measured, written to docs/results."""

from socialnav_core.reproduction.experiments import Experiment, EXPERIMENTS
from socialnav_core.reproduction.laboratory import Laboratory
from socialnav_core.reproduction.shipping import ship
from socialnav_core.reproduction.writing import write_results

__all__ = ['EXPERIMENTS', 'Experiment', 'Laboratory', 'ship', 'write_results']
