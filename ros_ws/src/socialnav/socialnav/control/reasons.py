"""Why a robot stands, where more than one place must know the words."""

import enum

ARRIVED = 'goal reached'
NO_GOAL = 'no goal_pose'
STALLED = 'no decision any more: the clock has stopped or the decision hangs'
UNDECIDED = 'no decision yet'
DRIVING = 'driving'
"""What is said of a robot that does not stand."""
NO_PROGRESS = 'no progress'
"""How it begins what is said of one that does not come nearer to its goal."""
GIVEN_UP = 'it stands until there is another goal'
"""How it ends where such a robot stands."""


class Cause(enum.Enum):
    """Of what kind a reason to stand is."""

    ARRIVED = enum.auto()
    NO_GOAL = enum.auto()
    INPUT = enum.auto()
    """An input is missing or too old."""
    FRAME = enum.auto()
    """Nobody knows where a frame lies."""
    PROGRESS = enum.auto()
    """The robot has come no nearer to its goal for too long."""
    CONTROL = enum.auto()
    """There is no command: the decision failed, or what it goes by cannot be."""
