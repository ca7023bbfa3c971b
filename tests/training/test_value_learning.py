"""Laws of a whole run."""

import csv
import dataclasses
import json
import math

import pytest
import torch

from socialnav_core.config import ConfigError
from socialnav_core.config.mapping import to_mapping
from socialnav_core.policies import load_policy
from socialnav_core.policies.value.checkpoint import (
    checkpoint_digest,
    CheckpointError,
    load_checkpoint,
)
from socialnav_core.simulation import make_scenario, Simulator
from socialnav_core.training import train, value_learning
from socialnav_core.training.folder import own_folder
from socialnav_core.training.progress import COLUMNS
from socialnav_core.training.run import Run
from socialnav_core.training.warm_up import begin


def with_training(config, **settings):
    """Return the configuration with some settings of training replaced."""
    return dataclasses.replace(config, training=dataclasses.replace(config.training, **settings))


def interrupted(monkeypatch, config, out, iterations, **options):
    """Run until some iterations are done, then die."""
    original = value_learning.iterate

    def die_at(run):
        if run.iteration == iterations:
            raise RuntimeError('killed')
        return original(run)

    with monkeypatch.context() as patch:
        patch.setattr(value_learning, 'iterate', die_at)
        with pytest.raises(RuntimeError, match='killed'):
            train(config, out, progress=False, **options)


def test_run_leaves_a_checkpoint_that_drives(tiny_config, tmp_path):
    train(tiny_config, tmp_path / 'run', progress=False)
    policy = load_policy(str(tmp_path / 'run'))
    state = Simulator(make_scenario('simple'), 3).reset()
    assert policy.act(state).shape == (3, 2)
    assert not (tmp_path / 'run' / 'training_state.safetensors').exists()


def test_same_seed_gives_the_same_weights_and_another_seed_others(tiny_config, tmp_path):
    configs = (tiny_config, tiny_config, dataclasses.replace(tiny_config, seed=1))
    digests = []
    for index, config in enumerate(configs):
        train(config, tmp_path / str(index), progress=False)
        digests.append(checkpoint_digest(tmp_path / str(index)))
    assert digests[0] == digests[1] != digests[2]


@pytest.mark.parametrize('iterations', [0, 1, 3])
def test_resumed_run_ends_with_the_weights_of_an_uninterrupted_one(
    tiny_config, tmp_path, monkeypatch, iterations
):
    train(tiny_config, tmp_path / 'whole', progress=False)
    interrupted(monkeypatch, tiny_config, tmp_path / 'cut', iterations)
    train(tiny_config, tmp_path / 'cut', resume=True, progress=False)
    assert checkpoint_digest(tmp_path / 'cut') == checkpoint_digest(tmp_path / 'whole')


def test_resumed_run_in_mixed_worlds_ends_with_the_weights_of_an_uninterrupted_one(
    tiny_config, tmp_path, monkeypatch
):
    config = with_training(tiny_config, kinds=2)
    train(config, tmp_path / 'whole', progress=False)
    interrupted(monkeypatch, config, tmp_path / 'cut', 2)
    train(config, tmp_path / 'cut', resume=True, progress=False)
    assert checkpoint_digest(tmp_path / 'cut') == checkpoint_digest(tmp_path / 'whole')


@pytest.mark.parametrize('scheduler', ['smooth', 'baby_step', 'one_pass'])
def test_resumed_curriculum_run_ends_with_the_weights_of_an_uninterrupted_one(
    tiny_config, tmp_path, monkeypatch, scheduler
):
    curriculum = dataclasses.replace(
        tiny_config.training.curriculum,
        enabled=True,
        scheduler=scheduler,
        target_success=0.0,
        window=1,
    )
    config = with_training(tiny_config, curriculum=curriculum, iterations=20)
    config = dataclasses.replace(
        config, scenario=dataclasses.replace(config.scenario, obstacle_radius_max=1.1)
    )
    train(config, tmp_path / 'whole', progress=False)
    interrupted(monkeypatch, config, tmp_path / 'cut', 17)
    train(config, tmp_path / 'cut', resume=True, progress=False)
    assert progress_rows(tmp_path / 'cut')[-1]['obstacle_radius'] != '0.3'
    assert checkpoint_digest(tmp_path / 'cut') == checkpoint_digest(tmp_path / 'whole')


