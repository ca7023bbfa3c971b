"""Laws of the tracker node, over the middleware."""

import signal

from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseArray
import numpy as np
import pytest

from socialnav import qos
from socialnav.messages.sensor_messages import detections_message
from socialnav.messages.stamps import nanoseconds_of
from socialnav_msgs.msg import AgentStates

SECOND = 10**9
STEP = SECOND // 20
VELOCITY = np.array([[1.0, 0.0], [-0.5, 0.5]])
START = np.array([[0.0, 0.0], [3.0, 1.0]])


class Detector:
    """Publishes detections with stamps of its own, and collects pedestrians."""

    def __init__(self, graph, **parameters):
        self.graph, self.stamp = graph, SECOND
        self.publisher = graph.node.create_publisher(PoseArray, 'detections', qos.DETECTIONS)
        self.pedestrians = graph.listen(AgentStates, 'pedestrians', qos.PEDESTRIANS)
        self.health = graph.listen(DiagnosticArray, '/diagnostics', qos.DIAGNOSTICS)
        self.process = graph.start('tracker_node', **parameters)
        graph.wait(self.publisher.get_subscription_count, 'node')

    def tell(self, positions, frame='odom', delay=0, step=STEP):
        """Publish detections of the next moment, or of one before it, ns."""
        self.stamp += step
        self.publisher.publish(detections_message(positions, self.stamp - delay, frame))

    def answer(self, positions):
        """Publish detections until they are answered; return the answer."""
        self.pedestrians.clear()

        def answered():
            self.tell(positions(self.stamp + STEP))
            self.graph.spin(0.05)
            return self.pedestrians

        return self.graph.wait(answered, 'pedestrians')[-1]

    def says(self, words):
        """Return whether the node's newest diagnosis has these words."""
        return bool(self.health) and words in self.health[-1].status[0].message

    def while_telling(self, condition, what, *positions, **options):
        """Publish detections in turn until a condition holds."""

        def holds():
            for one in positions:
                self.tell(one, **options)
                self.graph.spin(0.05)
            return condition()

        return self.graph.wait(holds, what)


def walking(stamp):
    """Return where two people are who walk."""
    return START + VELOCITY * (stamp - SECOND) * 1e-9


def nobody(_):
    return np.zeros((0, 2))


def test_the_velocities_of_walking_people_converge(graph):
    detector = Detector(graph)
    answers = [detector.answer(walking) for _ in range(20)]
    people = sorted(answers[-1].agents, key=lambda one: -one.velocity.x)
    velocities = [(one.velocity.x, one.velocity.y) for one in people]
    np.testing.assert_allclose(velocities, VELOCITY, atol=0.1)
    positions = [(one.position.x, one.position.y) for one in people]
    expected = walking(nanoseconds_of(answers[-1].header.stamp))
    np.testing.assert_allclose(positions, expected, atol=0.05)
    assert {one.id for one in people} == {one.id for one in answers[-10].agents}


def test_people_who_are_seen_no_more_coast_and_vanish(graph):
    detector = Detector(graph, coast_time=0.5)
    for _ in range(5):
        detector.answer(walking)
    counts = [len(detector.answer(nobody).agents) for _ in range(12)]
    assert counts[0] == 2 and counts[-1] == 0


def test_without_detections_nothing_is_published(graph):
    detector = Detector(graph)
    detector.answer(walking)
    graph.spin(0.3)
    detector.pedestrians.clear()
    graph.spin(1.0)
    assert detector.pedestrians == []


def test_detections_in_a_frame_that_is_not_known_are_not_answered(graph):
    detector = Detector(graph)
    detector.answer(walking)
    graph.spin(0.3)
    detector.pedestrians.clear()
    for _ in range(5):
        detector.tell(START, 'camera')
        graph.spin(0.05)
    assert detector.pedestrians == []


@pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_the_tracker_node_with_exit_code_0(graph, number):
    process = Detector(graph).process
    graph.kill(process, number)
    graph.wait(lambda: process.poll() is not None, 'end of the process')
    assert process.returncode == 0


def test_two_detectors_of_which_one_is_slower_are_both_heard(graph):
    detector, far = Detector(graph), np.array([[9.0, 9.0]])
    for _ in range(10):
        detector.answer(walking)
        detector.tell(far, delay=STEP + SECOND // 10)
        graph.spin(0.05)
    assert len(detector.answer(walking).agents) == 3


def test_detections_that_come_much_too_late_change_nothing(graph):
    detector = Detector(graph)
    for _ in range(5):
        detector.answer(walking)
    before = len(detector.pedestrians)
    detector.tell(nobody(None), delay=STEP + SECOND // 2)
    graph.spin(0.5)
    assert len(detector.pedestrians) == before
    assert len(detector.answer(walking).agents) == 2


def test_whoever_is_seen_by_a_slow_detector_is_told_and_the_rate_is_called_too_low(graph):
    detector = Detector(graph)
    rare = {'step': 6 * SECOND // 10}
    detector.while_telling(lambda: len(detector.pedestrians) > 8, 'answers', START, **rare)
    assert all(len(one.agents) == 2 for one in detector.pedestrians)
    assert not any(agent.velocity.x for one in detector.pedestrians for agent in one.agents)
    words = 'detections come every 0.60 s, but tracks die after coast_time 0.5 s'
    detector.while_telling(lambda: detector.says(words), 'diagnosis', START, **rare)


def test_somebody_who_is_seen_for_the_first_time_stands(graph):
    detector = Detector(graph)
    detector.while_telling(lambda: detector.pedestrians, 'answer', START)
    assert len(detector.pedestrians[0].agents) == 2
    assert not any(one.velocity.x for one in detector.pedestrians[0].agents)


def test_detections_without_a_stamp_are_not_answered_and_the_reason_is_told(graph):
    detector = Detector(graph)

    def without_stamp():
        detector.publisher.publish(detections_message(START, 0, 'odom'))
        return detector.says('detections without a stamp')

    detector.while_telling(without_stamp, 'diagnosis')
    assert detector.pedestrians == []


def test_two_detectors_whose_clocks_differ_are_not_answered_and_the_reason_is_told(graph):
    detector = Detector(graph)
    detector.stamp = 5000 * SECOND
    far, hour = np.array([[9.0, 9.0]]), 3600 * SECOND

    def told():
        detector.tell(START)
        detector.graph.spin(0.05)
        detector.tell(far, delay=hour)
        detector.graph.spin(0.05)
        return detector.says('not in step')

    graph.wait(told, 'diagnosis')
    detector.pedestrians.clear()
    for _ in range(10):
        told()
    assert detector.pedestrians == []
    graph.wait(lambda: detector.tell(START) or graph.spin(0.05) or detector.pedestrians, 'trust')
