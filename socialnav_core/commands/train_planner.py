"""`socialnav train-planner`: a search with a value network at its horizon."""

import argparse
from pathlib import Path
from typing import Any

from socialnav_core.commands.arguments import (
    add_command,
    add_training_options,
    training_assignments,
)
from socialnav_core.commands.choices import use_threads

EXAMPLES = """socialnav
socialnav --out out/planner --seed 1 --set network=gat4sn training.rounds=2
out/planner/config.yaml --out out/planner --resume"""


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'Train the value network at the horizon of the search, in worlds of every kind.'
    parser = add_command(commands, 'train-planner', run, summary, EXAMPLES)
    add_training_options(
        parser, 'training.learning_rate=5e-4', 'worlds, weights, exploration and batches'
    )


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    use_threads(given)
    from socialnav_core.config.reading import read_planner_config
    from socialnav_core.training.planner import train_planner

    config = read_planner_config(given.config, training_assignments(given))
    out = given.out or Path('out', config.name)
    train_planner(config, out, resume=given.resume, overwrite=given.overwrite)
    print(f'{out}: trained; measure it with socialnav evaluate {out} --scenario NAME')
