"""Whatever is said to a node: it lives, answers, keeps its limits, and drives on afterwards."""

from helpers import stops
from helpers.fuzzed_policy import FuzzedPolicy
from helpers.fuzzed_simulator import FuzzedSimulator
import numpy as np
import pytest

ROUNDS = 1
LONG_ROUNDS = 25
GROWTH = 20.0
"""What the allocator may add to the memory after the first rounds, MB."""
MOST_SAID = 200_000
"""Bytes that a node may write in a round: what is said of hostile messages is short."""
PROMPT = 1.0
"""Time in which a service answers and a robot drives on, s; waits for a core come on top."""
LOST = 3.0
"""Time after which Fast DDS sends a request again that was lost in a burst of others, s."""
MOST_BUSY = 0.3
"""Longest time for which the thread of a node runs until an answer, on any machine, s."""


@pytest.mark.parametrize('shooter', [FuzzedPolicy, FuzzedSimulator])
@pytest.mark.parametrize(
    ('seed', 'rounds'),
    [(0, ROUNDS), pytest.param(1, LONG_ROUNDS, marks=[pytest.mark.slow])],
)
def test_a_node_under_fire_lives_answers_and_keeps_its_limits(
    graph, tmp_path, shooter, seed, rounds
):
    log = tmp_path / 'log'
    fuzzed = shooter(graph, seed, log)
    for _ in range(rounds):
        fuzzed.round()
    figures = fuzzed.figures
    stops.measured.append(f'{shooter.__name__}, seed {seed}\n{figures.text()}')
    assert np.percentile(figures.own, 95) < PROMPT, figures.text()
    assert max(figures.own) < LOST + PROMPT, figures.text()
    assert max(figures.busy) < MOST_BUSY, figures.text()
    assert np.median(figures.recoveries) < PROMPT, figures.text()
    assert log.stat().st_size < rounds * MOST_SAID, figures.text()
    early = figures.memory[rounds // 4]
    assert figures.memory[-1] - early < GROWTH, figures.text()
