"""How much memory something will need, which is asked before it begins."""

import math
from pathlib import Path

from socialnav_core.config import Config, ConfigError, Scenario
from socialnav_core.config.prediction import PredictionConfig

GIBIBYTE = 2**30
ROBOT_BYTES, AGENT_BYTES = 32, 32
"""What an observation holds, with its target, of the robot and of each agent."""
STATE_BYTES = 400
"""What the arrays of a simulator hold of each agent, with copies."""
RECORD_BYTES = 400
"""What is kept of each episode that was measured."""
SHORTEST_STEP, MOST_PEOPLE, PERSON_BYTES, INPUTS = 0.1, 30, 24, 200
"""Of recorded crowds: time between moments, s; people of a world; bytes and inputs of each."""


def require_memory(needed: float, purpose: str) -> None:
    """
    Raise a ConfigError when something would need more memory than there is.

    :param needed: bytes, roughly.
    :param purpose: what needs it, for the message, with the settings that decide.
    """
    available = available_memory()
    if available is not None and needed > available:
        raise ConfigError(
            f'{purpose} would need about {needed / GIBIBYTE:,.1f} GiB of memory, and '
            f'{available / GIBIBYTE:,.1f} GiB are free'
        )


def available_memory() -> float | None:
    """Return the free memory, bytes, within the limit of a container; None where nobody knows."""
    information = Path('/proc/meminfo')
    if not information.is_file():
        return None
    lines = information.read_text().splitlines()
    free = [1024.0 * int(line.split()[1]) for line in lines if line.startswith('MemAvailable')]
    used, limit = (number_in(f'/sys/fs/cgroup/memory.{name}') for name in ('current', 'max'))
    if used is not None and limit is not None:
        free.append(max(0.0, limit - used))
    return min(free, default=None)


def number_in(path: str) -> float | None:
    """Return the number that a file of the system holds; None where there is none."""
    try:
        return float(Path(path).read_text())
    except (OSError, ValueError):
        return None


def observations_bytes(states: float, scenario: Scenario) -> float:
    """Return what observations of a number of states need, bytes."""
    return states * (ROBOT_BYTES + AGENT_BYTES * scenario.agents)


def worlds_bytes(worlds: int, scenario: Scenario, actions: int = 1) -> float:
    """
    Return what worlds and the decisions in them need, bytes.

    :param actions: that a decision weighs.
    """
    decisions = observations_bytes(2.0 * worlds * actions, scenario)
    return decisions + worlds * STATE_BYTES * (scenario.agents + 1)


def evaluation_bytes(episodes: int, worlds: int, scenario: Scenario, actions: int = 1) -> float:
    """Return what an evaluation of a number of cases needs, bytes."""
    return RECORD_BYTES * float(episodes) + worlds_bytes(worlds, scenario, actions)


def prediction_bytes(config: PredictionConfig) -> float:
    """Return what a training of the prediction needs at most, bytes: crowds, and one batch."""
    crowds, settings = config.crowds, config.training
    groups = float(crowds.groups + crowds.validation_groups)
    recorded = groups * crowds.worlds * MOST_PEOPLE * crowds.duration / SHORTEST_STEP
    drawn = settings.recordings_per_update * settings.moments_per_recording
    validated = crowds.validation_groups * settings.moments_per_recording
    examples = float(MOST_PEOPLE) * (drawn + validated)
    return PERSON_BYTES * recorded + 12.0 * examples * (3 * settings.width + INPUTS)


def training_bytes(config: Config) -> float:
    """Return what a training of values needs at most, bytes: replay, demonstrations, decisions."""
    settings, scenario, policy = config.training, config.scenario, config.policy
    steps = math.ceil(scenario.time_limit / scenario.time_step)
    replay = 3.0 * settings.replay_capacity  # itself, and twice while the state is written
    demonstrations = 2.0 * settings.imitation.episodes * steps
    collected = 2.0 * settings.worlds * settings.steps_per_iteration
    return (
        observations_bytes(max(replay, demonstrations) + collected, scenario)
        + observations_bytes(3.0 * settings.batch_size, scenario)
        + worlds_bytes(settings.worlds, scenario, policy.actions)
    )
