"""The policy node as a program that says, by a file, its argument, when it prepares its model."""

from pathlib import Path
import sys
import time

from socialnav import driver, policy_node

PREPARATION = 1.0
"""Time that it takes longer than usual, s."""

prepare = driver.ready_policy


def prepare_slowly(settings):
    """Return the policy, late."""
    Path(sys.argv[1]).touch()
    time.sleep(PREPARATION)
    return prepare(settings)


if __name__ == '__main__':
    driver.ready_policy = prepare_slowly
    sys.exit(policy_node.main())
