"""`socialnav train`: a value network from nothing to a checkpoint."""

import argparse
import functools
from pathlib import Path
from typing import Any, TYPE_CHECKING

from socialnav_core.commands.arguments import (
    add_command,
    add_overwrite_option,
    add_set_option,
    add_threads_option,
    whole_number,
)
from socialnav_core.commands.choices import use_threads
from socialnav_core.config.mapping import parse_assignments

if TYPE_CHECKING:  # torch takes a second, which --help need not
    from socialnav_core.config import Scenario
    from socialnav_core.policies import Policy

EXAMPLES = """quick
sarl --out out/sarl --seed 1
sarl_curriculum --set training.learning_rate=5e-4 scenario.time_limit=35
sarl --out out/sarl --resume"""

VALIDATION_EPISODES = 500


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'Train a value network by imitation of ORCA, then by value learning.'
    parser = add_command(commands, 'train', run, summary, EXAMPLES)
    parser.add_argument(
        'config', metavar='CONFIG', help='YAML file, or the name of one that comes with socialnav'
    )
    add_set_option(parser, 'training.learning_rate=3e-4')
    parser.add_argument('--out', type=Path, metavar='DIR', help='folder of the run (out/NAME)')
    parser.add_argument(
        '--seed', type=whole_number, metavar='N', help='seed of weights, cases and exploration'
    )
    parser.add_argument('--resume', action='store_true', help='go on with the run in the folder')
    add_overwrite_option(parser)
    add_threads_option(parser)


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    use_threads(given)
    from socialnav_core.config import read_config
    from socialnav_core.training import train

    assignments = parse_assignments(given.assignments)
    if given.seed is not None:
        assignments['seed'] = given.seed
    config = read_config(given.config, assignments)
    out = given.out or Path('out', config.name)
    train(
        config,
        out,
        resume=given.resume,
        overwrite=given.overwrite,
        evaluate=functools.partial(validate, name=config.name, seed=config.seed),
    )
    print(f'{out}: trained; measure it with socialnav evaluate {out} --scenario NAME')


def validate(policy: 'Policy', scenario: 'Scenario', name: str, seed: int) -> dict[str, Any]:
    """Print and return how a trained policy does on validation cases of its own world."""
    from socialnav_core.evaluation import evaluate
    from socialnav_core.evaluation.report import evaluation_text

    result = evaluate(
        policy, scenario, VALIDATION_EPISODES, seed, 'validation', name=name, progress=True
    )
    print(evaluation_text(result))
    return result.to_mapping()
