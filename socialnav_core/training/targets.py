"""What a state is worth, after the fact: the targets that the value network regresses on."""

import numpy as np


def q_lambda_targets(
    reward: np.ndarray,
    terminated: np.ndarray,
    truncated: np.ndarray,
    greedy: np.ndarray,
    best_value: np.ndarray,
    final_value: np.ndarray,
    discount: float,
    trace_decay: float,
) -> np.ndarray:
    """
    Return Watkins' Q(lambda) targets of the states visited, shape (steps, worlds).

    With Q*(s) = max_a Q(s, a), from the end of the window backwards: after a greedy action
    G_t = r + discount * [(1 - lambda) Q*(s_t+1) + lambda G_t+1]; after an exploratory one
    G_t = Q*(s_t), since its outcome says nothing of the greedy policy. A terminal step has no
    future; a truncated one bootstraps from the state it was cut at; G at the window's end is Q*.
    Watkins (1989), Learning from Delayed Rewards; Sutton & Barto (2018), section 12.10.

    :param reward: of each step, (steps, worlds).
    :param terminated: whether the step ended the episode for good, (steps, worlds).
    :param truncated: whether the step was the last before the time limit, (steps, worlds).
    :param greedy: whether the action was the best one known, (steps, worlds).
    :param best_value: Q* of each state and of the one after the last step, (steps + 1, worlds).
    :param final_value: Q* of the state at which a truncated episode was cut, (steps, worlds).
    :param discount: of one step.
    :param trace_decay: lambda; 0 looks one step ahead, 1 to the end of the greedy stretch.
    """
    targets = np.empty_like(best_value[:-1])
    following = best_value[-1]
    for step in reversed(range(len(reward))):
        continued = (1 - trace_decay) * best_value[step + 1] + trace_decay * following
        future = np.where(truncated[step], final_value[step], continued)
        observed = reward[step] + discount * np.where(terminated[step], 0, future)
        following = targets[step] = np.where(greedy[step], observed, best_value[step])
    return targets


def one_step_targets(
    reward: np.ndarray, terminated: np.ndarray, next_value: np.ndarray, discount: float
) -> np.ndarray:
    """
    Return r + discount * V(s'), or r alone after a terminal step, shape (steps, worlds).

    :param reward: of each step, (steps, worlds).
    :param terminated: whether the step ended the episode for good, (steps, worlds).
    :param next_value: V of the state that the step led to, (steps, worlds).
    :param discount: of one step.
    """
    return reward + discount * np.where(terminated, 0, next_value)


def discounted_returns(reward: np.ndarray, ended: np.ndarray, discount: float) -> np.ndarray:
    """
    Return the discounted sum of rewards from each step to the end of its episode, (steps, worlds).

    :param reward: of each step, (steps, worlds); every episode ends within the window.
    :param ended: whether the step was the last of its episode, (steps, worlds).
    :param discount: of one step.
    """
    returns = np.empty_like(reward)
    following = np.zeros_like(reward[0])
    for step in reversed(range(len(reward))):
        following = returns[step] = reward[step] + discount * np.where(ended[step], 0, following)
    return returns
