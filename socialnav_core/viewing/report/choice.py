"""Which cases of a world the page plays: failures of each policy first, then typical successes."""

from collections.abc import Sequence
import itertools

import numpy as np

from socialnav_core.evaluation import EvaluationResult

EPISODES = 40
"""The page plays about so many episodes in all, so that it stays small."""
MOST, LEAST = 8, 2
"""Cases of a world that are played, at most and, where there are so many to show, at least."""
SUCCESSES = 2
"""At most so many of them are cases that every policy solved."""


def cases_per_world(policies: int, worlds: int) -> int:
    """Return how many cases of each world are played, each with every policy."""
    return min(max(EPISODES // (policies * worlds), LEAST), MOST)


def chosen_cases(results: Sequence[EvaluationResult], count: int) -> list[int]:
    """
    Return cases of a world to play: those in which a policy failed, then some that all solved.

    Failures take turns: of each policy one, of another kind than before as long as there is one.
    The others are the case of median time and the one in which somebody came nearest.

    :param results: of all policies on the same cases.
    :param count: how many cases, at most.
    """
    successes = solved_by_all(results)[: min(SUCCESSES, count - 1)]
    turns = itertools.zip_longest(*map(failures, results))
    failed = dict.fromkeys(case for turn in turns for case in turn if case is not None)
    return [*list(failed)[: count - len(successes)], *successes]


def failures(result: EvaluationResult) -> list[int]:
    """Return the cases that a policy did not solve: the first of each kind, the second, ..."""
    records = result.records
    failed = np.flatnonzero(~records.success)
    kinds = [failed[records.outcome[failed] == kind] for kind in np.unique(records.outcome)]
    rounds = itertools.zip_longest(*[kind.tolist() for kind in kinds])
    return [case for each in rounds for case in each if case is not None]


def solved_by_all(results: Sequence[EvaluationResult]) -> list[int]:
    """Return at most two cases that every policy solved: the most typical, the closest call."""
    solved = np.flatnonzero(np.all([result.records.success for result in results], axis=0))
    if not len(solved):
        return []
    times = np.mean([result.records.time[solved] for result in results], axis=0)
    gaps = np.min([result.records.minimum_clearance[solved] for result in results], axis=0)
    typical = solved[np.argsort(times, kind='stable')[(len(solved) - 1) // 2]]
    return list(dict.fromkeys([int(typical), int(solved[gaps.argmin()])]))
