"""`socialnav train`: a value network from nothing to a checkpoint."""

import argparse
import functools
from pathlib import Path
from typing import Any, TYPE_CHECKING

from socialnav_core.commands.arguments import (
    add_command,
    add_training_options,
    training_assignments,
)
from socialnav_core.commands.choices import use_threads

if TYPE_CHECKING:  # torch takes a second, which --help need not
    from socialnav_core.config import Scenario
    from socialnav_core.policies import Policy

EXAMPLES = """quick
sarl --out out/sarl --seed 1
sarl_curriculum --set training.learning_rate=5e-4 scenario.time_limit=35
sarl --out out/sarl --resume
out/sarl/config.yaml --out out/sarl --resume --set training.iterations=200
sarl --init sarl --out out/tuned --set scenario=hard training.iterations=20"""

VALIDATION_EPISODES = 500


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'Train a value network by imitation of ORCA, then by value learning.'
    parser = add_command(commands, 'train', run, summary, EXAMPLES)
    add_training_options(parser, 'training.learning_rate=3e-4', 'weights, cases and exploration')
    parser.add_argument(
        '--init', metavar='MODEL',
        help='begin with the weights of this checkpoint, in place of imitation (random ones)',
    )  # fmt: skip


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    use_threads(given)
    from socialnav_core.config import read_config
    from socialnav_core.training import train

    config = read_config(given.config, training_assignments(given))
    out = given.out or Path('out', config.name)
    train(
        config,
        out,
        resume=given.resume,
        overwrite=given.overwrite,
        init=given.init,
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
