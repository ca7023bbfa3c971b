"""Results of predictions as text."""

from socialnav_core.evaluation.judgement import PredictionResult, TIMES
from socialnav_core.tables import text_table


def result_table(results: list[PredictionResult]) -> str:
    """Return errors, m, surprise, nats, and shares within one and two deviations, line by line."""
    moments = ' / '.join(f'{time:g}' for time in TIMES)
    head = ('crowd', 'noise', 'motion', 'people', f'error at {moments} s', 'constant velocity',
            'surprise', 'within 1 sigma', 'within 2 sigma')  # fmt: skip
    return text_table([head, *(cells(result) for result in results)])


def cells(result: PredictionResult) -> tuple[str, ...]:
    """Return the cells of a result."""
    return (
        result.crowd,
        'yes' if result.noise else 'no',
        result.motion,
        f'{result.people:,}',
        ' '.join(f'{value:.3f}' for value in result.error),
        ' '.join(f'{value:.3f}' for value in result.constant_velocity),
        ' '.join(f'{value:.2f}' for value in result.surprise),
        ' '.join(f'{value:.2f}' for value in result.within_one),
        ' '.join(f'{value:.2f}' for value in result.within_two),
    )
