"""`socialnav evaluate`: how good a policy is."""

import argparse
from pathlib import Path
from typing import Any

from socialnav_core.commands.arguments import (
    add_command,
    add_overwrite_option,
    add_world_options,
    positive_number,
)
from socialnav_core.commands.choices import BASELINES, chosen_scenario, open_policy
from socialnav_core.commands.files import require_new, require_own, write_json
from socialnav_core.config import ConfigError, Scenario
from socialnav_core.config.mapping import parse_assignments

EXAMPLES = """orca --scenario hard --safety-space 0.15
sarl --scenario crowd20 --episodes 5000 --json out/crowd20.json
models/sarl --scenario hard --set scenario.time_limit=35 policy.headings=16
out/sarl --scenario simple --lookahead oracle --no-screening --card"""


def add_parser(commands: Any) -> None:
    """
    Add the command.

    :param commands: what `add_subparsers` returned.
    """
    summary = 'Run a policy on unseen cases, each once, and print what came of it.'
    parser = add_command(commands, 'evaluate', run, summary, EXAMPLES)
    parser.add_argument(
        'model', metavar='MODEL', help='folder, name in models/, orca or straight_line'
    )
    add_world_options(parser)
    add_episodes_option(parser)
    parser.add_argument('--json', type=Path, metavar='FILE', help='write all figures and cases')
    parser.add_argument(
        '--card', action='store_true', help="add the result to the model's metrics and card"
    )
    add_overwrite_option(parser)


def add_episodes_option(parser: argparse.ArgumentParser) -> None:
    """
    Add `--episodes`.

    :param parser: of a command.
    """
    parser.add_argument(
        '--episodes', type=positive_number, default=500, metavar='N', help='cases (500)'
    )


def run(given: argparse.Namespace) -> None:
    """
    Run the command.

    :param given: parsed arguments.
    """
    from socialnav_core.evaluation.report import evaluation_text

    require_new(given.json, given)
    require_plain_settings(given)
    scenario = chosen_scenario(given)
    policy = open_policy(given.model, given)
    if given.card:
        require_card(policy, scenario, given)
    result = measure(given.model, policy, scenario, given)
    print(evaluation_text(result))
    values = described(result, given)
    write_json(given.json, values)
    if given.card:
        update_card(given.model, values)


def measure(model: str, policy: Any, scenario: Scenario, given: argparse.Namespace) -> Any:
    """
    Return the result of a policy.

    :param model: its name.
    :param policy: a Policy.
    :param scenario: the world.
    :param given: parsed arguments: episodes, seed, split.
    """
    from socialnav_core.evaluation import evaluate

    return evaluate(
        policy, scenario, given.episodes, given.seed, given.split, name=model, progress=True
    )


def described(result: Any, given: argparse.Namespace) -> dict[str, Any]:
    """
    Return a result as plain values, with the settings that were changed.

    :param result: of evaluate.
    :param given: parsed arguments.
    """
    from socialnav_core.policies.orca import SAFETY_SPACE

    values = result.to_mapping()
    cases = values.pop('cases')
    values['settings'] = parse_assignments(given.assignments)
    if result.model == 'orca':
        chosen = given.safety_space
        values['settings']['safety_space'] = SAFETY_SPACE if chosen is None else chosen
    return values | {'cases': cases}


def require_plain_settings(given: argparse.Namespace) -> None:
    """
    Raise a ConfigError when a result for a model card is not one of a model as it is.

    :param given: parsed arguments.
    """
    if given.card and given.model in BASELINES:
        raise ConfigError(f'{given.model} has no model card: drop --card')
    if given.card and given.assignments:
        raise ConfigError('a card holds results of unchanged settings: drop --set or --card')


def require_card(policy: Any, scenario: Scenario, given: argparse.Namespace) -> None:
    """
    Raise a ConfigError when a result must not be written into the card of a model.

    Cards of an installed package stay as they are, and so do those that hold a better result of
    the same kind, unless `--overwrite` is given.

    :param policy: a ValuePolicy.
    :param scenario: the world.
    :param given: parsed arguments.
    """
    from socialnav_core.policies.loading import find_model
    from socialnav_core.training.model_card import require_no_better

    folder = find_model(given.model)
    require_own(folder)
    if given.overwrite:
        return
    planned = {
        'scenario': scenario.name, 'lookahead': policy.config.lookahead,
        'screening': policy.config.screening.enabled, 'split': given.split,
        'episodes': given.episodes,
    }  # fmt: skip
    require_no_better(folder, planned)


def update_card(model: str, values: dict[str, Any]) -> None:
    """
    Add a result to the metrics and the card of a model.

    :param model: a folder, or a name in models/.
    :param values: the result.
    """
    from socialnav_core.policies.loading import find_model
    from socialnav_core.training import add_result, write_model_card

    folder = find_model(model)
    add_result(folder, values)
    write_model_card(folder)
