"""Every parameter of every node, in one table each: name, default, range, unit, description."""

from collections.abc import Callable
import dataclasses
import math
from typing import Any

from rcl_interfaces.msg import (
    FloatingPointRange,
    IntegerRange,
    ParameterDescriptor,
    SetParametersResult,
)
from rclpy.exceptions import InvalidParameterTypeException, InvalidParameterValueException
from rclpy.node import Node

from socialnav_core.config.mapping import unknown_key

DEFAULT_MODEL = 'gat4sn'


class ParameterError(ValueError):
    """A parameter that a node cannot start with; the text is one line that says what to do."""


@dataclasses.dataclass(frozen=True)
class Entry:
    """One parameter."""

    name: str
    """Its name."""
    default: Any
    """Its default, which fixes its type."""
    description: str
    """What it does."""
    unit: str = ''
    """Unit, if it has one."""
    range: tuple[float, float] | None = None
    """Smallest and largest value."""
    choices: tuple[str, ...] = ()
    """All values of a text that has only few."""
    live: str = 'no'
    """Whether it can be changed while the node runs: yes, no or only while it is inactive."""


OF_EVERY_NODE = ('use_sim_time', 'start_type_description_service', 'qos_overrides.')
"""How parameters begin that rclpy declares itself."""
KINEMATICS = ('holonomic', 'differential')

SIMULATOR_PARAMETERS = (
    Entry('scenario', 'hard', 'world to simulate; `socialnav scenarios` lists them'),
    Entry('seed', 0, 'seed of the test cases 0, 1, 2, ...', range=(0, 10**9)),
    Entry('episodes', 0, 'episodes to run before the world stands; 0: endless', range=(0, 10**6)),
    Entry('lockstep', False, 'one step of the world per command instead of real time'),
    Entry('real_time_factor', 1.0, 'simulated time per real time', '', (0.01, 100.0), live='yes'),
    Entry('publish_rate', 20.0, 'states published per second (real time)', 'Hz', (1.0, 1000.0)),
    Entry(
        'cmd_vel_timeout', 0.5, 'simulated time without a command after which the robot brakes',
        's', (0.05, 10.0), live='yes',
    ),
    Entry('kinematics', 'holonomic', 'how the robot moves', choices=KINEMATICS),
    Entry('robot_visible', False, 'whether pedestrians see the robot and avoid it'),
    Entry('enable_stamped_cmd_vel', False, 'TwistStamped instead of Twist; lockstep always does'),
    Entry('publish_clock', False, 'publish /clock and stamp everything with simulated time'),
    Entry('publish_scan', False, 'publish what a laser scanner on the robot measures'),
    Entry('scan_beams', 360, 'beams of the scanner, all around', '', (1, 100_000)),
    Entry('scan_range', 10.0, 'longest range of the scanner', 'm', (0.1, 1000.0)),
    Entry('scan_noise', 0.0, 'standard deviation of a range', 'm', (0.0, 10.0)),
    Entry('publish_detections', False, 'publish where a detector sees pedestrians'),
    Entry(
        'detection_noise', 0.0, 'standard deviation of a detection along each axis',
        'm', (0.0, 10.0),
    ),
    Entry('missed_detections', 0.0, 'probability that a pedestrian is missed', '', (0.0, 1.0)),
    Entry('detection_occlusion', False, 'detect only whom some beam of the scanner reaches'),
    Entry('map_frame', 'map', 'frame of the map; it coincides with odom_frame'),
    Entry('odom_frame', 'odom', 'frame of everything else'),
    Entry('base_frame', 'base_link', 'frame of the robot'),
)  # fmt: skip

