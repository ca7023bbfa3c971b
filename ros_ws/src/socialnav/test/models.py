"""Which models there are to test with."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory

from socialnav.parameters import DEFAULT_MODEL


def default_model_folder() -> Path:
    """Return where the default model is installed, if it is."""
    return Path(get_package_share_directory('socialnav')) / 'models' / DEFAULT_MODEL
