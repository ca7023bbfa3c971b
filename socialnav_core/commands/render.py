"""`socialnav render`: an episode as a moving picture, its trajectories as one, or a ROS 2 bag."""

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import Any, TYPE_CHECKING

from socialnav_core.commands.arguments import (
    add_command,
    add_overwrite_option,
    add_world_options,
    CASE,
    MODEL_HELP,
    whole_number,
)
from socialnav_core.commands.choices import (
    chosen_scenario,
    is_file,
    open_policy,
    require_no_observation,
    suited_to_policy,
    use_threads,
)
from socialnav_core.commands.files import require_new
from socialnav_core.config import ConfigError, Scenario

if TYPE_CHECKING:  # torch takes a second, which --help need not
    from socialnav_core.policies import Policy

EXAMPLES = """orca --scenario hard --seed 7 --case 3
sarl --scenario crowd20 --case 12 --out crossing.gif
sarl_curriculum --scenario curriculum-2.5 --case 0 --out paths.png
bound --scenario crowd20 --case 12
sarl --scenario hard --case 2 --bag episode.mcap"""

FORMATS = ('.gif', '.mp4', '.png')
BAG_FORMATS = ('.mcap',)


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = (
        'Run one case and show it: .gif and .mp4 move, .png shows the trajectories; '
        '--bag writes it as a ROS 2 bag.'
    )
    parser = add_command(commands, 'render', run, summary, EXAMPLES)
    parser.add_argument('model', metavar='MODEL', help=f'{MODEL_HELP}, or bound')
    add_world_options(parser)
    parser.add_argument(
        '--case', type=whole_number(*CASE), default=0, metavar='I', help='index of the case (0)'
    )
    parser.add_argument(
        '--out', type=Path, metavar='FILE',
        help='picture (MODEL-SCENARIO-SEED-CASE.gif in out/render; with --bag alone, none)',
    )  # fmt: skip
    parser.add_argument(
        '--bag', type=Path, metavar='FILE.mcap', help='the topics of the ROS 2 nodes (none)'
    )
    add_overwrite_option(parser)


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    from socialnav_core.config.scenarios import changes_of, title_of
    from socialnav_core.viewing import record
    from socialnav_core.viewing.recording import summary

    name = Path(given.model).name
    paths = [path for path in (picture_path(given, name), given.bag) if path is not None]
    for path in paths:
        require_format(path, BAG_FORMATS if path is given.bag else FORMATS)
        require_new(path, given)
    require_no_observation(given)
    scenario = chosen_scenario(given)
    policy = rendered_policy(given, scenario)
    scenario = suited_to_policy(scenario, policy, given)
    recording = record(policy, scenario, given.seed, given.case, given.split, name)
    look_ahead = f', look-ahead {recording.look_ahead}' if recording.look_ahead else ''
    changes = changes_of(scenario)
    world = f', in {title_of(scenario.name, changes)}' if changes else ''
    for path in paths:
        write(recording, path)
        print(f'{path}: {summary(recording)}{look_ahead}{world}')


def rendered_policy(given: argparse.Namespace, scenario: Scenario) -> 'Policy':
    """Return the policy that was asked for; `bound` drives the best path that is known."""
    from socialnav_core.evaluation.witness import WITNESS, witness_of

    if given.model != WITNESS:
        return open_policy(given.model, given)
    use_threads(given)
    return witness_of(scenario, given.case, given.seed, given.split)


def picture_path(given: argparse.Namespace, name: str) -> Path | None:
    """Return where the picture goes; None where only a bag is wanted."""
    if given.out is not None or given.bag is not None:
        return given.out
    scenario = Path(given.scenario).stem if is_file(given.scenario) else given.scenario
    return Path('out', 'render', f'{name}-{scenario}-{given.seed}-{given.case}.gif')


def require_format(path: Path, formats: tuple[str, ...]) -> None:
    """
    Raise a ConfigError unless a file can be written in the format that its suffix names.

    :param formats: suffixes to choose from.
    """
    if path.suffix not in formats:
        raise ConfigError(f'{path} must end in {" or ".join(formats)}')
    writer_of(path.suffix)  # a package that it lacks is missed now
    if path.suffix == '.mp4':
        from socialnav_core.viewing.animation import find_ffmpeg

        find_ffmpeg()


def write(recording: Any, path: Path) -> None:
    """
    Write a recording in the format that the file's suffix names, at once or not at all.

    :param path: its folder is made if needed.
    """
    from socialnav_core.storage import written_whole

    writer = writer_of(path.suffix)
    path.parent.mkdir(parents=True, exist_ok=True)
    with written_whole(path) as temporary:
        writer(recording, temporary)


def writer_of(suffix: str) -> Callable[[Any, Path], None]:
    """Return what writes a recording into a file."""
    if suffix == '.mcap':
        from socialnav_core.viewing.bag import write_bag

        return write_bag
    from socialnav_core.viewing.animation import write_gif, write_mp4
    from socialnav_core.viewing.plots import plot_recording

    return {'.gif': write_gif, '.mp4': write_mp4, '.png': plot_recording}[suffix]
