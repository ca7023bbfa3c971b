"""The policy node as a program, with a policy that takes very long from a certain place on."""

import sys
import time

import numpy as np

from socialnav import driver, policy_node
from socialnav_core.policies import PolicyDescription

STALL = 3.0
"""Time that a decision takes there, s."""


class StallingPolicy:
    """Drives east, but beyond x = 1 m each decision takes very long."""

    description = PolicyDescription('stalling', 'holonomic', remembers=True)
    predictor = None
    plan = None

    def act(self, state, limits=None):
        """Return the command."""
        if state.robot.position[0, 0] > 1.0:
            time.sleep(STALL)
        return np.array([[0.5, 0.0]])

    def attention(self, state):
        """Look at nobody."""

    def reset(self, worlds=None):
        """Forget nothing."""


if __name__ == '__main__':
    driver.ready_policy = lambda settings: StallingPolicy()
    sys.exit(policy_node.main())
