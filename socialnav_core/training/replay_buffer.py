"""A ring of states and the values they should have."""

import numpy as np
import torch

from socialnav_core.states import Observation


class ReplayBuffer:
    """The latest states seen, each with its target; the oldest make room for new ones."""

    def __init__(self, capacity: int, agents: int) -> None:
        """
        Make an empty buffer.

        :param agents: agent slots of a state, padding included.
        """
        self.capacity = capacity
        self.size = 0
        self.position = 0
        self._columns = {
            'robot': np.zeros((capacity, 6), np.float32),
            'others': np.zeros((capacity, agents, 7), np.float32),
            'mask': np.zeros((capacity, agents), bool),
            'target': np.zeros(capacity, np.float32),
        }

    def append(self, observation: Observation, target: np.ndarray) -> None:
        """
        Store states; of more than fit, the last ones.

        :param target: their values, (batch,).
        """
        kept = slice(max(0, len(target) - self.capacity), None)
        count = len(target[kept])
        slots = (self.position + np.arange(count)) % self.capacity
        rows = (observation.robot, observation.others, observation.mask, target)
        for column, values in zip(self._columns.values(), rows, strict=True):
            column[slots] = values[kept]
        self.position = int((self.position + count) % self.capacity)
        self.size = min(self.size + count, self.capacity)

    def sample(self, generator: np.random.Generator, batch_size: int) -> tuple[torch.Tensor, ...]:
        """Draw states with replacement: robot (batch, 6), others, mask and target (batch,)."""
        rows = generator.integers(self.size, size=batch_size)
        return tuple(torch.from_numpy(column[rows]) for column in self._columns.values())

    def get_state(self) -> dict[str, np.ndarray]:
        """Return what set_state needs to continue from here; the arrays are views."""
        state = {name: column[: self.size] for name, column in self._columns.items()}
        return state | {'position': np.array(self.position)}

    def set_state(self, state: dict[str, np.ndarray]) -> None:
        """
        Continue from a stored state.

        :param state: from get_state of a buffer of the same capacity.
        """
        self.size = len(state['target'])
        self.position = int(state['position'])
        for name, column in self._columns.items():
            column[: self.size] = state[name]
