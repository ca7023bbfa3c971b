"""What was measured of a learned prediction, and its model card."""

import csv
import json
from pathlib import Path
from typing import Any

from socialnav_core.config.prediction import PredictionConfig, SHARES
from socialnav_core.prediction.learned.checkpoint import load_weights
from socialnav_core.prediction.learned.layout import LAG, LAGS, NEIGHBOURS, TIMES
from socialnav_core.storage import arrays_digest, atomic_write
from socialnav_core.training.model_card import CARD_NAME, METRICS_NAME, read_metrics
from socialnav_core.training.progress import CSV_NAME


def add_results(folder: Path, results: list[dict[str, Any]]) -> None:
    """
    Put evaluations into the metrics of a checkpoint and write its card anew.

    :param results: PredictionResult as mappings, with seed and split; each replaces the older one
        of the same crowd. Single motions and LEVELS are left aside.
    """
    named = {
        f'{result["crowd"]}{"+noise" * result["noise"]}': {
            name: value for name, value in result.items() if name not in ('motion', 'within_level')
        }
        for result in results
        if result['motion'] == 'all'
    }
    text = json.dumps(read_metrics(folder) | named, indent=2)
    atomic_write(folder / METRICS_NAME, f'{text}\n'.encode())
    write_card(folder)


def write_card(folder: Path) -> None:
    """Write README.md of a checkpoint from its weights, config, metrics and progress."""
    weights, config = load_weights(folder)
    results = list(read_metrics(folder).values())
    parameters = sum(array.size for array in weights.values())
    sections = (
        f'# {config.name}',
        description(config, parameters, arrays_digest(weights)),
        training_data(config, folder / CSV_NAME),
        results_section(results),
        limits(results),
        reproduction(folder),
    )
    atomic_write(folder / CARD_NAME, ('\n\n'.join(sections) + '\n').encode())


def description(config: PredictionConfig, parameters: int, digest: str) -> str:
    """Return what the model is and what it is for."""
    width = config.training.width
    return (
        f'Learned prediction of pedestrians: three hidden layers of {width} units, '
        f'{parameters:,} parameters. Each person is seen in their own frame, with '
        f'{LAGS} motions of the last {LAG * (LAGS - 1):g} s and the {NEIGHBOURS} nearest '
        f'agents and obstacles. It gives the position at {len(TIMES)} moments up to '
        f'{TIMES[-1]:g} s and its standard deviation.\n\n'
        f'SHA-256 of the weights: `{digest}`\n\n'
        '## Intended use\n\n'
        'Planning among people, in simulation and research. It is no safety system. It is to be '
        'asked at every step, since it remembers what it saw.'
    )


def training_data(config: PredictionConfig, progress: Path) -> str:
    """Return what the model learned from."""
    crowds, training = config.crowds, config.training
    total = sum(getattr(crowds.mixture, name) for name in SHARES)
    shares = ', '.join(f'{getattr(crowds.mixture, name) / total:.0%} {name}' for name in SHARES)
    text = (
        '## Training data\n\n'
        f'{crowds.groups:,} recordings of {crowds.worlds} simulated worlds and '
        f'{crowds.duration:g} s each, `train` split, seed {config.seed}: {shares}. '
        f'{training.noise.share:.0%} of the batches have noise of up to '
        f'{1.2 * training.noise.position:g} m and {1.2 * training.noise.velocity:g} m/s. '
        f'{training.updates:,} updates; the weights are the best of those seen on '
        f'{crowds.validation_groups} recordings of the `validation` split.'
    )
    if not progress.is_file():
        return text
    with progress.open(newline='', encoding='utf-8') as file:
        last = list(csv.DictReader(file))[-1]
    return f'{text} In all {float(last["processor_seconds"]) / 60:.0f} min of processor.'


def results_section(results: list[dict[str, Any]]) -> str:
    """Return the table of results, empty where there are none."""
    if not results:
        return '## Results\n\nNot measured yet.'
    lines = [
        '## Results',
        '',
        'Mean distance to the truth in metres after 0.25 / 0.5 / 1 / 2 / 3 s, the negative '
        'logarithm of the density that was predicted where people went, in nats (surprise), and '
        'the share of the errors along an axis within one and two of the predicted standard '
        'deviations after the same times (a Gaussian: .68 and .95). Noise is .05 m and .1 m/s. '
        f'Simulated crowds are of the `{results[0]["split"]}` split, seed {results[0]["seed"]}; '
        'those named `recorded` are people of the recordings of ETH and UCY (Pellegrini et al. '
        '2009, Lerner et al. 2007), from which nothing was learned and which do not ship.',
        '',
        '| crowd | noise | people | error | constant velocity | surprise | within 1 | within 2 |',
        '|---|---|---|---|---|---|---|---|',
    ]
    return '\n'.join(lines + [row(result) for result in results])


def row(result: dict[str, Any]) -> str:
    """Return a line of the table."""
    columns = [
        ' / '.join(f'{value:.{digits}f}' for value in result[name])
        for name, digits in (('error', 3), ('constant_velocity', 3), ('surprise', 1),
                             ('within_one', 2), ('within_two', 2))
    ]  # fmt: skip
    cells = [result['crowd'], 'yes' if result['noise'] else 'no', f'{result["people"]:,}']
    return f'| {" | ".join(cells + columns)} |'


LIMITS = """## Limits

- It learned from simulated crowds alone: ORCA of many parameters, people who stop, people who
  avoid nobody, social forces, and walkers in streets.
- Nobody is assumed to see the robot, and walls are not seen but as discs.
- One mode: where somebody may pass on either side, the deviation is wide and the mean on the
  likelier one.
- Two deviations hold 95 % of the errors over all crowds together. Within one there are more than a
  Gaussian has: most people walk straight on, and a few turn or stop at once, farther than that.
- Somebody who is seen for the first time has no history; the deviation is wider, not the truth."""


def limits(results: list[dict[str, Any]]) -> str:
    """Return what to beware of, the crowds that constant velocity predicts better among it."""
    worse = [
        f'{result["crowd"]} ({result["error"][-1] / result["constant_velocity"][-1] - 1:+.0%})'
        for result in results
        if not result['noise'] and result['error'][-1] > result['constant_velocity'][-1]
    ]
    if not worse:
        return LIMITS
    return (
        f'{LIMITS}\n- Constant velocity is nearer to the truth after {TIMES[-1]:g} s for '
        f'{", ".join(worse)}: the network expects people to turn to other goals, as most of those '
        'do whom it learned from.'
    )


def reproduction(folder: Path) -> str:
    """Return the commands that make the model and its results again."""
    place = folder.resolve()
    again = f'out/{place.name}_again'
    recorded = any(name.startswith('recorded') for name in read_metrics(folder))
    files = '--recorded FILE ... ' if recorded else ''
    return (
        '## Reproduce\n\n```\n'
        f'socialnav train-prediction {place.parent.name}/{place.name}/config.yaml --out {again}\n'
        f'socialnav evaluate-prediction {again} {files}--card\n```\n\n'
        'The same machine, thread count and versions of the libraries and of socialnav give the '
        'same weights bit by bit; others give other weights.'
    )
