"""When one run to a goal ends and the next begins."""

from geometry_msgs.msg import PoseStamped


class Run:
    """
    The run that a controller is in.

    A robot begins a run with each goal that has a new stamp, frame or pose; one that was typed by
    hand may have no stamp. In lockstep every state carries its own goal, so there a run begins
    where the goal moves or the clock jumps over more than a step.
    """

    def __init__(self) -> None:
        self._begin = 0
        self._latest = 0
        self._goal: PoseStamped | None = None

    def begins(self, goal: PoseStamped, now: int, longest_step: float | None) -> bool:
        """
        Return whether a new run begins with this state; remember it.

        :param now: time of the state, ns.
        :param longest_step: time between two states of a run in lockstep, s; None elsewhere.
        """
        if longest_step is None:
            new = goal is not self._goal and goal != self._goal
        else:
            jumped = now - self._latest > longest_step * 1e9
            new = jumped or self._goal is None or goal.pose.position != self._goal.pose.position
        self._goal, self._latest = goal, now
        if new:
            self._begin = now
        return new

    @property
    def time(self) -> float:
        """Return the time since the run began, s."""
        return (self._latest - self._begin) * 1e-9
