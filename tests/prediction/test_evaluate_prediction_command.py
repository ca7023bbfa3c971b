"""Laws of `socialnav evaluate-prediction`."""

import json

from PIL import Image
import pytest

from socialnav_core import cli
from socialnav_core.config.prediction import PredictionConfig, PredictionTrainingConfig
from socialnav_core.evaluation.judgement import LEVELS, TIMES
from socialnav_core.prediction.learned.checkpoint import save_weights
from socialnav_core.training.prediction.network import build_network, inference_weights


@pytest.fixture
def model(tmp_path):
    """Return the folder of a prediction that nothing was taught."""
    config = PredictionConfig('untaught', training=PredictionTrainingConfig(width=16))
    save_weights(tmp_path / 'model', inference_weights(build_network(16, 0)), config)
    return tmp_path / 'model'


def run(*words):
    """Return the exit code of the command on few people."""
    few = ('--crowds', 'hard', '--groups', '1', '--split', 'validation')
    return cli.main(['evaluate-prediction', *map(str, words), *few])


def test_it_writes_figures_of_each_motion_and_a_picture(model, tmp_path, capsys):
    picture, figures = tmp_path / 'pictures' / 'reliability.png', tmp_path / 'figures.json'
    assert run(model, '--motions', '--picture', picture, '--json', figures) == 0
    values = json.loads(figures.read_text())
    assert {value['motion'] for value in values} >= {'all', 'new', 'turning', 'walking'}
    assert len(values[0]['surprise']) == len(TIMES)
    assert len(values[0]['within_level'][0]) == len(LEVELS)
    assert 'turning' in capsys.readouterr().out
    with Image.open(picture) as image:
        assert image.format == 'PNG'


def test_the_card_is_of_all_people(model):
    assert run(model, '--motions', '--card') == 0
    metrics = json.loads((model / 'metrics.json').read_text())
    assert set(metrics) == {'hard', 'hard+noise'}
    assert 'within_level' not in metrics['hard'] and 'motion' not in metrics['hard']
    assert (model / 'README.md').read_text().count('| hard |') == 2


@pytest.mark.parametrize('name', ['picture.txt', 'picture'])
def test_a_picture_of_an_unknown_format_is_refused_before_anything_is_measured(
    name, model, tmp_path, capsys
):
    assert run(model, '--picture', tmp_path / name) != 0
    assert '.png' in capsys.readouterr().err


def test_a_picture_that_exists_is_kept(model, tmp_path):
    picture = tmp_path / 'picture.png'
    picture.write_text('mine')
    assert run(model, '--picture', picture) != 0
    assert picture.read_text() == 'mine'
