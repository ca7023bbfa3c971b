"""The plain reference of a checkout: one world, one action, one forward pass at a time."""

import importlib.util
from pathlib import Path
from types import ModuleType

REFERENCE = Path(__file__).parents[2] / 'benchmarks' / 'core' / 'reference.py'


def load_reference() -> ModuleType | str:
    """Return the module, or why there is none."""
    if not REFERENCE.is_file():
        return f'there is no {REFERENCE}: ratios need a checkout'
    specification = importlib.util.spec_from_file_location('socialnav_reference', REFERENCE)
    assert specification is not None and specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    try:
        specification.loader.exec_module(module)
    except ImportError as error:
        return f'{error}: ratios need requirements/dev.txt'
    return module
