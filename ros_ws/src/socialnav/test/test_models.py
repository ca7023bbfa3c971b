"""Laws of the parameter `model`; no middleware is needed for them."""

from pathlib import Path
import shutil

from ament_index_python.packages import get_package_share_directory
import pytest

from socialnav.controller_settings import real_time_settings
from socialnav.models import installed, ready_policy
from socialnav.parameters import DEFAULT_MODEL, POLICY_PARAMETERS

SHARE = Path(get_package_share_directory('socialnav')) / 'models'
VALUES = {entry.name: entry.default for entry in POLICY_PARAMETERS}


def load(model):
    """Return what a node would drive by."""
    values = VALUES | {'model': str(model)}
    return ready_policy(values, real_time_settings(values))


def test_a_name_is_that_of_a_model_of_the_package_wherever_the_node_was_started(
    tmp_path, monkeypatch
):
    (tmp_path / DEFAULT_MODEL).mkdir()
    monkeypatch.chdir(tmp_path)
    assert Path(installed(DEFAULT_MODEL)) == SHARE / DEFAULT_MODEL


@pytest.mark.parametrize('name', ['', '.', '..', '../models', f'../models/{DEFAULT_MODEL}', '/'])
def test_nothing_but_a_name_is_looked_up_in_the_share_folder(name):
    assert installed(name) == name


def test_the_folder_of_a_checkpoint_is_a_model_wherever_it_is(tmp_path):
    folder = tmp_path / 'anywhere'
    shutil.copytree(SHARE / DEFAULT_MODEL, folder)
    assert load(folder).kinematics == 'holonomic'


@pytest.mark.parametrize(
    'name',
    [
        '', '.', '..', '/', '/etc/passwd', '../../../../../../etc', 'a\0b', 'file:///etc', '$HOME',
        'x' * 300, f'{SHARE}/{DEFAULT_MODEL}/config.yaml', f'{DEFAULT_MODEL}/weights.safetensors',
    ],
)  # fmt: skip
def test_whatever_is_no_checkpoint_is_one_line_about_what_could_be_given(name):
    with pytest.raises(ValueError, match='no model') as error:
        load(name)
    assert '\n' not in str(error.value)
