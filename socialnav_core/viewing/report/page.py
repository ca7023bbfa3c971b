"""The page: one file that needs no other and no network."""

from collections.abc import Sequence
from importlib.resources import files
import json
from typing import Any

from socialnav_core.extras import extra
from socialnav_core.viewing.recording import OUTCOMES
from socialnav_core.viewing.report import plots, repeat, tables
from socialnav_core.viewing.report.contents import density, Order, report_data, World
from socialnav_core.viewing.report.grids import Grid
from socialnav_core.viewing.report.learning import Curve
from socialnav_core.viewing.report.verdict import Standing, verdict

with extra('report'):
    from jinja2 import Environment, StrictUndefined


def report_page(worlds: list[World], grids: Sequence[Grid], order: Order) -> str:
    """
    Return the HTML of a report.

    :param worlds: at least one; all with the same policies.
    :param grids: whose heat maps are shown.
    """
    environment = Environment(
        autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    names = [result.model for result in worlds[0].results]
    return environment.from_string(resource('page.html')).render(
        names=names,
        style=resource('page.css'),
        script=resource('drawing.js') + resource('player.js'),
        data=embedded(report_data(worlds)),
        outcomes=OUTCOMES,
        verdict=verdict(
            [Standing(world.title, world.results, world.comparisons) for world in worlds]
        ),
        worlds=[section(world, order) for world in worlds],
        density=plots.success_over_density(worlds),
        learning=learning_plots(names, order.curves),
        grids=grids,
        commands=repeat.commands(order, worlds),
        versions=repeat.versions(),
        order=order,
        episodes=worlds[0].results[0].episodes,
    )


def resource(name: str) -> str:
    """Return a file beside this one."""
    return files('socialnav_core.viewing.report').joinpath(name).read_text(encoding='utf-8')


def embedded(values: Any) -> str:
    """Return JSON that no parser of HTML takes for markup."""
    text = json.dumps(values, separators=(',', ':'), allow_nan=False)
    for sign in '<>&':
        text = text.replace(sign, f'\\u{ord(sign):04x}')
    return text


def section(world: World, order: Order) -> dict[str, Any]:
    """Return what the page says of one world."""
    results = world.results
    return {
        'title': world.title,
        'meaning': world.meaning,
        'density': f'{density(world.scenario):.1f}',
        'figures': tables.main_rows(results),
        'everything': tables.all_rows(results),
        'differences': tables.comparison_rows(world) if world.comparisons else [],
        'arrivals': plots.arrivals(results, world.title),
        'distances': plots.distances(results, world.title),
        'cases': [cells_of(world, case, order) for case in world.played],
        'unseen': [(result.model, tables.unseen_failures(world, result)) for result in results],
    }


def cells_of(world: World, case: int, order: Order) -> dict[str, Any]:
    """Return a case that can be played: of each policy the episode's place, end and command."""
    return {
        'number': case,
        'episodes': [
            {
                'place': place,
                'outcome': playback['outcome'],
                'time': playback['times'][-1],
                'command': repeat.episode_command(order, world, playback['policy'], case),
            }
            for place, playback in enumerate(world.playbacks)
            if playback['case'] == case
        ],
    }


def learning_plots(names: Sequence[str], curves: Sequence[Curve]) -> list[str]:
    """Return a plot for each way of counting the steps of trainings."""
    places = {name: place for place, name in enumerate(names)}
    groups: dict[str, list[Curve]] = {}
    for curve in curves:
        groups.setdefault(curve.counts, []).append(curve)
    return [plots.learning(curves, places) for curves in groups.values()]
