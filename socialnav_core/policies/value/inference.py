"""Fast inference of a value network from NumPy arrays."""

from collections.abc import Callable

import numpy as np
import torch
from torch import nn

from socialnav_core.allocator import keep_freed_memory
from socialnav_core.states import Observation
from socialnav_core.threads import chosen_threads

# Rows computed at once on a CPU: what they need stays in the processor's cache.
FLOAT32_CHUNK = 256
BFLOAT16_CHUNK = 512
SHAPE_STEP = 128  # every other number of rows in bfloat16 would be compiled, and kept, by oneDNN


class ValueInference:
    """
    Computes values from NumPy arrays, without gradients, with the network's weights as they are.

    Weights may change between two calls: by an optimiser, by `load_state_dict`, or by moving the
    network to another device.

    A few rows (the actions of one decision) take one pass in float32; many rows are computed in
    chunks, with bfloat16 products where asked for. Those lose little value, but choose another
    action where two are nearly equal: 1 to 2 % of the decisions of SARL, up to 13 % of GAT4SN's.
    """

    def __init__(self, network: nn.Module, bfloat16: bool = False) -> None:
        """
        Keep the network.

        :param network: a value network, with `attention_weights` beside `forward`.
        :param bfloat16: whether products are in bfloat16 from BFLOAT16_CHUNK rows on.
        """
        self.network = network
        self.bfloat16 = bfloat16
        self._some_parameter = next(network.parameters())  # tells the device, wherever it goes

    @chosen_threads()
    def values(self, robot: np.ndarray, others: np.ndarray, mask: np.ndarray) -> np.ndarray:
        """
        Return the value of each row, float32 (rows,).

        :param robot: float32 (rows, 6).
        :param others: float32 (rows, agents, 7).
        :param mask: bool (rows, agents).
        """
        rows = len(robot)
        low = self.bfloat16 and rows >= BFLOAT16_CHUNK
        device, forward = self._some_parameter.device, self.network.forward
        with torch.inference_mode():
            inputs = [torch.from_numpy(array) for array in (robot, others, mask)]
            if device.type != 'cpu':
                moved = [tensor.to(device) for tensor in inputs]
                return _compute(forward, moved, low).cpu().numpy()
            if rows <= FLOAT32_CHUNK and not low:
                return forward(*inputs).numpy()
            keep_freed_memory()
            out = np.empty(rows, np.float32)
            for chunk in chunks(rows, low):
                out[chunk] = _compute(forward, [tensor[chunk] for tensor in inputs], low).numpy()
        return out

    @chosen_threads()
    def attention(self, seen: Observation) -> np.ndarray:
        """Return the attention weights of each row, float32 (rows, agents)."""
        with torch.inference_mode():
            device = self._some_parameter.device
            arrays = (torch.from_numpy(a).to(device) for a in (seen.robot, seen.others, seen.mask))
            return self.network.attention_weights(*arrays).cpu().numpy()  # type: ignore[operator]


def device_of(network: nn.Module) -> torch.device:
    """Return where the parameters of a network are."""
    return next(network.parameters()).device


def chunks(rows: int, bfloat16: bool) -> list[slice]:
    """
    Return slices that cover all rows; for bfloat16 they have few different lengths.

    For that the last one reaches back over rows that are computed already.
    """
    size, step = (BFLOAT16_CHUNK, SHAPE_STEP) if bfloat16 else (FLOAT32_CHUNK, 1)
    slices = []
    for begin in range(0, rows, size):
        count = min(size, -(-(rows - begin) // step) * step)
        slices.append(slice(max(0, min(begin, rows - count)), min(begin + size, rows)))
    return slices


def _compute(
    forward: Callable[..., torch.Tensor], inputs: list[torch.Tensor], bfloat16: bool
) -> torch.Tensor:
    """Return the values of the inputs, float32 (rows,), with bfloat16 products where wanted."""
    with torch.autocast(inputs[0].device.type, torch.bfloat16, enabled=bfloat16):
        return forward(*inputs)
