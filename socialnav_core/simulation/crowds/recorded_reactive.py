"""Recorded people who avoid the robot: near it they walk by ORCA, then back to what they did."""

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.orca import RADIUS_PADDING, RECIPROCAL
from socialnav_core.simulation.crowds.orca_kernel import Bodies, Foresight, orca_step
from socialnav_core.simulation.crowds.recorded import RecordedCrowd
from socialnav_core.simulation.recorded import Replay, replay_of

NEAR = 3.0
"""Who is nearer to the robot avoids it, m from rim to rim."""
CATCH_UP = 1.0
"""Who has left their recorded way heads for where they were so much later, s."""
HASTE, SLOWEST = 1.3, 0.5
"""They walk at most so much faster than recorded, and at least up to this, m/s."""
ON_WAY = 0.01
"""Who is no farther from their recorded place than this is on their way, m."""
ALONE = 1.0
"""Share of a conflict with somebody who only does what was recorded: they do not give way."""


def make_crowd(scenario: Scenario, batch_size: int) -> 'ReactiveCrowd':
    """Return the crowd."""
    return ReactiveCrowd(replay_of(scenario), batch_size)


class ReactiveCrowd:
    """Recorded people, of whom some have left their recorded ways; positions tell who."""

    def __init__(self, replay: Replay, batch_size: int) -> None:
        """Make room; `reset` fills it."""
        self._replay = replay
        self._recorded = RecordedCrowd(replay, batch_size)
        self.reset = self._recorded.reset
        self.renew_goals = self._recorded.renew_goals
        self.get_state = self._recorded.get_state
        self.set_state = self._recorded.set_state

    def decide(self, episodes: Episodes, due: np.ndarray, velocities: np.ndarray) -> None:
        """Write what people did then, or how they avoid the robot; see Crowd.decide."""
        self._recorded.decide(episodes, due, velocities)
        avoiding = self.avoiding(episodes)
        worlds = due & avoiding.any(axis=1)
        if not worlds.any():
            return
        out = self._avoidance(episodes, avoiding, velocities, worlds)
        chosen = avoiding & worlds[:, None]
        velocities[chosen] = out[:, : avoiding.shape[1]][chosen]

    def avoiding(self, episodes: Episodes) -> np.ndarray:
        """Return who is near the robot or has left their way, bool (batch, agents)."""
        agents, robot = episodes.state.agents, episodes.state.robot
        offset = agents.position - robot.position[:, None]
        gap = np.linalg.norm(offset, axis=-1) - agents.radius - robot.radius[:, None]
        recorded = self._replay.position[self._recorded.moments(episodes)]
        slots = recorded.shape[1]
        away = np.zeros_like(gap)
        away[:, :slots] = np.linalg.norm(recorded - agents.position[:, :slots], axis=-1)
        return agents.valid & ((gap < NEAR) | (away > ON_WAY))

    def _avoidance(
        self, episodes: Episodes, avoiding: np.ndarray, recorded: np.ndarray, worlds: np.ndarray
    ) -> np.ndarray:
        """Return the ORCA velocities of all people of some worlds, m/s, (batch, agents + 1, 2)."""
        scenario, robot = episodes.scenario, episodes.state.robot
        agents = episodes.state.agents.append(robot.as_agents())
        place, later = self._target(episodes)
        slots = place.shape[1]
        preferred = np.zeros_like(recorded)
        preferred[:, :slots] = (place - agents.position[:, :slots]) / later[..., None]
        fastest = HASTE * np.maximum(np.linalg.norm(recorded, axis=-1), SLOWEST)
        speed = np.linalg.norm(preferred, axis=-1)
        preferred *= np.minimum(1.0, fastest / np.maximum(speed, 1e-9))[..., None]
        out = np.concatenate([preferred, robot.velocity[:, None]], axis=1)
        share = np.where(avoiding, RECIPROCAL, ALONE)
        bodies = Bodies(
            position=agents.position,
            velocity=agents.velocity,
            preferred_velocity=out.copy(),
            radius=agents.radius + (RADIUS_PADDING + scenario.orca.safety_space),
            max_speed=np.concatenate([fastest, robot.preferred_speed[:, None]], axis=1),
            valid=agents.valid,
            responsibility=np.pad(share, ((0, 0), (0, 1)), constant_values=RECIPROCAL),
            neighbor_distance=np.full_like(agents.radius, scenario.orca.neighbor_distance),
        )
        orca = scenario.orca
        foresight = Foresight(orca.max_neighbors, orca.time_horizon, scenario.time_step)
        orca_step(bodies, foresight, worlds, scenario.pedestrians, out)
        return out

    def _target(self, episodes: Episodes) -> tuple[np.ndarray, np.ndarray]:
        """
        Return where people were CATCH_UP later, or when they went, and how much later that is.

        :returns: m, (batch, slots, 2), and s, (batch, slots); anything where there is nobody.
        """
        replay, step = self._replay, episodes.scenario.time_step
        slots = np.arange(replay.there.shape[1])
        now = self._recorded.moments(episodes)[:, None]
        moment = np.broadcast_to(now, (len(now), len(slots)))
        for _ in range(round(CATCH_UP / step) - 1):
            further = np.minimum(moment + 1, len(replay.there) - 1)
            moment = np.where(replay.there[further, slots], further, moment)
        place = replay.position[moment, slots] + step * replay.velocity[moment, slots]
        return place, step * (moment + 1 - now)
