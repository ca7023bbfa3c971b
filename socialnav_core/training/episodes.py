"""Outcomes of episodes, counted in the order in which the episodes started."""

import numpy as np

from socialnav_core.simulation import Outcome


class EpisodeWindow:
    """
    The latest episodes in the order of their start.

    Worlds that restart at once finish short episodes first; counted by their ends they would
    crowd out the long ones, which are the failures. So an episode waits here until all that
    started before it have ended. Cases are numbered in the order of their start.
    """

    def __init__(self, length: int, next_case: int) -> None:
        """
        Wait for a first episode.

        :param length: number of episodes that are remembered.
        :param next_case: case index of the first episode that counts.
        """
        self.length = length
        self.next_case = next_case
        self._waiting: dict[int, tuple[int, float]] = {}
        self._counted: list[tuple[int, float]] = []

    def record(self, case_index: np.ndarray, outcome: np.ndarray, time: np.ndarray) -> None:
        """
        Add episodes that have ended; ones begun before the first that counts are ignored.

        :param case_index: order of their start, (episodes,).
        :param outcome: Outcome codes, (episodes,).
        :param time: durations, s, (episodes,).
        """
        columns = (case_index.tolist(), outcome.tolist(), time.tolist())
        for case, code, duration in zip(*columns, strict=True):
            if case >= self.next_case:
                self._waiting[case] = (code, duration)
        while self.next_case in self._waiting:
            self._counted.append(self._waiting.pop(self.next_case))
            self.next_case += 1
        self._counted = self._counted[-self.length :]

    def restart(self, next_case: int) -> None:
        """
        Forget everything.

        :param next_case: case index of the first episode that counts from now on.
        """
        self.next_case = next_case
        self._waiting.clear()
        self._counted.clear()

    @property
    def full(self) -> bool:
        """Return whether as many episodes were counted as are remembered."""
        return len(self._counted) == self.length

    @property
    def success_rate(self) -> float:
        """Return the share of episodes that reached the goal; nan without episodes."""
        return self._share(lambda outcome: outcome == Outcome.GOAL)

    @property
    def collision_rate(self) -> float:
        """Return the share that touched something or left the bounds; nan without episodes."""
        return self._share(lambda outcome: outcome not in (Outcome.GOAL, Outcome.TIMEOUT))

    @property
    def mean_time(self) -> float:
        """Return the mean duration of successes, s; nan without any."""
        times = [time for outcome, time in self._counted if outcome == Outcome.GOAL]
        return float(np.mean(times)) if times else float('nan')

    def get_state(self) -> dict[str, np.ndarray]:
        """Return what set_state needs to continue from here."""
        waiting = [(case, *result) for case, result in self._waiting.items()]
        return {
            'next_case': np.array(self.next_case),
            'waiting': np.array(waiting, float).reshape(-1, 3),
            'counted': np.array(self._counted, float).reshape(-1, 2),
        }

    def set_state(self, state: dict[str, np.ndarray]) -> None:
        """Continue from a stored state."""
        self.next_case = int(state['next_case'])
        waiting, counted = state['waiting'].tolist(), state['counted'].tolist()
        self._waiting = {int(case): (int(outcome), time) for case, outcome, time in waiting}
        self._counted = [(int(outcome), time) for outcome, time in counted]

    def _share(self, holds) -> float:  # type: ignore[no-untyped-def]
        """
        Return the share of counted episodes.

        :param holds: of an outcome, whether it counts.
        """
        if not self._counted:
            return float('nan')
        return sum(bool(holds(outcome)) for outcome, _ in self._counted) / len(self._counted)
