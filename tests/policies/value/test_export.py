"""Laws of networks as ONNX files."""

import numpy as np
import onnxruntime
import pytest

from socialnav_core import cli
from socialnav_core.policies.loading import find_model
from socialnav_core.policies.value.checkpoint import load_checkpoint
from socialnav_core.policies.value.inference import ValueInference


def observations(rows, agents, seed=0):
    """Return robot, others and mask, with slots that are empty."""
    draws = np.random.default_rng(seed)
    robot = draws.normal(size=(rows, 6)).astype(np.float32)
    others = draws.normal(size=(rows, agents, 7)).astype(np.float32)
    return robot, others, draws.random((rows, agents)) < 0.7


@pytest.mark.parametrize('model', ['sarl', 'gat4sn'])
def test_the_file_computes_the_values_of_the_network(model, tmp_path):
    path = tmp_path / 'network.onnx'
    assert cli.main(['export', model, '--out', str(path)]) == 0
    session = onnxruntime.InferenceSession(path)
    network = ValueInference(load_checkpoint(find_model(model)).network)
    for rows, agents in ((1, 1), (17, 10), (4, 30)):
        seen = observations(rows, agents)
        (values,) = session.run(None, dict(zip(('robot', 'others', 'mask'), seen, strict=True)))
        assert values.shape == (rows,)
        np.testing.assert_allclose(values, network.values(*seen), atol=1e-5)


def test_a_file_that_exists_is_kept(tmp_path, capsys):
    path = tmp_path / 'network.onnx'
    path.write_text('mine')
    assert cli.main(['export', 'sarl', '--out', str(path)]) == cli.USAGE
    assert path.read_text() == 'mine' and '--overwrite' in capsys.readouterr().err
