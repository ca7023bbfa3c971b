"""An episode kept step by step, for pictures."""

import dataclasses

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.config.scenarios import changes_of
from socialnav_core.policies.protocol import Policy, PolicyDescription, require_same_kinematics
from socialnav_core.prediction.oracle import attach_simulator
from socialnav_core.simulation import Outcome, Simulator
from socialnav_core.simulation.kinematics import limits_of
from socialnav_core.states import CrowdState

OUTCOMES = {
    'goal': 'goal reached',
    'collision_pedestrian': 'collision with a pedestrian',
    'collision_obstacle': 'collision with an obstacle',
    'out_of_bounds': 'left the world',
    'timeout': 'time is up',
}
"""How each outcome is called in pictures."""


@dataclasses.dataclass
class Recording:
    """An episode of one world: every state, and how it ended."""

    states: list[CrowdState]
    """States of a batch of one, the start first, the end last."""
    scenario: str
    """Name of the scenario."""
    seed: int
    """Seed of the case."""
    case_index: int
    """Index of the case."""
    outcome: str
    """goal, collision_pedestrian, collision_obstacle, out_of_bounds or timeout."""
    policy: str
    """Name of the policy."""
    attention: list[np.ndarray] | None = None
    """Attention to each agent in each state but the last, (agents,), where the policy has any."""
    closest: list[float] | None = None
    """Least gap to any agent during each step, m; computed from the states where it is absent."""
    commands: list[np.ndarray] | None = None
    """What the policy chose in each state but the last, (2,), where that is known; see Policy."""
    kinematics: str = 'holonomic'
    """Motion of the robot: holonomic or differential."""
    goal_tolerance: float = 0.3
    """Distance at which the goal counts as reached, m."""
    description: PolicyDescription | None = None
    """What the policy is, where that is known."""

    @property
    def look_ahead(self) -> str | None:
        """Return the policy's prediction and what that knows; None where there is none."""
        return self.description.look_ahead if self.description else None

    @property
    def times(self) -> np.ndarray:
        """Return the time of each state, s, (states,)."""
        return np.array([state.time[0] for state in self.states])

    @property
    def robot_path(self) -> np.ndarray:
        """Return the robot's positions, m, (states, 2)."""
        return np.array([state.robot.position[0] for state in self.states])

    @property
    def agent_paths(self) -> np.ndarray:
        """Return the agents' positions, m, NaN where one is not there, (states, agents, 2)."""
        return np.array([
            np.where(state.agents.valid[0, :, None], state.agents.position[0], np.nan)
            for state in self.states
        ])  # fmt: skip

    @property
    def ever_there(self) -> np.ndarray:
        """Return which agents are there in any state, bool, (agents,)."""
        return np.any([state.agents.valid[0] for state in self.states], axis=0)

    @property
    def minimum_clearance(self) -> float:
        """Return the least gap between the robot's rim and an agent's, m, inf without agents."""
        if self.closest is not None:
            return min(self.closest, default=np.inf)
        return min(clearance(state) for state in self.states)


def summary(recording: Recording) -> str:
    """Return on one line how an episode ended, when, how near the robot came to anybody."""
    return f'{OUTCOMES[recording.outcome]}, {figures(recording)}'


def figures(recording: Recording) -> str:
    """Return when an episode ended and how near the robot came to anybody."""
    closest = recording.minimum_clearance
    near = f', closest {max(closest, 0.0):.2f} m' if np.isfinite(closest) else ''
    return f'{recording.times[-1]:.2f} s{near}'


def clearance(state: CrowdState) -> float:
    """Return the gap of rims of robot and nearest agent, batch of one, m, inf without agents."""
    offset = state.agents.position[0] - state.robot.position[0]
    gaps = np.linalg.norm(offset, axis=-1) - state.agents.radius[0] - state.robot.radius[0]
    return float(gaps[state.agents.valid[0]].min(initial=np.inf))


def state_at(recording: Recording, time: float) -> CrowdState:
    """
    Return the state of a moment between two recorded ones, with the velocities then under way.

    :param time: s; moments before the start or after the end give the first or the last state.
    """
    times = recording.times
    after = int(np.searchsorted(times, time))
    if after == 0 or after == len(times):
        return recording.states[min(after, len(times) - 1)]
    earlier, later = recording.states[after - 1], recording.states[after]
    share = (time - times[after - 1]) / (times[after] - times[after - 1])
    turn = np.angle(np.exp(1j * (later.robot.heading - earlier.robot.heading)))
    moved = later.with_robot(
        position=_blend(earlier.robot.position, later.robot.position, share),
        heading=earlier.robot.heading + share * turn,
    ).with_agents(
        position=_blend(earlier.agents.position, later.agents.position, share),
        valid=earlier.agents.valid,  # who is in the later state alone comes with it
    )
    return dataclasses.replace(moved, time=np.array([time]))


def record(
    policy: Policy,
    scenario: Scenario,
    seed: int = 0,
    case_index: int = 0,
    split: str = 'test',
    name: str = '',
) -> Recording:
    """
    Run one case and keep every state.

    :param name: name of the policy, for titles.
    :raises ConfigError: when the policy drives another kind of robot.
    """
    require_same_kinematics(policy, scenario)
    limits = limits_of(scenario)
    simulator = Simulator(scenario, batch_size=1)
    states = [simulator.reset(seed=seed, split=split, cases=[case_index])]
    policy.reset()
    attach_simulator(policy.predictor, simulator.next_agent_velocities)
    attention: list[np.ndarray] = []
    closest: list[float] = []
    commands: list[np.ndarray] = []
    ended = False
    while not ended:
        weights = policy.attention(states[-1])
        if weights is not None:
            attention.append(weights[0])
        commands.append(policy.act(states[-1], limits)[0])
        _, _, terminated, truncated, info = simulator.step(commands[-1][None])
        states.append(info['final_state'])
        closest.append(float(info['clearance'][0]))
        ended = bool(terminated[0] or truncated[0])
    outcome = Outcome(int(info['outcome'][0])).name.lower()
    return Recording(
        states, name_with_mark(scenario), seed, case_index, outcome, name, attention or None,
        closest, commands, scenario.kinematics, scenario.goal_tolerance, policy.description,
    )  # fmt: skip


def name_with_mark(scenario: Scenario) -> str:
    """Return the name of a scenario, marked where it is not the one of that name."""
    return f'{scenario.name} (changed)' if changes_of(scenario) else scenario.name


def _blend(first: np.ndarray, second: np.ndarray, share: float) -> np.ndarray:
    """Return the weighted mean of two arrays."""
    return first + share * (second - first)
