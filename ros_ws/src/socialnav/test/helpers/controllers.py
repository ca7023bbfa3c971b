"""Controllers that decide without the middleware."""

import dataclasses

import numpy as np

from helpers.worlds import BODY, messages_of, random_state
from socialnav.control.controller import Controller
from socialnav.parameters.policy import PolicyParameters
from socialnav_core.policies import PolicyDescription

SECOND = 10**9
SETTINGS = PolicyParameters(bounds=BODY.bounds)
LOCKSTEP = dataclasses.replace(
    SETTINGS, lockstep=True, controller_frequency=4.0, stop_publish_timeout=0.0
)


class Recorder:
    """A policy that keeps what it saw and drives east."""

    description = PolicyDescription('recorder', 'holonomic', remembers=True)
    predictor = None
    plan = None

    def __init__(self):
        self.states, self.limits, self.resets = [], [], 0
        self.command, self.error, self.duration = [0.5, 0.0], None, 0.0
        self.now = 0.0

    def act(self, state, limits=None):
        self.states.append(state)
        self.limits.append(limits)
        self.now += self.duration
        if self.error:
            raise self.error
        return np.array([self.command])

    def attention(self, state):
        return None

    def reset(self, worlds=None):
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
