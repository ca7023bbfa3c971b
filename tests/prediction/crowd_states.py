"""Worlds to predict in, and a network with random weights."""

import dataclasses

import numpy as np

from socialnav_core.prediction.learned import LearnedPredictor
from socialnav_core.states import Agents, CrowdState, Robot
from socialnav_core.training.prediction.network import build_network, inference_weights

TIMES = np.array([0.1, 0.25, 0.6, 1.0, 3.0, 3.5])


def random_predictor(seed=0):
    """Return a predictor whose outputs are far from zero."""
    weights = inference_weights(build_network(32, seed))
    return LearnedPredictor({name: 2.0 * array for name, array in weights.items()})


def random_state(people, obstacles=2, batch=2, seed=0, time=0.0):
    """Return worlds with people first, obstacles behind."""
    draws = np.random.default_rng(seed)
    agents = people + obstacles
    static = np.tile(np.arange(agents) >= people, (batch, 1))
    velocity = draws.uniform(-1, 1, (batch, agents, 2)) * ~static[..., None]
    crowd = Agents(
        draws.uniform(-4, 4, (batch, agents, 2)), velocity,
        draws.uniform(0.2, 0.5, (batch, agents)), static, np.ones((batch, agents), bool),
    )  # fmt: skip
    one = np.ones(batch)
    robot = Robot(np.zeros((batch, 2)), np.zeros((batch, 2)), one, one, one, np.zeros((batch, 2)))
    return CrowdState(robot, crowd, np.inf * one, time * one)


def moved(state, duration=0.25):
    """Return the worlds a little later, everybody as fast but a bit to the left."""
    angle = 0.3
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    later = state.with_agents(
        position=state.agents.position + duration * state.agents.velocity,
        velocity=state.agents.velocity @ turn,
    )
    return dataclasses.replace(later, time=state.time + duration)


def sequence(state, count=4):
    """Return some states of the same worlds, one after another."""
    states = [state]
    for _ in range(count - 1):
        states.append(moved(states[-1]))
    return states


def last_prediction(predictor, states, times=TIMES):
    """Show the states to a predictor that knows nothing; return what it says of the last."""
    predictor.reset()
    for state in states:
        prediction = predictor.predict(state, times)
    return prediction
