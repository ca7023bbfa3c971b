"""The table of metrics: an entry in it reaches console, JSON, cards, docs/metrics.md and ROS."""

from socialnav_core.metrics.catalogue import BOUND_METRICS, chosen, EVERY, METRICS, shown_in
from socialnav_core.metrics.figures import case_mappings, summarise
from socialnav_core.metrics.outcomes import COLLISIONS
from socialnav_core.metrics.people import (
    FORESEEN_RANGE,
    FORESEEN_STEPS,
    INTRUSION_DISTANCE,
    intrusions,
)
from socialnav_core.metrics.recorder import EpisodeRecorder
from socialnav_core.metrics.records import EpisodeRecords
from socialnav_core.metrics.table import Average, Metric, Place

__all__ = [
    'Average', 'BOUND_METRICS', 'COLLISIONS', 'EVERY', 'EpisodeRecorder', 'EpisodeRecords',
    'FORESEEN_RANGE', 'FORESEEN_STEPS', 'INTRUSION_DISTANCE', 'METRICS', 'Metric', 'Place',
    'case_mappings', 'chosen', 'intrusions', 'shown_in', 'summarise',
]  # fmt: skip
