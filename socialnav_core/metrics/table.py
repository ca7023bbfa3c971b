"""What an entry of the table of metrics is, and how its figure is worked out and written."""

from collections.abc import Callable
import dataclasses
import enum
import math

import numpy as np

from socialnav_core.metrics.records import EpisodeRecords
from socialnav_core.tables import number


class Average(enum.Enum):
    """Over what the values of episodes are averaged; those that are not finite never count."""

    EPISODES = 'all episodes'
    SUCCESSES = 'successes'
    STEPS = 'all steps'
    """Values are numbers of steps; the figure is their share of the steps of all episodes."""


class Place(enum.Enum):
    """Where a metric is shown without being asked for."""

    EVALUATION = 'evaluate'
    COMPARISON = 'compare'
    CARD = 'model card'


@dataclasses.dataclass(frozen=True)
class Metric:
    """
    One figure of a policy: what it means, how it is measured and how it is written.

    A metric that has no place is measured only where it is asked for by its name.
    """

    name: str
    """Key of its figure in JSON, and its name on the command line."""
    label: str
    """What it is called on a line of its own."""
    measure: Callable[[EpisodeRecords], np.ndarray]
    """Return its value in each episode, (episodes,)."""
    average: Average
    """Over what these values are averaged."""
    formula: str
    """How it is worked out, in words and symbols."""
    source: str
    """Who defined it."""
    unit: str = ''
    """Its unit; empty for shares."""
    digits: int = 3
    """Digits after the point."""
    heading: str = ''
    """What it is called above a column; its label where that is empty."""
    episode_key: str | None = ''
    """Key of its value in one episode; its name where that is empty, None where it has no key."""
    places: frozenset[Place] = frozenset()
    """Where it is shown without being asked for."""

    @property
    def column(self) -> str:
        """Return what it is called above a column."""
        return self.heading or self.label

    @property
    def column_with_unit(self) -> str:
        """Return what it is called above a column of bare numbers."""
        return f'{self.column}, {self.unit}' if self.unit else self.column

    @property
    def key(self) -> str | None:
        """Return the key of its value in one episode, None where it has none."""
        return self.name if self.episode_key == '' else self.episode_key

    def values(self, records: EpisodeRecords) -> np.ndarray:
        """Return its value in each episode, a share where it counts steps, (episodes,)."""
        values = self.measure(records)
        return values / records.steps if self.average is Average.STEPS else values

    def figure(self, records: EpisodeRecords) -> float | None:
        """Return its average over at least one episode; None where no episode has a value."""
        values = self.measure(records)
        if self.average is Average.STEPS:
            return float(values.sum() / records.steps.sum())
        if self.average is Average.SUCCESSES:
            values = values[records.success]
        finite = values[np.isfinite(values)]
        return float(finite.mean()) if finite.size else None

    def text(self, value: float | None) -> str:
        """Return a figure with its unit, a dash for None."""
        return number(value, self.digits, self.unit)


def finite_or_none(value: float) -> float | None:
    """Return a finite number, None for another one: JSON has no infinity."""
    return float(value) if math.isfinite(value) else None
