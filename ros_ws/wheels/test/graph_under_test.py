"""A node with every kind of endpoint that the commands are tried on."""

from pathlib import Path
import random
from threading import Thread

from geometry_msgs.msg import PoseStamped
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor
import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import String
from std_srvs.srv import SetBool

WORKSPACE = Path(__file__).resolve().parents[2]
ISOLATION = {
    'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST',
    'ROS_DOMAIN_ID': str(random.SystemRandom().randint(1, 100)),
    'FASTRTPS_DEFAULT_PROFILES_FILE': str(
        WORKSPACE / 'src' / 'socialnav' / 'config' / 'fast_discovery.xml'
    ),
}
"""Variables that keep a graph on this machine, in a domain of its own, and quick to discover."""
RATE = 20.0
"""Of the pose, Hz."""
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
RELIABLE = QoSProfile(depth=1)
SPEED = ParameterDescriptor(
    description='speed to walk at [m/s]',
    floating_point_range=[FloatingPointRange(from_value=0.0, to_value=2.0)],
)
UNRELIABLE = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)


class Talker:
    """Publishes in a thread of its own until it is closed."""

    def __init__(self) -> None:
        rclpy.init()
        self.node = rclpy.create_node('talker', namespace='/crowd')
        self.node.create_publisher(String, '/once', LATCHED).publish(String(data='said before'))
        self.pose = self.node.create_publisher(PoseStamped, 'pose', UNRELIABLE)
        self.voices = [
            self.node.create_publisher(String, '/mixed', profile)
            for profile in (RELIABLE, UNRELIABLE)
        ]
        self.node.create_publisher(String, '/_secret', 1)
        self.heard: list[str] = []
        self.node.create_subscription(String, '/heard', self.on_heard, 10)
        self.node.create_timer(1.0 / RATE, self.talk)
        self.node.declare_parameter('speed', 0.5, SPEED)
        self.node.declare_parameter('waypoints', [1, 2])
        self.node.create_service(SetBool, 'mute', self.on_mute)
        self.executor = SingleThreadedExecutor()
        self.executor.add_node(self.node)
        self.thread = Thread(target=self.spin)
        self.thread.start()

    def talk(self) -> None:
        """Publish a pose, and a word with each reliability."""
        message = PoseStamped()
        message.header.frame_id = 'map'
        message.pose.position.x = 1.5
        self.pose.publish(message)
        for voice, word in zip(self.voices, ('reliable', 'unreliable'), strict=True):
            voice.publish(String(data=word))

    def on_heard(self, message: String) -> None:
        """Keep what was heard."""
        self.heard.append(message.data)

    def on_mute(self, request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
        """Answer with what was asked."""
        response.success = True
        response.message = f'data was {request.data}'
        return response

    def spin(self) -> None:
        """Publish until the node is closed."""
        try:
            self.executor.spin()
        except ExternalShutdownException:
            return

    def close(self) -> None:
        """Leave the graph."""
        self.executor.shutdown()
        self.thread.join()
        self.node.destroy_node()
        rclpy.try_shutdown()
