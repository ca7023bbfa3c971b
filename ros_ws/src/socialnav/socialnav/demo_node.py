"""The listener of the demo: it knows an episode only from its topics."""

from functools import partial
import time
from typing import Any

from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseStamped, Twist, TwistStamped
from nav_msgs.msg import Odometry
from rclpy.node import Node
from visualization_msgs.msg import MarkerArray

from socialnav import qos
from socialnav.bag import Bag
from socialnav.diagnostics import is_unusable
from socialnav.episode_recorder import EpisodeRecorder
from socialnav_msgs.msg import AgentStates, EpisodeResult


class DemoNode(Node):
    """Listens to everything that an episode consists of."""

    def __init__(self, bag: Bag, lockstep: bool) -> None:
        """
        Subscribe.

        :param bag: takes all that is heard but diagnostics.
        :param lockstep: whether commands have stamps.
        """
        super().__init__('demo')
        self.bag = bag
        self.recorder = EpisodeRecorder()
        self.results: list[EpisodeResult] = []
        self.latest_progress = self.latest_message = time.monotonic()
        self.problem: str | None = None
        for name, kind, profile in (
            ('odom', Odometry, qos.RECORDING),
            ('pedestrians', AgentStates, qos.RECORDING),
            ('goal_pose', PoseStamped, qos.RECORDING),
            ('obstacles', AgentStates, qos.LATCHED_RECORDING),
        ):
            self.create_subscription(kind, name, partial(self.on_input, name), profile)
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

    def on_input(self, name: str, message: Any) -> None:
        """
        Store a part of a state.

        :param name: its topic.
        :param message: it has a header.
        """
        self.latest_message = time.monotonic()
        self.bag.write(f'/{name}', message)
        if self.recorder.store(name, message):
            self.latest_progress = self.latest_message

    def on_result(self, result: EpisodeResult) -> None:
        """
        Store how an episode ended.

        :param result: of the episode.
        """
        self.bag.write('/episode_result', result)
        self.recorder.store_result(result)
        self.results.append(result)

    def on_diagnostics(self, message: DiagnosticArray) -> None:
        """
        Store why the policy cannot drive.

        :param message: health of a node.
        """
        for status in message.status:
            if status.name == 'policy_node' and is_unusable(status):
                self.problem = status.message
