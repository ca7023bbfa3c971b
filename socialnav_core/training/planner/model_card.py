"""The model card of a planner."""

from pathlib import Path

from socialnav_core.config.planner import PlannerConfig
from socialnav_core.policies.search.checkpoint import Planner
from socialnav_core.storage import atomic_write
from socialnav_core.training.model_card import (
    CARD_NAME,
    last_row,
    NETWORKS,
    read_metrics,
    reproduction,
    results_section,
)
from socialnav_core.training.planner.worlds import NAMED, NON_REACTIVE_SHARE
from socialnav_core.training.progress import CSV_NAME

INTENDED_USE = """## Intended use

Driving a robot to a goal among any number of people and disc-shaped obstacles, in simulation and
research. It is no safety system: a real robot needs an independent one below it."""

LIMITS = """## Limits

- It learned among simulated people, who do not see the robot.
- The network sees the nearest 20 people and obstacles, and no walls; the search knows them all.
- The prediction of people (models/prediction) has limits of its own: see its card."""


def write_planner_card(folder: Path, planner: Planner) -> None:
    """Write README.md of a planner from its weights, config, metrics and progress."""
    network, config, digest = planner
    parameters = sum(parameter.numel() for parameter in network.parameters())
    results = list(read_metrics(folder).values())
    sections = (
        f'# {config.name}',
        description(config, parameters, digest),
        INTENDED_USE,
        training_data(config, last_row(folder / CSV_NAME)),
        results_section(results),
        LIMITS,
        reproduction(folder, results, 'train-planner'),
    )
    atomic_write(folder / CARD_NAME, ('\n\n'.join(sections) + '\n').encode())


def description(config: PlannerConfig, parameters: int, digest: str) -> str:
    """
    Return what the model is.

    :param parameters: number of weights.
    """
    policy = config.policy
    base = policy.differential
    drives = (
        ''
        if policy.kinematics == 'holonomic'
        else f' It drives a differential drive of {base.acceleration:g} m/s2, {base.turn_rate:g} '
        f'rad/s and {base.angular_acceleration:g} rad/s2 where nobody hands other limits over, '
        f'backwards at up to {base.reverse:g} of the preferred speed.'
    )
    return (
        f'Search in space and time over {policy.horizon:g} s with a value network at its horizon: '
        f'{NETWORKS[config.network]}, {parameters:,} parameters. People are predicted by '
        f'`{policy.lookahead}`. The network tells what each way on will cost beyond the distance '
        f'to the goal; the cheapest one in all is taken.{drives}\n\n'
        f'SHA-256 of the weights: `{digest}`'
    )


def training_data(config: PlannerConfig, last: dict[str, float]) -> str:
    """
    Return what the model learned from.

    :param last: last line of the progress report, empty where there is none.
    """
    settings, names = config.training, ', '.join(f'`{name}`' for name in NAMED)
    text = (
        '## Training data\n\n'
        f'{settings.rounds} rounds of {settings.groups} worlds x {settings.episodes} episodes, '
        f'cases of the `train` split, seed {config.seed}. {settings.named_share:.0%} of the '
        f'worlds are {names}; the others have 0 to 30 people and up to '
        '10 obstacles, and all radii, speeds, distances and tolerances are drawn anew; in '
        f'{NON_REACTIVE_SHARE:.0%} of these, people avoid nobody. The weights are those of the '
        f'round that drove best in {settings.validation_groups} worlds of the `validation` split.'
    )
    if not last:
        return text
    minutes = last['processor_seconds'] / 60
    return f'{text} In all {last["examples"]:,.0f} examples and {minutes:.0f} min of processor.'
