"""`socialnav bound`: what can be done at all in a world."""

import argparse
from pathlib import Path
from typing import Any

from socialnav_core.commands.arguments import (
    add_cases_options,
    add_command,
    add_overwrite_option,
    whole_number,
)
from socialnav_core.commands.choices import chosen_scenario, require_no_observation, use_threads
from socialnav_core.commands.evaluate import add_episodes_option
from socialnav_core.commands.files import require_new, write_json
from socialnav_core.config import ConfigError
from socialnav_core.tables import text_table

EXAMPLES = """--scenario hard --episodes 100
--scenario crowd20 --headings 128 --cell 0.03125 --json out/bound.json"""


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'Find the fastest path of each case for a robot that knows what people will do.'
    parser = add_command(commands, 'bound', run, summary, EXAMPLES)
    add_cases_options(parser)
    add_episodes_option(parser)
    parser.add_argument(
        '--headings', type=whole_number(3, 360), metavar='N', help='headings to choose from (64)'
    )
    parser.add_argument('--cell', type=float, metavar='M', help='side of the cells, m (0.0625)')
    parser.add_argument('--json', type=Path, metavar='FILE', help='write the times of all cases')
    add_overwrite_option(parser)


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    import numpy as np

    from socialnav_core.config import BoundConfig
    from socialnav_core.config.mapping import replace, to_mapping
    from socialnav_core.evaluation import find_bounds
    from socialnav_core.evaluation.bound import bounds_mapping, bounds_table

    require_new(given.json, given)
    require_no_observation(given)
    scenario = chosen_scenario(given)
    wanted = {name: getattr(given, name) for name in ('headings', 'cell')}
    config = replace(
        BoundConfig(), {name: value for name, value in wanted.items() if value is not None}
    )
    if scenario.kinematics != 'holonomic':
        raise ConfigError('the bound is that of a holonomic robot: drop scenario.kinematics')
    use_threads(given)
    cases = np.arange(given.episodes)
    bounds = find_bounds(scenario, cases, given.seed, given.split, config, progress=True)
    print(f'{scenario.name}: {given.episodes} cases of {given.split}, seed {given.seed}\n')
    print(text_table(bounds_table(bounds, config.comfort_distance)))
    write_json(
        given.json,
        {'scenario': scenario.name, 'seed': given.seed, 'split': given.split,
         'settings': to_mapping(config)} | bounds_mapping(bounds),
    )  # fmt: skip
