"""A small report whose figures were really measured."""

from socialnav_core.evaluation import compare, evaluate
from socialnav_core.policies import OrcaPolicy, StraightLinePolicy
from socialnav_core.simulation import make_scenario
from socialnav_core.viewing.report import Order, World
from socialnav_core.viewing.report.choice import chosen_cases
from socialnav_core.viewing.report.playback import playback

POLICIES = {'orca': OrcaPolicy, 'straight_line': StraightLinePolicy}
EPISODES, SEED, SPLIT = 8, 3, 'validation'


def made_results(scenario, episodes=EPISODES, names=POLICIES):
    """Return what became of each policy in the cases of a scenario."""
    return [
        evaluate(POLICIES[name](), scenario, episodes, SEED, SPLIT, name=name) for name in names
    ]


def made_world(name, episodes=EPISODES, cases=3):
    """Return a world with some cases to play."""
    scenario = make_scenario(name)
    results = made_results(scenario, episodes)
    playbacks = [
        playback(make(), scenario, SEED, case, SPLIT, policy)
        for case in chosen_cases(results, cases)
        for policy, make in POLICIES.items()
    ]
    return World(scenario, name, results, compare(results), playbacks)


def made_order(curves=()):
    """Return what was asked for."""
    options = ['--seed', str(SEED), '--split', SPLIT]
    words = ['report', *POLICIES, '--scenario', 'circle', 'simple', *options, '--out', 'out/<b>']
    return Order(words, options, SEED, SPLIT, curves, {'orca': 'abc'})
