"""Keep what is started here away from every other robot in the building, and quick to meet."""

from collections.abc import Mapping
from pathlib import Path
import random
import socket

from ament_index_python.packages import get_package_share_directory

DOMAINS = range(1, 100)
"""Domains whose ports are free on Linux."""
PARTICIPANTS = 32
"""Number of participants of a domain that are looked for on this machine."""


def isolated_environment(environment: Mapping[str, str]) -> dict[str, str]:
    """Return an environment whose nodes meet only each other on this machine; keep what is set."""
    profiles = Path(get_package_share_directory('socialnav')) / 'config' / 'fast_discovery.xml'
    defaults = {
        'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST',
        'FASTRTPS_DEFAULT_PROFILES_FILE': str(profiles),
    }
    if 'ROS_DOMAIN_ID' not in environment:
        defaults['ROS_DOMAIN_ID'] = str(free_domain())
    return defaults | dict(environment)


def free_domain() -> int:
    """
    Return a domain in which nobody is.

    :raises RuntimeError: when there is none.
    """
    for domain in random.sample(DOMAINS, len(DOMAINS)):
        if not occupied(domain):
            return domain
    raise RuntimeError('every ROS_DOMAIN_ID is in use on this machine: set one by hand')


def occupied(domain: int) -> bool:
    """
    Return whether some participant on this machine is in a domain.

    :param domain: its number; participants listen at the ports that follow from it.
    """
    first = 7400 + 250 * domain + 10
    return not all(map(free, range(first, first + 2 * PARTICIPANTS, 2)))


def free(port: int) -> bool:
    """Return whether nobody listens at a UDP port."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.bind(('', port))
        except OSError:
            return False
    return True
