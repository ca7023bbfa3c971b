"""The commands of ros2cli that the project's pages use, over rclpy, for where ros2cli is not packaged."""
