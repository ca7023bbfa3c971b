"""Settings of a grid of worlds: tables of one or two axes around one world."""

from collections.abc import Callable, Mapping
import dataclasses
import math
from typing import Any

from socialnav_core.config.bound import BoundConfig
from socialnav_core.config.mapping import (
    ConfigError,
    from_mapping,
    replace,
    require,
    require_choice,
    to_mapping,
    to_yaml,
    unknown_key,
)
from socialnav_core.config.observation import ObservationConfig
from socialnav_core.config.scenario import Scenario
from socialnav_core.config.scenarios import resolve_scenario

TRAVEL = 0.25
"""A goal that is to be so far away may be nearer or farther by this share."""
SPLITS = ('train', 'validation', 'test')


def at_distance(scenario: Scenario, distance: float) -> Scenario:
    """Return a world whose goals are about so far away; it grows where it is too small."""
    wider = max(scenario.spawn_half_width, 0.5 * distance)
    growth = wider / scenario.spawn_half_width
    return dataclasses.replace(
        scenario,
        spawn_half_width=wider,
        start_noise=growth * scenario.start_noise,
        bounds=scenario.bounds + 1.25 * (wider - scenario.spawn_half_width),
        minimum_travel=(1.0 - TRAVEL) * distance,
        maximum_travel=(1.0 + TRAVEL) * distance,
        time_limit=max(1.0, 0.1 * distance) * scenario.time_limit,
    )


def at_speed(scenario: Scenario, speed: float) -> Scenario:
    """Return a world with a robot of another speed, which has the time that it then needs."""
    limit = scenario.time_limit * max(1.0, scenario.robot_preferred_speed / speed)
    return dataclasses.replace(scenario, robot_preferred_speed=speed, time_limit=limit)


def with_walls(scenario: Scenario, walls: bool) -> Scenario:
    """Return a world with its walls or without."""
    return scenario if walls else dataclasses.replace(scenario, bounds=math.inf)


def setting(name: str) -> Callable[[Scenario, Any], Scenario]:
    """Return the axis along which a setting of the scenario changes."""
    return lambda scenario, value: replace(scenario, {name: value}, 'scenario')


AXES: dict[str, Callable[[Scenario, Any], Scenario]] = {
    'people': setting('pedestrians'),
    'obstacles': setting('obstacles'),
    'distance': at_distance,
    'walls': with_walls,
    'tolerance': setting('goal_tolerance'),
    'robot_radius': setting('robot_radius'),
    'robot_speed': at_speed,
    'people_speed': setting('pedestrian_speed'),
    'time_step': setting('time_step'),
}
"""What may change along an axis: the world with another value of it."""
VARIANT = 'variant'
"""An axis whose values are names of settings that are changed together."""
SECTIONS = ('scenario', 'policy', 'observation')
"""What the settings of a variant begin with."""
UNITS = {
    'distance': 'm', 'tolerance': 'm', 'robot_radius': 'm', 'robot_speed': 'm/s',
    'people_speed': 'm/s', 'time_step': 's',
}  # fmt: skip


@dataclasses.dataclass(frozen=True)
class Table:
    """Worlds along one axis or two."""

    name: str
    """What it is called."""
    world: Scenario
    """The world that changes."""
    axes: Mapping[str, tuple[Any, ...]]
    """Names of axes and the values along them; the first goes down, the second to the right."""
    variants: Mapping[str, Mapping[str, Any]] = dataclasses.field(default_factory=dict)
    """The settings that each value of the axis `variant` changes, such as policy.contact."""

    def changes(self, values: Mapping[str, Any], section: str) -> dict[str, Any]:
        """
        Return the settings of a section that the variant of a cell changes, by name.

        :param values: of each axis.
        """
        changed = self.variants.get(values.get(VARIANT, ''), {})
        prefix = f'{section}.'
        return {
            key.removeprefix(prefix): value
            for key, value in changed.items()
            if key.startswith(prefix)
        }


@dataclasses.dataclass(frozen=True)
class GridConfig:
    """Which worlds, and how many cases of each."""

    name: str
    """What it is called."""
    episodes: int
    """Cases of each world."""
    seed: int
    """Seed of the cases."""
    split: str
    """train, validation or test."""
    bound: BoundConfig
    """How finely the bound of each case is searched, where it is asked for."""
    tables: tuple[Table, ...]
    """The tables, each in the order in which it is shown."""


