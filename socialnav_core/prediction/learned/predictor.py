"""The learned prediction of people."""

from collections.abc import Mapping

import numpy as np

from socialnav_core.prediction.learned.features import person_features
from socialnav_core.prediction.learned.history import History
from socialnav_core.prediction.learned.network import Layers
from socialnav_core.prediction.learned.outputs import LEAST_DEVIATION, place
from socialnav_core.prediction.protocol import Prediction
from socialnav_core.states import CrowdState


class LearnedPredictor:
    """
    Predicts each person from their last 1.25 s and their nearest neighbours, in one mode.

    Obstacles stay. Nobody is assumed to see the robot. It remembers what it was shown, world by
    world: ask it at every step, not only when the answer matters.
    """

    knowledge = 'deployable'
    remembers = True

    def __init__(self, weights: Mapping[str, np.ndarray]) -> None:
        """
        Start without history.

        :param weights: of a trained network, as `load_predictor` reads them.
        """
        self.layers = Layers(weights)
        self.history = History()

    def predict(self, state: CrowdState, times: np.ndarray) -> Prediction:
        """
        Return where the agents of a state will be, and remember the state.

        :param times: from the time of the state, s, (steps,).
        """
        agents = state.agents
        times = np.asarray(times, np.float64)
        self.history.update(state)
        lagged, known = self.history.lagged()
        people, features, frames = person_features(
            agents.position, lagged, known, agents.radius, agents.static, agents.valid
        )
        positions = np.repeat(agents.position[:, None], len(times), axis=1)
        deviations = np.full((state.batch_size, len(times), agents.count), LEAST_DEVIATION)
        place(self.layers(features), people, frames, agents.velocity, times, positions, deviations)
        weights = np.ones((state.batch_size, 1))
        return Prediction(positions[:, None], deviations[:, None], weights)

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Forget the history of some worlds, by indices or a mask; None for all."""
        self.history.reset(worlds)
