"""How many steps per second the simulator makes."""

import math
from typing import Any

from socialnav_core.benchmarking.measurement import calls_per_second, in_turns, Measurement
from socialnav_core.config import Scenario
from socialnav_core.policies import StraightLinePolicy
from socialnav_core.simulation import make_scenario, Simulator

WORLDS = 1024
ROUNDS = 9
SECONDS = 0.35

SCENARIOS = {
    'simple': '5 pedestrians + 5 obstacles',
    'simple10': '5 pedestrians + 10 obstacles',
    'crowd20': '20 pedestrians',
}


def simulator_measurements(reference: Any) -> list[Measurement]:
    """
    Return steps per second of worlds in a batch, and of single worlds with ever more people.

    The robot drives straight at its goal; episodes that end are followed by others.

    :param reference: the plain reference, or None.
    """
    rows = [in_batches(name, meaning, reference) for name, meaning in SCENARIOS.items()]
    return rows + [alone(pedestrians) for pedestrians in (5, 20, 50, 200)]


def in_batches(name: str, meaning: str, reference: Any) -> Measurement:
    """
    Return steps per second of worlds of a scenario, many of them side by side.

    :param meaning: what is in the scenario, in words.
    """
    scenario = make_scenario(name)

    def plain_rate() -> float:
        return reference.reference_steps_per_second(
            scenario.pedestrians, scenario.obstacles, SECONDS
        )

    details = {'worlds': WORLDS}
    value, plain, ratio = in_turns(
        lambda: WORLDS * steps_per_second(scenario, WORLDS),
        plain_rate if reference else None,
        ROUNDS,
    )
    return Measurement(f'simulator, {meaning}', value, 'steps/s', plain, ratio, details)


def alone(pedestrians: int) -> Measurement:
    """Return steps per second of one world, at the density of people of crowd20."""
    half = 5.0 * math.sqrt(pedestrians / 20)
    scenario = Scenario(
        f'{pedestrians} pedestrians',
        pedestrians=pedestrians,
        obstacles=0,
        spawn_half_width=half,
        minimum_travel=1.5 * half,
        bounds=half + 2.5,
    )
    rate = steps_per_second(scenario, 1)
    details = {'milliseconds_per_step': 1000 / rate}
    return Measurement(f'one world, {pedestrians} pedestrians', rate, 'steps/s', details=details)


def steps_per_second(scenario: Scenario, worlds: int) -> float:
    """Return steps of the whole batch per second."""
    simulator, policy = Simulator(scenario, worlds), StraightLinePolicy()
    state = simulator.reset()

    def step() -> None:
        nonlocal state
        state = simulator.step(policy.act(state))[0]

    return calls_per_second(step, SECONDS)
