"""
What a GPU brings: equality with the processor, decisions per second, minutes of a training.

    python benchmarks/core/gpu.py --out out/gpu.json

The simulator stays on the processor; the value network's products move. Where there is no CUDA
the command says so and ends with 0.
"""

import argparse
import dataclasses
import json
from pathlib import Path
import time
from typing import Any

import numpy as np
import torch

from socialnav_core.config import read_config
from socialnav_core.policies import load_policy, ValuePolicy
from socialnav_core.simulation import make_scenario, Simulator
from socialnav_core.training.run import Run
from socialnav_core.training.value_learning import iterate
from socialnav_core.training.warm_up import begin

MODELS = ('sarl', 'gat4sn')
WORLDS = (128, 1024, 4096, 16384)
SECONDS = 4.0
"""How long each rate is measured, s."""
ITERATIONS = 6


def on(device: str, model: str, bfloat16: bool) -> ValuePolicy:
    """Return a shipped policy whose network is on a device."""
    policy = load_policy(model, device=device)
    return ValuePolicy(policy.network, policy.config, bfloat16)


def equality(model: str) -> dict[str, float]:
    """Return how far float32 values differ, and the share of worlds with the same action."""
    state = Simulator(make_scenario('hard'), 512).reset(seed=3)
    here, there = (on(device, model, False).decide(state) for device in ('cpu', 'cuda'))
    finite = np.isfinite(here.values)
    return {
        'largest_difference': float(np.abs(here.values - there.values)[finite].max()),
        'same_action': float((here.action == there.action).mean()),
    }


def decisions_per_second(model: str, device: str, worlds: int) -> float:
    """Return decisions per second, the simulator's steps among them."""
    simulator = Simulator(make_scenario('hard'), worlds)
    state, policy = simulator.reset(seed=3), on(device, model, True)
    for _ in range(2):
        state = simulator.step(policy.act(state))[0]
    steps, started = 0, time.perf_counter()
    while (elapsed := time.perf_counter() - started) < SECONDS:
        state = simulator.step(policy.act(state))[0]
        steps += 1
    return steps * worlds / elapsed


def training(recipe: str, device: str, worlds: int) -> dict[str, float]:
    """Return rates of value learning, imitation set aside."""
    config = read_config(recipe, {'training.device': device, 'training.worlds': worlds})
    part = dataclasses.replace(config.training.imitation, episodes=worlds, epochs=1)
    settings = dataclasses.replace(config.training, imitation=part)
    run = Run(dataclasses.replace(config, training=settings))
    begin(run, progress=False)
    iterate(run)
    started = time.perf_counter()
    for _ in range(ITERATIONS):
        iterate(run)
    seconds = time.perf_counter() - started
    decisions = ITERATIONS * worlds * settings.steps_per_iteration
    return {
        'decisions_per_second': decisions / seconds,
        'seconds_an_iteration': seconds / ITERATIONS,
    }


def measured() -> dict[str, Any]:
    """Return all figures of this machine."""
    results: dict[str, Any] = {
        'device': torch.cuda.get_device_name(),
        'torch': torch.__version__,
        'threads': torch.get_num_threads(),
        'equality': {model: equality(model) for model in MODELS},
        'decisions_per_second': {},
        'training': {},
    }
    for model in MODELS:
        for device in ('cpu', 'cuda'):
            for worlds in WORLDS:
                rate = decisions_per_second(model, device, worlds)
                results['decisions_per_second'][f'{model} {device} {worlds}'] = round(rate)
                print(model, device, worlds, round(rate), flush=True)
            results['training'][f'{model} {device}'] = training(model, device, 128)
            print(model, device, results['training'][f'{model} {device}'], flush=True)
        results['training'][f'{model} cuda 1024 worlds'] = training(model, 'cuda', 1024)
    return results


def main() -> None:
    """Run the command."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--out', type=Path, default=Path('out/gpu.json'))
    given = parser.parse_args()
    if not torch.cuda.is_available():
        print('no CUDA device here: nothing was measured')
        return
    torch.set_num_threads(1)
    given.out.parent.mkdir(parents=True, exist_ok=True)
    given.out.write_text(json.dumps(measured(), indent=2) + '\n')
    print(given.out.read_text())


if __name__ == '__main__':
    main()
