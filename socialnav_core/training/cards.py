"""The card of a checkpoint, whatever it holds."""

from pathlib import Path

from socialnav_core.policies.search.checkpoint import Planner
from socialnav_core.policies.value.checkpoint import Checkpoint
from socialnav_core.training.model_card import write_model_card
from socialnav_core.training.planner.model_card import write_planner_card


def write_card(folder: Path, held: Checkpoint | Planner) -> None:
    """Write README.md of a checkpoint from what it holds, its metrics and progress."""
    if isinstance(held, Planner):
        write_planner_card(folder, held)
    else:
        write_model_card(folder, held)
