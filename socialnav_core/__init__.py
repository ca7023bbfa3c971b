"""Robots that move among people: simulator, policies, training and evaluation, without ROS."""

__version__ = '0.1.0'
"""The one place that says it; setup.py reads it here, tests hold the other files to it."""
