"""Laws of lists that several publishers tell."""

from helpers.controllers import controller_of, Recorder, SECOND, SETTINGS
from helpers.worlds import messages_of, random_state
import pytest

from socialnav.control.lists import Lists, MOST
from socialnav.messages.stamps import header_message
from socialnav.messages.unread import Unread
from socialnav_msgs.msg import AgentState, AgentStates


def told(number, stamp=SECOND, source=''):
    """Return a list of one agent with a number."""
    return AgentStates(
        header=header_message(stamp, 'odom'), source=source, agents=[AgentState(id=number)]
    )


def lists_of(*pairs, publishers=()):
    """Return lists with these messages, by source and number in the order in which they came."""
    lists = Lists('obstacles')
    for source, number in pairs:
        lists.store(source, told(number))
    lists.hear_of(publishers)
    return lists


def ids(lists):
    return [message.agents[0].id for message in lists.all()]


def test_the_newest_list_of_each_publisher_counts():
    assert ids(lists_of(('/a:1', 1), ('/b:1', 2), ('/a:1', 3))) == [2, 3]


def test_each_list_ages_by_itself():
    lists = lists_of(('/a:1', 1), ('/b:1', 2))
    lists.store('/a:1', told(1, 3 * SECOND))
    assert dict(lists.ages(3 * SECOND, 0.5)) == {'/a': 0.0, '/b': 2.0}


def test_a_node_that_was_started_anew_replaces_itself_when_its_old_list_is_too_old():
    lists = lists_of(('/a:1', 1), ('/a:2', 2))
    lists.store('/a:2', told(2, SECOND + SECOND // 4))
    assert len(lists.ages(SECOND + SECOND // 4, 0.5)) == 2
    lists.store('/a:2', told(2, 2 * SECOND))
    assert lists.ages(2 * SECOND, 0.5) == [('/a', 0.0)]
    assert ids(lists) == [2]


def test_of_two_nodes_of_one_name_that_speak_in_turn_both_are_missed():
    lists = lists_of(('/a:1', 1), ('/a:2', 2), ('/a:1', 1))
    lists.store('/a:2', told(2, 2 * SECOND))
    assert sorted(age for _, age in lists.ages(2 * SECOND, 0.5)) == [0.0, 1.0]


def test_what_does_not_age_is_forgotten_when_its_node_has_left_and_was_started_anew():
    pairs = ('/a:1', 1), ('/b:1', 2), ('/a:2', 3)
    assert ids(lists_of(*pairs, publishers=['/a', '/a', '/b'])) == [1, 2, 3]
    assert ids(lists_of(*pairs, publishers=['/a', '/b'])) == [2, 3]


def test_the_list_of_a_node_that_left_for_good_stays():
    assert ids(lists_of(('/a:1', 1), ('/b:1', 2), publishers=['/b'])) == [1, 2]


@pytest.mark.parametrize(
    ('sources', 'publishers', 'reason'),
    [
        ([''], ['/a'], None),
        ([''], [], None),
        ([''], ['/a', '/a'], 'several publishers do not fill in their source: /a'),
        ([''], ['/a', '/b'], 'several publishers do not fill in their source: /a, /b'),
        (['/a:1', ''], ['/a', '/b'], None),
        (['/a:1', ''], ['/a', '/b', '/c'], 'several publishers do not fill in'),
        (['/a:1'], ['/a', '/b'], 'no list yet from /b'),
        (['/a:1', '/a:2'], ['/a', '/a'], None),
        (['/a:1'], ['/a', '/a'], 'no list yet from /a'),
        (['/a:1', '/b:1'], ['/bag_player'], None),
        ([], ['/a'], 'no list yet from /a'),
    ],
)
def test_who_speaks_and_cannot_be_told_apart_or_was_not_heard_is_named(
    sources, publishers, reason
):
    found = lists_of(*((source, 0) for source in sources), publishers=publishers).complaint()
    assert found == reason if reason is None else reason in found


def test_a_publisher_that_changes_its_name_all_the_time_is_named_and_fills_no_memory():
    lists = lists_of(*((f'/a:{number}', number) for number in range(1000)))
    assert len(lists.all()) == MOST + 1
    assert lists.complaint() == f'obstacles: lists of more than {MOST} sources'


def test_people_of_several_publishers_are_all_there_as_of_the_newest_list():
    policy = Recorder()
    state = random_state(0, pedestrians=1, obstacles=0)
    state.agents.position[:], state.agents.velocity[:] = [[[4.0, 4.0]]], [[[1.0, 0.0]]]
    controller = controller_of(policy, state=state, without=['pedestrians'])
    for source, stamp in (('/a:1', SECOND - SECOND // 5), ('/b:1', SECOND)):
        message = messages_of(state, stamp)['pedestrians']
        message.source = source
        controller.store('pedestrians', message)
    assert controller.decide(SECOND).reason is None
    positions = policy.states[0].agents.position[0].round(6).tolist()
    assert sorted(positions) == [[4.0, 4.0], [4.2, 4.0]]


def test_a_robot_stands_when_one_of_several_publishers_falls_silent():
    controller = controller_of(Recorder())
    for source, stamp in (('/a:1', SECOND), ('/b:1', 2 * SECOND), ('', 2 * SECOND)):
        message = messages_of(random_state(0), stamp)['pedestrians']
        message.source = source
        controller.store('pedestrians', message)
    controller.store('odom', messages_of(random_state(0), 2 * SECOND)['odom'])
    reason = controller.decide(2 * SECOND).reason
    assert reason == f'pedestrians older than {SETTINGS.input_timeout:g} s, told by /a'


def test_the_list_of_who_gave_no_name_goes_with_its_publisher():
    here = lists_of(('', 1), ('/a:1', 2), publishers=('/a', '/nameless'))
    assert ids(here) == [1, 2]
    here.hear_of(('/a',))
    assert ids(here) == [2]


def test_who_gave_no_name_is_kept_until_another_is_heard():
    waiting = lists_of(('', 1), publishers=('/a',))
    assert ids(waiting) == [1]


def test_what_cannot_be_read_counts_under_the_name_of_a_publisher_only():
    lists = lists_of(('/a:1', 1), ('/a:1', 2), publishers=('/a',))
    garbage = Unread(lambda _: None, b'')
    lists.store('/a:1', garbage)
    lists.store('', told(3))
    assert lists.all().count(None) == 1
    lists.store('/a:1', told(4))
    lists.store('wrong', garbage)
    assert lists.newest() is None and lists.all().count(None) == 1
    lists.store('', told(5))
    assert ids(lists) == [4, 5]
