"""Laws of the graph-attention layer."""

import pytest
import torch

from socialnav_core.policies.value.graph_attention import GraphAttention

MASK = torch.tensor([[True, True, True, True], [True, False, True, False]])


def _rows(seed: int) -> tuple[torch.Tensor, torch.Tensor]:
    generator = torch.Generator().manual_seed(seed)
    return torch.randn(2, 6, generator=generator), torch.randn(2, 4, 6, generator=generator)


def _layer(heads: int = 3, score: str = 'gat') -> GraphAttention:
    torch.manual_seed(0)
    return GraphAttention(6, 5, heads, score)


@pytest.mark.parametrize('score', ['gat', 'linear', 'gatv2'])
def test_shapes_are_those_of_the_documentation(score):
    robot, others, weights = _layer(3, score)(*_rows(1), MASK)
    assert (robot.shape, others.shape, weights.shape) == ((2, 15), (2, 4, 15), (2, 3, 4))


@pytest.mark.parametrize('score', ['gat', 'linear', 'gatv2'])
def test_heads_in_one_product_equal_layers_of_one_head_side_by_side(score):
    layer, single = _layer(3, score), _layer(1, score)
    robot, others, weights = layer(*_rows(1), MASK)
    for head in range(3):
        single.weight.data = layer.weight.data[head : head + 1]
        single.attention.data = layer.attention.data[head : head + 1]
        part = slice(5 * head, 5 * head + 5)
        expected = single(*_rows(1), MASK)
        torch.testing.assert_close(robot[:, part], expected[0])
        torch.testing.assert_close(others[:, :, part], expected[1])
        torch.testing.assert_close(weights[:, head], expected[2][:, 0])


def test_robot_row_is_its_projection_and_agent_rows_are_weighted_projections():
    layer = _layer(1)
    robot, others = _rows(1)
    robot_row, other_rows, weights = layer(robot, others, MASK)
    torch.testing.assert_close(robot_row, robot @ layer.weight[0].T)
    torch.testing.assert_close(other_rows, weights[:, 0, :, None] * (others @ layer.weight[0].T))


def test_robot_does_not_matter_for_the_weights_of_the_linear_score():
    layer = _layer(3, 'linear')
    others = _rows(1)[1]
    first, second = (layer(10.0 * _rows(seed)[0], others, MASK)[2] for seed in (1, 2))
    torch.testing.assert_close(first, second)


def test_robot_changes_the_weights_of_the_gat_score_but_not_the_order_of_the_agents():
    layer = _layer(3, 'gat')
    others = _rows(1)[1]
    first, second = (layer(10.0 * _rows(seed)[0], others, MASK)[2][0] for seed in (1, 2))
    assert not torch.allclose(first, second, atol=1e-3)
    assert torch.equal(first.argsort(dim=1), second.argsort(dim=1))


def test_robot_can_change_the_order_of_the_agents_under_the_gatv2_score():
    layer = _layer(3, 'gatv2')
    others = _rows(1)[1]
    first, second = (layer(10.0 * _rows(seed)[0], others, MASK)[2][0] for seed in (1, 2))
    assert not torch.equal(first.argsort(dim=1), second.argsort(dim=1))


def test_gatv2_score_is_the_attention_vector_times_the_rectified_sum():
    layer = _layer(1, 'gatv2')
    robot, others = _rows(1)
    mixed = (robot[0] + others[0]) @ layer.weight[0].T
    scores = torch.where(mixed > 0, mixed, 0.2 * mixed) @ layer.attention[0]
    torch.testing.assert_close(layer(robot, others, MASK)[2][0, 0], torch.softmax(scores, 0))


def test_weights_are_drawn_from_xaviers_range_for_each_head():
    torch.manual_seed(0)
    layer = GraphAttention(50, 50, heads=4)
    bound = 1.414 * (6 / 100) ** 0.5
    for head in layer.weight:
        assert 0.98 * bound < head.abs().max() <= bound
    attention_bound = 1.414 * (6 / 101) ** 0.5
    assert 0.95 * attention_bound < layer.attention.abs().max() <= attention_bound


def test_an_unknown_score_is_an_error_that_names_the_known_ones():
    with pytest.raises(ValueError, match="'gat', 'linear' or 'gatv2'"):
        GraphAttention(6, 5, score='cosine')


def test_a_layer_without_heads_is_an_error():
    with pytest.raises(ValueError, match='at least 1'):
        GraphAttention(6, 5, heads=0)