def reported(config):
    """Return the configuration with everything that the recipe of the report does otherwise."""
    return with_training(
        config, episodes=14, updates_per_episode=2, store_timeouts=False, optimizer='sgd',
        trace_decay=0.0, target_update_episodes=3, gradient_clip=math.inf,
    )  # fmt: skip


@pytest.mark.parametrize('iterations', [0, 15, 22])
def test_resumed_run_by_the_reports_recipe_ends_like_an_uninterrupted_one(
    tiny_config, tmp_path, monkeypatch, iterations
):
    config = reported(tiny_config)
    train(config, tmp_path / 'whole', progress=False)
    interrupted(monkeypatch, config, tmp_path / 'cut', iterations)
    train(config, tmp_path / 'cut', resume=True, progress=False)
    assert checkpoint_digest(tmp_path / 'cut') == checkpoint_digest(tmp_path / 'whole')


def test_run_of_a_given_length_in_episodes_ends_with_them(tiny_config, tmp_path):
    train(reported(tiny_config), tmp_path / 'run', progress=False)
    episodes = [int(row['episodes']) for row in progress_rows(tmp_path / 'run')]
    assert episodes[-1] >= 14 > episodes[-2]


def test_updates_follow_the_episodes_that_ended(tiny_config):
    run = Run(reported(tiny_config))
    begin(run, progress=False)
    for _ in range(16):
        before, ended = run.network.state_dict()['value.0.weight'].clone(), run.ended_episodes
        row = value_learning.iterate(run)
        same = torch.equal(run.network.state_dict()['value.0.weight'], before)
        assert same == (run.ended_episodes == ended) == (row['loss'] != row['loss'])
    assert run.ended_episodes


def test_targets_are_renewed_when_enough_episodes_have_ended(tiny_config):
    run = Run(reported(tiny_config))
    begin(run, progress=False)
    renewals = 0
    for _ in range(20):
        target = run.target_network.state_dict()['value.0.weight'].clone()
        ended = run.ended_episodes
        value_learning.iterate(run)
        due = run.ended_episodes // 3 > ended // 3
        now = run.target_network.state_dict()['value.0.weight']
        assert torch.equal(now, target) != due
        renewals += due
    assert renewals


def test_states_of_timeouts_are_replayed_only_where_wished(tiny_config):
    short = dataclasses.replace(tiny_config.scenario, time_limit=0.5)
    imitation = dataclasses.replace(tiny_config.training.imitation, episodes=0)
    sizes = []
    for store in (True, False):
        config = with_training(tiny_config, store_timeouts=store, imitation=imitation)
        run = Run(dataclasses.replace(config, scenario=short))
        begin(run, progress=False)
        value_learning.iterate(run)
        sizes.append(run.buffer.size)
    assert sizes == [24, 0]


def test_state_that_lacks_newer_settings_had_their_defaults(tiny_config, tmp_path, monkeypatch):
    def without_newer(config):
        values = to_mapping(config)
        del values['training']['optimizer'], values['training']['curriculum']['scheduler']
        return values

    with monkeypatch.context() as patch:
        patch.setattr('socialnav_core.training.resume.to_mapping', without_newer)
        interrupted(monkeypatch, tiny_config, tmp_path / 'run', 1)
    train(tiny_config, tmp_path / 'run', resume=True, progress=False)


def progress_rows(folder):
    """Return the rows of the progress report."""
    with (folder / 'progress.csv').open(newline='') as file:
        return list(csv.DictReader(file))


