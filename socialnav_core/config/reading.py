"""A training configuration, from a YAML file and changes to it."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any, TypeVar

from socialnav_core.config.documents import read_yaml, told_with_place
from socialnav_core.config.grid import grid_from, GridConfig
from socialnav_core.config.mapping import assign, ConfigError, from_mapping, to_mapping
from socialnav_core.config.planner import PlannerConfig
from socialnav_core.config.prediction import PredictionConfig
from socialnav_core.config.ranges import shown
from socialnav_core.config.scenarios import resolve_scenario
from socialnav_core.config.training import Config

Settings = TypeVar('Settings', bound=Any)

RECIPES = Path(__file__).parent / 'recipes'
PREDICTIONS = RECIPES / 'prediction'
PLANNERS = RECIPES / 'planner'
GRIDS = RECIPES / 'grid'
SHARED = ('kinematics', 'time_step', 'goal_tolerance', 'reward')


def read_config(source: str | Path, assignments: Mapping[str, Any] | None = None) -> Config:
    """
    Return a complete configuration.

    The scenario is a name, or a mapping with a name and the settings that differ from it. What
    scenario and policy share (time step, reward, ...) is taken from the scenario.

    :param source: a YAML file, or the name of one that comes with the package, such as sarl.
    :param assignments: dotted settings and their values, such as {'training.worlds': 64}.
    :raises ConfigError: when the file or a setting does not exist or makes no sense.
    """
    path = find_config(source, RECIPES)
    values = read_values(path, assignments or {})
    with told_with_place(path, assignments or {}):
        if 'scenario' not in values:
            raise ConfigError('there is no scenario; add a line such as scenario: simple')
        scenario = resolve_scenario(values['scenario'])
        policy = values.get('policy') or {}
        values |= {'scenario': scenario, 'policy': with_shared(policy, to_mapping(scenario))}
        return from_mapping(Config, values)


def read_prediction_config(
    source: str | Path, assignments: Mapping[str, Any] | None = None
) -> PredictionConfig:
    """
    Return a complete configuration of the learned prediction.

    :param source: a YAML file, or the name of one that comes with the package, such as mixed.
    :param assignments: dotted settings and their values, such as {'training.updates': 1000}.
    :raises ConfigError: when the file or a setting does not exist or makes no sense.
    """
    return read_as(PredictionConfig, find_config(source, PREDICTIONS), assignments or {})


def read_planner_config(
    source: str | Path, assignments: Mapping[str, Any] | None = None
) -> PlannerConfig:
    """
    Return a complete configuration of a planner.

    :param source: a YAML file, or the name of one that comes with the package, such as socialnav.
    :param assignments: dotted settings and their values, such as {'training.rounds': 2}.
    :raises ConfigError: when the file or a setting does not exist or makes no sense.
    """
    return read_as(PlannerConfig, find_config(source, PLANNERS), assignments or {})


def read_as(kind: type[Settings], path: Path, assignments: Mapping[str, Any]) -> Settings:
    """Return what a file says, changed by assignments, as a dataclass."""
    values = read_values(path, assignments)
    with told_with_place(path, assignments):
        return from_mapping(kind, values)


def read_grid_config(source: str | Path) -> GridConfig:
    """
    Return a grid of worlds.

    :param source: a YAML file, or the name of one that comes with the package, such as full.
    :raises ConfigError: when the file or a setting does not exist or makes no sense.
    """
    path = find_config(source, GRIDS)
    return grid_from(read_yaml(path), path.stem)


def read_values(path: Path, assignments: Mapping[str, Any]) -> dict[str, Any]:
    """Return what a file says, changed by assignments; its name is that of the file by default."""
    values: dict[str, Any] = {'name': path.stem} | read_yaml(path)
    for key, value in assignments.items():
        if key.startswith('scenario.') and isinstance(values.get('scenario'), str):
            values['scenario'] = {'name': values['scenario']}
        assign(values, key, value)
    return values


def find_config(source: str | Path, folder: Path) -> Path:
    """
    Return the file of a configuration.

    :param source: a path, or the name of a file of the package without its ending.
    :param folder: of the package's files.
    :raises ConfigError: when there is neither.
    """
    path, packaged = Path(source), folder / f'{source}.yaml'
    if path.is_file():
        return path
    if packaged.is_file():
        return packaged
    names = ', '.join(sorted(each.stem for each in folder.glob('*.yaml')))
    raise ConfigError(f'{source} is neither a file nor one of the configurations {names}')


def with_shared(policy: Mapping[str, Any], scenario: Mapping[str, Any]) -> dict[str, Any]:
    """
    Return the settings of a policy, completed by those that it has from the scenario.

    :raises ConfigError: when the policy has another value than the scenario.
    """
    if not isinstance(policy, Mapping):
        raise ConfigError(f'policy must be a mapping, not {shown(policy)}', 'policy')
    for name in SHARED:
        if name in policy and policy[name] != scenario[name]:
            raise ConfigError(
                f'policy.{name} is {shown(policy[name])} but scenario.{name} is '
                f'{shown(scenario[name])}; set it in the scenario alone',
                f'policy.{name}',
            )
    return dict(policy) | {name: scenario[name] for name in SHARED}
