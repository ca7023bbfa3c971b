"""What was measured of a checkpoint, and its model card."""

import csv
import json
from pathlib import Path
from typing import Any

from socialnav_core.config import Config, ConfigError, TrainingConfig
from socialnav_core.config.planner import PlannerConfig
from socialnav_core.metrics import Metric, Place, shown_in
from socialnav_core.policies.value.checkpoint import Checkpoint
from socialnav_core.prediction import knowledge_of
from socialnav_core.simulation.kinematics import kinematics_of
from socialnav_core.storage import atomic_write, CheckpointError
from socialnav_core.tables import markdown_table, number
from socialnav_core.training.progress import CSV_NAME

AnyConfig = Config | PlannerConfig

METRICS_NAME = 'metrics.json'
CARD_NAME = 'README.md'

NETWORKS = {
    'sarl': 'SARL (Chen et al. 2019, Crowd-Robot Interaction)',
    'gat4sn': 'GAT4SN (graph attention for social navigation)',
    'gat4sn_linear': 'GAT4SN without the LeakyReLU in its attention',
    'gat4sn_v2': 'GAT4SN with the attention of GATv2 (Brody et al. 2022)',
}


def add_result(folder: Path, config: AnyConfig, result: dict[str, Any]) -> None:
    """
    Put an evaluation into the metrics of a checkpoint; an older one of the same kind is replaced.

    Keys are scenarios, followed by what differs from the checkpoint's own settings, such as
    simple+oracle. The list of single cases is left out.

    :param result: of an evaluation, as `socialnav evaluate --json` writes it.
    """
    metrics = read_metrics(folder) | {
        result_key(result, config): {
            name: value for name, value in result.items() if name != 'cases'
        }
    }
    text = json.dumps(dict(sorted(metrics.items())), indent=2)
    atomic_write(folder / METRICS_NAME, f'{text}\n'.encode())


def require_no_better(folder: Path, config: AnyConfig, result: dict[str, Any]) -> None:
    """
    Raise a ConfigError when a result would replace one of more cases, or one of the test split.

    :param result: of an evaluation, or what is known of it before: all that decides its key, split
        and episodes.
    """
    key = result_key(result, config)
    kept = read_metrics(folder).get(key)
    if kept is None:
        return
    of_test = kept['split'] == 'test' != result['split']
    if of_test or result['episodes'] < kept['episodes']:
        raise ConfigError(
            f'the card has {kept["episodes"]:,} {kept["split"]} cases of {key}, this would be '
            f'{result["episodes"]:,} {result["split"]} cases; replace them by --overwrite'
        )


def result_key(result: dict[str, Any], config: AnyConfig) -> str:
    """Return a result's name: its scenario and what differs from the checkpoint's settings."""
    key = '+'.join([result['scenario'], *map(change_text, result.get('changes', {}).items())])
    if result['lookahead'] != config.policy.lookahead:
        key += f'+{result["lookahead"]}'
    screened = isinstance(config, Config) and config.policy.screening.enabled
    if result['screening'] != screened:
        key += '+screening' if result['screening'] else '+no_screening'
    return key


def change_text(change: tuple[str, Any]) -> str:
    """Return the name and value of a setting that was changed, such as `time_limit=35.0`."""
    return '='.join(map(str, change))


def read_metrics(folder: Path) -> dict[str, Any]:
    """
    Return the results of a checkpoint, empty where there are none.

    :raises CheckpointError: when the file holds something else.
    """
    path = folder / METRICS_NAME
    if not path.is_file():
        return {}
    try:
        metrics = json.loads(path.read_text(encoding='utf-8'))
    except (ValueError, RecursionError) as error:
        raise CheckpointError(f'{path} is damaged ({error}); delete it') from error
    if not isinstance(metrics, dict):
        raise CheckpointError(f'{path} holds no results; delete it')
    return metrics


def write_model_card(folder: Path, checkpoint: Checkpoint) -> None:
    """Write README.md of a checkpoint from its weights, config, metrics and progress."""
    network, config, digest = checkpoint
    parameters = sum(parameter.numel() for parameter in network.parameters())
    results = list(read_metrics(folder).values())
    sections = (
        f'# {config.name}',
        description(config, parameters, digest),
        intended_use(config),
        training_data(config, last_row(folder / CSV_NAME)),
        results_section(results),
        limits(config),
        reproduction(folder, results),
    )
    atomic_write(folder / CARD_NAME, ('\n\n'.join(sections) + '\n').encode())


