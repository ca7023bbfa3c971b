"""
A plain reference for speed ratios: one world at a time, in Python, as research code has it.

Every pedestrian owns a simulator of RVO2 (C++, through pyrvo), built once per episode and
refreshed each step. Collisions, rewards, goals and features are loops over agents, and the network
sees one action at a time. Nothing is slowed on purpose, and nothing is shared with the package, so
that the ratios keep their meaning when the package gets faster.
"""

from collections.abc import Sequence
import dataclasses
import math
import time

import numpy as np
import pyrvo
import torch
from torch import nn

TIME_STEP, TIME_LIMIT = 0.25, 25.0
SPAWN, BOUNDS = 5.0, 7.5  # half-widths, m
RADIUS, SPEED, PADDING = 0.3, 1.0, 0.01
NEIGHBOR_DISTANCE, MAX_NEIGHBORS, TIME_HORIZON = 10.0, 10, 5.0
COMFORT = 0.2
DISCOUNT = 0.9
PLACEMENT_ATTEMPTS = 10_000


@dataclasses.dataclass
class Disc:
    """A robot, pedestrian or obstacle: metres and metres per second; obstacles have speed 0."""

    x: float
    y: float
    goal_x: float
    goal_y: float
    radius: float = RADIUS
    speed: float = SPEED
    velocity_x: float = 0.0
    velocity_y: float = 0.0

    def to_goal(self) -> tuple[float, float]:
        """Return the preferred velocity: to the goal, slower within the last metre."""
        x, y = self.goal_x - self.x, self.goal_y - self.y
        scale = self.speed / max(1.0, math.hypot(x, y))
        return x * scale, y * scale

    def move(self, velocity: tuple[float, float]) -> None:
        """Advance by one step."""
        self.velocity_x, self.velocity_y = velocity
        self.x += self.velocity_x * TIME_STEP
        self.y += self.velocity_y * TIME_STEP


class OrcaPedestrian:
    """
    Decides for one pedestrian with a private simulator of RVO2, as research code does.

    RVO2 offers no step of a single agent, so each simulator decides for all of its agents.
    """

    def __init__(self, disc: Disc, others: Sequence[Disc]) -> None:
        """Build the simulator: the pedestrian is its agent 0."""
        self.simulator = pyrvo.RVOSimulator(
            TIME_STEP, NEIGHBOR_DISTANCE, MAX_NEIGHBORS, TIME_HORIZON, TIME_HORIZON, RADIUS, SPEED
        )
        for agent in (disc, *others):
            self.simulator.add_agent(
                (agent.x, agent.y), NEIGHBOR_DISTANCE, MAX_NEIGHBORS, TIME_HORIZON, TIME_HORIZON,
                agent.radius + PADDING, agent.speed, (agent.velocity_x, agent.velocity_y),
            )  # fmt: skip

    def decide(self, disc: Disc, others: Sequence[Disc]) -> tuple[float, float]:
        """Return the velocity of the pedestrian among the others."""
        for index, agent in enumerate((disc, *others)):
            self.simulator.set_agent_position(index, (agent.x, agent.y))
            self.simulator.set_agent_velocity(index, (agent.velocity_x, agent.velocity_y))
        self.simulator.set_agent_pref_velocity(0, disc.to_goal())
        self.simulator.do_step()
        return self.simulator.get_agent_velocity(0).to_tuple()


