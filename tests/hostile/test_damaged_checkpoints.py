"""Whatever is done to a checkpoint, it is refused in one line, or is what it was."""

import hashlib
import json
import os
import shutil

from hypothesis import given
from hypothesis import strategies as st
import pytest
from safetensors.torch import load_file, save
import torch
from wrong_values import trials, wrong_texts

from socialnav_core.config.mapping import to_yaml
from socialnav_core.places import MODELS
from socialnav_core.policies.value.checkpoint import load_checkpoint, tensors_digest
from socialnav_core.policies.value.checkpoint import save_weights as save_values
from socialnav_core.prediction.learned.checkpoint import load_weights
from socialnav_core.prediction.learned.checkpoint import save_weights as save_prediction
from socialnav_core.storage import CheckpointError

KINDS = {
    'sarl': ('weights.safetensors', lambda folder: load_checkpoint(folder).digest),
    'gat4sn': ('weights.safetensors', lambda folder: load_checkpoint(folder).digest),
    'prediction': ('prediction.safetensors', lambda folder: load_weights(folder)[1]),
}
HEADERS = ('[]', '[0]', '[-1]', '[1,1]', '[99999999999]', '"F16"', '"X"', '{}', 'null', '1e99')


def flip(draw, folder, name):
    """Alter some bytes of a file, most of them near its beginning."""
    data = bytearray((folder / name).read_bytes())
    for _ in range(draw(st.integers(1, 4))):
        place = draw(st.integers(0, min(len(data), 3000) - 1) | st.integers(0, len(data) - 1))
        data[place] ^= draw(st.integers(1, 255))
    (folder / name).write_bytes(data)


def cut(draw, folder, name):
    """Leave a part of a file."""
    data = (folder / name).read_bytes()
    (folder / name).write_bytes(data[: draw(st.integers(0, len(data) - 1))])


def replace_file(draw, folder, name):
    """Put something else where a file was."""
    path = folder / name
    path.unlink()
    what = draw(st.sampled_from(('nothing', 'folder', 'device', 'pipe', 'loop', 'empty', 'huge')))
    if what == 'folder':
        path.mkdir()
    elif what == 'device':
        path.symlink_to('/dev/zero')
    elif what == 'pipe':
        os.mkfifo(path)
    elif what == 'loop':
        path.symlink_to(path)
    elif what in ('empty', 'huge'):
        path.touch()
        os.truncate(path, 0 if what == 'empty' else 2**40)


def rewrite_header(draw, folder, name):
    """Replace a part of the header of the weights, lengths being right."""
    path = next(folder.glob('*.safetensors'))
    data = path.read_bytes()
    length = int.from_bytes(data[:8], 'little')
    header = json.loads(data[8 : 8 + length])
    entry = draw(st.sampled_from(sorted(header)))
    part = draw(st.sampled_from(sorted(header[entry])))
    header[entry][part] = json.loads(draw(st.sampled_from(HEADERS)))
    text = json.dumps(header).encode()
    path.write_bytes(len(text).to_bytes(8, 'little') + text + data[8 + length :])


def forge(draw, folder, name):
    """Write other weights or settings with digests that are right."""
    path = next(folder.glob('weights.safetensors'), None)
    if path is None:
        return flip(draw, folder, name)
    tensors = load_file(path)
    lines = (folder / 'config.yaml').read_text().splitlines()
    if draw(st.booleans()):
        some = tensors[draw(st.sampled_from(sorted(tensors)))]
        some.view(-1)[0] = draw(st.sampled_from((float('nan'), float('inf'), -1e30, 1e30, 2e4)))
    else:
        number = draw(st.integers(0, len(lines) - 1))
        lines[number] = f'{lines[number].partition(":")[0]}: {draw(wrong_texts)}'
    text = '\n'.join(lines).encode('utf-8', 'surrogatepass')
    (folder / 'config.yaml').write_bytes(text)
    digests = {
        'digest': tensors_digest(tensors), 'config_digest': hashlib.sha256(text).hexdigest()
    }  # fmt: skip
    path.write_bytes(save(tensors, digests))
    return None


DAMAGES = (flip, cut, replace_file, rewrite_header, forge)


@pytest.fixture(scope='module')
def damaged(tmp_path_factory):
    """Return a function that damages a model and loads it, and the complaints so far."""
    place = tmp_path_factory.mktemp('damaged')
    complaints = []

    def load(draw):
        model = draw(st.sampled_from(sorted(KINDS)))
        weights, load_model = KINDS[model]
        folder = place / 'model'
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(MODELS / model, folder)
        before = load_model(folder)
        damage = draw(st.sampled_from(DAMAGES))
        damage(draw, folder, draw(st.sampled_from((weights, 'config.yaml'))))
        try:
            after = load_model(folder)
        except CheckpointError as error:
            assert str(error) and '\n' not in str(error).strip(), str(error)
            complaints.append(str(error))
            return
        assert damage is forge or after == before

    return load, complaints


def check(damaged, count):
    """Load so many damaged checkpoints; most are noticed."""
    load, complaints = damaged
    complaints.clear()
    given(st.data())(trials(count)(lambda data: load(data.draw)))()
    print(f'{len(complaints)} of {count} damaged checkpoints refused in one line')
    assert len(complaints) > 0.8 * count


def test_a_damaged_checkpoint_is_refused_in_one_line(damaged):
    check(damaged, 60)


@pytest.mark.slow
@pytest.mark.timeout(1800)
def test_five_hundred_damaged_checkpoints_are_refused_in_one_line_each(damaged):
    check(damaged, 600)
    assert len(damaged[1]) >= 500


@pytest.mark.parametrize('weight', [float('nan'), float('inf'), 1e30])
def test_weights_that_no_training_leads_to_are_refused(weight, tmp_path):
    network, config, _ = load_checkpoint(MODELS / 'sarl')
    with torch.no_grad():
        next(network.parameters()).view(-1)[0] = weight
    save_values(tmp_path, network, config)
    with pytest.raises(CheckpointError, match=r'not finite|above 10000'):
        load_checkpoint(tmp_path)


def test_equal_models_are_equal_files(tmp_path):
    network, config, _ = load_checkpoint(MODELS / 'sarl')
    weights, prediction = load_weights(MODELS / 'prediction')
    for name in ('first', 'second', 'third', 'fourth', 'fifth'):
        save_values(tmp_path / name, network, config)
        save_prediction(tmp_path / name / 'people', weights, prediction)
    for name in ('*/weights.safetensors', '*/people/prediction.safetensors'):
        files = [path.read_bytes() for path in tmp_path.glob(name)]
        assert len(files) == 5 and len(set(files)) == 1
    assert to_yaml(load_checkpoint(tmp_path / 'first').config) == to_yaml(config)


@pytest.mark.parametrize('model', sorted(KINDS))
@pytest.mark.timeout(60)
def test_what_might_never_end_is_not_read(model, tmp_path):
    weights, load_model = KINDS[model]
    for name in (weights, 'config.yaml'):
        for number, make in enumerate((os.mkfifo, lambda path: path.symlink_to('/dev/zero'))):
            folder = tmp_path / f'{name}-{number}'
            shutil.copytree(MODELS / model, folder)
            (folder / name).unlink()
            make(folder / name)
            with pytest.raises(CheckpointError, match='no file|no such file'):
                load_model(folder)
