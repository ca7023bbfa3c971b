"""From the newest inputs to a command; knows no rclpy."""
