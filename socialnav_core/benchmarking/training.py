"""How long training takes."""

import dataclasses
import resource
import time

from socialnav_core.benchmarking.measurement import Measurement
from socialnav_core.config import Config, read_config
from socialnav_core.training.run import Run
from socialnav_core.training.value_learning import iterate
from socialnav_core.training.warm_up import begin

RECIPES = ('sarl', 'gat4sn')
DEMONSTRATIONS = 150
ITERATIONS = 8
WARM_UP = 2


def training_measurements() -> list[Measurement]:
    """Return minutes that each recipe takes, projected from some of its iterations."""
    return [projected(read_config(recipe)) for recipe in RECIPES]


def projected(config: Config) -> Measurement:
    """Return minutes of a run, projected from a part of its imitation and its iterations."""
    settings = config.training
    part = dataclasses.replace(settings.imitation, episodes=DEMONSTRATIONS)
    shorter = dataclasses.replace(settings, imitation=part)
    run = Run(dataclasses.replace(config, training=shorter))
    started = time.perf_counter()
    begin(run, progress=False)
    imitation = (time.perf_counter() - started) * settings.imitation.episodes / DEMONSTRATIONS
    rows = [iterate(run) for _ in range(WARM_UP + ITERATIONS)][WARM_UP:]
    rate = len(rows) / sum(1 / row['decisions_per_second'] for row in rows)
    decisions = settings.iterations * settings.worlds * settings.steps_per_iteration
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    return Measurement(
        f'training, {config.name} (projected)',
        (imitation + decisions / rate) / 60,
        'min',
        details={'decisions_per_second': rate, 'peak_memory_megabytes': peak},
    )
