"""Scenarios and policies as they were asked for on the command line."""

import argparse
import os
from pathlib import Path
from typing import Any, TYPE_CHECKING

from socialnav_core.config import (
    ConfigError,
    make_scenario,
    ObservationConfig,
    read_scenario,
    Scenario,
)
from socialnav_core.config.mapping import parse_assignments, replace
from socialnav_core.config.recorded import RECORDED_NAME

if TYPE_CHECKING:  # torch takes a second, which --help need not
    from socialnav_core.policies import Policy

ENDINGS = ('.yaml', '.yml')
"""Of files of scenarios; what holds a / is one too."""
SECTIONS = ('scenario', 'policy', 'observation')


def use_threads(given: argparse.Namespace) -> None:
    """Compute with as many threads as were asked for, in memory that stays with the process."""
    import torch

    from socialnav_core.allocator import keep_freed_memory
    from socialnav_core.threads import set_threads

    keep_freed_memory()
    set_threads(given.threads)
    torch.set_num_threads(given.threads)


def chosen_scenario(given: argparse.Namespace) -> Scenario:
    """
    Return the scenario with the settings that were changed.

    :raises ConfigError: for an unknown scenario or setting.
    """
    name, settings = given.scenario, chosen_settings(given)['scenario']
    scenario = read_scenario(Path(name)) if is_file(name) else make_scenario(name, settings)
    return replace(scenario, settings, 'scenario')


def suited_to_policy(scenario: Scenario, policy: 'Policy', given: argparse.Namespace) -> Scenario:
    """
    Return the scenario with the base that a planner drives, with the limits of its settings.

    A scenario of a file, and one whose kinematics were chosen, stays as it is.
    """
    from socialnav_core.policies.search.kinds import AnySearchPolicy, with_base

    chosen = is_file(given.scenario) or 'kinematics' in chosen_settings(given)['scenario']
    if chosen or not isinstance(policy, AnySearchPolicy):
        return scenario
    return with_base(scenario, policy.settings)


def is_file(scenario: str) -> bool:
    """Return whether a scenario was asked for by a file, and not by a name."""
    named = RECORDED_NAME.fullmatch(scenario) is not None
    return not named and (scenario.endswith(ENDINGS) or os.sep in scenario)


def chosen_settings(given: argparse.Namespace) -> dict[str, dict[str, Any]]:
    """
    Return the settings that were changed, by section.

    :raises ConfigError: for an assignment to another section.
    """
    sections: dict[str, dict[str, Any]] = {section: {} for section in SECTIONS}
    for key, value in parse_assignments(given.assignments).items():
        section, _, name = key.partition('.')
        if section not in sections or not name:
            raise ConfigError(
                f'unknown setting {key!r}; begin it with scenario., policy. or observation.'
            )
        sections[section][name] = value
    return sections


def chosen_observation(given: argparse.Namespace) -> ObservationConfig | None:
    """Return how people are to be seen; None where they are seen as they are."""
    chosen = chosen_settings(given)['observation']
    return replace(ObservationConfig(), chosen, 'observation') if chosen else None


def require_no_observation(given: argparse.Namespace) -> None:
    """Raise a ConfigError where a command shows the world as it is and was asked for another."""
    if chosen_settings(given)['observation']:
        raise ConfigError(f'{given.command} has no observation: drop --set observation.')


def open_policy(model: str, given: argparse.Namespace) -> 'Policy':
    """
    Return a policy with the settings that were changed.

    :raises CheckpointError: when the model is damaged.
    :raises ConfigError: when there is no such model, or for settings that it does not have.
    """
    from socialnav_core.policies import load_policy

    use_threads(given)
    return load_policy(model, **suited_to_scenario(model, given) | chosen_overrides(given))


def open_policies(models: list[str], given: argparse.Namespace) -> dict[str, 'Policy']:
    """
    Return several policies by name; each is given those of the changed settings that it has.

    :raises CheckpointError: when a model is damaged.
    :raises ConfigError: when there is no such model, or for settings that none of them has.
    """
    from socialnav_core.policies import load_policy
    from socialnav_core.policies.loading import has_setting

    use_threads(given)
    overrides = chosen_overrides(given)
    foreign = [name for name in overrides if not any(has_setting(one, name) for one in models)]
    return {
        model: load_policy(
            model,
            **suited_to_scenario(model, given)
            | {
                name: value
                for name, value in overrides.items()
                if has_setting(model, name) or name in foreign  # which is then complained about
            },
        )
        for model in models
    }


def suited_to_scenario(model: str, given: argparse.Namespace) -> dict[str, Any]:
    """Return the overrides with which a model drives the robot of the scenario, if it can."""
    from socialnav_core.policies.loading import suited

    return suited(model, chosen_scenario(given).kinematics)


def chosen_overrides(given: argparse.Namespace) -> dict[str, Any]:
    """
    Return the settings of policies that were changed, by name.

    :raises ConfigError: for an assignment to another section.
    """
    switches = {name: getattr(given, name) for name in ('lookahead', 'screening', 'safety_space')}
    chosen = {name: value for name, value in switches.items() if value is not None}
    return chosen | chosen_settings(given)['policy']
