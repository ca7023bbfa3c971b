"""An episode as the page plays it, with what the policy had in mind, in whole centimetres."""

from typing import Any

import numpy as np

from socialnav_core.config import Scenario
from socialnav_core.policies.protocol import Policy, PolicyDescription
from socialnav_core.policies.value.lookahead import Decision, ValuePolicy
from socialnav_core.prediction import Prediction, Predictor
from socialnav_core.simulation.kinematics import kinematics_of, Limits
from socialnav_core.states import CrowdState
from socialnav_core.viewing.recording import clearance, record, Recording

MOMENTS = np.array([0.75, 1.5, 2.25, 3.0])
"""When the positions of a predicted path are reached, s ahead."""
PLAN_POINTS = 12
"""A plan of more positions is thinned out to so many."""
REACH = 1.0
"""Actions are drawn where they would lead in this time, s."""
SCREENED = -1
"""Stands for the value of an action that must not be chosen."""
Playback = dict[str, Any]
"""Plain values, fit for JSON; drawing.js says what it reads."""


class Watched:
    """A policy that notes at each decision of one world what it has in mind."""

    def __init__(self, policy: Policy) -> None:
        """Watch a policy."""
        self.policy = policy
        self.plans: list[list[int]] = []
        self.predictions: list[list[int]] = []
        self.actions: list[list[list[int]]] = []

    @property
    def description(self) -> PolicyDescription:
        """Return what results tell of it."""
        return self.policy.description

    @property
    def predictor(self) -> Predictor | None:
        """Return what it predicts people by."""
        return self.policy.predictor

    @property
    def plan(self) -> np.ndarray | None:
        """Return where the latest decision leads."""
        return self.policy.plan

    def act(self, state: CrowdState, limits: Limits | None = None) -> np.ndarray:
        """Return the command, (1, 2), and note what led to it."""
        if isinstance(self.policy, ValuePolicy):
            decision = self.policy.decide(state, limits)
            self.actions.append(valued_actions(self.policy, decision, state))
            command = decision.command()
        else:
            command = self.policy.act(state, limits)
        if self.plan is not None:
            self.plans.append(centimetres(thinned(self.plan[0])))
        prediction = predicted(self.policy, state)
        if prediction is not None:
            self.predictions.append(paths_of(prediction, state))
        return command

    def attention(self, state: CrowdState) -> np.ndarray | None:
        """Return how much it looks at each agent, (1, agents)."""
        return self.policy.attention(state)

    def reset(self, worlds: np.ndarray | None = None) -> None:
        """Let it forget."""
        self.policy.reset(worlds)


def playback(
    policy: Policy, scenario: Scenario, seed: int, case: int, split: str, name: str
) -> Playback:
    """Run one case and return it as the page plays it."""
    watched = Watched(policy)
    recording = record(watched, scenario, seed, case, split, name)
    start = recording.states[0]
    obstacles = start.agents.valid[0] & start.agents.static[0]
    people = np.flatnonzero(~start.agents.static[0])
    order = np.concatenate([people, np.flatnonzero(obstacles)])
    bounds = float(start.bounds[0])
    near = recording.minimum_clearance
    return {
        'policy': name,
        'case': case,
        'outcome': recording.outcome,
        'times': [round(float(time), 3) for time in recording.times],
        'closest': round(near, 3) if np.isfinite(near) else None,
        'bounds': round(100 * bounds) if np.isfinite(bounds) else None,
        'goal': centimetres(start.robot.goal[0]),
        'tolerance': round(100 * recording.goal_tolerance),
        'radius': round(100 * float(start.robot.radius[0])),
        'obstacles': [
            centimetres([*start.agents.position[0, i], start.agents.radius[0, i]])
            for i in np.flatnonzero(obstacles)
        ],
        'robot': centimetres(recording.robot_path),
        'heading': headings(recording),
        'people': [people_at(state, people) for state in recording.states],
        'sizes': sizes(recording, people),
        'gaps': [gap_of(state) for state in recording.states],
        'attention': [whole(100 * each[order]) for each in recording.attention or ()],
        'plan': watched.plans,
        'predicted': watched.predictions,
        'actions': watched.actions,
    }


