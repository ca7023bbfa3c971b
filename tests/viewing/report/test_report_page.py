"""Laws of the page: it needs nothing else, tells what was measured, and everybody can read it."""

import dataclasses
import html.parser
import json
import re

from made_report import EPISODES, made_order, made_world, POLICIES
import pytest

from socialnav_core.viewing.report import report_page
from socialnav_core.viewing.report.contents import density, OUTCOME_NAMES
from socialnav_core.viewing.report.learning import Curve
from socialnav_core.viewing.report.page import embedded, resource
from socialnav_core.viewing.report.svg import COLOURS

HOSTILE = '</script><b id="hostile">&$\\x$'
VOID = {'meta', 'link', 'input', 'img', 'br', 'path', 'use', 'rect'}


class Page(html.parser.HTMLParser):
    """The elements of a page: their names with their attributes, the identities, the text."""

    def __init__(self, text):
        super().__init__()
        self.elements, self.open, self.text, self.data = [], [], '', ''
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        self.elements.append((tag, dict(attributes)))
        if tag not in VOID:
            self.open.append((tag, dict(attributes)))

    def handle_startendtag(self, tag, attributes):
        self.elements.append((tag, dict(attributes)))

    def handle_endtag(self, tag):
        assert self.open.pop()[0] == tag

    def handle_data(self, data):
        tag, attributes = self.open[-1] if self.open else ('', {})
        if attributes.get('id') == 'data':
            self.data += data
        elif tag not in ('script', 'style'):
            self.text += data

    def named(self, tag):
        return [attributes for name, attributes in self.elements if name == tag]


@pytest.fixture(scope='module')
def worlds():
    return [made_world('circle'), made_world('simple')]


@pytest.fixture(scope='module')
def text(worlds):
    return report_page(worlds, [], made_order())


@pytest.fixture(scope='module')
def page(text):
    return Page(text)


def test_the_page_is_well_formed(page):
    assert page.open == []
    identities = [attributes['id'] for _, attributes in page.elements if 'id' in attributes]
    assert len(identities) == len(set(identities))


def test_the_page_needs_no_other_file_and_no_network(page, text):
    for tag, attributes in page.elements:
        for name in ('src', 'href', 'action', 'srcset', 'xlink:href'):
            assert attributes.get(name, '#').startswith(('#', 'data:')), (tag, attributes)
    assert not re.search(r'https?:|@import|url\((?!#)', text)
    assert "default-src 'none'" in text


def test_the_data_are_those_of_the_evaluation(page, worlds):
    data = json.loads(page.data)
    assert tuple(data['outcomes']) == OUTCOME_NAMES
    for told, world in zip(data['worlds'], worlds, strict=True):
        assert [each['model'] for each in told['results']] == list(POLICIES)
        for values, result in zip(told['results'], world.results, strict=True):
            expected = result.to_mapping(['all'])
            assert values['figures'] == {name: expected[name] for name in values['figures']}
            assert values['success_interval'] == expected['success_interval']
            cases = expected['cases']
            assert len(cases) == EPISODES
            assert [data['outcomes'][code] for code in values['outcome']] == [
                case['outcome'] for case in cases
            ]
            assert values['time'] == [round(case['time'], 2) for case in cases]
        assert told['comparisons'] == [
            json.loads(json.dumps(each.to_mapping())) for each in world.comparisons
        ]
        assert told['episodes'] == json.loads(json.dumps(world.playbacks))


def test_the_tables_show_the_figures_with_their_intervals(page, worlds):
    for world in worlds:
        for result in world.results:
            low, high = result.success_interval
            assert f'{result.success_rate:.3f}' in page.text
            assert f'[{low:.3f}, {high:.3f}]' in page.text


def test_every_episode_has_a_button_that_says_what_it_loads(page, worlds):
    buttons = [each for each in page.named('button') if 'data-episode' in each]
    assert len(buttons) == sum(len(world.playbacks) for world in worlds)
    for button in buttons:
        world = worlds[int(button['data-world'])]
        playback = world.playbacks[int(button['data-episode'])]
        assert f'case {playback["case"]} of' in button['aria-label']
        assert f'with {playback["policy"]}:' in button['aria-label']
        assert button['data-command'].startswith(f'socialnav render {playback["policy"]} ')
        assert button['data-command'].endswith(f'--case {playback["case"]}')


