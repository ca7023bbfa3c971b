"""Laws of the page of settings."""

from pathlib import Path

from socialnav_core.config import Config, make_scenario, PolicyConfig
from socialnav_core.config.mapping import flatten, to_mapping
from socialnav_core.config.page import settings_page, value_text

PAGE = Path(__file__).parents[2] / 'docs' / 'settings.md'


def test_the_page_of_settings_is_that_of_the_code():
    assert PAGE.read_text() == settings_page(), 'run socialnav settings > docs/settings.md'


def test_every_setting_has_a_row_with_a_meaning():
    lines = [line.replace(r'\|', '') for line in settings_page().splitlines()]
    rows = {line.split('|')[1].strip(): line for line in lines if line.startswith('| ')}
    for name in flatten(to_mapping(Config('run', make_scenario('hard'), PolicyConfig()))):
        cells = rows[f'`{name}`'].split('|')
        assert len(cells) == 6 and cells[4].strip(), name


def test_defaults_are_written_as_yaml():
    values = (True, False, None, '', 'adam', 3, 0.25, 1e-4, float('inf'))
    texts = ['true', 'false', 'null', "''", 'adam', '3', '0.25', '0.0001', '.inf']
    assert [value_text(value) for value in values] == texts
