"""Crowds of many kinds, so that the network learns people and not one ORCA."""

import dataclasses
import math

import numpy as np

from socialnav_core.config import make_scenario, Scenario
from socialnav_core.config.prediction import CrowdMixture, SHARES
from socialnav_core.simulation.cases import Episodes
from socialnav_core.simulation.crowds.goals import renew_goals, velocities_to_goals
from socialnav_core.simulation.crowds.orca import RADIUS_PADDING, RECIPROCAL
from socialnav_core.simulation.crowds.orca_kernel import Bodies, Foresight, orca_step
from socialnav_core.simulation.crowds.social_force_kernel import social_force_step
from socialnav_core.training.prediction.recording import Recording
from socialnav_core.training.prediction.streets import as_tracked, FAR, walk_along, with_company

NAMED = ('crowd20', 'hard', 'packed-2.5', 'curriculum-2.5', 'simple')
TIME_STEPS = (0.1, 0.125, 0.2, 0.25)
PASSING_SHARE = 0.5
"""Share of the crowds, scenarios aside, whose people walk straight on through their world."""
USUAL_RADIUS_SHARE = 0.3
"""Share of the crowds, scenarios aside, whose people have the radius that trackers assume."""
STREET_TIME_STEPS = (0.1, 0.2, 0.25, 0.4)
TRACKED_SHARE = 0.3
"""Share of the crowds, scenarios and streets aside, that are seen as by a tracker."""
RATES = {'stop_and_go': (0.12, 0.03), 'street': (0.03, 0.0)}
"""How often people stop, and how often they turn to another goal, 1/s."""


@dataclasses.dataclass(frozen=True)
class Crowd:
    """A crowd as it was drawn: its world, and how its people decide."""

    kind: str
    """One of SHARES."""
    scenario: Scenario
    """Layout, numbers, time step and settings of ORCA."""
    unaware_share: float = 0.0
    """Share of the people who avoid nobody."""
    passing: bool = False
    """Whether people walk on instead of turning within their world."""
    tracked: bool = False
    """Whether bodies sway, and velocities are differences of marked positions."""
    force: tuple[float, float, float, float] = (2.0, 0.3, 0.5, 0.3)
    """Strength, reach, relaxation and share from behind of social forces."""


def draw_kind(mixture: CrowdMixture, generator: np.random.Generator) -> str:
    """Return a random kind of crowd."""
    shares = np.array([getattr(mixture, name) for name in SHARES])
    return SHARES[generator.choice(len(SHARES), p=shares / shares.sum())]


def draw_crowd(kind: str, generator: np.random.Generator) -> Crowd:
    """Return a crowd of a kind, one of SHARES, with random settings."""
    if kind == 'scenarios':
        name = NAMED[generator.choice(len(NAMED), p=(0.4, 0.2, 0.15, 0.15, 0.1))]
        return Crowd(kind, make_scenario(name))
    force = tuple(generator.uniform((1.0, 0.15, 0.4, 0.1), (4.0, 0.5, 0.8, 0.6)).tolist())
    share = generator.uniform(0.2, 1.0) if kind == 'unaware' else 0.0
    passing = bool(generator.random() < PASSING_SHARE)
    tracked = bool(generator.random() < TRACKED_SHARE) or kind == 'street'
    scenario = draw_scenario(generator)
    if kind == 'street':
        time_step = float(generator.choice(STREET_TIME_STEPS))
        scenario = dataclasses.replace(scenario, time_step=time_step)
    return Crowd(kind, scenario, share, passing, tracked, force)


def draw_scenario(generator: np.random.Generator) -> Scenario:
    """Return a world of 1 to 30 people and up to 10 obstacles that has room for them."""
    people = int(generator.integers(1, 31))
    obstacles = int(generator.integers(0, 11)) * int(generator.random() < 0.6)
    small, large = np.sort(generator.uniform(0.2, 1.5, 2))
    area = 2.2 * people + obstacles * (small + large + 1.2) ** 2
    half_width = float(np.clip(0.5 * math.sqrt(generator.uniform(2.0, 6.0) * area), 4.0, 14.0))
    plain = Scenario('mixed').orca
    orca = dataclasses.replace(
        plain,
        neighbor_distance=float(generator.uniform(2.0, 10.0)),
        max_neighbors=int(generator.integers(4, 11)),
        time_horizon=float(generator.uniform(1.0, 7.0)),
        safety_space=float(generator.uniform(0.0, 0.2)),
    )
    return Scenario(
        'mixed',
        pedestrians=people,
        obstacles=obstacles,
        obstacle_radius_min=float(small),
        obstacle_radius_max=float(large),
        spawn_half_width=half_width,
        minimum_travel=half_width,
        bounds=math.inf,
        pedestrian_radius=0.5,  # room for the largest; draw_people makes them smaller
        time_step=float(generator.choice(TIME_STEPS)),
        orca=orca,
    )


