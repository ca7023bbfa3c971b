"""What a report is made of, and its figures as plain values."""

from collections.abc import Mapping, Sequence
import dataclasses
import math
from typing import Any

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.config.scenarios import title_of
from socialnav_core.evaluation import Comparison, EvaluationResult
from socialnav_core.metrics import METRICS
from socialnav_core.metrics.figures import outcome_name
from socialnav_core.simulation import Outcome
from socialnav_core.viewing.report.learning import Curve
from socialnav_core.viewing.report.playback import Playback

OUTCOME_NAMES = tuple(outcome_name(outcome) for outcome in Outcome)
"""Names of outcomes; data name them by their places here."""


@dataclasses.dataclass(frozen=True)
class World:
    """One world, what became of it with each policy, and the cases that can be played."""

    scenario: Scenario
    """The world."""
    name: str
    """What the command calls it: the name of a scenario or a file."""
    results: Sequence[EvaluationResult]
    """One of each policy, on the same cases."""
    comparisons: Sequence[Comparison]
    """One of each pair of policies."""
    playbacks: Sequence[Playback]
    """Episodes, each case with every policy."""

    @property
    def title(self) -> str:
        """Return what texts call it."""
        return title_of(self.results[0].scenario, self.results[0].changes)

    @property
    def meaning(self) -> str:
        """Return who and what is in it."""
        scenario = self.scenario
        walls = f'walls {2 * scenario.bounds:g} m apart' * math.isfinite(scenario.bounds)
        parts = [
            f'{scenario.pedestrians} people', f'{scenario.obstacles} obstacles', walls,
            f'at most {scenario.time_limit:g} s', f'{scenario.kinematics} robot',
        ]  # fmt: skip
        return ', '.join(filter(None, parts))

    @property
    def played(self) -> list[int]:
        """Return the cases that can be played, in the order of the episodes."""
        return list(dict.fromkeys(playback['case'] for playback in self.playbacks))


@dataclasses.dataclass(frozen=True)
class Order:
    """What was asked for, so that it can be asked for again."""

    words: Sequence[str]
    """The command without `socialnav`."""
    options: Sequence[str]
    """Those of its words that every command about these cases needs, the world left out."""
    seed: int
    """Seed of the cases."""
    split: str
    """Split of the cases."""
    curves: Sequence[Curve]
    """How those policies learned of which that is known."""
    digests: Mapping[str, str]
    """Digest of the weights of each policy that has any, by its name."""


def density(scenario: Scenario) -> float:
    """Return people for each 100 m^2 of the walled square, else of the circle they come from."""
    if math.isfinite(scenario.bounds):
        area = (2.0 * scenario.bounds) ** 2
    else:
        area = math.pi * scenario.circle_radius**2
    return 100.0 * scenario.pedestrians / area


def report_data(worlds: Sequence[World]) -> dict[str, Any]:
    """Return the figures, all cases and the episodes as plain values, fit for JSON."""
    return {'outcomes': OUTCOME_NAMES, 'worlds': [world_data(world) for world in worlds]}


def world_data(world: World) -> dict[str, Any]:
    """Return what is known of one world as plain values."""
    first = world.results[0]
    return {
        'scenario': first.scenario,
        'title': world.title,
        'seed': first.seed,
        'split': first.split,
        'results': [result_data(result) for result in world.results],
        'comparisons': [comparison.to_mapping() for comparison in world.comparisons],
        'episodes': list(world.playbacks),
    }


def result_data(result: EvaluationResult) -> dict[str, Any]:
    """Return the figures of one policy, and of each of its cases what the plots show."""
    records = result.records
    people = METRICS['minimum_people_distance'].values(records)
    return {
        'model': result.model,
        'prediction': result.policy.prediction,
        'knowledge': result.policy.knowledge,
        'episodes': result.episodes,
        'success_interval': list(result.success_interval),
        'figures': result.summary(['all']),
        'outcome': [int(outcome) for outcome in records.outcome],
        'time': rounded(records.time, 2),
        'people_distance': rounded(people, 3),
    }


def rounded(values: np.ndarray, digits: int) -> list[float | None]:
    """Return numbers with so many digits after the point, None for those that are not finite."""
    return [round(float(each), digits) if np.isfinite(each) else None for each in values]
