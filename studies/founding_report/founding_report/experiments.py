"""The tables and figures: which systems are trained how often, and where they are tested."""

from collections.abc import Iterator
import dataclasses

from founding_report.laboratory import Laboratory, Request
from founding_report.measurements import Cases, LOOKAHEADS
from founding_report.rows import Row, ROWS

COLUMNS, LINES, FREEZING, ATTENTION = 'columns', 'lines', 'freezing', 'attention'
FIGURES = (FREEZING, ATTENTION)

HEADS = ('gat4sn_1', 'gat4sn_2', 'gat4sn_3', 'gat4sn')
SCORES = ('gat4sn', 'gat4sn_linear', 'gat4sn_v2')
LARGE_OBSTACLES = ('hard', 'packed-2.5')


@dataclasses.dataclass(frozen=True)
class Entry:
    """A row of a table."""

    row: Row
    seeds: int
    """How many training seeds it has: 0 to seeds - 1."""
    tests: tuple[str, ...] = ()
    """Scenarios in which it is tested, where they are not those of the row."""

    def cases(self, laboratory: Laboratory) -> tuple[Cases, ...]:
        """Return the cases that the row is tested in."""
        return tuple(
            Cases(scenario, lookahead, episodes=laboratory.episodes, unfolded=self.row.unfolded)
            for scenario in self.tests or self.row.tests
            for lookahead in LOOKAHEADS
        )

    def requests(self, laboratory: Laboratory) -> Iterator[Request]:
        """Yield what must be trained and measured."""
        for seed in range(self.seeds):
            yield Request(self.row, seed, self.cases(laboratory))


@dataclasses.dataclass(frozen=True)
class Experiment:
    """A table or figure and everything behind it."""

    name: str
    title: str
    question: str
    """What it is about, one paragraph."""
    entries: tuple[Entry, ...]
    layout: str
    """columns or lines: of a table; freezing or attention: a figure."""
    pairs: tuple[tuple[str, str], ...] = ()
    """Rows that are compared, the second one subtracted from the first."""
    new: str = ''
    """What the report does not have."""
    deviations: str = ''
    """What is done otherwise than in the report, and why."""

    def with_seeds(self, seeds: int | None) -> 'Experiment':
        """
        Return the experiment with another number of training seeds.

        :param seeds: for every row; None for its own.
        """
        if seeds is None:
            return self
        entries = tuple(dataclasses.replace(entry, seeds=seeds) for entry in self.entries)
        return dataclasses.replace(self, entries=entries)

    def requests(self, laboratory: Laboratory) -> list[Request]:
        """Return what must be trained and measured."""
        return [request for entry in self.entries for request in entry.requests(laboratory)]


def entries(seeds: int, *names: str, tests: tuple[str, ...] = ()) -> tuple[Entry, ...]:
    """
    Return rows of a table or figure, each with so many training seeds.

    :param tests: scenarios in which they are tested, where they are not those of the rows.
    """
    return tuple(Entry(ROWS[name], seeds, tests) for name in names)


RECIPE = (
    'The networks are trained by the recipe of docs/training.md (1,500 ORCA demonstrations, '
    'Q(lambda) targets, Adam, 6 replays of a sample, 128 worlds side by side) in place of the '
    "report's (3,000 demonstrations, frozen one-step targets, SGD, about 280 replays, one world) "
    "and for fewer episodes than the report's 10,000 or, among large obstacles, 25,000 (column "
    '"Episodes each" of the training table): it takes minutes instead of hours, so that there are '
    'several training seeds. Features that never varied in training are folded into the biases '
    'when it is over, which the report did not do (docs/training.md).'
)
COLLISION_TEST = (
    "The defects of the report's code are mended (docs/simulation.md): collisions are judged by "
    'the velocities that people really take, and a time-out masks no success.'
)
CONSTANT_VELOCITY = (
    "Constant-velocity look-ahead beside the oracle: the report's policy was told by the "
    'simulator where people will be after each action, which no robot knows.'
)
SEVERAL_SEEDS = 'Several training seeds, intervals, paired tests on the same cases.'

AS_TRAINED = (
    'All obstacles of `simple` have one radius, so nothing is learned of the weights on it, which '
    'stay random; "as trained" keeps them, as the report did, all other rows fold them into the '
    'biases (docs/training.md): the same networks, which differ only where radii do.'
)

TABLE1 = Experiment(
    'table1',
    'Table I: SARL with and without curriculum',
    'SARL with obstacles that grow while it learns (Algorithm 1) and SARL trained among the '
    'largest obstacles from the start, tested at growing obstacle radii. `curriculum-R` is the '
    'world of the report (walls at 10 m, 81 actions), `packed-R` has the same agents within '
    'walls at 7.5 m (17 actions).',
    entries(3, 'sarl_curriculum', 'sarl_no_curriculum', 'sarl_curriculum_packed',
            'sarl_no_curriculum_packed'),
    LINES,
    (('sarl_curriculum', 'sarl_no_curriculum'),
     ('sarl_curriculum_packed', 'sarl_no_curriculum_packed')),
    f'{CONSTANT_VELOCITY} {SEVERAL_SEEDS} SARL without curriculum at all radii; the packed world.',
    f'{RECIPE} {COLLISION_TEST}',
)  # fmt: skip

TABLE2 = Experiment(
    'table2',
    'Table II: SARL and GAT4SN, trained among small obstacles',
    'All networks are trained on `simple` (5 pedestrians, 5 obstacles of radius 0.3 m, 17 '
    'actions) and tested there and on `hard` (obstacle radii of 0.5 to 1.5 m).',
    (*entries(3, *HEADS[:3]), *entries(10, 'gat4sn', 'sarl')),
    COLUMNS,
    (*((name, 'sarl') for name in HEADS), *((name, 'gat4sn') for name in HEADS[:3])),
    f'{CONSTANT_VELOCITY} {SEVERAL_SEEDS}',
    f'{RECIPE} {COLLISION_TEST}',
)

