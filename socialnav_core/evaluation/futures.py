"""What the people of some cases will do, whatever the robot does: they do not see it."""

import dataclasses

import numpy as np

from socialnav_core.config import require, Scenario
from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.protocol import make_crowd
from socialnav_core.simulation.motion import TIME_TOLERANCE
from socialnav_core.states import CrowdState

FAR = 1e6
"""Where nobody minds those who are not there, m."""


@dataclasses.dataclass(frozen=True)
class Futures:
    """Some cases from their start to their time limit; a case has `steps` steps."""

    scenario: Scenario
    """Their world."""
    start: CrowdState
    """How they begin."""
    position: np.ndarray
    """Of the agents before each step, m, (cases, steps, agents, 2); of who is not there, FAR."""
    velocity: np.ndarray
    """Of the agents in each step, m/s, (cases, steps, agents, 2)."""


def steps_until_limit(scenario: Scenario) -> int:
    """Return with which step an episode is truncated that nothing else has ended."""
    time, steps = 0.0, 0
    while time < scenario.time_limit - TIME_TOLERANCE:  # as the simulator counts
        time += scenario.time_step
        steps += 1
    return steps


def record_futures(scenario: Scenario, cases: np.ndarray, seed: int, split: str) -> Futures:
    """
    Return what the people of some cases will do, bit by bit as in the simulator.

    :param cases: numbers of the cases.
    :raises ConfigError: when people react to the robot: they have no future without it.
    :raises PackingError: when a layout does not fit.
    """
    require(
        not scenario.robot_matters,
        f'scenario {scenario.name}: what people will do depends on the robot, so that there is no '
        'bound; set scenario.robot_visible=false and scenario.crowd=orca, or take recorded:FILE',
    )
    worlds, steps = np.arange(len(cases)), steps_until_limit(scenario)
    episodes, crowd = Episodes(scenario, len(cases)), make_crowd(scenario, len(cases))
    episodes.begin(seed, split, cases)
    episodes.start(worlds)
    crowd.reset(episodes, worlds)
    start, agents = episodes.state.copy(), episodes.state.agents
    episodes.state.robot.position[:] = FAR  # so that everybody appears, on its start too
    position = np.empty((len(cases), steps, *agents.position.shape[1:]))
    velocity, decided = np.empty_like(position), np.zeros_like(agents.velocity)
    for step in range(steps):
        crowd.decide(episodes, np.ones(len(cases), bool), decided)
        position[:, step] = np.where(agents.valid[..., None], agents.position, FAR)
        velocity[:, step] = decided
        agents.velocity[:] = decided
        agents.position += decided * scenario.time_step
        episodes.state.time += scenario.time_step
        if scenario.renew_goals:
            crowd.renew_goals(episodes)
    return Futures(scenario, start, position, velocity)
