"""Training of the learned prediction, from crowds to a checkpoint."""

import csv
import math
from pathlib import Path
import shlex
import time

from torch import nn

from socialnav_core.allocator import keep_freed_memory
from socialnav_core.config.prediction import PredictionConfig, PredictionTrainingConfig
from socialnav_core.memory import prediction_bytes, require_memory
from socialnav_core.prediction.learned.checkpoint import save_weights
from socialnav_core.progress import progress_bar
from socialnav_core.storage import named_errors
from socialnav_core.threads import chosen_threads
from socialnav_core.training.folder import finish_folder, own_folder
from socialnav_core.training.interruption import Interruption, TrainingInterrupted
from socialnav_core.training.prediction.examples import draw_examples
from socialnav_core.training.prediction.network import loss_of
from socialnav_core.training.prediction.run import PredictionRun
from socialnav_core.training.prediction.validation import validate
from socialnav_core.training.progress import CSV_NAME, open_csv
from socialnav_core.training.randomness import generator, Purpose
from socialnav_core.training.resume import load_state, save_state

COLUMNS = (
    'update', 'loss', 'validation_loss', 'error_1s', 'error_3s', 'learning_rate', 'seconds',
    'processor_seconds',
)  # fmt: skip
WARM_UP = 200  # updates


@chosen_threads()
def train_prediction(
    config: PredictionConfig,
    out: Path,
    resume: bool = False,
    overwrite: bool = False,
    progress: bool = True,
) -> None:
    """
    Train a prediction and leave a checkpoint folder with the best weights on validation crowds.

    Every saved state is complete: a run that was killed goes on from the last one with `resume`
    and ends with the same bits as one that was not (same machine, same number of threads).

    :raises ConfigError: when the folder is taken, or cannot be resumed with this configuration.
    :raises CheckpointError: when the state cannot be written.
    :raises TrainingInterrupted: after Ctrl-C or SIGTERM; the run was saved.
    """
    require_memory(prediction_bytes(config), 'the training')
    with own_folder(out, resume, overwrite):
        run_in_folder(config, out, resume, progress)


def run_in_folder(config: PredictionConfig, out: Path, resume: bool, progress: bool) -> None:
    """Train in a folder that is prepared; see `train_prediction`."""
    keep_freed_memory()
    with Interruption() as interruption:
        sections = load_state(out, config) if resume else None
        run = PredictionRun(config)
        if sections is not None:
            run.restore(sections)
        save(run, out)
        with (
            open_csv(out / CSV_NAME, run.updates, COLUMNS) as file,
            progress_bar(
                config.training.updates, 'prediction', 'update', run.updates, progress
            ) as bar,
        ):
            rows = csv.DictWriter(file, COLUMNS)
            while not run.finished and not interruption.requested:
                before, row = run.updates, iterate(run)
                with named_errors(file.name):
                    rows.writerow({name: f'{value:.6g}' for name, value in row.items()})
                    file.flush()
                save(run, out)
                bar.set_postfix_str(f'error {row["error_1s"]:.3f} m after 1 s')
                bar.update(run.updates - before)
        if interruption.requested and not run.finished:
            raise TrainingInterrupted(how_to_resume(run, out), interruption.number)
    finish_folder(out)


def iterate(run: PredictionRun) -> dict[str, float]:
    """Update the network until it is time to look at the validation crowds; return the numbers."""
    started, used = time.perf_counter(), time.process_time()
    settings = run.config.training
    last = min(run.updates + settings.validation_updates, settings.updates)
    count, total = last - run.updates, 0.0
    while run.updates < last:
        total += update(run)
    validation = validate(run.network, run.validation, settings)
    run.keep_best(validation)
    run.seconds += time.perf_counter() - started
    run.processor_seconds += time.process_time() - used
    return {
        'update': run.updates,
        'loss': total / count,
        'validation_loss': validation.loss,
        'error_1s': validation.error_1s,
        'error_3s': validation.error_3s,
        'learning_rate': learning_rate(settings, run.updates - 1),
        'seconds': run.seconds,
        'processor_seconds': run.processor_seconds,
    }


def update(run: PredictionRun) -> float:
    """
    Make one gradient step and return its loss.

    :raises FloatingPointError: when the loss is not a number.
    """
    settings = run.config.training
    draws = generator(run.config.seed, Purpose.EXAMPLES, run.updates)
    chosen = draws.integers(0, len(run.crowds), settings.recordings_per_update)
    examples = draw_examples(
        [run.crowds[number] for number in chosen], settings.moments_per_recording, settings.noise,
        draws,
    )  # fmt: skip
    for group in run.optimizer.param_groups:
        group['lr'] = learning_rate(settings, run.updates)
    loss = loss_of(run.network, examples, settings)
    run.optimizer.zero_grad()
    loss.backward()
    norm = nn.utils.clip_grad_norm_(run.network.parameters(), settings.gradient_clip)
    if not math.isfinite(norm.item()):
        raise FloatingPointError('the loss is not a number; lower training.learning_rate')
    run.optimizer.step()
    run.updates += 1
    return loss.item()


def learning_rate(settings: PredictionTrainingConfig, done: int) -> float:
    """Return the rate after some updates: a linear warm-up under a cosine that ends near zero."""
    warm = min(1.0, (done + 1) / WARM_UP)
    share = 0.5 * (1.0 + math.cos(math.pi * done / settings.updates))
    return settings.learning_rate * warm * (share + 0.005)


def save(run: PredictionRun, out: Path) -> None:
    """Write the best weights so far, then the state that the run goes on from."""
    save_weights(out, run.best_weights, run.config)
    save_state(out, run.sections(), run.config)


def how_to_resume(run: PredictionRun, out: Path) -> str:
    """Return the message of a run that was stopped."""
    place = shlex.quote(str(out))
    return (
        f'stopped after {run.updates} of {run.config.training.updates} updates; go on with '
        f'socialnav train-prediction {place}/config.yaml --out {place} --resume'
    )