POLICY_PARAMETERS = (
    Entry('autostart', True, 'configure and activate at start, without a lifecycle manager'),
    Entry(
        'model', DEFAULT_MODEL, 'name in the share folder, path, `orca` or `straight_line`',
        live='inactive',
    ),
    Entry(
        'screening', 'checkpoint',
        'refuse actions after which a collision is certain; checkpoint: as saved',
        choices=('checkpoint', 'enabled', 'disabled'), live='inactive',
    ),
    Entry(
        'screening_horizon', 0.0, 'how long the way of escape must stay free; 0: as saved',
        's', (0.0, 10.0), live='inactive',
    ),
    Entry('lockstep', False, 'decide once per state of a simulator in lockstep', live='inactive'),
    Entry(
        'scenario', 'hard', 'world that gives radius, speed and bounds in lockstep',
        live='inactive',
    ),
    Entry(
        'controller_frequency', 10.0, 'decisions per second', 'Hz', (1.0, 100.0), live='inactive',
    ),
    Entry(
        'input_timeout', 0.5, 'age of odom or pedestrians at which the robot stops',
        's', (0.05, 10.0), live='yes',
    ),
    Entry(
        'obstacles_timeout', 0.0, 'age of obstacles at which the robot stops; 0: they do not age',
        's', (0.0, 3600.0), live='yes',
    ),
    Entry('require_obstacles', False, 'stand until obstacles have come', live='yes'),
    Entry(
        'use_map', False, 'occupied cells of the map near the robot are obstacles; stand without',
        live='inactive',
    ),
    Entry(
        'plan_lookahead_distance', 2.0, 'way along a plan to the point that is headed for',
        'm', (0.1, 100.0), live='yes',
    ),
    Entry(
        'plan_timeout', 0.0, 'age of a plan at which the goal itself is headed for; 0: never',
        's', (0.0, 3600.0), live='yes',
    ),
    Entry(
        'stop_publish_timeout', 10.0, 'go silent after nothing but stops for so long; 0: never',
        's', (0.0, 3600.0), live='yes',
    ),
    Entry(
        'bounds', math.inf, 'half-width of the square around the origin not to be left',
        'm', (0.1, math.inf), live='yes',
    ),
    Entry('robot_radius', 0.3, 'radius of the robot', 'm', (0.05, 5.0), live='yes'),
    Entry('preferred_speed', 1.0, 'speed to drive at', 'm/s', (0.05, 5.0), live='yes'),
    Entry('kinematics', 'holonomic', 'how the robot moves', choices=KINEMATICS, live='inactive'),
    Entry('max_speed', 1.0, 'no command is faster', 'm/s', (0.0, 5.0), live='yes'),
    Entry(
        'max_acceleration', math.inf, 'no command changes the velocity faster',
        'm/s^2', (0.01, math.inf), live='yes',
    ),
    Entry('max_turn_rate', math.pi, 'no command turns faster', 'rad/s', (0.0, 20.0), live='yes'),
    Entry(
        'goal_tolerance', 0.3, 'distance to the goal at which it is reached',
        'm', (0.01, 5.0), live='yes',
    ),
    Entry('max_agents', 20, 'only the nearest so many agents count', '', (1, 1000), live='yes'),
    Entry(
        'planning_frame', 'odom', 'frame of decisions; inputs in others need tf2_ros',
        live='inactive',
    ),
    Entry('base_frame', 'base_link', 'frame of stamped commands', live='inactive'),
    Entry(
        'enable_stamped_cmd_vel', False, 'TwistStamped instead of Twist; lockstep always does',
        live='inactive',
    ),
    Entry(
        'device', 'cpu', 'where the network is computed', choices=('cpu', 'cuda'),
        live='inactive',
    ),
    Entry('threads', 1, 'threads of a decision', '', (1, 64), live='inactive'),
)  # fmt: skip


def requirement(entry: Entry) -> str:
    """
    Return what a value must be, in words.

    :param entry: the parameter.
    """
    if entry.choices:
        return f'must be one of {", ".join(entry.choices)}'
    kind = {bool: 'true or false', int: 'a whole number', str: 'a text'}.get(
        type(entry.default), 'a number with a decimal point'
    )
    if entry.range is None:
        return f'must be {kind}'
    low, high = entry.range
    return f'must be {kind} in [{low:g}, {high:g}]{" " + entry.unit if entry.unit else ""}'