def test_progress_has_one_row_an_iteration_also_after_a_resumption(
    tiny_config, tmp_path, monkeypatch
):
    config = with_training(tiny_config, checkpoint_iterations=2)
    interrupted(monkeypatch, config, tmp_path / 'run', 3)
    train(config, tmp_path / 'run', resume=True, progress=False)
    rows = progress_rows(tmp_path / 'run')
    assert [int(row['iteration']) for row in rows] == [1, 2, 3, 4]
    assert tuple(rows[0]) == COLUMNS
    assert list((tmp_path / 'run').glob('events.out.tfevents.*'))


def test_resuming_with_another_setting_names_it(tiny_config, tmp_path, monkeypatch):
    interrupted(monkeypatch, tiny_config, tmp_path / 'run', 1)
    other = with_training(tiny_config, trace_decay=0.5)
    with pytest.raises(ConfigError, match='training.trace_decay = 0.7, not 0.5'):
        train(other, tmp_path / 'run', resume=True, progress=False)


def test_nothing_is_resumed_where_nothing_was_saved(tiny_config, tmp_path):
    with pytest.raises(ConfigError, match='no unfinished run'):
        train(tiny_config, tmp_path / 'run', resume=True, progress=False)


def test_finished_run_goes_on_when_it_is_made_longer(tiny_config, tmp_path):
    folder = tmp_path / 'run'
    train(tiny_config, folder, progress=False)
    before = checkpoint_digest(folder)
    with pytest.raises(ConfigError, match='finished after training.iterations = 4.*=8'):
        train(tiny_config, folder, resume=True, progress=False)
    train(with_training(tiny_config, iterations=6), folder, resume=True, progress=False)
    assert [int(row['iteration']) for row in progress_rows(folder)] == [1, 2, 3, 4, 5, 6]
    assert checkpoint_digest(folder) != before


def test_run_is_never_made_shorter(tiny_config, tmp_path, monkeypatch):
    interrupted(monkeypatch, tiny_config, tmp_path / 'run', 3)
    with pytest.raises(ConfigError, match='training.iterations = 4, not 2'):
        train(with_training(tiny_config, iterations=2), tmp_path / 'run', resume=True)


def test_run_begins_with_the_weights_of_another(tiny_config, tmp_path):
    train(tiny_config, tmp_path / 'first', progress=False)
    still = with_training(tiny_config, iterations=1, updates_per_iteration=0)
    train(still, tmp_path / 'second', init=tmp_path / 'first', progress=False)
    first, second = (load_checkpoint(tmp_path / name) for name in ('first', 'second'))
    assert second.config.training.initial_weights == first.digest
    inside, outside = first.network.state_dict(), second.network.state_dict()
    same = [name for name in inside if torch.equal(inside[name], outside[name])]
    assert len(same) > 5  # all but what is folded anew
    with pytest.raises(ConfigError, match='--init'):
        train(second.config, tmp_path / 'third', progress=False)


def test_weights_of_another_network_are_no_beginning(tiny_config, tmp_path):
    other = dataclasses.replace(tiny_config.policy, network='gat4sn')
    with pytest.raises(ConfigError, match='policy.network = sarl, not gat4sn'):
        train(dataclasses.replace(tiny_config, policy=other), tmp_path / 'run', init='sarl')
    assert not (tmp_path / 'run').exists()


@pytest.mark.parametrize('options', [{'resume': True}, {'overwrite': True}, {}])
def test_two_trainings_never_share_a_folder(options, tiny_config, tmp_path):
    with (
        own_folder(tmp_path / 'run', resume=True, overwrite=False),
        pytest.raises(ConfigError, match='in use by another training'),
    ):
        train(tiny_config, tmp_path / 'run', progress=False, **options)


