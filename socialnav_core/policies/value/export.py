"""A value network as an ONNX file, for programs without Python."""

import io
from pathlib import Path
import warnings

import torch
from torch import nn

from socialnav_core.extras import extra
from socialnav_core.policies.value.observation import AGENT_FEATURES, ROBOT_FEATURES
from socialnav_core.storage import atomic_write

INPUTS, OUTPUT = ('robot', 'others', 'mask'), 'value'
"""Names in the file; what they hold is said by `Observation`."""
ROWS, AGENTS = 3, 5
"""Of the example that the network is traced with; the file takes any numbers."""


def export_network(network: nn.Module, path: Path) -> None:
    """
    Write a value network; the file is replaced at once or not at all.

    It maps robot (rows, 6), others (rows, agents, 7), float32, and mask (rows, agents), bool, to
    value (rows,), for any number of rows and agents.

    :param network: in evaluation mode, on the CPU.
    :raises MissingExtra: when onnx or onnxscript is not installed.
    """
    with extra('onnx'):
        import onnx  # noqa: F401  # torch names neither in a line of its own
        import onnxscript  # noqa: F401
    rows, agents = torch.export.Dim('rows'), torch.export.Dim('agents')
    example = (
        torch.randn(ROWS, ROBOT_FEATURES),
        torch.randn(ROWS, AGENTS, AGENT_FEATURES),
        torch.ones(ROWS, AGENTS, dtype=torch.bool),
    )
    crowd = {0: rows, 1: agents}
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')  # of torch's own parts, and that names are shared
        program = torch.onnx.export(
            network, example, input_names=INPUTS, output_names=[OUTPUT],
            dynamic_shapes=({0: rows}, crowd, crowd), dynamo=True, verbose=False,
        )  # fmt: skip
    buffer = io.BytesIO()
    program.save(buffer)  # type: ignore[arg-type, union-attr]
    path.parent.mkdir(parents=True, exist_ok=True)
    atomic_write(path, buffer.getvalue())
