"""Laws of the learning curves: every shipped model's is read, and nothing else is made up."""

import pytest

from socialnav_core.config import ConfigError
from socialnav_core.places import MODELS
from socialnav_core.viewing.report.learning import learning_curve


@pytest.mark.parametrize('name, counts', [('sarl', 'decisions'), ('socialnav', 'rounds')])
def test_the_history_of_a_shipped_model_is_read(name, counts):
    curve = learning_curve(name, MODELS / name)
    assert curve.counts == counts
    assert curve.steps == sorted(curve.steps) and len(curve.steps) == len(curve.success) > 2
    assert all(0 <= share <= 1 for share in curve.success)


def test_a_folder_without_history_and_one_of_another_kind_give_no_curve(tmp_path):
    assert learning_curve('new', tmp_path) is None
    assert learning_curve('prediction', MODELS / 'prediction') is None


@pytest.mark.parametrize(
    'text', ['', 'decisions,success_rate\n', 'decisions,success_rate\n1,nan\n2,\n']
)
def test_a_history_without_figures_gives_no_curve(text, tmp_path):
    (tmp_path / 'progress.csv').write_text(text)
    assert learning_curve('new', tmp_path) is None


def test_what_is_no_table_is_told_with_its_name(tmp_path):
    (tmp_path / 'progress.csv').write_bytes(b'decisions,success_rate\n\xff\xfe\n')
    with pytest.raises(ConfigError, match='progress.csv is no table'):
        learning_curve('new', tmp_path)
