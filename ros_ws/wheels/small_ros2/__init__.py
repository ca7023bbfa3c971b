"""Those commands of ros2cli that a user of this project needs, over rclpy alone."""
