"""`socialnav grid`: a policy in every kind of world."""

import argparse
import json
from pathlib import Path
from typing import Any, TYPE_CHECKING

from socialnav_core.commands.arguments import (
    add_command,
    add_overwrite_option,
    add_threads_option,
    EPISODES,
    MODEL_HELP,
    whole_number,
)
from socialnav_core.commands.choices import use_threads
from socialnav_core.commands.files import require_new, write_json
from socialnav_core.config import ConfigError

if TYPE_CHECKING:
    from socialnav_core.config.grid import GridConfig

EXAMPLES = """search --bound
search orca straight_line --quick --out out/quick
search gat4sn --episodes 500 --picture out/grid.png --markdown out/grid.md"""


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'Run policies in a grid of worlds: few people and many, near goals and far ones.'
    parser = add_command(commands, 'grid', run, summary, EXAMPLES)
    parser.add_argument('models', metavar='MODEL', nargs='+', help=MODEL_HELP)
    parser.add_argument(
        '--config', metavar='GRID', default='full',
        help='YAML file, or the name of one that comes with socialnav: full or quick (full)',
    )  # fmt: skip
    parser.add_argument('--quick', action='store_true', help='the same as --config quick')
    parser.add_argument(
        '--episodes',
        type=whole_number(*EPISODES),
        metavar='N',
        help='cases of each world (as in the file)',
    )
    parser.add_argument(
        '--bound', action='store_true',
        help='measure against the fastest path of a robot that knows the future (docs/bound.md)',
    )  # fmt: skip
    parser.add_argument(
        '--out', type=Path, default=Path('out', 'grid'), metavar='DIR',
        help='folder of a file for each policy; cells that are there are not run again (out/grid)',
    )  # fmt: skip
    parser.add_argument('--picture', type=Path, metavar='FILE', help='write a heat map')
    parser.add_argument('--markdown', type=Path, metavar='FILE', help='write tables in Markdown')
    add_overwrite_option(parser)
    add_threads_option(parser)


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    import dataclasses

    from socialnav_core.config.reading import read_grid_config
    from socialnav_core.evaluation.grid_report import grid_markdown, grid_text
    from socialnav_core.policies import load_policy

    config = read_grid_config('quick' if given.quick else given.config)
    if given.episodes is not None:
        config = dataclasses.replace(config, episodes=given.episodes)
    if len(set(given.models)) < len(given.models):
        raise ConfigError('name different models')
    for path in (given.picture, given.markdown):
        require_new(path, given)
    use_threads(given)
    for model in given.models:
        load_policy(model)
    files = {model: given.out / f'{Path(model).name}.json' for model in given.models}
    known = {model: known_cells(path, config, given) for model, path in files.items()}
    results = {}
    for model, path in files.items():
        results[model] = run_model(model, path, config, known[model], given)
        print(grid_text(config, model, results[model]), end='\n\n')
    if given.picture is not None:
        plot(config, results, given.picture)
    if given.markdown is not None:
        given.markdown.parent.mkdir(parents=True, exist_ok=True)
        given.markdown.write_text(grid_markdown(config, results), encoding='utf-8')


def run_model(
    model: str, path: Path, config: 'GridConfig', known: list[Any], given: argparse.Namespace
) -> list[Any]:
    """Return all cells of a policy, written to its file one by one."""
    from socialnav_core.config.grid import grid_mapping
    from socialnav_core.evaluation.grid import cells_of, run_grid
    from socialnav_core.progress import progress_bar

    head = {'model': model, 'bound': given.bound, 'grid': grid_mapping(config)}
    with progress_bar(len(list(cells_of(config))), model, 'world') as bar:
        return run_grid(
            model, config, given.bound, known,
            keep=lambda cells: write_json(path, head | {'cells': cells}), progress=bar.update,
        )  # fmt: skip


def known_cells(path: Path, config: 'GridConfig', given: argparse.Namespace) -> list[Any]:
    """
    Return the cells of an earlier run.

    :raises ConfigError: when the file is of another grid.
    """
    from socialnav_core.config.grid import grid_mapping

    if given.overwrite or not path.exists():
        return []
    try:
        values = json.loads(path.read_text(encoding='utf-8'))
        same = (values['grid'], values['bound']) == plain((grid_mapping(config), given.bound))
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise ConfigError(f'{path} holds no grid: name another folder by --out') from error
    if not same:
        raise ConfigError(
            f'{path} is of another grid: replace it by --overwrite or name another folder by --out'
        )
    return values['cells']


def plain(values: Any) -> Any:
    """Return values as they come back from JSON."""
    return tuple(json.loads(json.dumps(values)))


def plot(config: 'GridConfig', results: dict[str, list[Any]], path: Path) -> None:
    """Write the heat map, at once or not at all."""
    from socialnav_core.storage import written_whole
    from socialnav_core.viewing.heat_map import plot_grid

    if path.suffix not in ('.png', '.svg', '.pdf'):
        raise ConfigError(f'{path} must end in .png, .svg or .pdf')
    path.parent.mkdir(parents=True, exist_ok=True)
    with written_whole(path) as temporary:
        plot_grid(config, results, temporary)
