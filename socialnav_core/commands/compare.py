"""`socialnav compare`: which of some policies is better, and whether that could be chance."""

import argparse
from pathlib import Path
from typing import Any

from socialnav_core.commands.arguments import (
    add_command,
    add_overwrite_option,
    add_world_options,
    MODEL_HELP,
)
from socialnav_core.commands.choices import chosen_scenario, open_policies
from socialnav_core.commands.evaluate import (
    add_bound_option,
    add_episodes_option,
    add_metrics_option,
    described,
    measure,
    require_metrics,
)
from socialnav_core.commands.files import require_new, write_json
from socialnav_core.config import ConfigError

EXAMPLES = """sarl gat4sn --scenario hard
sarl gat4sn orca --scenario crowd20 --episodes 5000 --json out/comparison.json"""


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = (
        "Run some policies on the same cases and print the paired differences (McNemar's test)."
    )
    parser = add_command(commands, 'compare', run, summary, EXAMPLES)
    parser.add_argument('models', metavar='MODEL', nargs='+', help=MODEL_HELP)
    add_world_options(parser)
    add_episodes_option(parser)
    add_metrics_option(parser)
    add_bound_option(parser)
    parser.add_argument('--json', type=Path, metavar='FILE', help='write all figures and cases')
    add_overwrite_option(parser)


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    from socialnav_core.evaluation import compare
    from socialnav_core.evaluation.report import comparison_text

    if len(given.models) < 2 or len(set(given.models)) < len(given.models):
        raise ConfigError('name two or more different models')
    require_metrics(given)
    require_new(given.json, given)
    scenario = chosen_scenario(given)
    policies = open_policies(given.models, given)
    results = [measure(model, policy, scenario, given) for model, policy in policies.items()]
    comparisons = compare(results)
    print(comparison_text(results, comparisons, given.further))
    values = {
        'results': [described(result, given) for result in results],
        'comparisons': [comparison.to_mapping() for comparison in comparisons],
    }
    write_json(given.json, values)
