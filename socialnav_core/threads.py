"""How many processor threads torch computes with: few, since the networks here are small."""

from collections.abc import Iterator
import contextlib

import torch

_chosen = 1


def set_threads(count: int) -> None:
    """
    Compute with so many threads from now on, wherever this package computes with torch.

    The default is 1: torch's own, a thread for each core, makes these networks several times
    slower. Outside this package's own computations torch's setting stays as it is.

    :param count: at least 1.
    """
    global _chosen
    if count < 1:
        raise ValueError(f'the number of threads must be at least 1, not {count}')
    _chosen = count


@contextlib.contextmanager
def chosen_threads() -> Iterator[None]:
    """Let torch use as many threads as `set_threads` said, and afterwards as many as before."""
    before = torch.get_num_threads()
    if before == _chosen:
        yield
        return
    torch.set_num_threads(_chosen)
    try:
        yield
    finally:
        torch.set_num_threads(before)