class ReferenceWorld:
    """One world with a robot that the pedestrians do not see."""

    def __init__(
        self, pedestrians: int, obstacles: int, seed: int = 0, obstacle_radius: float = RADIUS
    ) -> None:
        """Keep the numbers of agents; reset() starts an episode."""
        self.counts = pedestrians, obstacles
        self.obstacle_radius = obstacle_radius
        self.generator = np.random.default_rng(seed)

    def reset(self) -> list[tuple[float, ...]]:
        """Start an episode and return what the robot sees."""
        self.time = 0.0
        self.robot = self._place_robot()
        self.obstacles: list[Disc] = []
        for _ in range(self.counts[1]):
            x, y = self._free_point(SPAWN, self.obstacle_radius, [self.robot, *self.obstacles])
            self.obstacles.append(Disc(x, y, x, y, self.obstacle_radius, 0.0))
        self.pedestrians: list[Disc] = []
        for _ in range(self.counts[0]):
            placed = [self.robot, *self.obstacles, *self.pedestrians]
            x, y = self._free_point(SPAWN, RADIUS, placed)
            self.pedestrians.append(Disc(x, y, *self._free_goal()))
        self.deciders = [OrcaPedestrian(*self._split(i)) for i in range(self.counts[0])]
        return self.observation()

    def step(self, command: tuple[float, float]) -> tuple[list[tuple[float, ...]], float, bool]:
        """Advance by one step and return (observation, reward, whether the episode ended)."""
        velocities, agents = self.velocities(), self.pedestrians + self.obstacles
        reward, ended = judge(self.robot, command, agents, velocities)
        self.robot.move(command)
        for agent, velocity in zip(agents, velocities, strict=True):
            agent.move(velocity)
        for pedestrian in self.pedestrians:
            left = pedestrian.goal_x - pedestrian.x, pedestrian.goal_y - pedestrian.y
            if math.hypot(*left) < pedestrian.radius:
                pedestrian.goal_x, pedestrian.goal_y = self._free_goal()
        self.time += TIME_STEP
        return self.observation(), reward, ended or self.time >= TIME_LIMIT

    def velocities(self) -> list[tuple[float, float]]:
        """Return what all agents will do in the coming step."""
        return [decider.decide(*self._split(i)) for i, decider in enumerate(self.deciders)] + [
            (0.0, 0.0)
        ] * len(self.obstacles)

    def observation(self) -> list[tuple[float, ...]]:
        """Return (x, y, vx, vy, radius) of every other agent."""
        return [
            (agent.x, agent.y, agent.velocity_x, agent.velocity_y, agent.radius)
            for agent in self.pedestrians + self.obstacles
        ]

    def _split(self, index: int) -> tuple[Disc, list[Disc]]:
        """Return a pedestrian and everybody else."""
        others = self.pedestrians[:index] + self.pedestrians[index + 1 :] + self.obstacles
        return self.pedestrians[index], others

    def _place_robot(self) -> Disc:
        """Return a robot whose goal, on the circle of radius SPAWN, is far from its start."""
        while True:  # a third of all draws are far enough
            goal, start = (self._circle_point() for _ in range(2))
            start = [value + self.generator.uniform(-1.25, 1.25) for value in start]
            if max(abs(goal[0] - start[0]), abs(goal[1] - start[1])) > 7.5:
                return Disc(*start, *goal)

    def _circle_point(self) -> tuple[float, float]:
        """Return a point on the circle of radius SPAWN."""
        angle = self.generator.uniform(0.0, 2.0 * math.pi)
        return SPAWN * math.cos(angle), SPAWN * math.sin(angle)

    def _free_goal(self) -> tuple[float, float]:
        """Return a pedestrian's goal that no obstacle covers."""
        for _ in range(PLACEMENT_ATTEMPTS):
            x, y = self._circle_point()
            if all(
                math.hypot(x - other.x, y - other.y) > other.radius + RADIUS + COMFORT
                for other in self.obstacles
            ):
                return x, y
        raise RuntimeError('no room for a goal: use fewer or smaller obstacles')

    def _free_point(
        self, half_width: float, radius: float, others: Sequence[Disc]
    ) -> tuple[float, float]:
        """Return a point of a square where a disc keeps its distance from the others."""
        for _ in range(PLACEMENT_ATTEMPTS):
            x, y = self.generator.uniform(-half_width, half_width, 2).tolist()
            if all(
                math.hypot(x - other.x, y - other.y) > other.radius + radius + COMFORT
                for other in others
            ):
                return x, y
        raise RuntimeError('no room for an agent: use fewer or smaller ones')


def judge(
    robot: Disc,
    command: tuple[float, float],
    agents: Sequence[Disc],
    velocities: Sequence[tuple[float, float]],
) -> tuple[float, bool]:
    """Return the reward of a step and whether it ends the episode."""
    clearance = math.inf
    for agent, velocity in zip(agents, velocities, strict=True):
        x, y = agent.x - robot.x, agent.y - robot.y
        move_x = (velocity[0] - command[0]) * TIME_STEP
        move_y = (velocity[1] - command[1]) * TIME_STEP
        length = move_x * move_x + move_y * move_y
        share = -(x * move_x + y * move_y) / length if length > 0.0 else 0.0
        share = min(1.0, max(0.0, share))
        gap = math.hypot(x + share * move_x, y + share * move_y) - agent.radius - robot.radius
        clearance = min(clearance, gap)
    end_x, end_y = robot.x + command[0] * TIME_STEP, robot.y + command[1] * TIME_STEP
    wall = BOUNDS - max(abs(end_x), abs(end_y)) - robot.radius
    if clearance < 0.0 or wall < 0.0:
        return -0.25, True
    if math.hypot(robot.goal_x - end_x, robot.goal_y - end_y) < RADIUS:
        return 1.0, True
    return min(0.0, min(clearance, wall) - COMFORT) * 0.5 * TIME_STEP, False


