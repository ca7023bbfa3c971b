"""Python's garbage collector, kept from stopping a node for long."""

import gc


def set_aside() -> None:
    """
    Let the collector pass over everything that there is now.

    A full collection looks at all that PyTorch, rclpy and the node have made, which takes a tenth
    of a second, and may come at any time. What is made from now on is collected as ever, and what
    was set aside by an earlier call and is garbage by now is collected at once.
    """
    gc.unfreeze()
    gc.collect()
    gc.freeze()
