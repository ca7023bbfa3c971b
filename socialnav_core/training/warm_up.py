"""What comes before value learning: imitation, and a replay that holds demonstrations."""

import sys
import time

from socialnav_core.progress import progress_bar
from socialnav_core.training.demonstrators import make_demonstrator
from socialnav_core.training.imitation import collect_demonstrations, imitate
from socialnav_core.training.randomness import generator, Purpose
from socialnav_core.training.run import Run


def begin(run: Run, progress: bool) -> None:
    """
    Imitate, fill the replay with demonstrations and start the worlds of value learning.

    Half of the replay is filled, so that the other half is there for what comes.
    """
    started, used = time.perf_counter(), time.process_time()
    config, settings = run.config, run.config.training
    imitation = settings.imitation
    if imitation.episodes:
        with progress_bar(imitation.episodes, 'demonstrations', visible=progress) as bar:
            demonstrations = collect_demonstrations(
                run.simulator, make_demonstrator(imitation), imitation.episodes, config.seed,
                bar.update,
            )  # fmt: skip
        count = len(demonstrations.returns)
        announce(f'imitation: {imitation.episodes} episodes of ORCA, {count} states', progress)
        random = generator(config.seed, Purpose.IMITATION)
        if not settings.initial_weights:  # those know more than the demonstrator can teach
            with progress_bar(imitation.epochs, 'imitation', 'epoch', visible=progress) as bar:
                imitate(run.network, demonstrations, settings, random, bar.update)
        order = generator(config.seed, Purpose.SELECTION).permutation(count)
        run.buffer.append(*demonstrations.select(order[: settings.replay_capacity // 2]))
    run.renew_target()
    run.decision = run.policy.decide(run.simulator.reset(seed=config.seed, split='train'))
    run.seconds = time.perf_counter() - started
    run.processor_seconds = time.process_time() - used


def announce(text: str, progress: bool) -> None:
    """Say on stderr what happens."""
    if progress:
        print(text, file=sys.stderr, flush=True)
