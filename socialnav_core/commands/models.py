"""`socialnav models`: which trained models there are and how good they are."""

import argparse
import json
from pathlib import Path
from typing import Any

from socialnav_core.commands.arguments import add_command
from socialnav_core.config import ConfigError
from socialnav_core.tables import text_table

EXAMPLES = """
out
--cards"""

COLUMNS = ('name', 'network', 'parameters', 'trained in', 'success (time)', 'digest')
HEADLINES = 4
DIGEST_LENGTH = 12


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'List the trained models with their results.'
    parser = add_command(commands, 'models', run, summary, EXAMPLES)
    parser.add_argument(
        'folder',
        metavar='DIR',
        nargs='?',
        type=Path,
        help='checkpoints (the shipped ones)',
    )
    parser.add_argument(
        '--cards', action='store_true', help='write the model cards anew from metrics.json'
    )


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    from socialnav_core.places import MODELS
    from socialnav_core.policies.loading import is_model

    parent = given.folder or MODELS
    if not parent.is_dir():
        raise ConfigError(f'there is no folder {parent}')
    folders = sorted(path for path in parent.glob('*') if is_model(path))
    if not folders:
        raise ConfigError(f'no models in {parent}; train one with socialnav train quick')
    if given.cards:
        write_cards(folders)
    print(text_table([COLUMNS, *(row(folder) for folder in folders)]))


def write_cards(folders: list[Path]) -> None:
    """Write the card of each model anew."""
    from socialnav_core.commands.files import require_own
    from socialnav_core.policies.loading import read_model
    from socialnav_core.training import write_card

    for folder in folders:
        require_own(folder)
        write_card(folder, read_model(folder))


def row(folder: Path) -> tuple[str, ...]:
    """Return the cells of COLUMNS for one model; of a damaged one, what is wrong with it."""
    from socialnav_core.policies.loading import read_model
    from socialnav_core.storage import CheckpointError

    try:
        held = read_model(folder)
    except CheckpointError as error:
        return (folder.name, 'damaged', '', '', str(error), '')
    parameters = sum(parameter.numel() for parameter in held.network.parameters())
    kind, world = kind_and_world(held.config)
    return (
        folder.name,
        kind,
        f'{parameters:,}',
        world,
        headlines(folder / 'metrics.json'),
        held.digest[:DIGEST_LENGTH],
    )


def kind_and_world(config: Any) -> tuple[str, str]:
    """Return what network a model has, and where it was trained."""
    from socialnav_core.config.planner import PlannerConfig

    if isinstance(config, PlannerConfig):
        return f'search + {network_text(config.network, config.heads)}', 'mixed worlds'
    return network_text(config.policy.network, config.policy.heads), config.scenario.name


def network_text(name: str, heads: int) -> str:
    """Return the name of a network, with its number of heads where it has any."""
    return f'{name} ({heads} head{"s" * (heads > 1)})' if name.startswith('gat4sn') else name


def headlines(path: Path) -> str:
    """
    Return the first results of a model with its own settings, such as `hard 0.992 (10.97 s)`.

    :param path: of its metrics; an absent file gives a dash.
    """
    if not path.is_file():
        return '-'
    try:
        results = json.loads(path.read_text(encoding='utf-8'))
        plain = [result for key, result in results.items() if '+' not in key][:HEADLINES]
        return ', '.join(headline(result) for result in plain) or '-'
    except (OSError, ValueError, TypeError, AttributeError, KeyError, RecursionError):
        return f'{path.name} is damaged'


def headline(result: dict[str, Any]) -> str:
    """
    Return a result in a few words; of another split than test, which one.

    :param result: as in metrics.json.
    """
    from socialnav_core.metrics import METRICS

    success, time = METRICS['success_rate'], METRICS['navigation_time_mean']
    split = result['split']
    remarks = [] if result[time.name] is None else [time.text(result[time.name])]
    remarks += [] if split == 'test' else [split]
    remark = f' ({", ".join(remarks)})' if remarks else ''
    return f'{result["scenario"]} {success.text(result[success.name])}{remark}'
