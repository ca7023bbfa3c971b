"""Laws of the parameters that a policy is made from; no middleware is needed for them."""

from pathlib import Path
import shutil

from ament_index_python.packages import get_package_share_directory
import numpy as np
import pytest
import torch

from socialnav.control.models import example_state, installed, ready_policy
from socialnav.control.settings import controller_settings
from socialnav.parameters.policy import PolicyParameters

NETWORK = 'gat4sn'
SHARE = Path(get_package_share_directory('socialnav')) / 'models'


def policy_of(**changes):
    """Return the policy of a node with some parameters."""
    return ready_policy(PolicyParameters(**changes))


def load(model):
    """Return what a node would drive by."""
    return policy_of(model=str(model))


def test_a_name_is_that_of_a_model_of_the_package_wherever_the_node_was_started(
    tmp_path, monkeypatch
):
    (tmp_path / NETWORK).mkdir()
    monkeypatch.chdir(tmp_path)
    assert Path(installed(NETWORK)) == SHARE / NETWORK


def test_a_name_that_nothing_has_is_answered_with_those_that_there_are():
    with pytest.raises(ValueError, match=f'orca, straight_line, .*search, .*{NETWORK}'):
        load('nobody')


@pytest.mark.parametrize('name', ['', '.', '..', '../models', f'../models/{NETWORK}', '/'])
def test_nothing_but_a_name_is_looked_up_in_the_share_folder(name):
    assert installed(name) == name


def test_the_folder_of_a_checkpoint_is_a_model_wherever_it_is(tmp_path):
    folder = tmp_path / 'anywhere'
    shutil.copytree(SHARE / NETWORK, folder)
    assert load(folder).description.kinematics == 'holonomic'


@pytest.mark.parametrize(
    'name',
    [
        '', '.', '..', '/', '/etc/passwd', '../../../../../../etc', 'a\0b', 'file:///etc', '$HOME',
        'x' * 300, f'{SHARE}/{NETWORK}/config.yaml', f'{NETWORK}/weights.safetensors',
    ],
)  # fmt: skip
def test_whatever_is_no_checkpoint_is_one_line_about_what_could_be_given(name):
    with pytest.raises(ValueError, match='no model') as error:
        load(name)
    assert '\n' not in str(error.value)


def test_the_model_suits_the_base_where_none_is_named():
    plain = policy_of().description
    assert (plain.name, plain.kinematics, plain.prediction) == (
        'socialnav', 'holonomic', 'learned',
    )  # fmt: skip
    turning = policy_of(kinematics='differential').description
    assert (turning.name, turning.kinematics, turning.prediction) == (
        'socialnav_diff_drive', 'differential', 'learned',
    )  # fmt: skip


def test_a_base_drives_backwards_only_where_that_is_asked_for():
    for model in ('auto', 'search'):
        plain = policy_of(model=model, kinematics='differential')
        assert plain.settings.differential.reverse == 0.0
        asked = policy_of(model=model, kinematics='differential', reverse=0.4)
        assert asked.settings.differential.reverse == 0.4
    assert policy_of(reverse=0.4).description.kinematics == 'holonomic'


def test_another_prediction_is_one_parameter_away():
    assert policy_of(lookahead='constant_velocity').description.prediction == 'constant_velocity'


@pytest.mark.parametrize('name', ['/etc/passwd', '../hard', f'{SHARE}/{NETWORK}/config.yaml'])
def test_a_scenario_is_a_name_and_never_a_file(name):
    with pytest.raises(ValueError, match='unknown scenario'):
        controller_settings(PolicyParameters(lockstep=True, scenario=name))


def test_the_horizon_of_screening_is_as_saved_unless_another_is_asked_for():
    saved = policy_of(model=NETWORK).config.screening
    longer = policy_of(model=NETWORK, screening_horizon=2.5).config.screening
    assert longer.horizon == 2.5 != saved.horizon
    assert (longer.margin, longer.enabled) == (saved.margin, saved.enabled)


@pytest.mark.parametrize(
    'parameter', [{'screening_horizon': 1.0}, {'device': 'cuda'}, {'screening': 'enabled'}]
)
def test_a_policy_without_a_network_is_not_asked_for_what_networks_have(parameter):
    complaint = "orca has no setting '(screening|device).*'; it has safety_space"
    with pytest.raises(ValueError, match=complaint):
        policy_of(model='orca', **parameter)


@pytest.mark.skipif(torch.cuda.is_available(), reason='there is a CUDA GPU')
def test_without_a_gpu_there_is_one_line_and_no_slower_device_instead():
    with pytest.raises(ValueError, match='use cpu'):
        policy_of(model=NETWORK, device='cuda')


@pytest.mark.skipif(not torch.cuda.is_available(), reason='needs a CUDA GPU')
def test_a_gpu_decides_as_the_processor_does():
    policy = policy_of(model=NETWORK, device='cuda')
    assert {parameter.device.type for parameter in policy.network.parameters()} == {'cuda'}
    state = example_state(PolicyParameters().body)
    np.testing.assert_array_equal(policy.act(state), policy_of(model=NETWORK).act(state))