def reference_steps_per_second(pedestrians: int, obstacles: int, seconds: float = 3.0) -> float:
    """
    Return how many steps a second the reference takes, starts of episodes included.

    :param pedestrians: Number of pedestrians, all of which decide by ORCA.
    :param obstacles: Number of obstacles of radius 0.3 m.
    """
    world, steps, ended = ReferenceWorld(pedestrians, obstacles), 0, True
    start = time.perf_counter()
    while time.perf_counter() - start < seconds:
        if ended:
            world.reset()
        _, _, ended = world.step(world.robot.to_goal())
        steps += 1
    return steps / (time.perf_counter() - start)


def features(robot: Disc, agents: Sequence[Disc]) -> tuple[list[float], list[list[float]]]:
    """Return the robot's 6 features and each agent's 7, with the x axis towards the goal."""
    x, y = robot.goal_x - robot.x, robot.goal_y - robot.y
    distance, angle = math.hypot(x, y), math.atan2(y, x)
    cosine, sine = math.cos(angle), math.sin(angle)

    def rotate(x: float, y: float) -> tuple[float, float]:
        return x * cosine + y * sine, y * cosine - x * sine

    velocity = rotate(robot.velocity_x, robot.velocity_y)
    own = [distance, robot.speed, 0.0, robot.radius, *velocity]
    rows = []
    for agent in agents:
        offset_x, offset_y = agent.x - robot.x, agent.y - robot.y
        rows.append([
            *rotate(offset_x, offset_y), *rotate(agent.velocity_x, agent.velocity_y),
            agent.radius, math.hypot(offset_x, offset_y), agent.radius + robot.radius,
        ])  # fmt: skip
    return own, rows


def decide(
    network: nn.Module, world: ReferenceWorld, actions: Sequence[tuple[float, float]], oracle: bool
) -> tuple[float, float]:
    """
    Return the action of the greatest one-step look-ahead value.

    With the oracle the world is asked for each action what its agents will do, as published code
    asks its environment; otherwise agents keep their velocity.
    """
    robot, agents = world.robot, world.pedestrians + world.obstacles
    best_value, best_action = -math.inf, actions[0]
    velocities = [(agent.velocity_x, agent.velocity_y) for agent in agents]
    discount = DISCOUNT ** (TIME_STEP * robot.speed)
    for action in actions:
        if oracle:
            velocities = world.velocities()
        reward, ended = judge(robot, action, agents, velocities)
        value = reward
        if not ended:
            next_robot = dataclasses.replace(robot)
            next_robot.move(action)
            next_agents = [dataclasses.replace(agent) for agent in agents]
            for agent, velocity in zip(next_agents, velocities, strict=True):
                agent.move(velocity)
            own, rows = features(next_robot, next_agents)
            mask = torch.ones(1, len(rows), dtype=torch.bool)
            with torch.no_grad():
                value += discount * network(torch.tensor([own]), torch.tensor([rows]), mask).item()
        if value > best_value:
            best_value, best_action = value, action
    return best_action


def action_set(speeds: int, headings: int) -> list[tuple[float, float]]:
    """Return stop and, for exponentially spaced speeds up to SPEED, each heading, m/s."""
    actions = [(0.0, 0.0)]
    for i in range(1, speeds + 1):
        speed = (math.exp(i / speeds) - 1.0) / (math.e - 1.0) * SPEED
        for angle in np.linspace(0.0, 2.0 * math.pi, headings, endpoint=False).tolist():
            actions.append((speed * math.cos(angle), speed * math.sin(angle)))
    return actions


def reference_decision_seconds(
    network: nn.Module,
    actions: Sequence[tuple[float, float]],
    agents: int,
    repeats: int = 50,
    oracle: bool = False,
) -> np.ndarray:
    """
    Return the seconds that each of some decisions takes the reference, shape (repeats,).

    :param network: Value network, forward(robot (1, 6), others (1, agents, 7), mask (1, agents)).
    :param actions: Velocities to choose from, m/s, as of action_set.
    :param repeats: Number of decisions, in one episode after the other, after a first unmeasured.
    :param oracle: Whether the pedestrians' next step is known; else they keep their velocity.
    """
    world, ended, durations = ReferenceWorld(agents, 0), True, []
    for _ in range(repeats + 1):
        if ended:
            world.reset()
        start = time.perf_counter()
        action = decide(network, world, actions, oracle)
        durations.append(time.perf_counter() - start)
        _, _, ended = world.step(action)
    return np.array(durations[1:])
