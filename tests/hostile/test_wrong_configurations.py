"""Whatever a configuration holds, it is read or refused in one line that names the place."""

import dataclasses

from hypothesis import given
from hypothesis import strategies as st
import pytest
from wrong_values import trials, wrong_texts
import yaml

from socialnav_core.config import Config, ConfigError, make_scenario, Scenario, SearchConfig
from socialnav_core.config.mapping import flatten, from_mapping, replace, to_mapping, to_yaml
from socialnav_core.config.prediction import PredictionConfig
from socialnav_core.config.ranges import plain_and_rules, Range, rules_of
from socialnav_core.config.reading import read_config, read_prediction_config
from socialnav_core.config.scenarios import read_scenario

SEARCH = SearchConfig()
WHOLE = (Config('run', make_scenario('hard')), PredictionConfig('people'), SEARCH)
NO_NUMBERS = (float('nan'), float('inf'), -float('inf'), -1e9, 1e30, 10**400, -(10**30))
READERS = {
    read_config: WHOLE[0], read_prediction_config: WHOLE[1], read_scenario: make_scenario('hard'),
}  # fmt: skip


def numbers_of(settings):
    """Return the dotted names of all numbers of a configuration, with their ranges."""
    found = {}
    for name, value in vars(settings).items():
        if dataclasses.is_dataclass(value):
            found |= {f'{name}.{inner}': rule for inner, rule in numbers_of(value).items()}
        elif isinstance(value, (int, float)) and not isinstance(value, bool):
            found[name] = rules_of(type(settings)).get(name, (None, None))[1]
    return found


@pytest.mark.parametrize('settings', WHOLE, ids=lambda each: type(each).__name__)
def test_every_number_has_a_range(settings):
    found = numbers_of(settings)
    assert len(found) > 15
    assert [name for name, rule in found.items() if not isinstance(rule, Range)] == []


@pytest.mark.parametrize('settings', WHOLE, ids=lambda each: type(each).__name__)
def test_every_number_out_of_its_range_is_refused_by_name(settings):
    for name, rule in numbers_of(settings).items():
        for number in NO_NUMBERS:
            if rule.or_infinite and number in (float('inf'), 10**400):
                continue  # an integer too large for a float is as good as infinity
            with pytest.raises(ConfigError, match=name.rpartition('.')[2]):
                replace(settings, {name: number})


@pytest.mark.parametrize('settings', WHOLE, ids=lambda each: type(each).__name__)
def test_every_default_is_in_its_range(settings):
    assert from_mapping(type(settings), to_mapping(settings)) == settings


def test_settings_made_in_python_pass_the_same_ranges():
    for changes in ({'pedestrians': 2.5}, {'time_step': 'x'}, {'bounds': float('nan')}):
        with pytest.raises(ConfigError, match=next(iter(changes))):
            Scenario('made', **changes)


def test_annotations_leave_the_type_of_a_field():
    for name, (kind, rule) in rules_of(Scenario).items():
        assert plain_and_rules(kind) == (kind,), (name, rule)


def spoilt(draw, text):
    """Return a text in which a value, or some characters, were replaced."""
    if draw(st.booleans()):
        lines = text.splitlines()
        number = draw(st.integers(0, len(lines) - 1))
        lines[number] = f'{lines[number].partition(":")[0]}: {draw(wrong_texts)}'
        return '\n'.join(lines)
    begin = draw(st.integers(0, len(text)))
    end = begin + draw(st.integers(0, 20))
    return text[:begin] + draw(wrong_texts) + text[end:]


@st.composite
def spoilt_documents(draw):
    """Draw what reads a configuration, and a text of one with up to three faults."""
    reader = draw(st.sampled_from(list(READERS)))
    text = to_yaml(READERS[reader])
    for _ in range(draw(st.integers(1, 3))):
        text = spoilt(draw, text)
    return reader, text


@pytest.fixture(scope='module')
def counted(tmp_path_factory):
    """Return a function that reads a document, and how often one was refused."""
    path = tmp_path_factory.mktemp('configurations') / 'spoilt.yaml'
    refused = []

    def read(reader, text):
        path.write_bytes(text.encode('utf-8', 'surrogatepass'))
        try:
            settings = reader(path)
        except ConfigError as error:
            assert 'spoilt.yaml' in str(error) and '\n' not in str(error), str(error)
            assert len(str(error)) < 2000, str(error)
            refused.append(str(error))
            return
        again = yaml.safe_load(to_yaml(settings))
        assert flatten(to_mapping(from_mapping(type(settings), again))) == flatten(
            to_mapping(settings)
        )

    return read, refused


def check(counted, count):
    """Read so many spoilt documents; at least half of them are wrong."""
    read, refused = counted
    refused.clear()
    given(spoilt_documents())(trials(count)(lambda document: read(*document)))()
    print(f'{len(refused)} wrong configurations refused in one line')
    assert len(refused) > count / 2


def test_a_wrong_configuration_is_refused_in_one_line_that_names_the_file(counted):
    check(counted, 150)


@pytest.mark.slow
@pytest.mark.timeout(1800)
def test_two_thousand_wrong_configurations_are_refused_in_one_line_each(counted):
    check(counted, 3200)
    assert len(counted[1]) >= 2000
