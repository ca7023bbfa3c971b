"""Laws of the softmax over valid entries."""

import torch

from socialnav_core.policies.value.masked_softmax import masked_softmax

MASK = torch.tensor([[True, True, False], [False, False, False]])


def test_valid_weights_are_the_softmax_of_the_valid_scores():
    weights = masked_softmax(torch.tensor([[1.0, 2.0, 9.0], [1.0, 2.0, 3.0]]), MASK)
    torch.testing.assert_close(weights[0, :2], torch.softmax(torch.tensor([1.0, 2.0]), 0))


def test_invalid_weights_are_exactly_zero_even_beside_very_small_scores():
    scores = torch.tensor([[-3e38, -3e38, 3e38], [0.0, 0.0, 0.0]])
    weights = masked_softmax(scores, MASK)
    assert torch.equal(weights, torch.tensor([[0.5, 0.5, 0.0], [0.0, 0.0, 0.0]]))


def test_large_scores_do_not_overflow():
    weights = masked_softmax(torch.tensor([[1e30, 1e30, 0.0], [0.0, 0.0, 0.0]]), MASK)
    assert torch.equal(weights[0], torch.tensor([0.5, 0.5, 0.0]))


def test_gradient_is_finite_where_nothing_is_valid():
    scores = torch.zeros(2, 3, requires_grad=True)
    masked_softmax(scores, MASK)[:, 0].sum().backward()
    assert torch.isfinite(scores.grad).all()
