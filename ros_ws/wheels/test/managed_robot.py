"""A program that is a managed node, until it is told to end."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.lifecycle import LifecycleNode


def main() -> None:
    """Serve the node."""
    rclpy.init()
    node = LifecycleNode('robot', namespace='/crowd', enable_communication_interface=True)
    print('ready', flush=True)
    try:
        rclpy.spin(node)
    except ExternalShutdownException:
        return


if __name__ == '__main__':
    main()