def grid_from(values: Mapping[str, Any], name: str) -> GridConfig:
    """
    Return the grid that the mapping of a file describes.

    :raises ConfigError: for what is unknown, missing or makes no sense.
    """
    known = {'scenario', 'episodes', 'seed', 'split', 'bound', 'tables'}
    for key in values:
        require(key in known, unknown_key('', key, sorted(known)))
    missing = [key for key in sorted(known - {'bound'}) if key not in values]
    require(not missing, f'grid {name}: {" and ".join(missing)} missing')
    for key in ('episodes', 'seed'):
        require(type(values[key]) is int and values[key] >= 0, f'{key} must be a whole number')
    require(values['episodes'] >= 1, 'episodes must be at least 1')
    require_choice('split', values['split'], SPLITS)
    require(isinstance(values['tables'], Mapping), 'tables must be a mapping of tables by name')
    world = resolve_scenario(values['scenario'])
    return GridConfig(
        name, values['episodes'], values['seed'], values['split'],
        from_mapping(BoundConfig, values.get('bound') or {}, 'bound'),
        tuple(table_from(key, table, world) for key, table in values['tables'].items()),
    )  # fmt: skip


def table_from(name: str, values: Any, world: Scenario) -> Table:
    """Return a table; see `grid_from`."""
    where = f'tables.{name}'
    require(isinstance(values, Mapping), f'{where} must be a mapping of axes')
    axes = {key: value for key, value in values.items() if key != 'world'}
    variants = variants_from(axes.get(VARIANT, {}), f'{where}.{VARIANT}')
    if VARIANT in axes:
        axes[VARIANT] = list(variants)
    for axis, along in axes.items():
        require(axis in (*AXES, VARIANT), unknown_key(where, axis, (*AXES, VARIANT)))
        require(isinstance(along, list) and len(along) > 0, f'{where}.{axis} must be a list')
    require(1 <= len(axes) <= 2, f'{where} must have one axis or two')
    base = replace(world, values.get('world') or {}, 'scenario')
    table = Table(name, base, {axis: tuple(along) for axis, along in axes.items()}, variants)
    for variant in variants:
        world_of(table, {VARIANT: variant})
        observation_of(table, {VARIANT: variant})
    return table


def variants_from(values: Any, where: str) -> dict[str, dict[str, Any]]:
    """Return the settings of each variant by its name; see `grid_from`."""
    require(isinstance(values, Mapping), f'{where} must be a mapping of settings by name')
    for name, settings in values.items():
        require(isinstance(name, str), f'{where}: {name!r} is no name')
        require(isinstance(settings, Mapping), f'{where}.{name} must be a mapping of settings')
        for key in settings:
            section = str(key).partition('.')[0]
            require(section in SECTIONS, unknown_key(f'{where}.{name}', str(key), SECTIONS))
    return {name: dict(settings) for name, settings in values.items()}


def world_of(table: Table, values: Mapping[str, Any]) -> Scenario:
    """
    Return the world of a cell.

    :param values: of each axis of the table.
    :raises ConfigError: when there is no such world.
    """
    scenario, words = table.world, []
    for axis, value in values.items():
        if axis == VARIANT:
            scenario = replace(scenario, table.changes(values, 'scenario'), 'scenario')
            words.append(str(value))
            continue
        try:
            scenario = AXES[axis](scenario, value)
        except TypeError as error:
            raise ConfigError(f'tables.{table.name}.{axis} cannot be {value!r}') from error
        words.append(f'{axis} {value}')
    return dataclasses.replace(scenario, name=' '.join(words))


def observation_of(table: Table, values: Mapping[str, Any]) -> ObservationConfig | None:
    """
    Return how people are seen in a cell; None where they are seen as they are.

    :param values: of each axis of the table.
    :raises ConfigError: for settings that do not exist.
    """
    changes = table.changes(values, 'observation')
    return replace(ObservationConfig(), changes, 'observation') if changes else None


def grid_mapping(config: GridConfig) -> dict[str, Any]:
    """Return plain values that tell one grid from another, fit for JSON."""
    values = to_mapping(config)
    values['tables'] = [
        {'name': table.name, 'world': to_yaml(table.world),
         'axes': {axis: list(along) for axis, along in table.axes.items()},
         'variants': table.variants}
        for table in config.tables
    ]  # fmt: skip
    return values
