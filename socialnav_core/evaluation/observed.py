"""The world as a policy sees it whose sensors are not perfect."""

import numpy as np

from socialnav_core.config import ObservationConfig, require, Scenario
from socialnav_core.states import CrowdState


class Observer:
    """Sees the worlds of an evaluation; what it draws depends on the case and the step alone."""

    def __init__(self, config: ObservationConfig, scenario: Scenario, seed: int) -> None:
        """
        Choose how well it sees.

        :raises ConfigError: for a delay of more than a time step.
        """
        require(
            config.delay <= scenario.time_step,
            f'observation.delay must be at most the time step, {scenario.time_step:g} s',
        )
        self._config, self._seed = config, seed

    def see(self, state: CrowdState, cases: np.ndarray, steps: np.ndarray) -> CrowdState:
        """
        Return what is seen of a state.

        :param cases: of the worlds, negative where one is idle, (batch,).
        :param steps: made so far in each, (batch,).
        """
        config, agents = self._config, state.agents
        people = agents.valid & ~agents.static
        draws = np.zeros((*people.shape, 5))
        for world in np.flatnonzero(cases >= 0):
            address = (self._seed, int(cases[world]), int(steps[world]))
            generator = np.random.default_rng(np.random.SeedSequence(address))
            draws[world, :, :4] = generator.standard_normal((people.shape[1], 4))
            draws[world, :, 4] = generator.random(people.shape[1])
        position = agents.position - config.delay * agents.velocity
        offset = position - state.robot.position[:, None]
        gap = (
            np.hypot(offset[..., 0], offset[..., 1]) - agents.radius - state.robot.radius[:, None]
        )
        seen = (draws[..., 4] >= config.missed) & (gap <= config.reach)
        noise = people[..., None] * draws[..., :4]
        return state.with_agents(
            position=position + config.position_noise * noise[..., :2],
            velocity=agents.velocity + config.velocity_noise * noise[..., 2:],
            valid=agents.valid & (agents.static | seen),
        )
