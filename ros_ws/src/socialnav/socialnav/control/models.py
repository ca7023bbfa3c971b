"""From the name of a model to a policy that is ready to decide."""

import dataclasses
import os
from pathlib import Path
import re
from typing import Any

from ament_index_python.packages import get_package_share_directory
import numpy as np
import torch

from socialnav.control.settings import ControllerSettings
from socialnav.messages.conversions import RobotBody
from socialnav_core.config import ConfigError
from socialnav_core.policies import load_policy, Policy, ValuePolicy
from socialnav_core.states import Agents, CrowdState, Robot
from socialnav_core.threads import set_threads

BASELINES = ('orca', 'straight_line')
"""Policies that are no models: nothing is looked up for them."""
NAME = re.compile(r'\w[\w.-]*')
"""What a name of a model looks like; anything else is a path."""
SCREENING = {'checkpoint': None, 'enabled': True, 'disabled': False}


def ready_policy(values: dict[str, Any], settings: ControllerSettings) -> Policy:
    """
    Return a policy that has decided once, so that its first real decision is not a slow one.

    :param values: all parameters of the policy node.
    :param settings: what the robot is like.
    :raises ValueError: no such model, a damaged one, or one for another kind of robot.
    """
    torch.set_num_threads(values['threads'])
    set_threads(values['threads'])
    policy = load_policy(
        installed(values['model']),
        lookahead=None if values['model'] in BASELINES else 'constant_velocity',
        screening=SCREENING[values['screening']],
    )
    if policy.kinematics != settings.kinematics:
        raise ConfigError(
            f'model {values["model"]} drives a {policy.kinematics} robot, not a '
            f'{settings.kinematics} one: change the parameter kinematics or the model'
        )
    equip(policy, values)
    policy.act(example_state(settings.body))
    policy.reset()
    return policy


def equip(policy: Policy, values: dict[str, Any]) -> None:
    """
    Give a policy the screening horizon and the device that are asked for.

    :param policy: has just been loaded.
    :param values: all parameters of the policy node.
    :raises ConfigError: a policy without a network is asked for either, or there is no GPU.
    """
    horizon, on_gpu = values['screening_horizon'], values['device'] == 'cuda'
    if not isinstance(policy, ValuePolicy):
        if horizon or on_gpu:
            raise ConfigError(
                f'{values["model"]} has no network: leave screening_horizon at 0 and device at cpu'
            )
        return
    if on_gpu and not torch.cuda.is_available():
        raise ConfigError('device cuda needs a CUDA GPU and a CUDA build of torch; use cpu')
    policy.network.to(values['device'])
    if horizon:
        screening = dataclasses.replace(policy.config.screening, horizon=horizon)
        policy.config = dataclasses.replace(policy.config, screening=screening)


def installed(model: str) -> str:
    """
    Return the folder of a model of this package, or the path or baseline that was given.

    :param model: a name is looked up in the share folder and cannot lead out of it; a path stays.
    :raises ConfigError: a name that nothing has; tells those that there are.
    """
    if model in BASELINES or not NAME.fullmatch(model):
        return model
    models = Path(get_package_share_directory('socialnav')) / 'models'
    for folder in (models / model, model):
        if os.path.isdir(folder):  # no error for what cannot be a path
            return str(folder)
    known = sorted(path.name for path in models.glob('*')) if models.is_dir() else []
    raise ConfigError(
        f'no model {model!r}: give the folder of a checkpoint or {", ".join([*BASELINES, *known])}'
    )


def example_state(body: RobotBody) -> CrowdState:
    """
    Return a robot with a pedestrian and an obstacle near by, batch of one.

    :param body: of the robot.
    """
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
