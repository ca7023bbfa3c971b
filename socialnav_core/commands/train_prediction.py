"""`socialnav train-prediction`: a network that predicts people, from nothing to a checkpoint."""

import argparse
from pathlib import Path
from typing import Any

from socialnav_core.commands.arguments import (
    add_command,
    add_overwrite_option,
    add_set_option,
    add_threads_option,
    whole_number,
)
from socialnav_core.commands.choices import use_threads
from socialnav_core.config.mapping import parse_assignments

EXAMPLES = """mixed
mixed --out out/prediction --seed 1 --set training.updates=2000
out/prediction/config.yaml --out out/prediction --resume"""


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'Train a network that predicts people, on crowds of many kinds.'
    parser = add_command(commands, 'train-prediction', run, summary, EXAMPLES)
    parser.add_argument(
        'config', metavar='CONFIG', help='YAML file, or the name of one that comes with socialnav'
    )
    add_set_option(parser, 'training.learning_rate=1e-3')
    parser.add_argument('--out', type=Path, metavar='DIR', help='folder of the run (out/NAME)')
    parser.add_argument(
        '--seed', type=whole_number, metavar='N', help='seed of crowds, weights and batches'
    )
    parser.add_argument('--resume', action='store_true', help='go on with the run in the folder')
    add_overwrite_option(parser)
    add_threads_option(parser)


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    use_threads(given)
    from socialnav_core.config.reading import read_prediction_config
    from socialnav_core.training.prediction import train_prediction

    assignments = parse_assignments(given.assignments)
    if given.seed is not None:
        assignments['seed'] = given.seed
    config = read_prediction_config(given.config, assignments)
    out = given.out or Path('out', config.name)
    train_prediction(config, out, resume=given.resume, overwrite=given.overwrite)
    print(f'{out}: trained; measure it with socialnav evaluate-prediction {out}')
