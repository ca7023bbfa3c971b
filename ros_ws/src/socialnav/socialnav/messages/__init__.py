"""Between ROS messages and arrays, each once."""
