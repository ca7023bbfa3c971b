"""The nodes as processes for some episodes, with a summary, a picture and a bag of them."""

import argparse
import os
from pathlib import Path
import signal
import sys
import time

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.signals import SignalHandlerOptions

from socialnav.demo.bag import open_bag
from socialnav.demo.children import Nodes, running_nodes
from socialnav.demo.episode_recorder import cause
from socialnav.demo.graph import node_parameters, node_topics, TRUTH
from socialnav.demo.isolation import isolated_environment
from socialnav.demo.listener import DemoNode
from socialnav.demo.report import heading, row, summary, write_json
from socialnav.parameters import DEFAULT_MODEL
from socialnav.programs import INTERRUPTED, take_signals
from socialnav_core.simulation import make_scenario

SILENCE = 180.0
"""Time without a new state after which the demo gives up, s; compiling takes a part of it."""
BACKLOG = 0.5
"""Time without any message of the world after which all of them have been heard, s."""
SLOWEST = 0.3
"""Smallest real-time factor; where time is slower the watchdog takes each period for a stall."""
EXAMPLES = """examples:
  ros2 run socialnav demo
  ros2 run socialnav demo --episodes 20 --scenario crowd20 --model orca --out out/crowd
  ros2 run socialnav demo --real-time
  ros2 run socialnav demo --sensors --out out/demo_sensors
"""


class DemoError(RuntimeError):
    """The demo cannot go on; the text is one line."""


def main() -> None:
    """Run the demo and leave with its exit code."""
    take_signals(signal.default_int_handler)
    options = parse(sys.argv[1:])
    os.environ.update(isolated_environment(os.environ))
    rclpy.init(args=[], signal_handler_options=SignalHandlerOptions.NO)
    try:
        run_demo(options)
    except (DemoError, OSError) as error:
        sys.exit(f'error: {error}')
    except KeyboardInterrupt:
        sys.exit(INTERRUPTED)
    finally:
        rclpy.try_shutdown()


def parse(arguments: list[str]) -> argparse.Namespace:
    """
    Return the options of the command line; leave with exit code 2 where they are wrong.

    :param arguments: without the name of the program.
    """
    parser = argparse.ArgumentParser(
        prog='demo', description=__doc__, epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )  # fmt: skip
    parser.add_argument('--episodes', type=int, default=5, help='number of episodes (default: 5)')
    parser.add_argument('--scenario', default='hard', help='world (default: hard)')
    parser.add_argument('--seed', type=int, default=0, help='seed of the cases (default: 0)')
    parser.add_argument(
        '--model', default=DEFAULT_MODEL,
        help=f'model: name, folder, search, orca or straight_line (default: {DEFAULT_MODEL})',
    )  # fmt: skip
    parser.add_argument(
        '--out', type=Path, default=Path('out/demo'), help='folder to write (default: out/demo)'
    )
    parser.add_argument('--real-time', action='store_true', help='to watch: not in lockstep')
    parser.add_argument(
        '--sensors', action='store_true',
        help='the policy knows only a laser scan and detections of people; in real time',
    )  # fmt: skip
    parser.add_argument(
        '--real-time-factor', type=float, default=1.0, metavar='N',
        help='simulated time per real time, where that counts (default: 1)',
    )  # fmt: skip
    options = parser.parse_args(arguments)
    options.real_time = options.real_time or options.sensors
    if options.episodes < 1 or options.seed < 0:
        parser.error('--episodes must be at least 1 and --seed not negative')
    if not SLOWEST <= options.real_time_factor <= 20:
        parser.error(f'--real-time-factor must lie between {SLOWEST:g} and 20')
    try:
        make_scenario(options.scenario)
    except ValueError as error:
        parser.error(str(error))
    return options


def run_demo(options: argparse.Namespace) -> None:
    """
    Run the episodes, print and write what came of them.

    :raises DemoError: a node died, nothing came for long, or the robot never moved.
    :raises OSError: the folder cannot be written.
    """
    options.out.mkdir(parents=True, exist_ok=True)
    graph = node_parameters(options), os.environ, node_topics(options)
    with open_bag(options.out / 'episodes.mcap') as bag:
        topics = TRUTH if options.sensors else {}
        listener = DemoNode(bag, topics, lockstep=not options.real_time)
        with running_nodes(*graph) as nodes:
            print(f'started: {", ".join(nodes)}; the first time they compile', file=sys.stderr)
            listen(listener, nodes, options.episodes)
    results = listener.results[: options.episodes]
    print(summary(results), flush=True)
    if options.real_time:
        print(listener.punctuality())
    write_json(results, options.out / 'episodes.json')
    if not any(result.path_length for result in results):
        raise DemoError('the robot never moved: nothing was decided')
    write_picture(listener, options)
    names = ('episodes.json', 'episodes.mcap', 'episode.gif')
    print(f'written: {", ".join(str(options.out / name) for name in names)}')


def listen(listener: DemoNode, nodes: Nodes, episodes: int) -> None:
    """
    Print a table of the episodes, each when it ends, until all have.

    :raises DemoError: a node died or cannot be used, or nothing new came for long.
    """
    executor = SingleThreadedExecutor()
    executor.add_node(listener)
    printed = 0
    print(heading(), flush=True)
    while printed < episodes:
        executor.spin_once(timeout_sec=0.1)
        for number, result in enumerate(listener.results[printed:], printed + 1):
            print(row(number, result), flush=True)
        printed = len(listener.results)
        dead = {name: node.poll() for name, node in nodes.items() if node.poll() is not None}
        for name, code in dead.items():
            raise DemoError(f'{name} ended with exit code {code}')
        if listener.problem is not None:
            raise DemoError(f'policy_node: {listener.problem}')
        if time.monotonic() - listener.latest_progress > SILENCE:
            raise DemoError(
                f'no new state for {SILENCE:g} s: run it again when the computer is less busy'
            )
    while time.monotonic() - listener.latest_message < BACKLOG:  # results overtake states
        executor.spin_once(timeout_sec=0.1)
    executor.shutdown()


def write_picture(listener: DemoNode, options: argparse.Namespace) -> None:
    """
    Write a good episode as an animation.

    :raises DemoError: when no episode was recorded.
    """
    # here and not above: these load matplotlib and scipy, which would keep the nodes waiting
    from socialnav_core.viewing.animation import write_gif
    from socialnav_core.viewing.recording import Recording

    episode = listener.recorder.good_episode()
    if episode is None:
        raise DemoError('no state was received')
    result, states = episode
    outcome = cause(states[-1]) if result.outcome == 'collision' else result.outcome
    recording = Recording(
        states, result.scenario, result.seed, result.case_index, outcome, options.model
    )
    write_gif(recording, options.out / 'episode.gif')