def description(config: Config, parameters: int, digest: str) -> str:
    """
    Return what the model is.

    :param parameters: number of weights.
    """
    policy = config.policy
    count = f'{policy.heads} head{"s" * (policy.heads > 1)}'
    heads = f' with {count}' if policy.network.startswith('gat4sn') else ''
    directions = kinematics_of(policy.kinematics).directions
    return (
        f'Value network {NETWORKS[policy.network]}{heads}, {parameters:,} parameters. Each '
        f'{policy.time_step:g} s a one-step look-ahead ({policy.lookahead}) tries '
        f'{policy.speeds * policy.headings + 1} actions ({policy.speeds} speeds x '
        f'{policy.headings} {directions} and stop; {policy.kinematics}) and takes the one of the '
        f'largest reward plus discounted value. Screening of unsafe actions: '
        f'{"on" if policy.screening.enabled else "off"}.\n\n'
        f'SHA-256 of the weights: `{digest}`'
    )


def intended_use(config: Config) -> str:
    """Return what the model is for."""
    return (
        '## Intended use\n\n'
        f'Driving a {config.policy.kinematics} robot of radius {config.scenario.robot_radius:g} m '
        f'at up to {config.scenario.robot_preferred_speed:g} m/s to a goal among pedestrians and '
        'disc-shaped obstacles, in simulation and research. It is no safety system: a real robot '
        'needs an independent one below it.'
    )


def training_data(config: Config, last: dict[str, float]) -> str:
    """
    Return what the model learned from.

    :param last: last line of the progress report, empty where there is none.
    """
    settings = config.training
    curriculum = settings.curriculum
    lines = [
        '## Training data\n',
        f'Simulated episodes of {worlds_of(config)}, cases of the `train` split, seed '
        f'{config.seed}:\n',
        imitation_line(settings),
        value_learning_line(settings),
        f'- products in {"bfloat16" if settings.bfloat16 else "float32"}, weights in float32.',
    ]
    if curriculum.enabled:
        lines.append(
            f'- curriculum ({curriculum.scheduler}): largest obstacle radius from '
            f'{curriculum.start_radius:g} m to {curriculum.final_radius:g} m by '
            f'{curriculum.radius_step:g} m whenever {curriculum.target_success:.0%} of '
            f'{curriculum.window} episodes succeed.'
        )
    if last:
        spent = last.get('processor_seconds')  # reports of earlier revisions lack it
        minutes = '' if spent is None else f', {spent / 60:.1f} min of processor'
        lines.append(
            f'\nIn all {last["decisions"]:,.0f} decisions and {last["episodes"]:,.0f} episodes '
            f'after imitation{minutes}; largest obstacle radius at the end '
            f'{last["obstacle_radius"]:g} m.'
        )
    return '\n'.join(lines)


def worlds_of(config: Config) -> str:
    """Return which worlds a model learned in."""
    scenario, kinds = config.scenario, config.training.kinds
    if kinds:
        return (
            f'{kinds} kinds of worlds (up to {scenario.pedestrians} ORCA pedestrians and '
            f'{scenario.obstacles} obstacles; speeds, radii, distances and walls drawn)'
        )
    people = f'{scenario.pedestrians} ORCA pedestrians'
    return f'`{scenario.name}` ({people}, {scenario.obstacles} obstacles)'


def imitation_line(settings: TrainingConfig) -> str:
    """Return what came before value learning, a line of a list."""
    imitation = settings.imitation
    space = f'safety space {imitation.safety_space:g} m'
    shown = f'{imitation.episodes:,} episodes of an ORCA robot ({space})'
    if settings.initial_weights:
        return f'- begun with the weights `{settings.initial_weights}`; replayed first: {shown};'
    return f'- imitation: {shown}, {imitation.epochs} epochs;'


def value_learning_line(settings: TrainingConfig) -> str:
    """Return how values were learned, a line of a list."""
    if settings.episodes:
        length = f'{settings.episodes:,} episodes'
    else:
        length = f'{settings.iterations} iterations of {settings.steps_per_iteration} steps'
    if settings.updates_per_episode:
        updates = f'{settings.updates_per_episode} updates an episode'
    else:
        updates = f'{settings.updates_per_iteration} updates each'
    targets = f'Q(lambda) targets with lambda {settings.trace_decay:g}'
    if settings.target_update_episodes:
        targets = f'one-step targets renewed every {settings.target_update_episodes} episodes'
    return (
        f'- value learning: {length} in {settings.worlds} worlds, {updates}, {targets}, '
        f'look-ahead `{settings.lookahead}`;'
    )


