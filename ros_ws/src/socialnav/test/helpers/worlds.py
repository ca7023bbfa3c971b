"""Small worlds for tests."""

from geometry_msgs.msg import PoseStamped, Quaternion
from nav_msgs.msg import Odometry
import numpy as np

from socialnav.messages.conversions import RobotBody
from socialnav.messages.filling import filled
from socialnav_core.messages import agent_states, goal, odometry
from socialnav_core.messages.parts import rotation
from socialnav_core.states import Agents, CrowdState, Robot
from socialnav_msgs.msg import AgentStates

BODY = RobotBody(radius=0.3, preferred_speed=1.0, bounds=7.5)


def random_state(seed: int, pedestrians: int = 3, obstacles: int = 2) -> CrowdState:
    """Return a world in which nothing is round, batch of one."""
    generator = np.random.default_rng(seed)
    agents = pedestrians + obstacles
    static = np.arange(agents)[None] >= pedestrians
    velocity = generator.normal(size=(1, agents, 2))
    velocity[static] = 0.0
    return CrowdState(
        Robot(
            position=generator.normal(size=(1, 2)),
            velocity=generator.normal(size=(1, 2)),
            heading=generator.uniform(-np.pi, np.pi, 1),
            radius=np.array([BODY.radius]),
            preferred_speed=np.array([BODY.preferred_speed]),
            goal=generator.normal(size=(1, 2)) + 5.0,
        ),
        Agents(
            position=generator.normal(scale=3.0, size=(1, agents, 2)),
            velocity=velocity,
            radius=generator.uniform(0.2, 0.5, (1, agents)),
            static=static,
            valid=np.ones((1, agents), dtype=bool),
        ),
        bounds=np.array([BODY.bounds]),
        time=np.array([0.5]),
    )


def apart(state: CrowdState) -> CrowdState:
    """Return a world in which nobody is nearer to the robot than half a metre."""
    offset = state.agents.position - state.robot.position[:, None]
    distance = np.linalg.norm(offset, axis=-1)
    wanted = np.maximum(distance, state.agents.radius + state.robot.radius[:, None] + 0.5)
    position = state.robot.position[:, None] + offset * (wanted / distance)[..., None]
    return state.with_agents(position=position)


def messages_of(state: CrowdState, stamp: int = 0, frame: str = 'odom') -> dict:
    """Return the four inputs of a policy."""
    return {
        'odom': filled(Odometry, odometry(state, stamp, frame, 'base_link')),
        'goal_pose': filled(PoseStamped, goal(state, stamp, frame)),
        'pedestrians': filled(AgentStates, agent_states(state, False, stamp, frame)),
        'obstacles': filled(AgentStates, agent_states(state, True, stamp, frame)),
    }


def quaternion_of(heading: float) -> Quaternion:
    """Return the rotation about the z axis by an angle, rad."""
    return filled(Quaternion, rotation(heading))
