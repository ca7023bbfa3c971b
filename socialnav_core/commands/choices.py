"""Scenarios and policies as they were asked for on the command line."""

import argparse
from typing import Any

from socialnav_core.config import ConfigError, Scenario
from socialnav_core.config.mapping import parse_assignments, replace

BASELINES = ('orca', 'straight_line')
"""Policies without a network."""

SECTIONS = ('scenario', 'policy')


def use_threads(given: argparse.Namespace) -> None:
    """
    Compute with as many threads as were asked for, in memory that stays with the process.

    :param given: parsed arguments.
    """
    import torch

    from socialnav_core.allocator import keep_freed_memory
    from socialnav_core.threads import set_threads

    keep_freed_memory()
    set_threads(given.threads)
    torch.set_num_threads(given.threads)


def chosen_scenario(given: argparse.Namespace) -> Scenario:
    """
    Return the scenario with the settings that were changed.

    :param given: parsed arguments of a command with the world options.
    :raises ConfigError: for an unknown scenario or setting.
    """
    from socialnav_core.simulation import make_scenario

    scenario = make_scenario(given.scenario)
    return replace(scenario, chosen_settings(given)['scenario'], 'scenario')


def chosen_settings(given: argparse.Namespace) -> dict[str, dict[str, Any]]:
    """
    Return the settings that were changed, by section.

    :param given: parsed arguments of a command with the world options.
    :raises ConfigError: for an assignment to another section.
    """
    sections: dict[str, dict[str, Any]] = {section: {} for section in SECTIONS}
    for key, value in parse_assignments(given.assignments).items():
        section, _, name = key.partition('.')
        if section not in sections or not name:
            raise ConfigError(f'unknown setting {key!r}; begin it with scenario. or policy.')
        sections[section][name] = value
    return sections


def open_policy(model: str, given: argparse.Namespace, several: bool = False) -> Any:
    """
    Return a policy with the settings that were changed.

    :param model: as typed.
    :param given: parsed arguments of a command with the world options.
    :param several: whether it is one of several, so that options that it lacks are for others.
    :raises CheckpointError: when the model is damaged.
    :raises ConfigError: when there is no such model, or for settings that it does not have.
    """
    from socialnav_core.policies import load_policy, ValuePolicy

    use_threads(given)
    safety_space = given.safety_space if model == 'orca' or not several else None
    if several and model in BASELINES:
        return load_policy(model, safety_space=safety_space)
    policy = load_policy(model, given.lookahead, given.screening, safety_space)
    settings = chosen_settings(given)['policy']
    if not settings:
        return policy
    if not isinstance(policy, ValuePolicy):
        raise ConfigError(f'{model} has no settings that begin with policy.')
    config = replace(policy.config, settings, 'policy')
    for name in ('network', 'heads', 'kinematics'):
        if getattr(config, name) != getattr(policy.config, name):
            raise ConfigError(f'policy.{name} was fixed when {model} was trained')
    return ValuePolicy(policy.network, config)
