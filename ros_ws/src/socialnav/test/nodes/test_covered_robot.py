"""A robot that is told to be among the people stands and says so, over the middleware."""

from helpers.driving import Drive
from helpers.sensing import resting_state


def test_a_tracker_that_takes_the_robot_for_a_person_is_named(graph):
    drive, free = Drive(graph).start(), resting_state()
    drive.moves(free)
    listed = resting_state(pedestrians=1)
    listed.agents.position[:], listed.agents.velocity[:] = 0.02, 0.0
    drive.stands('does the tracker take the robot for a person?', listed, 'robot listed as person')
    drive.moves(free)
