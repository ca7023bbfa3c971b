"""Optional packages: what is missing is named together with the extra that brings it."""

from collections.abc import Iterator
import contextlib


class MissingExtra(ImportError):
    """An optional package is not installed; told in one line that says how to install it."""


@contextlib.contextmanager
def extra(name: str) -> Iterator[None]:
    """
    Say how to install what an import within the block lacks.

    :param name: of the extra in setup.py that brings it.
    :raises MissingExtra: when a package is not there.
    """
    try:
        yield
    except ModuleNotFoundError as error:
        raise MissingExtra(
            f"{error.name} is not installed: pip install 'socialnav_core[{name}]'", name=error.name
        ) from error
