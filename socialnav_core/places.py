"""Where the files that belong to the package lie: in a checkout, or where it is installed."""

from pathlib import Path

PACKAGE = Path(__file__).resolve().parent  # in a workspace built with links, that of the sources
CHECKOUT = PACKAGE.parent if (PACKAGE.parent / 'setup.py').is_file() else None
"""Root of the repository; None where the package was installed as a copy."""
MODELS = (CHECKOUT or PACKAGE) / 'models'
"""The shipped models; setup.py copies them into an installed package."""
