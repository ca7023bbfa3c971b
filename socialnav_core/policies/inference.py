"""Fast inference of a value network from NumPy arrays."""

import numpy as np
import torch
from torch import nn

from socialnav_core.states import Observation

CHUNK = 512  # rows computed at once: what they need stays in the processor's cache
SHAPE_STEP = 128  # every other number of rows would be compiled, and kept, by oneDNN


class ValueInference:
    """Computes values in chunks of rows, without gradients; sees weights as they are now."""

    def __init__(self, network: nn.Module, bfloat16: bool = False) -> None:
        """
        Keep the network.

        :param network: a value network.
        :param bfloat16: whether products of batches of a chunk or more are in bfloat16.
        """
        self.network = network
        self.bfloat16 = bfloat16

    def values(self, robot: np.ndarray, others: np.ndarray, mask: np.ndarray) -> np.ndarray:
        """
        Return the value of each row, float32 (rows,).

        :param robot: float32 (rows, 6).
        :param others: float32 (rows, agents, 7).
        :param mask: bool (rows, agents).
        """
        rows = len(robot)
        out = np.empty(rows, np.float32)
        device = device_of(self.network)
        inputs = [torch.from_numpy(array).to(device) for array in (robot, others, mask)]
        low = self.bfloat16 and rows >= CHUNK
        with torch.inference_mode(), torch.autocast(device.type, torch.bfloat16, enabled=low):
            for chunk in chunks(rows) if device.type == 'cpu' else [slice(None)]:
                values = self.network(*(array[chunk] for array in inputs))
                out[chunk] = values.float().cpu().numpy()
        return out

    def attention(self, seen: Observation) -> np.ndarray:
        """
        Return the attention weights of each row, float32 (rows, agents).

        :param seen: observation of as many worlds.
        """
        with torch.inference_mode():
            device = device_of(self.network)
            arrays = (torch.from_numpy(a).to(device) for a in (seen.robot, seen.others, seen.mask))
            return self.network.attention_weights(*arrays).cpu().numpy()


def device_of(network: nn.Module) -> torch.device:
    """
    Return where the parameters of a network are.

    :param network: with at least one parameter.
    """
    return next(network.parameters()).device


def chunks(rows: int) -> list[slice]:
    """
    Return slices that cover all rows; from a chunk on, they have few different lengths.

    The last one reaches back over rows that are computed already rather than be of odd length.

    :param rows: number of rows.
    """
    slices = []
    for begin in range(0, rows, CHUNK):
        count = min(CHUNK, -(-(rows - begin) // SHAPE_STEP) * SHAPE_STEP)
        slices.append(slice(max(0, min(begin, rows - count)), min(begin + CHUNK, rows)))
    return slices
