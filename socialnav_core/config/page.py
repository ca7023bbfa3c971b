"""Every setting with its default, its range and what it means, as a page of the documentation."""

import ast
from collections.abc import Iterator
import dataclasses
import inspect
import math
from typing import Any

from socialnav_core.config.mapping import join
from socialnav_core.config.planner import PlannerConfig
from socialnav_core.config.prediction import PredictionConfig
from socialnav_core.config.ranges import rules_of
from socialnav_core.config.scenario import Scenario
from socialnav_core.config.search import SearchConfig
from socialnav_core.config.training import Config
from socialnav_core.tables import markdown_table, NOTHING

COLUMNS = ('setting', 'default', 'allowed', 'meaning')
INTRODUCTION = """# Settings

Written by `socialnav settings` from the dataclasses in `socialnav_core/config`.

A number must be finite and in its range, both ends allowed; what is out of it is refused in one
line that names the setting, wherever it comes from: a file, `--set`, Python, or the config of a
checkpoint. `.inf` is allowed where the range says so.
"""
SECTIONS = {
    'Scenario': ('A world: `scenario` in a config, files of scenarios.', 'scenario', Scenario),
    'Training': ('What `socialnav train` reads, besides the scenario.', '', Config),
    'Prediction': ('What `socialnav train-prediction` reads.', '', PredictionConfig),
    'Planner': (
        'What `socialnav train-planner` reads: the search, as below, and',
        '',
        PlannerConfig,
    ),
    'Search': ('The policy `search`.', 'policy', SearchConfig),
}
"""Title, what is below it, dotted path and dataclass of each table."""


def settings_page() -> str:
    """Return docs/settings.md."""
    parts = [INTRODUCTION]
    for title, (meaning, where, kind) in SECTIONS.items():
        table = markdown_table(COLUMNS, list(rows_of(kind, where)))
        parts.append(f'## {title}\n\n{meaning}\n\n{table}\n')
    return '\n'.join(parts)


def rows_of(kind: Any, where: str) -> Iterator[tuple[str, ...]]:
    """
    Yield a row of COLUMNS for each setting of a dataclass, those of nested ones too.

    :param where: dotted path of the dataclass.
    """
    meanings, rules = meanings_of(kind), rules_of(kind)
    for field in dataclasses.fields(kind):
        name = join(where, field.name)
        if dataclasses.is_dataclass(field.default):
            yield from rows_of(type(field.default), name)
        elif field.name != 'scenario':
            default = '' if field.default is dataclasses.MISSING else value_text(field.default)
            allowed = str(rules[field.name][1]) if field.name in rules else NOTHING
            yield (f'`{name}`', default, allowed, meanings[field.name])


def value_text(value: Any) -> str:
    """Return a default as YAML writes it."""
    if isinstance(value, float):
        return '.inf' if math.isinf(value) else f'{value:.6g}'
    if isinstance(value, str):
        return value or "''"
    return 'null' if value is None else str(value).lower()


def meanings_of(kind: Any) -> dict[str, str]:
    """Return the docstring under each field of a dataclass, on one line."""
    body = ast.parse(inspect.getsource(kind)).body[0].body  # type: ignore[attr-defined]
    meanings = {}
    for field, text in zip(body, body[1:], strict=False):
        if isinstance(field, ast.AnnAssign) and isinstance(text, ast.Expr):
            words = ast.literal_eval(text.value).split()
            meanings[field.target.id] = ' '.join(words).replace('|', r'\|')  # type: ignore[union-attr]
    return meanings
