"""Every setting, as frozen dataclasses, and the YAML files and names that they come from."""

from socialnav_core.config.bound import BoundConfig
from socialnav_core.config.differential import DifferentialConfig
from socialnav_core.config.documents import read_yaml
from socialnav_core.config.mapping import ConfigError, require, require_choice
from socialnav_core.config.observation import ObservationConfig
from socialnav_core.config.policy import PolicyConfig, ScreeningConfig
from socialnav_core.config.reading import read_config
from socialnav_core.config.scenario import CROWDS, KINEMATICS, OrcaConfig, RewardConfig, Scenario
from socialnav_core.config.scenarios import (
    make_scenario,
    read_scenario,
    resolve_scenario,
    SCENARIOS,
)
from socialnav_core.config.search import SearchConfig
from socialnav_core.config.training import (
    Config,
    CurriculumConfig,
    ImitationConfig,
    TrainingConfig,
)

__all__ = [
    'BoundConfig',
    'CROWDS',
    'Config',
    'ConfigError',
    'CurriculumConfig',
    'DifferentialConfig',
    'ImitationConfig',
    'KINEMATICS',
    'ObservationConfig',
    'OrcaConfig',
    'PolicyConfig',
    'RewardConfig',
    'SCENARIOS',
    'Scenario',
    'ScreeningConfig',
    'SearchConfig',
    'TrainingConfig',
    'make_scenario',
    'read_config',
    'read_scenario',
    'read_yaml',
    'require',
    'require_choice',
    'resolve_scenario',
]
