"""`socialnav export`: the network of a model for programs without Python."""

import argparse
from pathlib import Path
from typing import Any

from socialnav_core.commands.arguments import add_command, add_overwrite_option
from socialnav_core.commands.files import require_new

EXAMPLES = """sarl
gat4sn --out out/gat4sn.onnx"""


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'Write the value network of a model as an ONNX file.'
    parser = add_command(commands, 'export', run, summary, EXAMPLES)
    parser.add_argument('model', metavar='MODEL', help='folder of a checkpoint or name in models/')
    parser.add_argument('--out', type=Path, metavar='FILE', help='what to write (out/MODEL.onnx)')
    add_overwrite_option(parser)


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    import logging

    from socialnav_core.policies.loading import find_model, read_model
    from socialnav_core.policies.value.export import export_network

    folder = find_model(given.model)
    path = given.out or Path('out', f'{folder.resolve().name}.onnx')
    require_new(path, given)
    logging.disable(logging.WARNING)  # torch tells of packages for images
    export_network(read_model(folder).network, path)
    print(
        f'{path}: robot (rows, 6), others (rows, agents, 7), mask (rows, agents) -> value (rows)'
    )