def test_training_that_would_not_fit_into_memory_is_refused_before_it_begins(
    tiny_config, tmp_path
):
    config = with_training(tiny_config, replay_capacity=100_000_000, worlds=60_000)
    crowded = dataclasses.replace(config.scenario, pedestrians=1000)
    with pytest.raises(ConfigError, match='GiB'):
        train(dataclasses.replace(config, scenario=crowded), tmp_path / 'run')
    assert not (tmp_path / 'run').exists()


def test_existing_run_is_not_touched(tiny_config, tmp_path):
    train(tiny_config, tmp_path / 'run', progress=False)
    before = checkpoint_digest(tmp_path / 'run')
    with pytest.raises(ConfigError, match='not empty'):
        train(dataclasses.replace(tiny_config, seed=1), tmp_path / 'run', progress=False)
    assert checkpoint_digest(tmp_path / 'run') == before


def test_damaged_state_is_refused(tiny_config, tmp_path, monkeypatch):
    interrupted(monkeypatch, tiny_config, tmp_path / 'run', 1)
    path = tmp_path / 'run' / 'training_state.safetensors'
    content = bytearray(path.read_bytes())
    content[-100] ^= 1
    path.write_bytes(content)
    with pytest.raises(CheckpointError, match='damaged'):
        train(tiny_config, tmp_path / 'run', resume=True, progress=False)


def test_failing_write_keeps_the_state_that_was_saved_last(tiny_config, tmp_path, monkeypatch):
    interrupted(monkeypatch, tiny_config, tmp_path / 'run', 2)
    saved = (tmp_path / 'run' / 'training_state.safetensors').read_bytes()

    def full_disk(path, data):
        raise OSError(28, 'No space left on device')

    with monkeypatch.context() as patch:
        patch.setattr('socialnav_core.training.resume.atomic_write', full_disk)
        with pytest.raises(CheckpointError, match='No space left on device'):
            train(tiny_config, tmp_path / 'run', resume=True, progress=False)
    assert (tmp_path / 'run' / 'training_state.safetensors').read_bytes() == saved
    train(tiny_config, tmp_path / 'run', resume=True, progress=False)


def test_evaluation_of_the_finished_policy_becomes_metrics_and_model_card(tiny_config, tmp_path):
    def evaluate(policy, scenario):
        assert policy.config == tiny_config.policy and scenario == tiny_config.scenario
        return {
            'scenario': scenario.name, 'lookahead': 'constant_velocity', 'screening': False,
            'success_rate': 0.5, 'success_interval': [0.25, 0.75], 'collision_rate': 0.5,
            'timeout_rate': 0.0, 'navigation_time_mean': None, 'episodes': 2, 'seed': 0,
            'split': 'validation', 'cases': [],
        }  # fmt: skip

    train(tiny_config, tmp_path / 'run', evaluate=evaluate, progress=False)
    metrics = json.loads((tmp_path / 'run' / 'metrics.json').read_text())
    assert metrics['simple']['success_rate'] == 0.5 and 'cases' not in metrics['simple']
    assert '0.5000 [0.2500, 0.7500]' in (tmp_path / 'run' / 'README.md').read_text()


def test_run_without_imitation_learns_from_its_own_states(tiny_config, tmp_path):
    imitation = dataclasses.replace(tiny_config.training.imitation, episodes=0)
    train(with_training(tiny_config, imitation=imitation), tmp_path / 'run', progress=False)
    assert (tmp_path / 'run' / 'weights.safetensors').exists()


def test_weights_as_trained_stay_beside_the_folded_ones(tiny_config, tmp_path):
    train(tiny_config, tmp_path / 'folded', progress=False)
    plain = with_training(tiny_config, fold_constant_features=False)
    train(plain, tmp_path / 'plain', progress=False)
    unfolded = checkpoint_digest(tmp_path / 'folded' / 'unfolded')
    assert unfolded == checkpoint_digest(tmp_path / 'plain')
    assert unfolded != checkpoint_digest(tmp_path / 'folded')
    assert not (tmp_path / 'plain' / 'unfolded').exists()
