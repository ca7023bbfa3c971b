"""The plain reference of a checkout: one world, one action, one forward pass at a time."""

import importlib.util
from types import ModuleType

from socialnav_core.extras import extra, MissingExtra
from socialnav_core.places import CHECKOUT

REFERENCE = 'benchmarks/core/reference.py'


def load_reference() -> ModuleType | str:
    """Return the module, or why there is none."""
    if CHECKOUT is None or not (CHECKOUT / REFERENCE).is_file():
        return f'ratios need a checkout of the repository, which has {REFERENCE}'
    specification = importlib.util.spec_from_file_location(
        'socialnav_reference', CHECKOUT / REFERENCE
    )
    assert specification is not None and specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    try:
        with extra('benchmark'):
            specification.loader.exec_module(module)
    except MissingExtra as error:
        return f'no ratios: {error}'
    return module
