"""Laws of crowds in a corridor without ends, and what is known of people there."""

import numpy as np
import pytest

from socialnav_core import cli
from socialnav_core.evaluation.crowd_flow import (
    Corridor,
    lane_order,
    measure_flow,
    overlap_share,
    torus,
    weidmann,
)


def test_lanes_of_one_way_have_order_one_and_mixed_ones_little():
    y = np.repeat([0.5, 2.0, 3.5], 8)
    position = np.stack([np.tile(np.arange(8.0), 3), y], axis=1)[None]
    lanes, mixed = np.repeat([1.0, -1.0, 1.0], 8)[None], np.tile([1.0, -1.0], 12)[None]
    assert lane_order(position, lanes) == 1.0
    assert lane_order(position, mixed) == pytest.approx(1 / 49)


def test_the_corridor_has_no_ends():
    assert np.allclose(torus(np.array([9.5, -4.8])), (-0.5, 0.2))
    assert overlap_share(np.array([[[0.1, 1.0], [9.9, 1.0], [5.0, 2.0]]]), 0.3) == 2 / 3
    corridor = Corridor('non_reactive', 0.2, False, 1, 0)
    start = corridor.position.copy()
    for _ in range(40):  # 10 s at 1 m/s: once around
        assert corridor.step() == pytest.approx(1.0)
    assert np.allclose(torus(corridor.position - start), 0.0, atol=1e-9)


def test_people_near_an_end_avoid_those_at_the_other():
    corridor = Corridor('orca', 0.04, True, 1, 0)
    corridor.position[0] = [[9.2, 2.0], [1.0, 2.1]]  # walk towards each other over the end
    for _ in range(10):
        corridor.step()
        assert overlap_share(corridor.position, 0.3) == 0.0
    apart = torus(corridor.position[0, 0] - corridor.position[0, 1])
    assert apart[0] > 0.0


def test_people_walk_slower_the_more_they_are():
    assert weidmann(0.2) > 0.99 > weidmann(1.0) > weidmann(3.0) > weidmann(5.4) == 0.0
    for density in (0.5, 1.0):
        flow = measure_flow('social_force', density, False, worlds=1)
        assert flow.speed == pytest.approx(weidmann(density), abs=0.12)


@pytest.mark.parametrize('crowd', ['orca', 'social_force', 'headed_social_force'])
def test_people_who_meet_form_lanes(crowd):
    flow = measure_flow(crowd, 0.5, True, worlds=1)
    assert flow.lanes_at_start < 0.5 < 0.8 < flow.lanes
    assert flow.overlap < 0.05


def test_who_does_not_react_forms_no_lanes():
    flow = measure_flow('non_reactive', 0.5, True, worlds=1)
    assert flow.lanes == pytest.approx(flow.lanes_at_start, abs=0.1)
    assert flow.overlap > 0.1


def test_the_command_measures_the_crowds_that_are_asked_for(capsys):
    assert cli.main(['crowds', 'non_reactive', 'orca', '--markdown']) == 0
    shown = capsys.readouterr().out
    assert '| non_reactive | 1.00 | 1.00 |' in shown and 'Weidmann' in shown
    with pytest.raises(SystemExit):
        cli.main(['crowds', '--seed', 'x'])
    assert cli.main(['crowds', 'changing']) == 2
