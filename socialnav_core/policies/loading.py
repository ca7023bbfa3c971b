"""How a policy is found by its name, and made with other settings than its own."""

from collections.abc import Callable, Mapping
import dataclasses
import os
from pathlib import Path
from typing import Any

from torch import cuda

from socialnav_core.config import ConfigError, PolicyConfig, require, SearchConfig
from socialnav_core.config.mapping import flatten, replace, to_mapping
from socialnav_core.places import MODELS
from socialnav_core.policies.mppi import MppiConfig, MppiPolicy
from socialnav_core.policies.orca import OrcaPolicy
from socialnav_core.policies.protocol import Policy
from socialnav_core.policies.search.checkpoint import load_planner, PLANNER, Planner
from socialnav_core.policies.search.kinds import AnySearchPolicy, search_policy
from socialnav_core.policies.search.terminal import TerminalValue
from socialnav_core.policies.social_force import SocialForcePolicy
from socialnav_core.policies.straight_line import StraightLinePolicy
from socialnav_core.policies.value.checkpoint import Checkpoint, load_checkpoint, WEIGHTS
from socialnav_core.policies.value.lookahead import ValuePolicy
from socialnav_core.simulation.kinematics import kinematics_of


@dataclasses.dataclass(frozen=True)
class WithoutNetwork:
    """A policy that needs no checkpoint."""

    settings: Any
    """What can be overridden, with its defaults: a dataclass."""
    make: Callable[[Any], Policy] = lambda settings: settings
    """Returns the policy of such settings; where there is none, they are the policy themselves."""


WITHOUT_NETWORK = {
    'orca': WithoutNetwork(OrcaPolicy()),
    'straight_line': WithoutNetwork(StraightLinePolicy()),
    'social_force': WithoutNetwork(SocialForcePolicy()),
    'mppi': WithoutNetwork(MppiConfig(), MppiPolicy),
    'search': WithoutNetwork(SearchConfig(), search_policy),
}
"""Policies that need no checkpoint, by name."""
SHORT_NAMES = {'screening': 'screening.enabled'}
"""Settings that may be called by less than their whole name."""
FIXED = ('network', 'heads', 'kinematics')
"""Settings of a value network that were fixed when it was trained."""
DEVICE = 'device'
"""Where a network is computed, cpu or cuda: not a setting that a checkpoint holds."""


def load_policy(model: str | Path, **overrides: Any) -> Policy:
    """
    Return a policy that is ready to act.

    :param model: a name in WITHOUT_NETWORK, the folder of a checkpoint or a name in models/.
    :param overrides: settings by name, dotted where they are nested, such as lookahead='oracle',
        screening=True, goal_tolerance=0.2 or **{'screening.horizon': 2.0}; None leaves the
        policy's own. `settings_of` names all.
    :raises CheckpointError: when the checkpoint is damaged.
    :raises ConfigError: when there is no such model, or it lacks what is to be overridden.
    """
    if model in WITHOUT_NETWORK:
        entry = WITHOUT_NETWORK[str(model)]
        return entry.make(replace(entry.settings, wanted_settings(model, overrides), str(model)))
    return policy_of(model, read_model(find_model(model)), overrides)


def read_model(folder: Path) -> Checkpoint | Planner:
    """
    Return what the checkpoint in a folder holds.

    :raises CheckpointError: when it is damaged.
    """
    is_planner = (folder / PLANNER).is_file()
    return load_planner(folder) if is_planner else load_checkpoint(folder)


def policy_of(
    model: str | Path, held: Checkpoint | Planner, overrides: Mapping[str, Any]
) -> Policy:
    """
    Return the policy of what a checkpoint holds; see `load_policy`.

    :param model: its name, for messages.
    """
    if isinstance(held, Planner):
        return planner_policy(model, held, overrides)
    return value_policy(model, held, overrides)


def planner_policy(
    model: str | Path, planner: Planner, overrides: Mapping[str, Any]
) -> AnySearchPolicy:
    """
    Return the policy of the checkpoint of a planner; see `load_policy`.

    :param model: its name, for messages.
    """
    wanted = wanted_settings(model, overrides)
    require('kinematics' not in wanted, f'policy.kinematics was fixed when {model} was trained')
    settings = replace(planner.config.policy, wanted, 'policy')
    value = TerminalValue(planner.network, kinematics_of(settings.kinematics))
    return search_policy(settings, value, planner.config.name)


def value_policy(
    model: str | Path, checkpoint: Checkpoint, overrides: Mapping[str, Any]
) -> ValuePolicy:
    """
    Return the policy of a checkpoint; see `load_policy`.

    :param model: its name, for messages.
    """
    wanted = wanted_settings(model, overrides)
    for name in FIXED:
        require(name not in wanted, f'policy.{name} was fixed when {model} was trained')
    device = wanted.pop(DEVICE, 'cpu')
    if device == 'cuda' and not cuda.is_available():
        raise ConfigError('device cuda needs a CUDA GPU and a CUDA build of torch; use cpu')
    config = replace(checkpoint.config.policy, wanted, 'policy')
    return ValuePolicy(checkpoint.network.to(device), config)


def wanted_settings(model: str | Path, overrides: Mapping[str, Any]) -> dict[str, Any]:
    """
    Return the overrides that are not None, by the settings' whole names.

    :raises ConfigError: for a setting that the policy of the model lacks; tells what there is.
    """
    known = settings_of(model)
    wanted = {
        SHORT_NAMES.get(name, name): value
        for name, value in overrides.items()
        if value is not None
    }
    for name in wanted:
        require(
            name in known, f'{model} has no setting {name!r}; it has {", ".join(known) or "none"}'
        )
    return wanted


def suited(model: str | Path, kinematics: str) -> dict[str, Any]:
    """Return the overrides with which a model drives a kind of robot, none where it is fixed."""
    fixed = model not in WITHOUT_NETWORK or not has_setting(model, 'kinematics')
    return {} if fixed else {'kinematics': kinematics}


def has_setting(model: str | Path, name: str) -> bool:
    """Return whether the policy of a model has a setting, by a name that `load_policy` takes."""
    return SHORT_NAMES.get(name, name) in settings_of(model)


def settings_of(model: str | Path) -> tuple[str, ...]:
    """Return the names of the settings that the policy of a model has."""
    if model in WITHOUT_NETWORK:
        return tuple(flatten(to_mapping(WITHOUT_NETWORK[str(model)].settings)))
    if (find_model(model) / PLANNER).is_file():
        return tuple(flatten(to_mapping(SearchConfig())))
    return (*flatten(to_mapping(PolicyConfig())), DEVICE)


def is_model(folder: Path) -> bool:
    """Return whether a folder holds the weights of a policy."""
    # os.path says no, rather than fail, for what cannot be a path
    return any(os.path.isfile(folder / weights) for weights in (WEIGHTS, PLANNER))


def find_model(model: str | Path) -> Path:
    """
    Return the folder of a checkpoint.

    :param model: a folder, or the name of one in models/.
    :raises ConfigError: when there is none; names those that there are.
    """
    for folder in (Path(model), MODELS / model):
        if is_model(folder):
            return folder
    known = sorted(path.name for path in MODELS.glob('*') if is_model(path))
    choices = ', '.join([*WITHOUT_NETWORK, *known])
    raise ConfigError(f'no model {str(model)!r}: give the folder of a checkpoint or {choices}')
