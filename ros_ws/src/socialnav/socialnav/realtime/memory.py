"""Python's garbage collector, kept from stopping a node for long."""

import gc

FEW = 20_000
"""Objects that the collector looks at in some milliseconds."""


def set_aside() -> None:
    """
    Let the collector pass over everything that there is now, where that is much.

    A full collection looks at all that PyTorch, numba, rclpy and the node have made, which takes
    a tenth of a second, and may come at any time. What is made from now on is collected as ever.
    Garbage among what was set aside is collected by the next call that finds much again, a model
    that was loaded for instance; a call that finds little takes milliseconds.
    """
    much = len(gc.get_objects()) > FEW
    if much:
        gc.unfreeze()
    gc.collect()
    if much:
        gc.freeze()