def valued_actions(policy: ValuePolicy, decision: Decision, state: CrowdState) -> list[list[int]]:
    """
    Return where the actions of one world lead in REACH, cm from the robot, and their values.

    Values go from 0, the worst, to 100, the best; SCREENED where an action must not be chosen.
    """
    commands, values = decision.commands[:1], decision.values[0].astype(float)
    motion = kinematics_of(policy.kinematics)
    displacement, _, _ = motion.move(state.robot.heading[:1, None], commands, REACH)
    allowed = np.isfinite(values)
    worst = values[allowed].min(initial=np.inf)
    span = values[allowed].max(initial=-np.inf) - worst
    shares = np.zeros_like(values) if not span > 0.0 else (values - worst) / span
    return [centimetres(displacement[0]), whole(np.where(allowed, 100 * shares, SCREENED))]


def predicted(policy: Policy, state: CrowdState) -> Prediction | None:
    """
    Return where a policy expects the people of one world at MOMENTS, None where it does not tell.

    A predictor with a history must not see a state twice: of such a one the policy's own note of
    its latest prediction is taken, at those of its times that come nearest.
    """
    if policy.predictor is None:
        return None
    noted, times = getattr(policy, 'prediction', None), getattr(policy, 'times', None)
    if noted is not None and times is not None:
        steps = np.unique(np.abs(times[:, None] - MOMENTS).argmin(axis=0))
        return Prediction(noted.positions[:, :, steps], noted.deviations[:, :, steps],
                          noted.weights)  # fmt: skip
    return None if policy.predictor.remembers else policy.predictor.predict(state, MOMENTS)


def paths_of(prediction: Prediction, state: CrowdState) -> list[int]:
    """Return the likeliest path of each person, cm from where each is, all in one row."""
    people = np.flatnonzero(~state.agents.static[0])
    likeliest = prediction.positions[0, prediction.weights[0].argmax()][:, people]
    offsets = likeliest - state.agents.position[0, people]  # (steps, people, 2)
    return centimetres(offsets.swapaxes(0, 1))


def people_at(state: CrowdState, people: np.ndarray) -> list[int | None]:
    """Return where people are, cm, one after the other; None where nobody is."""
    places = centimetres(state.agents.position[0, people])
    there = np.repeat(state.agents.valid[0, people], 2)
    return [place if valid else None for place, valid in zip(places, there, strict=True)]


def sizes(recording: Recording, people: np.ndarray) -> list[list[int]]:
    """Return the radii of people, cm: once where they stay the same, else for each state."""
    radii = [centimetres(state.agents.radius[0, people]) for state in recording.states]
    return radii[:1] if all(each == radii[0] for each in radii) else radii


def headings(recording: Recording) -> list[int]:
    """Return where a robot that has a front looks in each state, degrees; nothing for others."""
    if recording.kinematics == 'holonomic':
        return []
    return [round(float(np.degrees(state.robot.heading[0]))) for state in recording.states]


def gap_of(state: CrowdState) -> int | None:
    """Return the gap between the robot and whoever is nearest, cm; None without anybody."""
    gap = clearance(state)
    return round(100 * gap) if np.isfinite(gap) else None


def thinned(points: np.ndarray) -> np.ndarray:
    """Return at most PLAN_POINTS of some points, the last among them."""
    if len(points) <= PLAN_POINTS:
        return points
    kept = np.linspace(len(points) / PLAN_POINTS, len(points), PLAN_POINTS)
    return points[np.rint(kept).astype(int) - 1]


def centimetres(metres: Any) -> list[int]:
    """Return lengths as whole centimetres in one row."""
    return whole(100 * np.asarray(metres, float))


def whole(numbers: np.ndarray) -> list[int]:
    """Return numbers rounded, in one row."""
    rounded: list[int] = np.rint(numbers).astype(int).ravel().tolist()
    return rounded
