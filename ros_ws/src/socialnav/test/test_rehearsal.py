"""Laws of alarms and of the rehearsals that they call for."""

import math
from pathlib import Path
import sys
from types import SimpleNamespace

from driving import Drive
import pytest
from test_controller import controller_of, give, Recorder, SECOND, SETTINGS
import torch
from worlds import messages_of, random_state

from socialnav.control.controller import Controller
from socialnav.realtime.alarm import Alarm
from socialnav.realtime.rehearsal import Rehearsal
from socialnav_core.config import PolicyConfig
from socialnav_core.policies import build_network, ValuePolicy
from socialnav_core.sensing import HERE

REHEARSING_NODE = Path(__file__).with_name('rehearsing_node.py')


@pytest.fixture
def rehearsed(graph):
    """Return a function that tells whether there is a rehearsal before a tick some time away."""

    def within(until_tick, decision_time):
        calls = []
        rehearsal = Rehearsal(
            graph.node,
            SimpleNamespace(time_until_next_call=lambda: until_tick * 1e9, clock=None),
            SimpleNamespace(
                rehearse=lambda: calls.append(graph.node.get_clock().now().nanoseconds),
                tally=SimpleNamespace(decision_time=decision_time),
            ),
        )
        began = graph.node.get_clock().now().nanoseconds
        rehearsal.expect()
        graph.spin(4 * until_tick)
        rehearsal.close()
        return [(moment - began) * 1e-9 for moment in calls]

    return within


def test_an_alarm_rings_once_each_time_that_it_is_set_and_the_latest_setting_counts(graph):
    calls = []
    alarm = Alarm(graph.node, lambda: calls.append(1))
    alarm.set(60.0)
    alarm.set(0.01)
    graph.wait(lambda: calls, 'alarm')
    graph.spin(0.2)
    assert len(calls) == 1
    alarm.set(-1.0)
    graph.wait(lambda: len(calls) == 2, 'alarm for a moment that is over')
    alarm.close()


def test_an_alarm_that_was_closed_does_not_ring_though_the_executor_was_told_before():
    calls, callbacks = [], []
    node = SimpleNamespace(
        create_timer=lambda period, callback, **options: callbacks.append(callback),
        destroy_timer=lambda timer: None,
    )
    Alarm(node, lambda: calls.append(1)).close()
    callbacks[0]()
    assert not calls


def test_a_rehearsal_comes_shortly_before_a_distant_tick_and_never_before_a_near_one(rehearsed):
    moments = rehearsed(0.5, 0.01)
    assert len(moments) == 1 and moments[0] > 0.4
    assert not rehearsed(0.01, 0.001) and not rehearsed(0.1, 0.06)


def test_a_rehearsal_changes_no_decision():
    torch.manual_seed(0)
    config = PolicyConfig()
    policy = ValuePolicy(build_network(config), config)
    decisions = []
    for rehearse in (False, True):
        controller = Controller(policy, SETTINGS, steady=lambda: 0.0)
        for seed in range(5):
            give(controller, random_state(seed), SECOND + seed)
            decisions.append(controller.decide(SECOND + seed))
            if rehearse:
                give(controller, random_state(seed + 1), SECOND + seed + 1)
                controller.rehearse()
        assert controller.tally.decisions == 5
    for plain, rehearsed in zip(decisions[:5], decisions[5:], strict=True):
        assert plain.reason is rehearsed.reason is None
        assert plain.command.tolist() == rehearsed.command.tolist()


def test_a_policy_that_may_remember_what_it_saw_is_not_made_to_rehearse():
    policy = Recorder()
    controller = controller_of(policy)
    controller.decide(SECOND)
    controller.rehearse()
    assert len(policy.states) == 1


def test_a_rehearsal_asks_nobody_for_a_transform():
    asked, config = [], PolicyConfig()

    def locate(frame, source, stamp):
        asked.append(source)
        return HERE

    policy = ValuePolicy(build_network(config), config)
    controller = Controller(policy, SETTINGS, locate=locate)
    give(controller, random_state(0), SECOND)
    goal = messages_of(random_state(0), SECOND)['goal_pose']
    goal.header.frame_id = 'map'
    controller.store('goal_pose', goal)
    assert controller.decide(SECOND).reason is None
    assert asked == ['map']
    controller.rehearse()
    assert asked == ['map']


def test_a_rehearsal_that_fails_leaves_it_to_the_decision_to_tell():
    config = PolicyConfig()
    policy = ValuePolicy(build_network(config), config)
    controller = Controller(policy, SETTINGS)
    give(controller, random_state(0), SECOND)
    controller.decide(SECOND)
    state = random_state(0)
    state.robot.position[:] = math.nan
    give(controller, state, SECOND)
    controller.rehearse()
    assert controller.decide(SECOND).reason.startswith('odom: position')


def test_a_node_that_drives_rehearses(graph, tmp_path):
    rehearsals = tmp_path / 'rehearsals'
    drive = Drive(graph).start([sys.executable, str(REHEARSING_NODE), str(rehearsals)])
    drive.moves(random_state(0))

    def rehearsed():
        drive.robot.publish(random_state(0))
        graph.spin(0.05)
        return rehearsals.exists() and len(rehearsals.read_text()) > 2

    graph.wait(rehearsed, 'rehearsals')
