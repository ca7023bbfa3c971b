"""How a report is made again: its commands, and the versions that it was made with."""

from importlib.metadata import version
import platform
import shlex
import subprocess

from socialnav_core import __version__
from socialnav_core.places import CHECKOUT
from socialnav_core.viewing.report.contents import Order, World

PACKAGES = ('numpy', 'numba', 'torch', 'scipy')
"""Those that figures can depend on."""
PATIENCE = 10.0
"""How long git may take, s."""


def commands(order: Order, worlds: list[World]) -> list[tuple[str, str]]:
    """Return what each command does, and the command."""
    episodes = worlds[0].results[0].episodes
    models = [result.model for result in worlds[0].results]
    kind = 'compare' if len(models) > 1 else 'evaluate'
    lines = [('This page', shell('socialnav', *order.words))]
    for world in worlds:
        words = (*models, '--scenario', world.name, '--episodes', str(episodes), *order.options)
        lines.append((f'Figures of {world.title}', shell('socialnav', kind, *words)))
    return lines


def episode_command(order: Order, world: World, model: str, case: int) -> str:
    """Return the command that draws one episode."""
    words = (model, '--scenario', world.name, *order.options, '--case', str(case))
    return shell('socialnav', 'render', *words)


def shell(*words: str) -> str:
    """Return words as a shell reads them."""
    return shlex.join(words)


def versions() -> list[tuple[str, str]]:
    """Return what took part in the figures, and its version."""
    return [
        ('socialnav_core', f'{__version__}{revision()}'),
        ('Python', platform.python_version()),
        *((package, version(package)) for package in PACKAGES),
        ('system', f'{platform.system()} {platform.machine()}'),
    ]


def revision() -> str:
    """Return the commit of a checkout, and whether files differ from it; empty without git."""
    if CHECKOUT is None:
        return ''
    try:
        words = ['git', '-C', str(CHECKOUT), 'describe', '--always', '--dirty', '--exclude', '*']
        done = subprocess.run(words, capture_output=True, text=True, timeout=PATIENCE)
    except (OSError, subprocess.TimeoutExpired):
        return ''
    return f' ({done.stdout.strip()})' if done.returncode == 0 else ''
