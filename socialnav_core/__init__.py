"""Robots that move among people: simulator, policies, training and evaluation, without ROS."""
