"""`socialnav report`: which policy to use and why, on one page."""

import argparse
import os
from pathlib import Path
from typing import Any, TYPE_CHECKING

from socialnav_core.commands.arguments import (
    add_command,
    add_overwrite_option,
    add_world_options,
    MODEL_HELP,
)
from socialnav_core.commands.choices import (
    chosen_scenario,
    open_policies,
    require_no_observation,
)
from socialnav_core.commands.evaluate import add_episodes_option
from socialnav_core.config import ConfigError

if TYPE_CHECKING:  # torch takes a second, which --help need not
    from socialnav_core.policies import Policy
    from socialnav_core.viewing.report import Order, World

EXAMPLES = """sarl gat4sn orca --scenario hard --out out/report
search --scenario simple crowd20 --episodes 1000 --out out/search
search --scenario hard --grid out/grid/search.json --out out/grid_report"""

PAGE = 'index.html'


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'Write one HTML page: figures, comparisons, plots, and episodes to play.'
    parser = add_command(commands, 'report', run, summary, EXAMPLES)
    parser.add_argument('models', metavar='MODEL', nargs='+', help=MODEL_HELP)
    add_world_options(parser, several=True)
    add_episodes_option(parser)
    parser.add_argument(
        '--grid', type=Path, nargs='+', default=[], metavar='FILE',
        help='show these results of socialnav grid as heat maps',
    )  # fmt: skip
    parser.add_argument(
        '--out', type=Path, required=True, metavar='DIR', help=f'folder of the page, {PAGE}'
    )
    add_overwrite_option(parser)


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    from socialnav_core.storage import atomic_write
    from socialnav_core.viewing.report import report_page
    from socialnav_core.viewing.report.grids import read_grid

    require_different(given)
    require_free(given)
    require_no_observation(given)
    views = views_of(given)
    grids = [read_grid(path) for path in given.grid]
    policies = [open_policies(given.models, view) for view in views]
    order = order_of(given)
    pairs = zip(views, policies, strict=True)
    worlds = [measured(view, opened, len(views)) for view, opened in pairs]
    page = report_page(worlds, grids, order)
    given.out.mkdir(parents=True, exist_ok=True)
    atomic_write(given.out / PAGE, page.encode())
    print(f'{given.out / PAGE}: open it in a browser')


def require_different(given: argparse.Namespace) -> None:
    """Raise a ConfigError where a policy or a world is named twice."""
    for names, what in ((given.models, 'models'), (given.scenario, 'scenarios')):
        if len(set(names)) < len(names):
            raise ConfigError(f'name different {what}')


def require_free(given: argparse.Namespace) -> None:
    """Raise a ConfigError unless the folder is new or empty, or its page may be replaced."""
    out = given.out
    parent = next(folder for folder in (out, *out.absolute().parents) if folder.exists())
    if not parent.is_dir() or not os.access(parent, os.W_OK):
        raise ConfigError(f'{out} cannot be used: no right to write to {parent}')
    if not out.is_dir() or not any(out.iterdir()):
        return
    if not given.overwrite:
        raise ConfigError(
            f'{out} is not empty; replace its report by --overwrite or choose another --out'
        )
    if not (out / PAGE).is_file():
        raise ConfigError(f'{out} holds no report but other files; choose another --out')


def views_of(given: argparse.Namespace) -> list[argparse.Namespace]:
    """
    Return what was asked for, for each world alone.

    :raises ConfigError: for an unknown world, or two of the same name.
    """
    views = [
        argparse.Namespace(**vars(given) | {'scenario': name}) for name in given.scenario
    ]  # fmt: skip
    names = [chosen_scenario(view).name for view in views]
    if len(set(names)) < len(names):
        raise ConfigError(f'two worlds are called {max(names, key=names.count)}: rename one')
    return views


def measured(given: argparse.Namespace, policies: dict[str, 'Policy'], worlds: int) -> 'World':
    """
    Return what became of some policies in a world.

    :param worlds: how many there are in all.
    """
    from socialnav_core.evaluation import compare, evaluate
    from socialnav_core.viewing.report import World
    from socialnav_core.viewing.report.choice import cases_per_world, chosen_cases
    from socialnav_core.viewing.report.playback import playback

    scenario = chosen_scenario(given)
    results = [
        evaluate(policy, scenario, given.episodes, given.seed, given.split, name=model,
                 progress=True)
        for model, policy in policies.items()
    ]  # fmt: skip
    cases = chosen_cases(results, cases_per_world(len(results), worlds))
    playbacks = [
        playback(policy, scenario, given.seed, case, given.split, model)
        for case in cases
        for model, policy in policies.items()
    ]
    comparisons = compare(results) if len(results) > 1 else []
    return World(scenario, given.scenario, results, comparisons, playbacks)


def order_of(given: argparse.Namespace) -> 'Order':
    """Return what was asked for as words to type, and what is known of the models."""
    from socialnav_core.policies.loading import find_model, read_model, WITHOUT_NETWORK
    from socialnav_core.viewing.report import Order
    from socialnav_core.viewing.report.learning import learning_curve

    trained = [model for model in given.models if model not in WITHOUT_NETWORK]
    folders = {model: find_model(model) for model in trained}
    curves = [learning_curve(model, folder) for model, folder in folders.items()]
    digests = {model: read_model(folder).digest for model, folder in folders.items()}
    options = options_of(given)
    words = ['report', *given.models, '--scenario', *given.scenario, *options]
    words += ['--episodes', str(given.episodes)]
    words += ['--grid', *map(str, given.grid)] if given.grid else []
    words += ['--out', str(given.out)]
    known = [curve for curve in curves if curve]
    return Order(words, options, given.seed, given.split, known, digests)


def options_of(given: argparse.Namespace) -> list[str]:
    """Return the options that say which cases are run and how, as they are typed."""
    words = ['--seed', str(given.seed), '--split', given.split]
    words += ['--set', *given.assignments] if given.assignments else []
    words += ['--lookahead', given.lookahead] if given.lookahead is not None else []
    words += (
        ['--safety-space', f'{given.safety_space:g}'] if given.safety_space is not None else []
    )
    if given.screening is not None:
        words.append('--screening' if given.screening else '--no-screening')
    return words
