"""The network's arithmetic in NumPy, so that a robot needs no torch."""

from collections.abc import Mapping

import numpy as np


class Layers:
    """Linear layers with SiLU between them, by the weights of a trained network."""

    def __init__(self, weights: Mapping[str, np.ndarray]) -> None:
        """
        Take over the layers `0`, `1`, ... in order.

        :param weights: float32, `N.weight` (out, in) and `N.bias` (out,) of each layer N.
        """
        names = sorted({int(name.partition('.')[0]) for name in weights})
        self.matrices = [np.ascontiguousarray(weights[f'{name}.weight'].T) for name in names]
        self.biases = [weights[f'{name}.bias'] for name in names]

    def __call__(self, inputs: np.ndarray) -> np.ndarray:
        """Return the outputs, (rows, outputs), of inputs, float32 (rows, inputs)."""
        values = inputs
        for matrix, bias in zip(self.matrices[:-1], self.biases[:-1], strict=True):
            values = silu(values @ matrix + bias)
        return values @ self.matrices[-1] + self.biases[-1]


def silu(values: np.ndarray) -> np.ndarray:
    """Return x / (1 + exp(-x)); what would overflow is as good as zero."""
    return values / (1.0 + np.exp(np.minimum(-values, 80.0)))
