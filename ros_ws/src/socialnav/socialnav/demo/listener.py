"""The listener of the demo: it knows an episode only from its topics."""

from collections.abc import Mapping
from functools import partial
import time
from typing import Any

from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseStamped, Twist, TwistStamped
from nav_msgs.msg import Odometry
from rclpy.node import Node
from visualization_msgs.msg import MarkerArray

from socialnav import qos
from socialnav.control.diagnostics import is_unusable
from socialnav.demo.bag import Bag
from socialnav.demo.episode_recorder import EpisodeRecorder
from socialnav_msgs.msg import AgentStates, EpisodeResult


class DemoNode(Node):
    """Listens to everything that an episode consists of."""

    def __init__(self, bag: Bag, topics: Mapping[str, str], lockstep: bool) -> None:
        """
        Subscribe.

        :param bag: takes all that is heard but diagnostics.
        :param topics: other names of topics.
        :param lockstep: whether commands have stamps.
        """
        super().__init__('demo')
        self.bag = bag
        self.recorder = EpisodeRecorder()
        self.results: list[EpisodeResult] = []
        self.latest_progress = self.latest_message = time.monotonic()
        self.problem: str | None = None
        self.facts: dict[str, str] = {}
        for name, kind, profile in (
            ('odom', Odometry, qos.RECORDING),
            ('pedestrians', AgentStates, qos.RECORDING),
            ('goal_pose', PoseStamped, qos.RECORDING),
            ('obstacles', AgentStates, qos.LATCHED_RECORDING),
        ):
            topic = topics.get(name, name)
            self.create_subscription(kind, topic, partial(self.on_input, name, topic), profile)
        for name, kind, profile in (
            ('cmd_vel', TwistStamped if lockstep else Twist, qos.RECORDING),
            ('markers', MarkerArray, qos.RECORDING),
        ):
            self.create_subscription(kind, name, partial(bag.write, f'/{name}'), profile)
        self.create_subscription(
            EpisodeResult, 'episode_result', self.on_result, qos.LATCHED_RECORDING
        )
        self.create_subscription(
            DiagnosticArray, '/diagnostics', self.on_diagnostics, qos.DIAGNOSTICS
        )

    def on_input(self, name: str, topic: str, message: Any) -> None:
        """Store a part of a state; it has a header."""
        self.latest_message = time.monotonic()
        self.bag.write(f'/{topic}', message)
        if self.recorder.store(name, message):
            self.latest_progress = self.latest_message

    def on_result(self, result: EpisodeResult) -> None:
        """Store how an episode ended."""
        self.bag.write('/episode_result', result)
        self.recorder.store_result(result)
        self.results.append(result)

    def on_diagnostics(self, message: DiagnosticArray) -> None:
        """Store what the policy counts, and why it cannot drive."""
        for status in message.status:
            if status.name != 'policy_node':
                continue
            self.facts = {value.key: value.value for value in status.values}
            if is_unusable(status):
                self.problem = status.message

    def punctuality(self) -> str:
        """Return how many decisions of the policy came too late, as far as is known."""
        late, decisions = (self.facts.get(f'{which}decisions', '?') for which in ('late ', ''))
        return f'{late} of {decisions} decisions were late'
