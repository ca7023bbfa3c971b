"""`ros2 param load`: give a node the parameters of a file."""

import argparse
import sys

from rcl_interfaces.msg import Parameter
from rcl_interfaces.srv import SetParameters
from rclpy.parameter import parameter_dict_from_yaml_file
import yaml

from small_ros2.clients import absolute, ask
from small_ros2.command import CommandError
from small_ros2.graph import probe


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the command."""
    parser.add_argument('node_name', help='full name, with namespace')
    parser.add_argument('parameter_file', help='as `ros2 param dump` prints it')
    parser.add_argument('--no-use-wildcard', action='store_true', help='leave out those of /**')
    parser.set_defaults(command=load)


def load(options: argparse.Namespace) -> None:
    """
    Give a node the parameters of a file; like ros2cli's, exit with 0 though some were refused.

    Every dump has some that are: rclpy lets nobody set what is read-only to what it is already.
    """
    owner = absolute(options.node_name)
    parameters = parameters_of(options.parameter_file, owner, not options.no_use_wildcard)
    with probe() as node:
        request = SetParameters.Request(parameters=parameters)
        results = ask(node, SetParameters, owner, 'set_parameters', request).results
    for parameter, result in zip(parameters, results, strict=True):
        reason = f': {result.reason}' if result.reason else ''
        if result.successful:
            print(f'Set parameter {parameter.name} successful{reason}')
        else:
            print(f'Set parameter {parameter.name} failed{reason}', file=sys.stderr)


def parameters_of(path: str, owner: str, use_wildcard: bool) -> list[Parameter]:
    """
    Return the parameters of a node that a file has.

    :param owner: full name of the node.
    :param use_wildcard: whether those of all nodes are its parameters, too.
    :raises CommandError: a file that cannot be read, or that has none for this node.
    """
    try:
        found = parameter_dict_from_yaml_file(path, use_wildcard, target_nodes=[owner])
    except (AttributeError, TypeError) as error:  # rclpy takes for granted that it is a mapping
        text = f'{path} cannot be loaded: it must hold parameters by the names of nodes'
        raise CommandError(text) from error
    except (OSError, UnicodeDecodeError, RuntimeError, yaml.YAMLError) as error:
        raise CommandError(f'{path} cannot be loaded: {" ".join(str(error).split())}') from error
    return list(found.values())
