"""From the name of a model to a policy that is ready to decide."""

import os
from pathlib import Path
import re
from typing import Any

from ament_index_python.packages import get_package_share_directory
import numpy as np
import torch

from socialnav.messages.conversions import RobotBody
from socialnav.parameters import AUTO, DEFAULT_MODEL
from socialnav.parameters.policy import PolicyParameters
from socialnav_core.config import ConfigError
from socialnav_core.policies import load_policy, Policy
from socialnav_core.policies.loading import has_setting, is_model, suited, WITHOUT_NETWORK
from socialnav_core.states import Agents, CrowdState, Robot
from socialnav_core.threads import set_threads

NAME = re.compile(r'\w[\w.-]*')
"""What a name of a model looks like; anything else is a path."""
DEFAULTS = {'holonomic': DEFAULT_MODEL, 'differential': f'{DEFAULT_MODEL}_diff_drive'}
"""Model that drives a base where none is named, by kinematics."""
REVERSE = 'differential.reverse'
"""Setting of the models that know how to drive backwards."""
SCREENING = {'checkpoint': None, 'enabled': True, 'disabled': False}


def ready_policy(settings: PolicyParameters) -> Policy:
    """
    Return a policy that has decided once, so that its first real decision is not a slow one.

    :raises ValueError: no such model, a damaged one, or one for another kind of robot.
    """
    torch.set_num_threads(settings.threads)
    set_threads(settings.threads)
    name = named_model(settings)
    model, overrides = installed(name), chosen_overrides(settings)
    policy = load_policy(model, **overrides)
    if policy.description.knowledge == 'oracle':  # which exists in simulation only
        policy = load_policy(model, **(overrides | {'lookahead': 'constant_velocity'}))
    kinematics = policy.description.kinematics
    if kinematics != settings.kinematics:
        raise ConfigError(
            f'model {name} drives a {kinematics} robot, not a '
            f'{settings.kinematics} one: change the parameter kinematics or the model'
        )
    policy.act(example_state(settings.body), settings.limits)
    policy.reset()
    return policy


def named_model(settings: PolicyParameters) -> str:
    """Return the model that is asked for, the one for the base where none is named."""
    return DEFAULTS[settings.kinematics] if settings.model == AUTO else settings.model


def chosen_overrides(settings: PolicyParameters) -> dict[str, Any]:
    """Return the settings of a policy that the parameters of the policy node change, by name."""
    name = named_model(settings)
    asked = {} if settings.lookahead == 'checkpoint' else {'lookahead': settings.lookahead}
    return (
        suited(name, settings.kinematics)
        | chosen_reverse(name, settings)
        | asked
        | {
            'screening': SCREENING[settings.screening],
            'screening.horizon': settings.screening_horizon or None,
            'device': None if settings.device == 'cpu' else settings.device,
        }
    )


def chosen_reverse(name: str, settings: PolicyParameters) -> dict[str, float]:
    """
    Return how fast a model may drive backwards, nothing where neither base nor model can.

    :param name: of the model.
    """
    known = settings.reverse > 0.0 or has_setting(installed(name), REVERSE)
    return {REVERSE: settings.reverse} if known and settings.kinematics == 'differential' else {}


def installed(model: str) -> str:
    """
    Return the folder of a model of this package, or the path or baseline that was given.

    :param model: a name is looked up in the share folder and cannot lead out of it; a path stays.
    :raises ConfigError: a name that nothing has; tells those that there are.
    """
    if model in WITHOUT_NETWORK or not NAME.fullmatch(model):
        return model
    models = Path(get_package_share_directory('socialnav')) / 'models'
    for folder in (models / model, model):
        if os.path.isdir(folder):  # no error for what cannot be a path
            return str(folder)
    known = sorted(path.name for path in models.glob('*') if is_model(path))
    raise ConfigError(
        f'no model {model!r}: give the folder of a checkpoint or '
        f'{", ".join([*WITHOUT_NETWORK, *known])}'
    )


def example_state(body: RobotBody) -> CrowdState:
    """Return a robot with a pedestrian and an obstacle near by, batch of one."""
    return CrowdState(
        Robot(
            position=np.zeros((1, 2)),
            velocity=np.zeros((1, 2)),
            heading=np.zeros(1),
            radius=np.array([body.radius]),
            preferred_speed=np.array([body.preferred_speed]),
            goal=np.array([[4.0, 0.0]]),
        ),
        Agents(
            position=np.array([[[2.0, 1.0], [2.0, -1.0]]]),
            velocity=np.array([[[-1.0, 0.0], [0.0, 0.0]]]),
            radius=np.full((1, 2), 0.3),
            static=np.array([[False, True]]),
            valid=np.ones((1, 2), dtype=bool),
        ),
        bounds=np.array([body.bounds]),
        time=np.zeros(1),
    )
