"""The named scenarios: families of worlds, by name."""

from collections.abc import Mapping
import dataclasses
import difflib
import math
from pathlib import Path
import re
from typing import Any

from socialnav_core.config.documents import read_yaml, told_with_place
from socialnav_core.config.mapping import (
    ConfigError,
    flatten,
    from_mapping,
    replace,
    to_mapping,
)
from socialnav_core.config.ranges import shown
from socialnav_core.config.recorded import recorded_interval, RECORDED_NAME, recorded_scenario
from socialnav_core.config.scenario import OrcaConfig, RewardConfig, Scenario

CURRICULUM_RADIUS = (0.3, 2.5)

_LARGE_WORLD = {
    'spawn_half_width': 7.5, 'bounds': 10.0, 'minimum_travel': 10.0, 'obstacles': 10,
    'hardest_obstacle_ratio': 0.2,
}  # fmt: skip

_FIXED = {
    'simple': Scenario('simple'),
    'hard': Scenario('hard', obstacle_radius_min=0.5, obstacle_radius_max=1.5),
    'simple10': Scenario('simple10', obstacles=10),
    'crowd20': Scenario('crowd20', pedestrians=20, obstacles=0),
    'crowd20_random': Scenario(
        'crowd20_random',
        pedestrians=20,
        obstacles=0,
        layout='open_square',
        spawn_half_width=6.0,
        circle_radius=6.0 * math.sqrt(2.0),
        minimum_travel=8.0,
        bounds=math.inf,
        randomize_attributes=True,
        crowd='changing',
        time_limit=49.0,
        orca=OrcaConfig(max_neighbors=19, safety_space=0.15),
        reward=RewardConfig(walls_discomfort=False),
    ),
    'plaza': Scenario(
        'plaza',
        pedestrians=20,
        obstacle_radius_min=0.2,
        obstacle_radius_max=1.5,
        spawn_half_width=8.0,
        minimum_travel=8.0,
        bounds=10.5,
        time_limit=40.0,
    ),
    'circle': Scenario(
        'circle',
        obstacles=0,
        layout='circle_crossing',
        bounds=math.inf,
        renew_goals=False,
        orca=OrcaConfig(static_responsibility=1.0),
        reward=RewardConfig(walls_discomfort=False),
    ),
}

SCENARIOS = {
    'simple': '5 pedestrians and 5 obstacles of radius 0.3 m',
    'hard': '5 pedestrians and 5 obstacles of radius 0.5 to 1.5 m',
    'simple10': '5 pedestrians and 10 obstacles of radius 0.3 m',
    'crowd20': '20 pedestrians, no obstacles',
    'crowd20_random': '20 pedestrians of all speeds and sizes who come, change goals and go',
    'plaza': '20 pedestrians and 5 obstacles of radius 0.2 to 1.5 m, 21 m world',
    'curriculum-R': '5 pedestrians and 10 obstacles up to radius R (0.3 to 2.5 m), 20 m world',
    'packed-R': 'the same as curriculum-R in a 15 m world',
    'circle': '5 pedestrians cross a circle of radius 4 m, no obstacles, no walls',
    'recorded:FILE': 'recorded people of a file of lines `frame person x y`, who react to nobody',
    'recorded_reactive:FILE': 'the same people, who avoid the robot where it is near',
}
"""Names of the scenarios and what they are; R stands for a number, FILE for a path."""


def make_scenario(name: str, settings: Mapping[str, Any] | None = None) -> Scenario:
    """
    Return the scenario of a name.

    :param name: a key of SCENARIOS, with a number for R, such as curriculum-1.5.
    :param settings: by dotted name, that will be changed; how many recorded people there are at
        a time depends on recording.interval. They are not changed here.
    :raises ConfigError: when there is none.
    """
    if name in _FIXED:
        return _FIXED[name]
    recorded = RECORDED_NAME.fullmatch(name)
    if recorded:
        crowd, file = recorded.groups()
        return recorded_scenario(name, crowd, file, recorded_interval(settings or {}))
    family, _, text = name.partition('-')
    if family in ('curriculum', 'packed') and re.fullmatch(r'[0-9]{1,9}(\.[0-9]{1,9})?', text):
        return growing_scenario(family, float(text))
    nearest = difflib.get_close_matches(name[:100], SCENARIOS, n=1, cutoff=0.4)
    hint = f'did you mean {nearest[0]}? ' if nearest else ''
    raise ConfigError(f'unknown scenario {shown(name)}; {hint}there are: {", ".join(SCENARIOS)}')


