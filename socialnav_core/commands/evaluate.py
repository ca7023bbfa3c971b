"""`socialnav evaluate`: how good a policy is."""

import argparse
import dataclasses
from pathlib import Path
from typing import Any, TYPE_CHECKING

from socialnav_core.commands.arguments import (
    add_command,
    add_overwrite_option,
    add_world_options,
    EPISODES,
    MODEL_HELP,
    whole_number,
)
from socialnav_core.commands.choices import (
    chosen_observation,
    chosen_overrides,
    chosen_scenario,
    open_policy,
    suited_to_policy,
    use_threads,
)
from socialnav_core.commands.files import require_new, require_own, write_json
from socialnav_core.config import ConfigError, Scenario
from socialnav_core.config.mapping import parse_assignments

if TYPE_CHECKING:  # torch takes a second, which --help need not
    from socialnav_core.policies import Policy, PolicyDescription
    from socialnav_core.policies.search.checkpoint import Planner
    from socialnav_core.policies.value.checkpoint import Checkpoint

FORESEEN = 'foreseen_intrusion_rate'
"""A metric that is measured only where it is asked for: it looks ahead in every step."""

EXAMPLES = """orca --scenario hard --safety-space 0.15
sarl --scenario crowd20 --episodes 5000 --json out/crowd20.json
models/sarl --scenario hard --metrics spl mean_jerk
search --scenario hard --bound
models/sarl --scenario hard --set scenario.time_limit=35 policy.headings=16
search --scenario crowd20 --set observation.position_noise=0.05 observation.missed=0.1
out/sarl --scenario simple --lookahead oracle --no-screening --card"""


def add_parser(commands: Any) -> None:
    """Add the command."""
    summary = 'Run a policy on unseen cases, each once, and print what came of it.'
    parser = add_command(commands, 'evaluate', run, summary, EXAMPLES)
    parser.add_argument('model', metavar='MODEL', help=MODEL_HELP)
    add_world_options(parser)
    add_episodes_option(parser)
    add_metrics_option(parser)
    add_bound_option(parser)
    parser.add_argument('--json', type=Path, metavar='FILE', help='write all figures and cases')
    parser.add_argument(
        '--card', action='store_true', help="add the result to the model's metrics and card"
    )
    add_overwrite_option(parser)


def add_episodes_option(parser: argparse.ArgumentParser) -> None:
    """Add `--episodes`."""
    parser.add_argument(
        '--episodes', type=whole_number(*EPISODES), default=500, metavar='N', help='cases (500)'
    )


def add_metrics_option(parser: argparse.ArgumentParser) -> None:
    """Add `--metrics`."""
    parser.add_argument(
        '--metrics', nargs='+', default=[], metavar='NAME', dest='further',
        help='measure these too, or all; see socialnav metrics',
    )  # fmt: skip


def add_bound_option(parser: argparse.ArgumentParser) -> None:
    """Add `--bound`."""
    parser.add_argument(
        '--bound', action='store_true',
        help='measure against the fastest path of a robot that knows the future (docs/bound.md)',
    )  # fmt: skip


def require_metrics(given: argparse.Namespace) -> None:
    """
    Note which metrics are wanted besides those that are always shown.

    :raises ConfigError: for a name that no metric has.
    """
    from socialnav_core.metrics import BOUND_METRICS, chosen

    chosen(given.further)
    if given.bound:
        given.further = [*given.further, *BOUND_METRICS]


def run(given: argparse.Namespace) -> None:
    """Run the command."""
    from socialnav_core.evaluation.report import evaluation_text

    require_metrics(given)
    require_new(given.json, given)
    scenario = chosen_scenario(given)
    card = open_card(given) if given.card else None
    policy = card.policy(given) if card else open_policy(given.model, given)
    scenario = suited_to_policy(scenario, policy, given)
    if card and not given.overwrite:
        card.require_no_better(policy.description, scenario, given)
    result = measure(given.model, policy, scenario, given)
    print(evaluation_text(result, given.further))
    values = described(result, given)
    write_json(given.json, values)
    if card:
        card.add(values)


def measure(model: str, policy: 'Policy', scenario: Scenario, given: argparse.Namespace) -> Any:
    """Return the result of a policy."""
    from socialnav_core.evaluation import evaluate, with_bounds
    from socialnav_core.metrics import EVERY

    result = evaluate(
        policy, scenario, given.episodes, given.seed, given.split, name=model, progress=True,
        foresight=bool({FORESEEN, EVERY} & set(given.further)),
        observation=chosen_observation(given),
    )  # fmt: skip
    return with_bounds(result, scenario, progress=True) if given.bound else result


def described(result: Any, given: argparse.Namespace) -> dict[str, Any]:
    """Return a result as plain values, with the settings that were changed."""
    values = result.to_mapping(given.further)
    cases = values.pop('cases')
    values['settings'] = parse_assignments(given.assignments) | dict(result.policy.settings)
    return values | {'cases': cases}


@dataclasses.dataclass(frozen=True)
class Card:
    """The model card that a result is for, and the checkpoint, which is read once."""

    folder: Path
    """Of the checkpoint."""
    checkpoint: 'Checkpoint | Planner'
    """What it holds."""

    def policy(self, given: argparse.Namespace) -> 'Policy':
        """Return the policy of the checkpoint as it was asked for."""
        from socialnav_core.policies.loading import policy_of

        return policy_of(given.model, self.checkpoint, chosen_overrides(given))

    def require_no_better(
        self, policy: 'PolicyDescription', scenario: Scenario, given: argparse.Namespace
    ) -> None:
        """Raise a ConfigError when the card has a better result of the same kind."""
        from socialnav_core.training.model_card import require_no_better

        planned = {
            'scenario': scenario.name, 'lookahead': policy.prediction,
            'screening': policy.screening, 'split': given.split, 'episodes': given.episodes,
        }  # fmt: skip
        require_no_better(self.folder, self.checkpoint.config, planned)

    def add(self, values: dict[str, Any]) -> None:
        """Add a result to the metrics and write the card anew."""
        from socialnav_core.training import add_result, write_card

        add_result(self.folder, self.checkpoint.config, values)
        write_card(self.folder, self.checkpoint)


def open_card(given: argparse.Namespace) -> Card:
    """
    Return the card of the model that was asked for.

    :raises CheckpointError: when the model is damaged.
    :raises ConfigError: when there is no such model, or the result is not one of it as it is.
    """
    from socialnav_core.policies.loading import find_model, read_model, WITHOUT_NETWORK

    if given.model in WITHOUT_NETWORK:
        raise ConfigError(f'{given.model} has no model card: drop --card')
    if given.assignments:
        raise ConfigError('a card holds results of unchanged settings: drop --set or --card')
    use_threads(given)
    folder = find_model(given.model)
    require_own(folder)
    return Card(folder, read_model(folder))
