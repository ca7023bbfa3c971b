"""`socialnav render`: an episode as a moving picture, or its trajectories as one."""

import argparse
from pathlib import Path
from typing import Any

from socialnav_core.commands.arguments import (
    add_command,
    add_overwrite_option,
    add_world_options,
    whole_number,
)
from socialnav_core.commands.choices import chosen_scenario, open_policy
from socialnav_core.commands.files import require_new
from socialnav_core.config import ConfigError

EXAMPLES = """orca --scenario hard --seed 7 --case 3
sarl --scenario crowd20 --case 12 --out crossing.gif
sarl --scenario curriculum-2.5 --case 0 --out paths.png"""

FORMATS = ('.gif', '.mp4', '.png')


def add_parser(commands: Any) -> None:
    """
    Add the command.

    :param commands: what `add_subparsers` returned.
    """
    summary = 'Run one case and show it: .gif and .mp4 move, .png shows the trajectories.'
    parser = add_command(commands, 'render', run, summary, EXAMPLES)
    parser.add_argument(
        'model', metavar='MODEL', help='folder, name in models/, orca or straight_line'
    )
    add_world_options(parser)
    parser.add_argument(
        '--case', type=whole_number, default=0, metavar='I', help='index of the case (0)'
    )
    parser.add_argument(
        '--out', type=Path, metavar='FILE', help='(MODEL-SCENARIO-SEED-CASE.gif in out/render)'
    )
    add_overwrite_option(parser)


def run(given: argparse.Namespace) -> None:
    """
    Run the command.

    :param given: parsed arguments.
    """
    from socialnav_core.evaluation import record
    from socialnav_core.evaluation.recording import summary

    name = Path(given.model).name
    path = given.out or Path(
        'out', 'render', f'{name}-{given.scenario}-{given.seed}-{given.case}.gif'
    )
    if path.suffix not in FORMATS:
        raise ConfigError(f'{path} must end in one of {", ".join(FORMATS)}')
    require_new(path, given)
    if path.suffix == '.mp4':
        from socialnav_core.evaluation.animation import require_ffmpeg

        require_ffmpeg()
    scenario = chosen_scenario(given)
    policy = open_policy(given.model, given)
    recording = record(policy, scenario, given.seed, given.case, given.split, name)
    write(recording, path)
    print(f'{path}: {summary(recording)}')


def write(recording: Any, path: Path) -> None:
    """
    Write a recording in the format that the file's suffix names, at once or not at all.

    :param recording: the episode.
    :param path: of the file, whose folder is made if needed.
    """
    from socialnav_core.evaluation.animation import write_gif, write_mp4
    from socialnav_core.evaluation.plots import plot_recording

    writer = {'.gif': write_gif, '.mp4': write_mp4, '.png': plot_recording}[path.suffix]
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f'.{path.stem}.part{path.suffix}')
    try:
        writer(recording, temporary)
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)
