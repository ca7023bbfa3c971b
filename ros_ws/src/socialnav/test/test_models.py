"""What becomes of the parameters that a policy is made from."""

import numpy as np
import pytest
import torch

from socialnav.controller_settings import controller_settings
from socialnav.models import example_state, ready_policy
from socialnav.parameters import POLICY_PARAMETERS

DEFAULTS = {entry.name: entry.default for entry in POLICY_PARAMETERS}


def policy_of(**changes):
    """Return the policy of a node with some parameters."""
    values = DEFAULTS | changes
    return ready_policy(values, controller_settings(values))


def test_the_horizon_of_screening_is_as_saved_unless_another_is_asked_for():
    saved = policy_of().config.screening
    longer = policy_of(screening_horizon=2.5).config.screening
    assert longer.horizon == 2.5 != saved.horizon
    assert (longer.margin, longer.enabled) == (saved.margin, saved.enabled)


@pytest.mark.parametrize('parameter', [{'screening_horizon': 1.0}, {'device': 'cuda'}])
def test_a_policy_without_a_network_is_not_asked_for_what_networks_have(parameter):
    with pytest.raises(ValueError, match='orca has no network'):
        policy_of(model='orca', **parameter)


@pytest.mark.skipif(torch.cuda.is_available(), reason='there is a CUDA GPU')
def test_without_a_gpu_there_is_one_line_and_no_slower_device_instead():
    with pytest.raises(ValueError, match='use cpu'):
        policy_of(device='cuda')


@pytest.mark.skipif(not torch.cuda.is_available(), reason='needs a CUDA GPU')
def test_a_gpu_decides_as_the_processor_does():
    policy = policy_of(device='cuda')
    assert {parameter.device.type for parameter in policy.network.parameters()} == {'cuda'}
    state = example_state(controller_settings(DEFAULTS).body)
    np.testing.assert_array_equal(policy.act(state), policy_of().act(state))
