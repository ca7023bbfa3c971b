"""`socialnav evaluate-prediction`: how far a prediction is from what people do."""

import argparse
import dataclasses
from pathlib import Path
from typing import Any

from socialnav_core.commands.arguments import (
    add_command,
    add_overwrite_option,
    add_threads_option,
    SEED,
    whole_number,
)
from socialnav_core.commands.choices import use_threads
from socialnav_core.commands.files import require_new, require_own, require_picture, write_json
from socialnav_core.config import ConfigError

EXAMPLES = """
out/prediction --split validation --crowds crowd20 unaware
prediction --recorded people.txt --motions --json out/prediction.json
prediction --picture out/reliability.png"""


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'Compare predictions with what people did, crowd by crowd.'
    parser = add_command(commands, 'evaluate-prediction', run, summary, EXAMPLES)
    parser.add_argument(
        'model', metavar='MODEL', nargs='?', default='prediction',
        help='folder of a learned prediction, or its name in models/ (prediction)',
    )  # fmt: skip
    parser.add_argument(
        '--crowds', nargs='*', metavar='NAME', help='crowds to judge it on (all of them)'
    )
    parser.add_argument(
        '--recorded', nargs='+', type=Path, default=[], metavar='FILE',
        help='files of recorded people, a line `frame person x y` each 0.4 s',
    )  # fmt: skip
    parser.add_argument(
        '--groups', type=whole_number(1, 10_000), default=6, metavar='N',
        help='recordings of each crowd, 12 worlds of 20 s each (6)',
    )  # fmt: skip
    parser.add_argument(
        '--seed', type=whole_number(*SEED), default=0, metavar='N', help='seed of the crowds (0)'
    )
    parser.add_argument(
        '--split', choices=('validation', 'test'), default='test', help='of the crowds (test)'
    )
    parser.add_argument(
        '--motions', action='store_true',
        help='also those who are new, stand, start, turn or walk on, each apart',
    )  # fmt: skip
    parser.add_argument(
        '--picture', type=Path, metavar='FILE',
        help='draw how often people are within what is predicted, by crowd and time ahead',
    )  # fmt: skip
    parser.add_argument('--json', type=Path, metavar='FILE', help='write all figures')
    parser.add_argument(
        '--card', action='store_true', help="put the figures into the model's metrics and card"
    )
    add_overwrite_option(parser)
    add_threads_option(parser)


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    use_threads(given)
    from socialnav_core.evaluation.prediction import CROWDS
    from socialnav_core.evaluation.prediction_report import result_table
    from socialnav_core.prediction.learned.checkpoint import find_predictor, load_predictor
    from socialnav_core.training.prediction.model_card import add_results

    require_new(given.json, given)
    require_picture(given.picture, given)
    if given.card:
        require_own(find_predictor(given.model))
    crowds = CROWDS if given.crowds is None else given.crowds
    for crowd in crowds:
        if crowd not in CROWDS:
            raise ConfigError(f'no crowd {crowd!r}; there are: {", ".join(CROWDS)}')
    results = measured(load_predictor(given.model), crowds, given)
    print(result_table(results))
    values = [
        dataclasses.asdict(result) | {'seed': given.seed, 'split': given.split}
        for result in results
    ]
    write_json(given.json, values)
    if given.picture:
        draw(results, given.picture)
    if given.card:
        add_results(find_predictor(given.model), values)


def measured(predictor: Any, crowds: Any, given: argparse.Namespace) -> list[Any]:
    """Return the results on crowds, without and with noise, and on recorded people."""
    from socialnav_core.config.recordings import read_tracks
    from socialnav_core.evaluation.judgement import judge, summarise
    from socialnav_core.evaluation.prediction import evaluate_prediction
    from socialnav_core.evaluation.recorded_people import track_moments

    tracks = {path.stem: read_tracks(path) for path in given.recorded}
    options = given.groups, given.seed, given.split
    results = [
        result
        for crowd in crowds
        for noise in (False, True)
        for result in evaluate_prediction(predictor, crowd, *options, noise, given.motions)
    ]
    for name, track in tracks.items():
        crowd = f'recorded: {name}'
        found = judge(predictor, [track_moments(track)], crowd)
        results += summarise(found, crowd, motions=given.motions)
    return results


def draw(results: list[Any], path: Path) -> None:
    """Write the picture, at once or not at all."""
    from socialnav_core.storage import written_whole
    from socialnav_core.viewing.reliability import plot_reliability

    path.parent.mkdir(parents=True, exist_ok=True)
    with written_whole(path) as temporary:
        plot_reliability(results, temporary)
