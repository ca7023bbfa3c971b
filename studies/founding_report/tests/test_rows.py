"""Rows are configurations that exist, and the networks of the report."""

import pytest

from founding_report.experiments import EXPERIMENTS
from founding_report.report_figures import PARAMETERS, REPORT, SAME_SYSTEM
from founding_report.rows import QUICK, REPORTED_RECIPE, ROWS
from socialnav_core.config.mapping import flatten, to_mapping
from socialnav_core.policies import OrcaPolicy
from socialnav_core.policies.value.checkpoint import build_network
from socialnav_core.simulation import make_scenario, Simulator
from socialnav_core.training.imitation import collect_demonstrations


@pytest.mark.parametrize('name', ROWS)
def test_every_row_resolves_to_a_configuration_named_like_its_run(name):
    config = ROWS[name].resolved(3, quick=False)
    assert (config.name, config.seed) == (ROWS[name].run_name, 3)
    for test in ROWS[name].tests:
        make_scenario(test)


@pytest.mark.parametrize('name', PARAMETERS)
def test_networks_have_as_many_parameters_as_in_the_report(name):
    network = build_network(ROWS[name].resolved(0, quick=False).policy)
    assert sum(parameter.numel() for parameter in network.parameters()) == PARAMETERS[name]


@pytest.mark.parametrize('name', REPORTED_RECIPE)
def test_the_reports_recipe_differs_in_training_alone(name):
    theirs = ROWS[f'{name}_report_recipe'].resolved(0, quick=False)
    ours = ROWS[name].resolved(0, quick=False)
    assert (theirs.scenario, theirs.policy) == (ours.scenario, ours.policy)
    assert theirs.training != ours.training


def test_the_reports_recipe_is_one():
    first, *others = (
        ROWS[f'{name}_report_recipe'].resolved(0, quick=False).training for name in REPORTED_RECIPE
    )
    assert all(training == first for training in others)
    assert (first.imitation.episodes, first.episodes) == (3000, 5000)


@pytest.mark.parametrize('name', REPORTED_RECIPE)
def test_a_smoke_run_of_the_reports_recipe_ends_after_few_updates(name):
    training = ROWS[f'{name}_report_recipe'].resolved(0, quick=True).training
    assert training.episodes * training.updates_per_episode <= 10


def test_a_smoke_run_differs_by_the_quick_settings_alone():
    full, quick = (flatten(to_mapping(ROWS['sarl'].resolved(0, q))) for q in (False, True))
    assert {name for name in full if full[name] != quick[name]} == set(QUICK)


@pytest.mark.parametrize('name', ['sarl', 'sarl_no_curriculum', 'sarl_no_curriculum_packed'])
def test_a_smoke_run_has_demonstrations_to_imitate(name):
    config = ROWS[name].resolved(0, quick=True)
    episodes = config.training.imitation.episodes
    found = collect_demonstrations(Simulator(config.scenario, episodes), OrcaPolicy(), episodes, 0)
    assert len(found.returns)


def test_figures_of_the_report_belong_to_rows_and_their_tests():
    for row, scenario in REPORT:
        assert scenario in ROWS[row].tests
    assert set(SAME_SYSTEM) <= set(ROWS)


def test_compared_rows_belong_to_their_experiment():
    for experiment in EXPERIMENTS.values():
        names = {entry.row.name for entry in experiment.entries}
        assert all(set(pair) <= names for pair in experiment.pairs), experiment.name


def test_curriculum_rows_differ_by_the_curriculum_alone():
    for world in ('', '_packed'):
        with_, without = (
            flatten(to_mapping(ROWS[f'sarl_{kind}{world}'].resolved(0, quick=False)))
            for kind in ('curriculum', 'no_curriculum')
        )
        differing = {name for name in with_ if with_[name] != without[name]}
        assert differing == {'name', 'training.curriculum.enabled'}