def complaint(entry: Entry, value: object) -> str | None:
    """
    Return what is wrong with a value of the right type, or None.

    :param entry: the parameter.
    :param value: what was given.
    """
    low, high = entry.range or (-math.inf, math.inf)
    if entry.choices and value not in entry.choices:
        return f'{entry.name} {requirement(entry)}, not {value!r}'
    if entry.range and not low <= value <= high:  # type: ignore[operator]
        return f'{entry.name} {requirement(entry)}, not {value!r}'
    return None


def descriptor(entry: Entry) -> ParameterDescriptor:
    """
    Return what `ros2 param describe` shows.

    :param entry: the parameter.
    """
    unit = f' [{entry.unit}]' if entry.unit else ''
    result = ParameterDescriptor(name=entry.name, description=entry.description + unit)
    result.additional_constraints = requirement(entry)
    if entry.range and isinstance(entry.default, int):
        low, high = entry.range
        result.integer_range = [IntegerRange(from_value=int(low), to_value=int(high), step=1)]
    elif entry.range:
        low, high = entry.range
        result.floating_point_range = [FloatingPointRange(from_value=low, to_value=high)]
    return result


def declare(
    node: Node, table: tuple[Entry, ...], active: Callable[[], bool] = lambda: True
) -> dict[str, Any]:
    """
    Declare all parameters of a node and return their values.

    From then on, a change is refused unless the entry is live and the value in its range.

    :param node: whose parameters they are.
    :param table: the entries.
    :param active: tells whether the node drives.
    :raises ParameterError: a value of the wrong type or outside of its range, or an unknown name.
    """
    refuse_unknown(node, [entry.name for entry in table])
    values = {entry.name: declared(node, entry) for entry in table}
    node.add_on_set_parameters_callback(lambda changes: judged(table, changes, active()))
    return values


def refuse_unknown(node: Node, known: list[str]) -> None:
    """
    Raise a ParameterError where a value was given to a parameter that does not exist.

    rclpy ignores it, so that a robot would drive with the default of what was mistyped; nothing
    that is public in rclpy tells what was given.

    :param node: that has been started with parameters.
    :param known: names of all parameters of the node.
    """
    for name in node._parameter_overrides:
        if name not in known and not name.startswith(OF_EVERY_NODE):
            raise ParameterError(unknown_key('', name, known))


def declared(node: Node, entry: Entry) -> Any:
    """
    Declare one parameter and return its value.

    :param node: whose parameter it is.
    :param entry: the parameter.
    """
    try:
        value = node.declare_parameter(entry.name, entry.default, descriptor(entry)).value
    except (InvalidParameterTypeException, InvalidParameterValueException):
        raise ParameterError(f'parameter {entry.name} {requirement(entry)}') from None
    if (text := complaint(entry, value)) is not None:
        raise ParameterError(f'parameter {text}')
    return value


def judged(table: tuple[Entry, ...], changes: list, active: bool) -> SetParametersResult:
    """
    Return whether changes of a running node are accepted, and why not.

    :param table: the entries.
    :param changes: parameters of rclpy.
    :param active: whether the node drives.
    """
    entries = {entry.name: entry for entry in table}
    for change in changes:
        entry = entries.get(change.name)
        reason = None if entry is None else refusal(entry, change.value, active)
        if reason is not None:
            return SetParametersResult(successful=False, reason=reason)
    return SetParametersResult(successful=True)


def refusal(entry: Entry, value: object, active: bool) -> str | None:
    """
    Return why a running node refuses a value, or None.

    :param entry: the parameter.
    :param value: what it should become.
    :param active: whether the node drives.
    """
    if entry.live == 'no':
        return f'{entry.name} cannot change while the node runs: start it with another value'
    if entry.live == 'inactive' and active:
        return f'{entry.name} cannot change while the node drives: deactivate it first'
    return complaint(entry, value)


def fixed_values(table: tuple[Entry, ...], values: dict[str, Any]) -> dict[str, Any]:
    """
    Return the values that cannot change while a node drives.

    :param table: the entries.
    :param values: of all parameters.
    """
    return {entry.name: values[entry.name] for entry in table if entry.live != 'yes'}
