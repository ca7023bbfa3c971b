"""The plots of the page: success over density, arrivals, distances to people, learning."""

from collections.abc import Sequence
from typing import Any

from matplotlib.ticker import MaxNLocator, PercentFormatter, StrMethodFormatter
import numpy as np

from socialnav_core.evaluation import EvaluationResult
from socialnav_core.metrics import INTRUSION_DISTANCE, METRICS
from socialnav_core.viewing.report.contents import density, World
from socialnav_core.viewing.report.learning import Curve
from socialnav_core.viewing.report.svg import COLOURS, INK, LINES, Plot, plot


def style_of(place: int) -> dict[str, Any]:
    """Return how the lines of a policy look, by its place among all."""
    return {'color': COLOURS[place % len(COLOURS)], 'linestyle': LINES[place % len(LINES)]}


def arrivals(results: Sequence[EvaluationResult], title: str) -> str:
    """Return the share of the cases that have reached their goal after so much time."""
    spoken = ', '.join(
        f'{result.model} {result.success_rate:.1%}' for result in results
    )  # fmt: skip
    with plot(
        f'arrivals {title}',
        f'Share of cases that arrived over time in {title}; in the end {spoken}',
    ) as drawn:
        end = max(float(result.records.time.max()) for result in results)
        for place, result in enumerate(results):
            times = np.sort(result.records.time[result.records.success])
            staircase(drawn, times, result.episodes, (0.0, end), place, result.model)
        finish(drawn, 'time, s', 'arrived')
    return drawn.svg


def distances(results: Sequence[EvaluationResult], title: str) -> str | None:
    """Return the share of the cases in which somebody came nearer than so much, if there were."""
    metric = METRICS['minimum_people_distance']
    values = [metric.values(result.records) for result in results]
    nearest = [np.sort(each[np.isfinite(each)]) for each in values]
    if not any(map(len, nearest)):
        return None
    spoken = ', '.join(
        f'{result.model} {np.mean(each < INTRUSION_DISTANCE):.0%}'
        for result, each in zip(results, values, strict=True)
    )
    with plot(
        f'distances {title}',
        f'Share of cases over the least distance to people in {title}; '
        f'below {INTRUSION_DISTANCE:g} m: {spoken}',
    ) as drawn:
        low = min(float(each[0]) for each in nearest if len(each))
        high = max(float(np.quantile(each, 0.98)) for each in nearest if len(each))
        span = (min(low, 0.0) - 0.02, max(high, 2 * INTRUSION_DISTANCE))
        for place, (result, each) in enumerate(zip(results, nearest, strict=True)):
            staircase(drawn, each, result.episodes, span, place, result.model)
        drawn.axes.axvline(INTRUSION_DISTANCE, color=INK, linewidth=1, linestyle=':')
        drawn.axes.set_xlim(span)
        finish(drawn, 'least distance to people, m', 'came nearer', 'lower right')
    return drawn.svg


def success_over_density(worlds: Sequence[World]) -> str | None:
    """Return the success over the density of people; None where all worlds are alike in that."""
    ordered = sorted(worlds, key=lambda world: density(world.scenario))
    along = [density(world.scenario) for world in ordered]
    if len(set(along)) < 2:
        return None
    with plot('density', 'Success rate over people per 100 square metres') as drawn:
        for place, first in enumerate(worlds[0].results):
            results = [world.results[place] for world in ordered]
            rates = np.array([result.success_rate for result in results])
            low, high = np.array([result.success_interval for result in results]).T
            drawn.axes.errorbar(
                along, rates, [np.maximum(rates - low, 0), np.maximum(high - rates, 0)],
                label=first.model, marker='o', capsize=4, **style_of(place),
            )  # fmt: skip
        drawn.axes.set_ylim(top=1.02)
        finish(drawn, 'people per 100 m²', 'success', 'lower left', whole=False)
    return drawn.svg


def learning(curves: Sequence[Curve], places: dict[str, int]) -> str:
    """
    Return the success during some trainings.

    :param curves: that count the same steps.
    :param places: of the models among all.
    """
    counts = curves[0].counts
    names = ', '.join(curve.model for curve in curves)
    with plot(f'learning {counts}', f'Success during training over {counts}: {names}') as drawn:
        for curve in curves:
            drawn.axes.plot(
                curve.steps, curve.success, label=curve.model, **style_of(places[curve.model])
            )
        drawn.axes.xaxis.set_major_locator(MaxNLocator(5, integer=True))
        drawn.axes.xaxis.set_major_formatter(StrMethodFormatter('{x:,.0f}'))
        finish(drawn, counts, 'success in training', 'lower right')
    return drawn.svg


def staircase(
    drawn: Plot, values: np.ndarray, count: int, span: tuple[float, float], place: int, name: str
) -> None:
    """
    Draw the share of cases whose value is at most so much.

    :param values: sorted, of those cases that have one.
    :param count: of all cases.
    :param span: from where to where; no value lies before it.
    """
    values = values[values <= span[1]]
    below = np.arange(len(values) + 1) / count
    steps = np.concatenate([span[:1], values, span[1:]])
    drawn.axes.step(steps, np.append(below, below[-1]), where='post', label=name,
                    **style_of(place))  # fmt: skip


def finish(drawn: Plot, along: str, up: str, corner: Any = 'best', whole: bool = True) -> None:
    """
    Label the axes, the one up in per cent.

    :param whole: whether the axis up goes from nothing to all.
    """
    drawn.axes.set_xlabel(along)
    drawn.axes.set_ylabel(up)
    drawn.axes.yaxis.set_major_formatter(PercentFormatter(1.0, decimals=None))
    if whole:
        drawn.axes.set_ylim(0.0, 1.02)
    drawn.axes.legend(loc=corner)
