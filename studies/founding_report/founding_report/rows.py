"""The systems that are trained, each for several seeds."""

import dataclasses
from typing import Any

from socialnav_core.config import Config, read_config

QUICK = {
    'scenario.time_limit': 16.0,
    'training.worlds': 8,
    'training.iterations': 2,
    'training.steps_per_iteration': 8,
    'training.updates_per_iteration': 2,
    'training.batch_size': 32,
    'training.replay_capacity': 2000,
    'training.imitation.episodes': 16,
    'training.imitation.epochs': 1,
}
"""Changes that make a run take seconds; it learns nothing."""

QUICK_EPISODES = {'training.episodes': 10, 'training.updates_per_episode': 1}
"""The same for runs whose length is given in episodes."""


@dataclasses.dataclass(frozen=True)
class Row:
    """A system: how it is trained and where it is tested."""

    name: str
    """Its name, in models/ too when it is shipped."""
    label: str
    """What it is called in tables."""
    config: str
    """Configuration that it starts from."""
    settings: dict[str, Any]
    """Settings that differ from the configuration."""
    tests: tuple[str, ...]
    """Scenarios in which it is tested; the last one decides which seed is shipped."""
    shipped: bool = False
    """Whether its best seed belongs into models/."""
    run: str = ''
    """Row whose runs these are, where they are not its own."""
    unfolded: bool = False
    """Whether the weights are those of training, constant features not folded."""

    @property
    def run_name(self) -> str:
        """Return the name of the folder of runs."""
        return self.run or self.name

    def assignments(self, quick: bool) -> dict[str, Any]:
        """
        Return all settings that differ from the configuration.

        :param quick: whether to train for seconds only.
        """
        settings = {'name': self.run_name} | self.settings
        if not quick:
            return settings
        in_episodes = read_config(self.config, settings).training.episodes
        return settings | QUICK | (QUICK_EPISODES if in_episodes else {})

    def resolved(self, seed: int, quick: bool) -> Config:
        """
        Return the complete configuration of a run.

        :param quick: whether to train for seconds only.
        """
        return read_config(self.config, self.assignments(quick) | {'seed': seed})


RADII = ('1.0', '1.5', '2.0', '2.5')
CURRICULUM = tuple(f'curriculum-{radius}' for radius in RADII)
PACKED = tuple(f'packed-{radius}' for radius in RADII)
REPORTED_TESTS = ('simple', 'hard')

IN_SIMPLE10 = {'scenario': 'simple10', 'training.iterations': 140}
IN_PACKED = {'scenario': 'packed-2.5', 'policy.speeds': 2, 'policy.headings': 8}
WITHOUT_CURRICULUM = {'training.curriculum.enabled': False}
REPORTED_RECIPE = {
    'sarl': 'report_sarl',
    'gat4sn': 'report_gat4sn',
    'sarl_no_curriculum': 'report_sarl_no_curriculum',
}
"""Rows that are also trained by the report's own recipe, and the configurations with it."""


def rows_of_networks() -> list[Row]:
    """Return the networks trained among small obstacles."""
    rows = [Row('sarl', 'SARL', 'sarl', {}, REPORTED_TESTS, True)]
    rows += [
        Row(
            'gat4sn' if heads == 4 else f'gat4sn_{heads}',
            f'GAT4SN, {heads} head{"s" * (heads > 1)}',
            'gat4sn', {'policy.heads': heads}, REPORTED_TESTS, True,
        )
        for heads in (1, 2, 3, 4)
    ]  # fmt: skip
    rows += [
        Row('gat4sn_linear', 'GAT4SN, 4 heads, linear scores', 'gat4sn',
            {'policy.network': 'gat4sn_linear'}, REPORTED_TESTS),
        Row('gat4sn_v2', 'GAT4SN, 4 heads, GATv2 scores', 'gat4sn',
            {'policy.network': 'gat4sn_v2'}, REPORTED_TESTS, True),
    ]  # fmt: skip
    return rows


def in_simple10(row: Row) -> Row:
    """
    Return a row trained with 10 small obstacles and tested among 20 pedestrians.

    :param row: of rows_of_networks.
    """
    return dataclasses.replace(
        row,
        name=f'{row.name}_simple10',
        settings=row.settings | IN_SIMPLE10,
        tests=('crowd20',),
    )


def rows_of_curriculum() -> list[Row]:
    """Return SARL among large obstacles, with and without curricula."""
    return [
        Row('sarl_curriculum', 'SARL with curriculum', 'sarl_curriculum', {}, CURRICULUM, True),
        Row('sarl_no_curriculum', 'SARL without curriculum', 'sarl_curriculum',
            WITHOUT_CURRICULUM, CURRICULUM, True),
        Row('sarl_curriculum_packed', 'SARL with curriculum, packed', 'sarl_curriculum',
            IN_PACKED, PACKED, True),
        Row('sarl_no_curriculum_packed', 'SARL without curriculum, packed', 'sarl_curriculum',
            IN_PACKED | WITHOUT_CURRICULUM, PACKED),
        Row('sarl_baby_step_packed', 'SARL with baby steps, packed', 'sarl_curriculum',
            IN_PACKED | {'training.curriculum.scheduler': 'baby_step'}, PACKED),
        Row('sarl_one_pass_packed', 'SARL with one pass, packed', 'sarl_curriculum',
            IN_PACKED | {'training.curriculum.scheduler': 'one_pass'}, PACKED),
    ]  # fmt: skip


def unfolded(row: Row) -> Row:
    """
    Return a row with the weights of training: it differs where a constant feature does not.

    :param row: of rows_of_networks.
    """
    return dataclasses.replace(
        row,
        name=f'{row.name}_unfolded',
        label=f'{row.label}, as trained',
        tests=('hard',),
        shipped=False,
        run=row.name,
        unfolded=True,
    )


def by_reported_recipe(row: Row) -> Row:
    """
    Return a row trained by the report's own recipe.

    :param row: one of REPORTED_RECIPE.
    """
    return dataclasses.replace(
        row,
        name=f'{row.name}_report_recipe',
        label=f"{row.label}, report's recipe",
        config=REPORTED_RECIPE[row.name],
        settings={},
        shipped=False,
    )


def with_stale_radii(row: Row) -> Row:
    """
    Return a row whose demonstrator has the defect of the report's code.

    :param row: with obstacles of many radii.
    """
    return dataclasses.replace(
        row,
        name=f'{row.name}_stale',
        label=f'{row.label}, stale radii',
        settings=row.settings | {'training.imitation.stale_radii': True},
        shipped=False,
    )


def all_rows() -> dict[str, Row]:
    """Return every row by its name."""
    networks, curriculum = rows_of_networks(), rows_of_curriculum()
    rows = {row.name: row for row in networks + curriculum}
    compared = [rows[name] for name in ('sarl', 'gat4sn', 'gat4sn_linear', 'gat4sn_v2')]
    recipes = [rows[name] for name in REPORTED_RECIPE]
    more = [in_simple10(row) for row in compared[:2]] + [unfolded(row) for row in compared]
    more += [by_reported_recipe(row) for row in recipes]
    more += [with_stale_radii(row) for row in (recipes[-1], more[-1])]
    return rows | {row.name: row for row in more}


ROWS = all_rows()
