"""Why a robot stands, where more than one place must know the words."""

ARRIVED = 'goal reached'
NO_GOAL = 'no goal_pose'
STALLED = 'no decision any more: the clock has stopped or the decision hangs'
UNDECIDED = 'no decision yet'
