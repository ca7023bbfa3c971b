"""How a policy is found by its name."""

import dataclasses
import os
from pathlib import Path

from socialnav_core.config import ConfigError, require
from socialnav_core.places import MODELS
from socialnav_core.policies.orca import OrcaPolicy
from socialnav_core.policies.protocol import Policy
from socialnav_core.policies.straight_line import StraightLinePolicy
from socialnav_core.policies.value.checkpoint import load_checkpoint, WEIGHTS
from socialnav_core.policies.value.lookahead import ValuePolicy


def load_policy(
    model: str | Path,
    lookahead: str | None = None,
    screening: bool | None = None,
    safety_space: float | None = None,
) -> Policy:
    """
    Return a policy that is ready to act.

    :param model: orca, straight_line, the folder of a checkpoint or the name of one in models/.
    :param lookahead: overrides the checkpoint's: constant_velocity or oracle.
    :param screening: overrides the checkpoint's.
    :param safety_space: added to every radius by orca, m (0.15).
    :raises CheckpointError: when the checkpoint is damaged.
    :raises ConfigError: when there is no such model, or it lacks what is to be overridden.
    """
    require(safety_space is None or model == 'orca', f'{model} has no safety space, orca has')
    if model in ('orca', 'straight_line'):
        plain = lookahead is None and screening is None
        require(plain, f'{model} has neither look-ahead nor screening')
        return OrcaPolicy(safety_space) if model == 'orca' else StraightLinePolicy()
    network, config = load_checkpoint(find_model(model))
    policy = config.policy
    if lookahead is not None:
        policy = dataclasses.replace(policy, lookahead=lookahead)
    if screening is not None:
        switch = dataclasses.replace(policy.screening, enabled=screening)
        policy = dataclasses.replace(policy, screening=switch)
    return ValuePolicy(network, policy)


def find_model(model: str | Path) -> Path:
    """
    Return the folder of a checkpoint.

    :param model: a folder, or the name of one in models/.
    :raises ConfigError: when there is none; names those that there are.
    """
    for folder in (Path(model), MODELS / model):
        if os.path.isfile(folder / WEIGHTS):  # no error for what cannot be a path
            return folder
    known = sorted(path.parent.name for path in MODELS.glob(f'*/{WEIGHTS}'))
    choices = ', '.join(['orca', 'straight_line', *known])
    raise ConfigError(f'no model {str(model)!r}: give the folder of a checkpoint or {choices}')
