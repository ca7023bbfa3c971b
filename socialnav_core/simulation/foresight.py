"""Where people would be some steps ahead if nobody changed their mind."""

import numpy as np

from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.protocol import Crowd


def foresee(episodes: Episodes, crowd: Crowd, steps: int) -> np.ndarray:
    """
    Return the positions after each of the next steps, m, (batch, steps, agents, 2).

    The crowd decides as always, with its present goals; afterwards everything is as it was.
    """
    agents, active = episodes.state.agents, episodes.active
    kept, position, velocity = crowd.get_state(), agents.position.copy(), agents.velocity.copy()
    time, streams = episodes.state.time.copy(), episodes.goal_streams.copy()
    out = np.empty((len(position), steps, *position.shape[1:]))
    decided = np.zeros_like(velocity)
    for step in range(steps):
        crowd.decide(episodes, active, decided)
        agents.velocity[:] = decided
        agents.position += decided * episodes.scenario.time_step
        out[:, step] = agents.position
        episodes.state.time += episodes.scenario.time_step
    crowd.set_state(kept)
    agents.position[:], agents.velocity[:] = position, velocity
    episodes.state.time[:], episodes.goal_streams[:] = time, streams
    return out
