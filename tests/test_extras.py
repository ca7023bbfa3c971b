"""Laws of optional packages: what is missing is named with the extra that brings it."""

import importlib
from pathlib import Path
import sys

import pytest

from socialnav_core import cli
from socialnav_core.benchmarking import reference
from socialnav_core.extras import extra, MissingExtra

ROOT = Path(__file__).parents[1]


def test_a_package_that_is_there_is_imported():
    with extra('train'):
        import json
    assert json.loads('1') == 1


def test_a_missing_package_is_named_with_its_extra(monkeypatch):
    monkeypatch.setitem(sys.modules, 'mcap_ros2', None)
    monkeypatch.delitem(sys.modules, 'socialnav_core.viewing.bag', raising=False)
    monkeypatch.delitem(sys.modules, 'mcap_ros2.writer', raising=False)
    with pytest.raises(MissingExtra, match=r"^mcap_ros2.* pip install 'socialnav_core\[bag\]'$"):
        importlib.import_module('socialnav_core.viewing.bag')


def test_a_command_that_lacks_a_package_fails_in_one_line(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr('shutil.which', lambda name: None)
    monkeypatch.setitem(sys.modules, 'imageio_ffmpeg', None)
    words = ['render', 'orca', '--scenario', 'circle', '--out', str(tmp_path / 'a.mp4')]
    assert cli.main(words) == cli.FAILURE
    captured = capsys.readouterr().err
    assert captured.count('\n') == 1
    assert 'socialnav_core[video]' in captured


def test_without_a_checkout_the_benchmark_says_what_needs_one(monkeypatch):
    monkeypatch.setattr(reference, 'CHECKOUT', None)
    assert 'need a checkout' in reference.load_reference()


def test_without_rvo2_the_benchmark_names_the_extra(monkeypatch):
    monkeypatch.setitem(sys.modules, 'pyrvo', None)
    assert 'socialnav_core[benchmark]' in reference.load_reference()
