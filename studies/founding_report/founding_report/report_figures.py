"""The figures of the founding report's tables I, II and III."""

import dataclasses

CASES = 500
"""Number of test cases behind a figure of the report: of table III, which names none, assumed."""


@dataclasses.dataclass(frozen=True)
class ReportFigures:
    """What the report says of one system in one world; None where it says nothing."""

    success: float
    collision: float | None = None
    time: float | None = None
    """Mean over successes, s."""


REPORT = {
    ('gat4sn_1', 'simple'): ReportFigures(0.994, 0.002, 11.96),
    ('gat4sn_2', 'simple'): ReportFigures(0.992, 0.000, 12.20),
    ('gat4sn_3', 'simple'): ReportFigures(0.978, 0.002, 12.39),
    ('gat4sn', 'simple'): ReportFigures(0.996, 0.002, 11.61),
    ('sarl', 'simple'): ReportFigures(0.998, 0.000, 11.46),
    ('gat4sn_1', 'hard'): ReportFigures(0.982, 0.014, 12.74),
    ('gat4sn_2', 'hard'): ReportFigures(0.992, 0.004, 13.01),
    ('gat4sn_3', 'hard'): ReportFigures(0.954, 0.010, 15.00),
    ('gat4sn', 'hard'): ReportFigures(0.972, 0.014, 12.75),
    ('sarl', 'hard'): ReportFigures(0.958, 0.018, 12.88),
    ('gat4sn_simple10', 'crowd20'): ReportFigures(0.972, 0.022, 16.989),
    ('sarl_simple10', 'crowd20'): ReportFigures(0.960, 0.040, 13.645),
    ('sarl_curriculum', 'curriculum-1.0'): ReportFigures(0.95),
    ('sarl_curriculum', 'curriculum-1.5'): ReportFigures(0.83),
    ('sarl_curriculum', 'curriculum-2.0'): ReportFigures(0.73),
    ('sarl_curriculum', 'curriculum-2.5'): ReportFigures(0.64),
    ('sarl_no_curriculum', 'curriculum-2.5'): ReportFigures(0.05),
}
"""By the name of the row and the scenario."""

PARAMETERS = {'gat4sn_1': 66051, 'gat4sn_2': 72401, 'gat4sn_3': 78751, 'gat4sn': 85101,
              'sarl': 96502}  # fmt: skip
"""Numbers of parameters in table II."""

SAME_SYSTEM = {
    'gat4sn_linear': 'gat4sn',
    'sarl_unfolded': 'sarl',
    'gat4sn_unfolded': 'gat4sn',
    'gat4sn_linear_unfolded': 'gat4sn',
    'sarl_report_recipe': 'sarl',
    'gat4sn_report_recipe': 'gat4sn',
    'sarl_no_curriculum_report_recipe': 'sarl_no_curriculum',
    'sarl_no_curriculum_stale': 'sarl_no_curriculum',
    'sarl_no_curriculum_report_recipe_stale': 'sarl_no_curriculum',
}
"""Rows that are other forms of what the report measured."""


def reported(row: str, scenario: str) -> ReportFigures | None:
    """Return the report's figures of a row in a scenario, None where it has none."""
    return REPORT.get((SAME_SYSTEM.get(row, row), scenario))
