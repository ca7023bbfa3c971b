"""Controllers that decide without the middleware."""

import dataclasses

import numpy as np

from helpers.worlds import BODY, messages_of, random_state
from socialnav.control.controller import Controller
from socialnav.parameters.policy import PolicyParameters

SECOND = 10**9
SETTINGS = PolicyParameters(bounds=BODY.bounds)
LOCKSTEP = dataclasses.replace(
    SETTINGS, lockstep=True, controller_frequency=4.0, stop_publish_timeout=0.0
)


class Recorder:
    """A policy that keeps what it saw and drives east."""

    kinematics = 'holonomic'

    def __init__(self):
        self.states, self.resets = [], 0
        self.command, self.error, self.duration = [0.5, 0.0], None, 0.0
        self.now = 0.0

    def act(self, state):
        self.states.append(state)
        self.now += self.duration
        if self.error:
            raise self.error
        return np.array([self.command])

    def reset(self):
        self.resets += 1


def controller_of(policy, settings=SETTINGS, without=(), stamp=SECOND, state=None):
    """Return a controller with inputs of one second."""
    controller = Controller(policy, settings, steady=lambda: policy.now)
    give(controller, state or random_state(0), stamp, without)
    return controller


def give(controller, state, stamp, without=()):
    """Hand a whole state to a controller."""
    for name, message in messages_of(state, stamp).items():
        if name not in without:
            controller.store(name, message)
