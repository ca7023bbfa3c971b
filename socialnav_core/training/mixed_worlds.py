"""Worlds of many kinds side by side, so that a network is right with nobody and in a crowd."""

from collections.abc import Callable, Sequence
import dataclasses
import math
from typing import Any

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.simulation import PackingError, Simulator
from socialnav_core.simulation.simulator import Step
from socialnav_core.states import Agents, CrowdState, mapped
from socialnav_core.training.randomness import generator, Purpose

TRIED_CASES = 20
"""A kind of world is taken when so many of its first cases find room."""


class MixedWorlds:
    """
    Simulators of several scenarios that are stepped as one batch.

    Case i is case i // kinds of kind i % kinds. States have slots for the agents of the largest
    kind; the others are not valid.
    """

    def __init__(self, scenario: Scenario, kinds: int, worlds: int, seed: int) -> None:
        """
        Draw the kinds; `reset` lays their worlds out.

        :param scenario: its numbers of pedestrians and obstacles are the largest ones.
        :param worlds: of all kinds together; a multiple of `kinds`.
        """
        self.scenario = scenario
        self._simulators = [
            mixed_simulator(scenario, kind, kinds, worlds // kinds, seed) for kind in range(kinds)
        ]
        self.kinematics = self._simulators[0].kinematics

    @property
    def state(self) -> CrowdState:
        """Return a copy of the present state."""
        return self._joined([simulator.state for simulator in self._simulators])

    @property
    def active(self) -> np.ndarray:
        """Return whether a world runs, bool (batch,)."""
        return np.concatenate([simulator.active for simulator in self._simulators])

    def reset(
        self, seed: int = 0, split: str = 'test', cases: Sequence[int] | np.ndarray | None = None
    ) -> CrowdState:
        """Start an episode in every world; see `Simulator.reset`."""
        kinds = len(self._simulators)
        for kind, simulator in enumerate(self._simulators):
            own = (
                None
                if cases is None
                else [case // kinds for case in cases if case % kinds == kind]
            )
            simulator.reset(seed, split, own)
        return self.state

    def step(self, command: np.ndarray) -> Step:
        """Advance all worlds; see `Simulator.advance`."""
        commands = np.split(command, len(self._simulators))
        made = [
            simulator.step(one) for simulator, one in zip(self._simulators, commands, strict=True)
        ]
        states, rewards, terminated, truncated, infos = zip(*made, strict=True)
        info: dict[str, Any] = {
            name: np.concatenate([one[name] for one in infos])
            for name in infos[0]
            if name not in ('final_state', 'case_index')
        }
        info['final_state'] = self._joined([one['final_state'] for one in infos])
        info['case_index'] = self._numbered([one['case_index'] for one in infos])
        together = np.concatenate
        return (
            self._joined(states),
            together(rewards),
            together(terminated),
            together(truncated),
            info,
        )

    def next_agent_velocities(self) -> np.ndarray:
        """Return what agents will do in the coming step; see `Simulator.next_agent_velocities`."""
        agents = self.scenario.agents
        return np.concatenate([
            filled(simulator.next_agent_velocities(), agents) for simulator in self._simulators
        ])  # fmt: skip

    def get_state(self) -> dict[str, np.ndarray]:
        """Return all that is needed to go on from here."""
        return {
            f'{kind}.{name}': array
            for kind, simulator in enumerate(self._simulators)
            for name, array in simulator.get_state().items()
        }

    def set_state(self, arrays: dict[str, np.ndarray]) -> None:
        """Go on from where `get_state` was called, with the same scenario, kinds and seed."""
        for kind, simulator in enumerate(self._simulators):
            prefix = f'{kind}.'
            simulator.set_state({
                name.removeprefix(prefix): array
                for name, array in arrays.items()
                if name.startswith(prefix)
            })  # fmt: skip

    def _joined(self, states: Sequence[CrowdState]) -> CrowdState:
        """Return the states of all kinds as one."""
        padded = [with_slots(state, self.scenario.agents) for state in states]
        return mapped(lambda *arrays: np.concatenate(arrays), *padded)

    def _numbered(self, cases: Sequence[np.ndarray]) -> np.ndarray:
        """Return the numbers of the kinds' own cases among all, -1 of idle worlds, (batch,)."""
        kinds = len(cases)
        return np.concatenate([
            np.where(own < 0, -1, own * kinds + kind) for kind, own in enumerate(cases)
        ])  # fmt: skip


def mixed_simulator(
    scenario: Scenario, kind: int, kinds: int, worlds: int, seed: int
) -> Simulator:
    """
    Return the worlds of one kind, drawn until its first cases find room.

    :raises PackingError: when none of many draws does.
    """
    draws = generator(seed, Purpose.MIXED_WORLDS, kind)
    for _ in range(20):
        drawn = draw_kind(scenario, (kind + draws.random()) / kinds, draws)
        simulator = Simulator(drawn, TRIED_CASES)
        try:
            simulator.reset(seed, 'train', range(TRIED_CASES))
        except PackingError:
            continue
        simulator = Simulator(drawn, worlds)
        simulator.change_scenario(drawn, radii_of_cases(drawn, seed, kind))
        return simulator
    raise PackingError(f'{scenario.name}: no kind of world found room; lower scenario.obstacles')


def draw_kind(scenario: Scenario, position: float, draws: np.random.Generator) -> Scenario:
    """
    Return a world with as many people as its position among the kinds asks for.

    :param position: from 0, nobody, to 1, all; small numbers are more frequent than large ones.
    """
    people = int((scenario.pedestrians + 1) * position**1.5)
    obstacles = int(draws.integers(scenario.obstacles + 1)) * int(draws.random() < 0.6)
    largest = float(draws.uniform(scenario.obstacle_radius_min, scenario.obstacle_radius_max))
    area = 2.5 * people + obstacles * (scenario.obstacle_radius_min + largest + 1.4) ** 2 + 16.0
    half_width = float(np.clip(0.5 * math.sqrt(draws.uniform(1.5, 4.0) * area), 4.0, 12.0))
    return dataclasses.replace(
        scenario,
        pedestrians=people,
        obstacles=obstacles,
        obstacle_radius_max=largest,
        spawn_half_width=half_width,
        minimum_travel=half_width,
        bounds=half_width + 2.5 if draws.random() < 0.5 else math.inf,
        randomize_attributes=bool(draws.random() < 0.5),
        pedestrian_speed=float(draws.uniform(0.5, 1.6)),
        robot_radius=float(draws.uniform(0.2, 0.5)),
        time_limit=15.0 + 3.0 * half_width / scenario.robot_preferred_speed,
    )


def radii_of_cases(scenario: Scenario, seed: int, kind: int) -> Callable[[int], Scenario]:
    """Return which largest radius of obstacles each case of a kind has, drawn anew in each."""

    def scenario_of(case: int) -> Scenario:
        draws = generator(seed, Purpose.MIXED_RADII, kind << 32 | case)
        low, high = scenario.obstacle_radius_min, scenario.obstacle_radius_max
        return dataclasses.replace(scenario, obstacle_radius_max=float(draws.uniform(low, high)))

    return scenario_of


def with_slots(state: CrowdState, slots: int) -> CrowdState:
    """Return a state with more slots for agents, in which nobody is."""
    agents = Agents(*[filled(array, slots) for array in vars(state.agents).values()])
    return dataclasses.replace(state, agents=agents)


def filled(array: np.ndarray, slots: int) -> np.ndarray:
    """Return an array (batch, agents, ...) with so many agents; missing ones are zero."""
    missing = [(0, 0), (0, slots - array.shape[1])] + [(0, 0)] * (array.ndim - 2)
    return np.pad(array, missing)
