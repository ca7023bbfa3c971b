"""ROS 2 nodes of socialnav: a policy that drives a robot, and a crowd to drive in."""