TABLE3 = Experiment(
    'table3',
    'Table III: 20 pedestrians',
    'SARL and GAT4SN with 4 heads are trained on `simple10` (5 pedestrians, 10 obstacles of '
    'radius 0.3 m) and tested among 20 pedestrians (`crowd20`).',
    entries(3, 'gat4sn_simple10', 'sarl_simple10'),
    LINES,
    (('gat4sn_simple10', 'sarl_simple10'),),
    f'{CONSTANT_VELOCITY} {SEVERAL_SEEDS}',
    f'{RECIPE} {COLLISION_TEST} The report does not say how many cases are behind its Table III; '
    'the 500 of its Table II are taken for its intervals.',
)

RECIPES = Experiment(
    'recipes',
    "The report's recipe and ours",
    "The report's own recipe (3,000 demonstrations, then 5,000 episodes of value learning with "
    'SGD, frozen one-step targets and many replays; time-outs are not stored), collected in '
    'batches, beside the recipe of docs/training.md, for three systems of the report.',
    (*entries(1, 'sarl_report_recipe'), *entries(3, 'sarl'),
     *entries(1, 'gat4sn_report_recipe'), *entries(3, 'gat4sn'),
     *entries(1, 'sarl_no_curriculum_report_recipe'), *entries(3, 'sarl_no_curriculum'),
     *entries(1, 'sarl_no_curriculum_report_recipe_stale'),
     *entries(3, 'sarl_no_curriculum_stale')),
    LINES,
    (*((f'{name}_report_recipe', name) for name in ('sarl', 'gat4sn', 'sarl_no_curriculum')),
     ('sarl_no_curriculum_stale', 'sarl_no_curriculum'),
     ('sarl_no_curriculum_report_recipe_stale', 'sarl_no_curriculum_report_recipe')),
    f"{CONSTANT_VELOCITY} The report's demonstrator on purpose: its planner kept the radii of the "
    'first episode.',
    "One training seed of the report's recipe, as in the report; it has 10,000 episodes (25,000 "
    'among large obstacles), half of them or fewer are run here. Features that never varied in '
    f'training are folded into the biases in all rows (docs/training.md). {COLLISION_TEST}',
)  # fmt: skip

ATTENTION_SCORES = Experiment(
    'attention',
    'Is GAT4SN better than SARL?',
    "SARL beside GAT4SN with 4 heads and three scores of attention: the report's equation 2, "
    "the report's code (linear: no LeakyReLU, so that the robot cancels in the softmax) and "
    'GATv2 (the ranking of agents may depend on the robot). All have the same training budget; '
    f'every difference is measured on the same cases. {AS_TRAINED}',
    (*entries(10, 'sarl', 'gat4sn', 'sarl_unfolded', 'gat4sn_unfolded'),
     *entries(3, *SCORES[1:], *(f'{name}_unfolded' for name in SCORES[1:]))),
    LINES,
    (*((name, 'sarl') for name in SCORES),
     *(('gat4sn', name) for name in SCORES[1:]),
     *((f'{name}_unfolded', 'sarl_unfolded') for name in SCORES),
     *((name, f'{name}_unfolded') for name in ('sarl', *SCORES))),
    f'{CONSTANT_VELOCITY} {SEVERAL_SEEDS} The linear and GATv2 scores. What folding does.',
    f'{RECIPE} {COLLISION_TEST}',
)  # fmt: skip

SCHEDULERS = Experiment(
    'schedulers',
    'Curriculum schedulers',
    'The report argues for its smooth scheduler (every world has some obstacles of the present '
    "level's radius, the others are smaller) against baby steps (all levels so far, one for "
    'each episode) and one pass (the present level alone). Here they have the same budget in the '
    'packed world, beside training without any curriculum.',
    entries(3, 'sarl_curriculum_packed', 'sarl_baby_step_packed', 'sarl_one_pass_packed',
            'sarl_no_curriculum_packed'),
    LINES,
    tuple(('sarl_curriculum_packed', name) for name in
          ('sarl_baby_step_packed', 'sarl_one_pass_packed', 'sarl_no_curriculum_packed')),
    'The comparison itself: the report cites it from Bengio et al. (2009).',
    f'{RECIPE} The world is the packed one with 17 actions. It has no room for ten obstacles of '
    'the last levels, so baby steps and one pass let them begin at 0.5 m (docs/training.md).',
)  # fmt: skip

FIGURE1 = Experiment(
    'figure1',
    'Figure 1: the freezing robot',
    'SARL, trained among small obstacles (`simple`), stands still near a large obstacle until '
    'its time is up.',
    entries(3, 'sarl_unfolded', tests=LARGE_OBSTACLES),
    FREEZING,
)

FIGURE4 = Experiment(
    'figure4',
    'Figure 4: GAT4SN and SARL in the same case',
    'A case in which GAT4SN with 4 heads reaches the goal and SARL, trained with the same '
    'seed, stands still until its time is up.',
    entries(3, 'gat4sn_unfolded', 'sarl_unfolded', tests=LARGE_OBSTACLES),
    ATTENTION,
)

EXPERIMENTS = {
    experiment.name: experiment
    for experiment in (TABLE1, TABLE2, TABLE3, FIGURE1, FIGURE4, RECIPES, ATTENTION_SCORES,
                       SCHEDULERS)
}  # fmt: skip
