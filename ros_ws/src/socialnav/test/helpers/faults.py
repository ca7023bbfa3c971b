"""
What goes wrong around a robot, what is said then, and what the robot does: the tests go by it.

`python -m helpers.faults docs/faults.md` writes the page; a test holds the page to this table.
"""

import dataclasses
from pathlib import Path
import sys

from helpers.stops import INPUT_TIMEOUT, LIMIT, PERIOD

TICK = LIMIT - INPUT_TIMEOUT
"""A period, and what a busy machine may add, s."""
SINCE_DECISION = LIMIT + PERIOD
"""Time to a stop where it counts from a decision, which may be a period later, s."""
STANDS, DRIVES, LIMITS = 'stands', 'drives on', 'drives within the limits'


@dataclasses.dataclass(frozen=True)
class Fault:
    """A row of the page; a test takes its words and its time from here."""

    what: str
    """What happens."""
    said: str
    """What is said, or a part of it."""
    does: str = STANDS
    """What the robot does."""
    within: float | None = None
    """Longest time until then, s; None where no time counts."""


INPUTS = {
    'odom missing': Fault('no odometry comes', 'no odom'),
    'pedestrians missing': Fault('no pedestrians come', 'no pedestrians'),
    'obstacles missing': Fault('no obstacles come (`require_obstacles`)', 'no obstacles'),
    'goal missing': Fault('there is no goal', 'no goal_pose'),
    'nobody publishes': Fault('nobody publishes `odom`', 'nobody publishes /odom'),
    'odom of another type': Fault(
        '`odom` comes as another type', 'publishes /odom as geometry_msgs/PoseStamped'
    ),
    'odom stops': Fault('odometry stops', 'odom older than 0.5 s', within=LIMIT),
    'pedestrians stop': Fault('pedestrians stop', 'pedestrians older than 0.5 s', within=LIMIT),
    'obstacles stop': Fault(
        'obstacles stop, `obstacles_timeout` 0.4', 'obstacles older than 0.4 s', within=LIMIT
    ),
    'pedestrian nan': Fault('a pedestrian is at NaN', 'pedestrians: position', within=LIMIT),
    'pedestrian inf': Fault('a velocity is infinite', 'pedestrians: velocity', within=LIMIT),
    'radius negative': Fault('a radius is negative', 'negative radius', within=LIMIT),
    'pedestrians elsewhere': Fault(
        'pedestrians in a frame that nobody knows', "pedestrians: in frame 'camera'", within=LIMIT
    ),
    'list too long': Fault(
        '5,000 pedestrians', 'pedestrians: a message that cannot be read, or is too long',
        within=LIMIT,
    ),
    'obstacle nan': Fault('a radius of an obstacle is NaN', 'obstacles: radius', within=LIMIT),
    'odom inf': Fault('the place of the robot is infinite', 'odom: position', within=LIMIT),
    'odom far': Fault('the place of the robot is beyond 1e9 m', 'odom: position', within=LIMIT),
    'no rotation': Fault('its orientation is no rotation', 'odom: orientation', within=LIMIT),
    'speed nan': Fault('its velocity is NaN', 'odom: velocity', within=LIMIT),
    'turn rate inf': Fault('its turn rate is infinite', 'odom: turn rate', within=LIMIT),
    'twist elsewhere': Fault(
        'its twist is in a frame that is neither `base_frame` nor that of the pose',
        "odom: the twist is in child_frame_id 'camera'", within=LIMIT,
    ),
    'twist nowhere': Fault(
        'odometry has no `child_frame_id`', 'its twist is taken to be in base_link', DRIVES
    ),
    'twist of another frame': Fault(
        'the twist is in the frame of the pose, though `child_frame_id` names the robot',
        'its twist is in the frame of the pose', DRIVES,
    ),
    'pose stands': Fault(
        'the pose of odometry stands while its twist moves',
        'the pose stands while the twist moves', DRIVES,
    ),
    'odom jumps': Fault(
        'the pose jumps farther than the robot can have driven', 'odom jumped by',
        'stands until there is another goal, or the same with another stamp', LIMIT,
    ),
    'people jump': Fault('a pedestrian jumps under its id', 'jumped by', DRIVES),
    'people too fast': Fault(
        'a pedestrian is faster than anybody runs', 'taken to stand', DRIVES
    ),
    'goal nan': Fault('the goal is NaN', 'goal_pose: position', within=LIMIT),
    'goal elsewhere': Fault(
        'the goal is in a frame that nobody knows', "goal_pose: in frame 'map'", within=LIMIT
    ),
    'plan unusable': Fault(
        'a plan ends elsewhere', 'ignored: plan: it ends', 'drives to the goal itself'
    ),
    'plan long': Fault('a plan of 100,000 poses', 'driving', 'follows it, and decides in time'),
    'nothing stands': Fault(
        '`require_obstacles` and `use_map` are false', 'drives into what nobody tells it of',
        DRIVES,
    ),
}  # fmt: skip
CLOCKS = {
    'stamps of the past': Fault(
        'stamps are 5 s old, messages are not', 'has just come: are the clocks in step?',
        within=LIMIT,
    ),
    'stamps of the future': Fault('stamps are 5 s ahead', 'from the future', within=LIMIT),
    'no stamps': Fault('stamps are 0', 'use_sim_time differs between the nodes', within=LIMIT),
    'clock stopped': Fault(
        'the simulated clock stops', 'the clock has stopped', within=SINCE_DECISION
    ),
    'decision hangs': Fault(
        'a decision hangs', 'or the decision hangs', within=SINCE_DECISION
    ),
}  # fmt: skip
PROGRESS = {
    'held': Fault(
        'the robot is commanded and does not move', 'no progress',
        'drives on; said after `progress_timeout` of driving, 10 s',
    ),
    'held for long': Fault(
        'the same for longer', 'it stands until there is another goal',
        'stands after `progress_stop_timeout` of driving, 30 s',
    ),
    'astray': Fault(
        'the robot moves away from its goal', 'but not towards the goal', 'as above, both'
    ),
    'no way': Fault(
        'the policy chooses to stand', 'the policy chooses to stand',
        'as above; drives on when it chooses to drive after 5 s of standing',
    ),
    'nobody listens': Fault('nobody listens to `cmd_vel`', 'nobody listens to /cmd_vel', DRIVES),
    'base of another type': Fault(
        'the base wants TwistStamped and Twist is sent, or the reverse',
        'set enable_stamped_cmd_vel true', DRIVES,
    ),
    'another publisher': Fault(
        'another node publishes `cmd_vel`', 'cmd_vel has other publishers', DRIVES
    ),
}  # fmt: skip
PATHS = {
    'path cancelled': Fault('the client cancels', 'NONE: cancelled', within=TICK),
    'path replaced': Fault(
        'a newer path comes', 'NONE: a newer path has come', 'follows it without a stop'
    ),
    'path empty': Fault('the path is empty', 'INVALID_PATH: path: empty'),
    'path nan': Fault('a place of it is NaN', 'INVALID_PATH: path: position with NaN'),
    'path mixed': Fault(
        'its poses are in different frames', 'INVALID_PATH: path: a pose in another frame'
    ),
    'path elsewhere': Fault(
        'it is in a frame that nobody knows', "TF_ERROR: goal_pose: in frame 'map'"
    ),
    'controller unknown': Fault(
        '`controller_id` is another one', "INVALID_CONTROLLER: there is no 'DWB' here"
    ),
    'checker unknown': Fault(
        '`goal_checker_id` or `progress_checker_id` is another one', 'UNKNOWN: there is no'
    ),
    'path held': Fault(
        'the robot does not move for `progress_timeout`',
        'FAILED_TO_MAKE_PROGRESS: no progress: moved less than',
    ),
    'path without odom': Fault(
        'odometry stops for `input_timeout` and `failure_tolerance`',
        'CONTROLLER_TIMED_OUT: odom older than',
    ),
    'path with nan': Fault(
        'an input is NaN for `failure_tolerance`', 'PATIENCE_EXCEEDED: pedestrians: position'
    ),
    'path with nan at once': Fault(
        'the same, `failure_tolerance` 0', 'NO_VALID_CONTROL: pedestrians: position'
    ),
    'goal cancelled': Fault('`~/cancel_goal` is called', 'UNKNOWN: the goal was cancelled'),
    'path and goal_pose': Fault(
        '`goal_pose` or `plan` comes meanwhile',
        'ignored: goal_pose: a path of follow_path is being followed', 'follows the path',
    ),
    'path deactivated': Fault('`deactivate`', 'UNKNOWN: the node was deactivated'),
    'path too early': Fault('the node is not active', 'the path is not accepted', 'is silent'),
}  # fmt: skip
LIFE = {
    'deactivated': Fault('`deactivate`', 'inactive', 'zero command, then silence'),
    'signal': Fault(
        'SIGINT, SIGTERM or SIGHUP', '', 'a zero command is the last; exit code 0'
    ),
    'policy killed': Fault(
        '`kill -9` of policy_node', '', 'the base brakes after its own time-out', INPUT_TIMEOUT
    ),
    'impossible transition': Fault(
        'a transition that the state does not have', 'no transition', DRIVES
    ),
    'model missing': Fault(
        'the model is missing', 'not configured: no model', 'stands: the node is unconfigured'
    ),
    'impossible value': Fault(
        'a parameter is set to what it cannot be', 'out of range',
        'keeps the present one'
    ),
    'other node': Fault(
        'a parameter file is for another node', 'not for /policy_node', 'has the defaults'
    ),
}  # fmt: skip
BASE = {
    'too fast': Fault('`cmd_vel` is faster than `max_speed`', 'limited', LIMITS),
    'no speed': Fault('`cmd_vel` has NaN, infinity or 1e300', 'ignored: cmd_vel', 'ignores it'),
}
SECTIONS = {
    'Inputs': INPUTS,
    'Clocks and decisions': CLOCKS,
    'Progress and the base': PROGRESS,
    'Paths of nav2 (`follow_path`)': PATHS,
    'Life cycle, processes and parameters': LIFE,
    'The simulated base': BASE,
}
FAULTS = {name: fault for section in SECTIONS.values() for name, fault in section.items()}
PAGE = Path(__file__).parents[5] / 'docs' / 'faults.md'
INTRODUCTION = f"""# What the robot does when ...

Each row is a test with real nodes, from which this page is written (`make docs`). What is said
stands in the log, in `/diagnostics` and on `~/state`, at least in part. Times count from what
happens to the first zero command, at most, with 10 decisions a second, inputs 20 times a second
and `input_timeout` {INPUT_TIMEOUT:g} s; {TICK - PERIOD:.2f} s of it are for a busy machine. A
robot that stands for an input drives on with the next good one.
"""


def page() -> str:
    """Return the page."""
    return INTRODUCTION + ''.join(section(*one) for one in SECTIONS.items())


def section(title: str, rows: dict[str, Fault]) -> str:
    """Return a section of the page."""
    head = '| what happens | what is said | what the robot does | within |\n|---|---|---|---|\n'
    return f'\n## {title}\n\n{head}' + ''.join(row(fault) for fault in rows.values())


def row(fault: Fault) -> str:
    """Return a line of a table."""
    time = '-' if fault.within is None else f'{fault.within:.2f} s'
    said = f'"{fault.said}"' if fault.said else '-'
    return f'| {fault.what} | {said} | {fault.does} | {time} |\n'


if __name__ == '__main__':
    Path(sys.argv[1]).write_text(page())