def record(
    crowd: Crowd,
    worlds: int,
    duration: float,
    split: str,
    seed: int,
    first_case: int,
    generator: np.random.Generator,
) -> Recording:
    """
    Return some worlds of a crowd, recorded from their start; the robot is not there.

    :param duration: s.
    :param split: of the layouts and goals: train, validation or test.
    :param seed: of the layouts and goals.
    :param first_case: layouts are those of this case and the next ones.
    :param generator: of all else that people do.
    :raises PackingError: when a layout does not fit.
    """
    scenario = crowd.scenario
    episodes = Episodes(scenario, worlds)
    episodes.begin(seed, split, np.arange(first_case, first_case + worlds))
    episodes.start(np.arange(worlds))
    people = scenario.pedestrians
    unaware, pause = draw_people(crowd, episodes, generator)
    agents = episodes.state.agents
    moments = round(duration / scenario.time_step) + 1
    position = np.empty((worlds, moments, people, 2), np.float32)
    velocity, goal = np.empty_like(position), np.empty_like(position)
    decided = np.zeros_like(agents.velocity)
    for moment in range(moments):
        position[:, moment] = agents.position[:, :people]
        velocity[:, moment] = agents.velocity[:, :people]
        goal[:, moment] = episodes.goal[:, :people]
        if crowd.kind in RATES:
            change_minds(crowd, episodes, pause, generator)
        decide(crowd, episodes, unaware, pause > 0, decided)
        agents.velocity[:] = decided
        agents.position += decided * scenario.time_step
        renew_goals(episodes)
    recording = Recording(
        scenario.time_step, position, velocity, goal, agents.radius.copy(),
        agents.position[:, people:].copy(),
    )  # fmt: skip
    if crowd.kind == 'street':
        recording = with_company(recording, generator)
    return as_tracked(recording, generator) if crowd.tracked else recording


def draw_people(
    crowd: Crowd, episodes: Episodes, generator: np.random.Generator
) -> tuple[np.ndarray, np.ndarray]:
    """
    Give people speeds, radii and goals; return who avoids nobody and who pauses how long.

    People of named scenarios stay as they are. Shapes are (worlds, people).
    """
    people = crowd.scenario.pedestrians
    shape = (len(episodes.goal), people)
    if crowd.kind != 'scenarios':
        spread = generator.random()  # from all alike to all different
        for array, low, high in ((episodes.preferred_speed, 0.4, 1.6),
                                 (episodes.state.agents.radius, 0.2, 0.5)):  # fmt: skip
            common, own = generator.uniform(low, high), generator.uniform(low, high, shape)
            array[:, :people] = common + spread * (own - common)
        if generator.random() < USUAL_RADIUS_SHARE:
            episodes.state.agents.radius[:, :people] = Scenario('usual').pedestrian_radius
    unaware, pause = generator.random(shape) < crowd.unaware_share, np.zeros(shape)
    if crowd.kind == 'street':
        pause = walk_along(episodes, people, generator)
    elif crowd.passing:
        start, goal = episodes.state.agents.position[:, :people], episodes.goal[:, :people]
        way = goal - start
        goal[:] = start + FAR * way / np.linalg.norm(way, axis=-1, keepdims=True)
    return unaware, pause


def change_minds(
    crowd: Crowd, episodes: Episodes, pause: np.ndarray, generator: np.random.Generator
) -> None:
    """Let some people stop for .5 to 4 s and some turn to another goal, in place."""
    step, (stop_rate, goal_rate) = crowd.scenario.time_step, RATES[crowd.kind]
    pause -= step
    stops = (pause <= 0) & (generator.random(pause.shape) < stop_rate * step)
    pause[stops] = generator.uniform(0.5, 4.0, pause.shape)[stops]
    turns = generator.random(pause.shape) < goal_rate * step
    here = episodes.state.agents.position[:, : pause.shape[1]]
    episodes.goal[:, : pause.shape[1]][turns] = here[turns]  # arrived: renew_goals draws another


def decide(
    crowd: Crowd, episodes: Episodes, unaware: np.ndarray, pausing: np.ndarray, out: np.ndarray
) -> None:
    """
    Write the velocities of all agents until the next decision.

    :param unaware: who avoids nobody, (worlds, people); so is pausing.
    :param out: m/s, (worlds, agents, 2), zero for obstacles.
    """
    scenario, agents = crowd.scenario, episodes.state.agents
    people, orca = scenario.pedestrians, scenario.orca
    preferred = velocities_to_goals(episodes, agents.count)
    preferred[:, :people][pausing] = 0.0
    if crowd.kind == 'social_force':
        social_force_step(
            agents.position, agents.velocity, preferred, agents.radius, episodes.preferred_speed,
            people, *crowd.force, scenario.time_step, out,
        )  # fmt: skip
        return
    distance = np.full_like(agents.radius, orca.neighbor_distance)
    distance[:, :people][unaware] = 0.0
    bodies = Bodies(
        position=agents.position,
        velocity=agents.velocity,
        preferred_velocity=preferred,
        radius=agents.radius + (RADIUS_PADDING + orca.safety_space),
        max_speed=episodes.preferred_speed,
        valid=agents.valid,
        responsibility=np.where(agents.static, orca.static_responsibility, RECIPROCAL),
        neighbor_distance=distance,
    )
    foresight = Foresight(orca.max_neighbors, orca.time_horizon, scenario.time_step)
    orca_step(bodies, foresight, np.ones(len(preferred), bool), people, out)
    out[:, :people][pausing] = 0.0  # who pauses steps aside for nobody
