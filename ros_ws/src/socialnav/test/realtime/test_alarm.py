"""Laws of alarms."""

from types import SimpleNamespace

from socialnav.realtime.alarm import Alarm


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