def test_failures_that_cannot_be_played_are_named(page, worlds):
    for world in worlds:
        for result in world.results:
            for case in result.records.case_index[~result.records.success]:
                assert case in world.played or re.search(rf'cases [\d, ]*\b{case}\b', page.text)


def test_pictures_have_words_and_controls_have_names(page):
    plots = page.named('svg')
    assert len(plots) == 5  # density, and two of each world
    assert all(each['role'] == 'img' and each['aria-label'] for each in plots)
    assert all(each['alt'] for each in page.named('img'))
    assert all(each.get('aria-label') for each in page.named('canvas'))
    [_, *headings] = [tag for tag, _ in page.elements if re.fullmatch('h[1-6]', tag)]
    assert 'h1' not in headings
    assert page.named('html') == [{'lang': 'en'}]


def test_parts_of_plots_have_names_of_their_own(text):
    names = re.findall(r' id="([mp][0-9a-f]{10})"', text)
    assert len(names) > 5 and len(names) == len(set(names))


def test_names_and_settings_are_no_markup(worlds):
    result = dataclasses.replace(worlds[0].results[0], model=HOSTILE, scenario=HOSTILE)
    playbacks = [{**each, 'policy': HOSTILE} for each in worlds[0].playbacks[:1]]
    world = dataclasses.replace(
        worlds[0], results=[result], comparisons=[], playbacks=playbacks, name=HOSTILE
    )
    page = Page(report_page([world], [], made_order()))
    assert page.open == []
    assert all(attributes.get('id') != 'hostile' for _, attributes in page.elements)
    assert HOSTILE in page.text
    assert json.loads(page.data)['worlds'][0]['results'][0]['model'] == HOSTILE


def test_json_in_the_page_holds_no_sign_of_markup():
    assert not set(embedded({'a': HOSTILE})) & set('<>&')
    assert json.loads(embedded({'a': HOSTILE})) == {'a': HOSTILE}


def test_the_exact_commands_and_versions_are_on_the_page(page):
    from socialnav_core import __version__

    assert "--out 'out/<b>'" in page.text
    assert 'socialnav compare orca straight_line --scenario simple --episodes 8' in page.text
    assert f'socialnav_core{__version__}' in page.text.replace('\n', '')


def test_models_with_a_history_of_their_training_show_it(worlds):
    order = made_order([Curve('orca', 'decisions', [0, 100, 200], [0.0, 0.5, 0.9])])
    page = Page(report_page(worlds, [], order))
    labels = [each['aria-label'] for each in page.named('svg')]
    assert [each for each in labels if 'during training' in each] == [
        'Success during training over decisions: orca'
    ]


def test_worlds_of_the_same_density_have_no_plot_over_it(worlds):
    page = Page(report_page(worlds[:1], [], made_order()))
    assert not [each for each in page.named('svg') if 'per 100 square' in each['aria-label']]


def test_density_counts_people_on_the_ground_that_they_have(worlds):
    circle, simple = (density(world.scenario) for world in worlds)
    assert simple == pytest.approx(100 * 5 / 15**2)
    assert circle == pytest.approx(100 * 5 / (3.14159265 * 4**2))


def luminance(colour):
    """Return the relative luminance of a colour as WCAG defines it."""
    parts = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(first, second):
    low, high = sorted((luminance(first), luminance(second)))
    return (high + 0.05) / (low + 0.05)


def schemes():
    """Return the colours of the page by name, in the light and in the dark."""
    light, dark = resource('page.css').split('prefers-color-scheme: dark')
    return [dict(re.findall(r'--(\w+): (#\w{6});', part)) for part in (light, dark)]


@pytest.mark.parametrize('colours', schemes(), ids=['light', 'dark'])
def test_everything_stands_out_as_wcag_aa_asks(colours):
    for ground in ('ground', 'raised'):
        for name in ('ink', 'faint', 'accent', 'good', 'bad', 'caution'):
            assert contrast(colours[name], colours[ground]) >= 4.5, (name, ground)
    for name in ('robot', 'person', 'goal', 'attention', 'predicted', 'plan', 'actions', 'wall'):
        assert contrast(colours[name], colours['floor']) >= 3, name
    assert all(contrast(colour, colours['ground']) >= 3 for colour in COLOURS)
