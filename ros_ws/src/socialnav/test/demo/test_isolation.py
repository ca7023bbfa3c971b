"""Laws of what keeps a demo away from the robots of others."""

import socket

import pytest

from socialnav.demo.isolation import DOMAINS, free_domain, isolated_environment, occupied


def test_nodes_meet_on_this_machine_only_in_a_domain_that_is_free():
    environment = isolated_environment({})
    assert environment['ROS_AUTOMATIC_DISCOVERY_RANGE'] == 'LOCALHOST'
    assert int(environment['ROS_DOMAIN_ID']) in DOMAINS


def test_what_the_user_has_set_stays():
    wanted = {'ROS_AUTOMATIC_DISCOVERY_RANGE': 'SUBNET', 'ROS_DOMAIN_ID': '7'}
    assert isolated_environment(wanted).items() >= wanted.items()


@pytest.mark.parametrize('participant', [0, 1, 5])
def test_a_domain_in_which_somebody_listens_is_not_free(participant):
    domain = free_domain()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as listener:
        listener.bind(('', 7400 + 250 * domain + 10 + 2 * participant))
        assert occupied(domain)
    assert not occupied(domain)
