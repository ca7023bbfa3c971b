"""The data that every part shares: the world as it is, and what a network sees of it."""

from collections.abc import Callable, Sequence
import dataclasses
from typing import Any, TypeVar

import numpy as np

Arrays = TypeVar('Arrays', bound=Any)


@dataclasses.dataclass
class Agents:
    """Pedestrians and static obstacles; one whose ``valid`` is False is padding."""

    position: np.ndarray
    """Centres, m, (batch, agents, 2)."""
    velocity: np.ndarray
    """Velocities, m/s, (batch, agents, 2)."""
    radius: np.ndarray
    """Radii, m, (batch, agents)."""
    static: np.ndarray
    """Whether an agent is an obstacle that never moves, bool, (batch, agents)."""
    valid: np.ndarray
    """Whether an agent is real, bool, (batch, agents); nothing may depend on one that is not."""

    @property
    def count(self) -> int:
        """Return the number of agent slots of a world, padding included."""
        return self.position.shape[1]

    def append(self, others: 'Agents') -> 'Agents':
        """Return these agents followed by others of the same worlds."""
        return mapped(lambda *pair: np.concatenate(pair, axis=1), self, others)

    def take(self, kept: np.ndarray) -> 'Agents':
        """Return some of the agents of each world, by their indices, (batch, kept)."""
        worlds = np.arange(len(kept))[:, None]
        return mapped(lambda array: array[worlds, kept], self)


@dataclasses.dataclass
class Robot:
    """The robot of each world."""

    position: np.ndarray
    """Centre, m, (batch, 2)."""
    velocity: np.ndarray
    """Velocity, m/s, (batch, 2)."""
    heading: np.ndarray
    """Heading, rad, counter-clockwise from the x axis, (batch,)."""
    radius: np.ndarray
    """Radius, m, (batch,)."""
    preferred_speed: np.ndarray
    """Speed that it would like to drive at, m/s, (batch,)."""
    goal: np.ndarray
    """Where it should arrive, m, (batch, 2)."""
    turn_rate: np.ndarray = None  # type: ignore[assignment]
    """Turn rate, rad/s, counter-clockwise, (batch,); where it is left out, nobody turns."""

    def __post_init__(self) -> None:
        """Fill in a turn rate that was left out."""
        if self.turn_rate is None:
            self.turn_rate = np.zeros_like(self.heading, dtype=np.float64)

    def as_agents(self) -> Agents:
        """Return the robot as others see it: one agent in each world."""
        never = np.zeros((len(self.radius), 1), bool)
        body = (self.position[:, None], self.velocity[:, None], self.radius[:, None])
        return Agents(*body, never, ~never)


@dataclasses.dataclass
class CrowdState:
    """
    A batch of worlds: one robot each, and the agents around it.

    Arrays are NumPy float64 (masks bool), world frame, SI units, batch axis first.
    """

    robot: Robot
    """The robot of each world."""
    agents: Agents
    """Everybody and everything else, (batch, agents)."""
    bounds: np.ndarray
    """Half-width of the square around the origin not to be left, m, inf for none, (batch,)."""
    time: np.ndarray
    """Time since the start of the episode, s, (batch,)."""

    @property
    def batch_size(self) -> int:
        """Return the number of worlds."""
        return self.bounds.shape[0]

    def copy(self) -> 'CrowdState':
        """Return a state that shares no memory with this one."""
        # Every step makes one, and `mapped` would take a tenth of the step of a single world.
        robot = Robot(*[array.copy() for array in vars(self.robot).values()])
        agents = Agents(*[array.copy() for array in vars(self.agents).values()])
        return CrowdState(robot, agents, self.bounds.copy(), self.time.copy())

    def select(self, worlds: np.ndarray) -> 'CrowdState':
        """Return the state of some worlds, by indices or a mask along the batch axis."""
        return mapped(lambda array: array[worlds], self)

    def nearest(self, count: int) -> 'CrowdState':
        """Return the state with the agents nearest to the robot alone, rim to centre, in order."""
        if self.agents.count <= count:
            return self
        offset = self.agents.position - self.robot.position[:, None]
        gap = np.hypot(offset[..., 0], offset[..., 1]) - self.agents.radius
        gap[~self.agents.valid] = np.inf
        kept = np.sort(np.argsort(gap, axis=1, kind='stable')[:, :count], axis=1)
        return dataclasses.replace(self, agents=self.agents.take(kept))

    def with_robot(self, **changes: np.ndarray) -> 'CrowdState':
        """Return the state with other values of fields of the robot."""
        return dataclasses.replace(self, robot=dataclasses.replace(self.robot, **changes))

    def with_agents(self, **changes: np.ndarray) -> 'CrowdState':
        """Return the state with other values of fields of the agents."""
        return dataclasses.replace(self, agents=dataclasses.replace(self.agents, **changes))

    def arrays(self) -> dict[str, np.ndarray]:
        """Return all arrays by dotted names such as `robot.position`, not copied."""
        parts = {'robot': self.robot, 'agents': self.agents}
        nested = {
            f'{part}.{name}': array for part in parts for name, array in vars(parts[part]).items()
        }
        return nested | {'bounds': self.bounds, 'time': self.time}

    @staticmethod
    def from_arrays(arrays: dict[str, np.ndarray]) -> 'CrowdState':
        """Return the state whose `arrays` these are; other names are left aside."""
        known = (field.name for field in dataclasses.fields(Robot))
        robot = Robot(**{
            name: arrays[f'robot.{name}'] for name in known if f'robot.{name}' in arrays
        })  # fmt: skip
        agents = Agents(*(arrays[f'agents.{field.name}'] for field in dataclasses.fields(Agents)))
        return CrowdState(robot, agents, arrays['bounds'], arrays['time'])


@dataclasses.dataclass
class Observation:
    """What a value network sees: the world turned so that the goal lies on the x axis, float32."""

    robot: np.ndarray
    """[goal distance, preferred speed, heading, radius, vx, vy], (..., 6)."""
    others: np.ndarray
    """[px, py, vx, vy, radius, distance, sum of radii] of each agent, (..., agents, 7)."""
    mask: np.ndarray
    """Whether an agent is real, bool, (..., agents)."""

    def select(self, rows: np.ndarray) -> 'Observation':
        """Return some observations of a batch, by indices or a mask along the batch axis."""
        return mapped(lambda array: array[rows], self)

    @staticmethod
    def concatenate(batches: 'Sequence[Observation]') -> 'Observation':
        """Return batches with the same number of agents one after the other."""
        return mapped(lambda *arrays: np.concatenate(arrays), *batches)

    @staticmethod
    def empty(agents: int) -> 'Observation':
        """Return a batch of none, with slots for so many agents, padding included."""
        return Observation(
            np.zeros((0, 6), np.float32),
            np.zeros((0, agents, 7), np.float32),
            np.zeros((0, agents), bool),
        )


def mapped(function: Callable[..., np.ndarray], first: Arrays, *others: Arrays) -> Arrays:
    """Return a dataclass of arrays with a function applied to each array, nested ones too."""
    columns = zip(*[vars(record).values() for record in (first, *others)], strict=True)
    # every step copies a state; dataclasses.fields and is_dataclass would take most of the time
    return type(first)(*[
        mapped(function, *column) if isinstance(column[0], (Robot, Agents)) else function(*column)
        for column in columns
    ])  # fmt: skip
