"""What ROS 2 messages hold, as plain mappings: written into bags, filled into messages."""

from socialnav_core.messages.agents import agent_states, agent_states_of
from socialnav_core.messages.intentions import attention_markers, planned_path, predicted_path
from socialnav_core.messages.markers import world_markers
from socialnav_core.messages.parts import header, Message
from socialnav_core.messages.results import episode_result, EpisodeEnd
from socialnav_core.messages.robot import goal, odometry, stamped_twist, twist

__all__ = [
    'EpisodeEnd', 'Message', 'agent_states', 'agent_states_of', 'attention_markers',
    'episode_result', 'goal', 'header', 'odometry', 'planned_path', 'predicted_path',
    'stamped_twist', 'twist', 'world_markers',
]  # fmt: skip