def results_section(results: list[dict[str, Any]]) -> str:
    """Return the measurements as a table."""
    if not results:
        return '## Results\n\nNot measured yet; see the last command below.'
    metrics = shown_in(Place.CARD, {name for result in results for name in result})
    head = ['scenario', 'look-ahead', 'knowledge', 'screening', 'cases']
    head += [metric.column_with_unit for metric in metrics]
    return (
        '## Results\n\n'
        'Success with its 95 % Wilson interval; time is the mean over successes.\n\n'
        f'{markdown_table(head, [result_row(result, metrics) for result in results])}'
    )


def result_row(result: dict[str, Any], metrics: list[Metric]) -> list[str]:
    """
    Return the cells of a result: what was run, then the figures.

    :param result: of an evaluation; one that lacks a metric has a dash there.
    """
    return [
        result['scenario'],
        result['lookahead'],
        knowledge_of(result['lookahead']),
        'on' if result['screening'] else 'off',
        f'{result["episodes"]:,} {result["split"]}, seed {result["seed"]}',
        *(card_figure(result, metric) for metric in metrics),
    ]


def card_figure(result: dict[str, Any], metric: Metric) -> str:
    """Return a figure; shares with one more digit than elsewhere, as cards have many cases."""
    digits = metric.digits if metric.unit else metric.digits + 1
    text = number(result.get(metric.name), digits)
    if metric.name != 'success_rate':
        return text
    low, high = (number(end, digits) for end in result['success_interval'])
    return f'{text} [{low}, {high}]'


def limits(config: Config) -> str:
    """Return where the model is not to be trusted."""
    scenario = config.scenario
    seen, people = 'see', 'real people do not follow ORCA'
    speeds, agents = f'{scenario.pedestrian_speed:g} m/s', f'{scenario.agents}'
    if config.training.kinds:
        speeds, agents = 'the speeds drawn for their world', f'up to {agents}'
    if not scenario.robot_visible:
        seen, people = 'do not see', f'{people}, and they do see the robot'
    return (
        '## Limits\n\n'
        '- The network sees positions, velocities and radii without noise or occlusion, and no '
        'walls.\n'
        f'- Its pedestrians follow ORCA at {speeds} and {seen} the robot; {people}.\n'
        f'- It was trained with {agents} agents and obstacles up to '
        f'{scenario.obstacle_radius_max:g} m of radius; more or larger ones are extrapolation.\n'
        + unvaried_features(config)
        + '- `constant_velocity` predicts that people walk straight on; `oracle` knows their next '
        'step, which no robot does.'
    )


def unvaried_features(config: Config) -> str:
    """Return the line on features that never varied, empty where their weights were left alone."""
    if not config.training.fold_constant_features:
        return ''
    return (
        '- The network ignores features that never varied in training, such as a radius common to '
        'all; the collision test of the look-ahead still sees them.\n'
    )


def reproduction(folder: Path, results: list[dict[str, Any]], command: str = 'train') -> str:
    """
    Return the commands that make the model and its results again.

    :param command: of the training.
    """
    place = folder.resolve()
    again = f'out/{place.name}_again'
    source = f'{place.parent.name}/{place.name}/config.yaml'
    commands = [f'socialnav {command} {source} --out {again}']
    screening = {True: ' --screening', False: ' --no-screening'} if command == 'train' else {}
    commands += [
        f'socialnav evaluate {again} --scenario {result["scenario"]} '
        f'--episodes {result["episodes"]} --seed {result["seed"]} --split {result["split"]} '
        f'--lookahead {result["lookahead"]}{screening.get(result["screening"], "")} --card'
        for result in results
    ]
    if not results:
        commands.append(f'socialnav evaluate {again} --scenario simple --card')
    block = '\n'.join(commands)
    return (
        '## Reproduce\n\n'
        f'```\n{block}\n```\n\n'
        'The same machine, thread count and versions of the libraries and of socialnav give the '
        'same weights bit by bit; others give other weights.'
    )


def last_row(path: Path) -> dict[str, float]:
    """Return the last line of a progress report, empty where there is none."""
    if not path.is_file():
        return {}
    with path.open(newline='', encoding='utf-8') as file:
        rows = list(csv.DictReader(file))
    return {name: float(value) for name, value in rows[-1].items()} if rows else {}
