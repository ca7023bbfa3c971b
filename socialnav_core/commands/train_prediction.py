"""`socialnav train-prediction`: a network that predicts people, from nothing to a checkpoint."""

import argparse
from pathlib import Path
from typing import Any

from socialnav_core.commands.arguments import (
    add_command,
    add_training_options,
    training_assignments,
)
from socialnav_core.commands.choices import use_threads

EXAMPLES = """mixed
mixed --out out/prediction --seed 1 --set training.updates=2000
out/prediction/config.yaml --out out/prediction --resume"""


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'Train a network that predicts people, on crowds of many kinds.'
    parser = add_command(commands, 'train-prediction', run, summary, EXAMPLES)
    add_training_options(parser, 'training.learning_rate=1e-3', 'crowds, weights and batches')


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    use_threads(given)
    from socialnav_core.config.reading import read_prediction_config
    from socialnav_core.training.prediction import train_prediction

    config = read_prediction_config(given.config, training_assignments(given))
    out = given.out or Path('out', config.name)
    train_prediction(config, out, resume=given.resume, overwrite=given.overwrite)
    print(f'{out}: trained; measure it with socialnav evaluate-prediction {out}')