def growing_scenario(family: str, radius: float) -> Scenario:
    """
    Return the world of a level of the curriculum.

    :param family: curriculum (larger world) or packed.
    :param radius: largest obstacle radius, m.
    :raises ConfigError: for a radius outside of CURRICULUM_RADIUS.
    """
    low, high = CURRICULUM_RADIUS
    if not low <= radius <= high:
        raise ConfigError(f'{family}-R takes R from {low} to {high} m, not {radius:g}')
    world: dict[str, Any] = {'obstacles': 10, 'hardest_obstacle_ratio': 0.2}
    if family == 'curriculum':
        world = _LARGE_WORLD
    return Scenario(f'{family}-{radius:g}', obstacle_radius_max=radius, **world)


def resolve_scenario(value: str | Mapping[str, Any]) -> Scenario:
    """
    Return the scenario of a name, or of a mapping with a name and settings that differ.

    A mapping with a name of one's own must hold every setting.

    :param value: as found in a YAML file, such as {'name': 'hard', 'time_limit': 35}.
    :raises ConfigError: for an unknown name or setting.
    """
    if isinstance(value, str):
        return make_scenario(value)
    if not isinstance(value, Mapping) or not isinstance(value.get('name'), str):
        raise ConfigError('scenario must be a name or a mapping with a name', 'scenario')
    settings = flatten({key: setting for key, setting in value.items() if key != 'name'})
    try:
        known = make_scenario(value['name'], settings)
    except ConfigError as error:
        require_complete(settings, error)
        return from_mapping(Scenario, value, 'scenario')
    return replace(known, settings, 'scenario')


def require_complete(settings: Mapping[str, Any], unknown: ConfigError) -> None:
    """
    Raise a ConfigError unless settings say everything about a world but its name.

    :param unknown: why its name is none of the package's.
    """
    everything = flatten(to_mapping(_FIXED['simple']))
    missing = sorted(everything.keys() - settings.keys() - {'name'})
    if missing:
        raise ConfigError(
            f'{unknown}; a scenario of your own must say everything, and {", ".join(missing[:3])}'
            f'{" ..." * (len(missing) > 3)} is missing: begin with what socialnav scenarios hard '
            'prints',
            'scenario.name',
        )


def read_scenario(path: Path) -> Scenario:
    """
    Return the scenario of a file, as `socialnav scenarios NAME` prints them.

    :raises ConfigError: when the file or a setting does not exist or makes no sense.
    """
    values = read_yaml(path)
    try:
        return resolve_scenario(values)
    except ConfigError as error:
        key = error.key.removeprefix('scenario.')
        with told_with_place(path, {}):
            raise ConfigError(str(error), key) from error


def changes_of(scenario: Scenario) -> dict[str, Any]:
    """Return the settings in which a scenario differs from the package's of its name, dotted."""
    try:
        plain = make_scenario(scenario.name)
    except ConfigError:  # a name of one's own says that it is another world
        return {}
    known = flatten(to_mapping(plain))
    return {
        name: value
        for name, value in flatten(to_mapping(scenario)).items()
        if value != known[name]
    }


def title_of(name: str, changes: Mapping[str, Any]) -> str:
    """
    Return what texts call a scenario: its name, and what was changed.

    :param changes: see `changes_of`.
    """
    return f'{name} with {", ".join(f"{k}={v}" for k, v in changes.items())}' if changes else name


def with_obstacle_radius(scenario: Scenario, radius: float) -> Scenario:
    """Return the scenario with another largest obstacle radius; a level is named after it."""
    family, dash, _ = scenario.name.partition('-')
    name = f'{family}-{radius:g}' if dash else scenario.name
    return dataclasses.replace(scenario, name=name, obstacle_radius_max=radius)
