"""The policy node as a program that adds a point to a file, its argument, at each rehearsal."""

from pathlib import Path
import sys

from socialnav import driver, policy_node
from socialnav.control.controller import Controller


class CountedController(Controller):
    """Says when it rehearses."""

    def rehearse(self):
        """Rehearse and say so."""
        super().rehearse()
        with Path(sys.argv[1]).open('a') as file:
            file.write('.')


if __name__ == '__main__':
    driver.Controller = CountedController
    sys.exit(policy_node.main())
