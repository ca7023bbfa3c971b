"""What the simulator node does with its parameters."""

import dataclasses
from typing import Any

from socialnav.simulator.world_messages import Frames
from socialnav_core.config import Scenario
from socialnav_core.simulation import resolve_scenario

REPEAT_PERIOD = 0.5
"""Time without an answer after which a state in lockstep is published again, s."""


@dataclasses.dataclass(frozen=True)
class SimulatorSettings:
    """Settings of the simulator node; units as in the table of parameters."""

    lockstep: bool
    """Whether the world waits for each command."""
    simulated_time: bool
    """Whether stamps are simulated time; otherwise they are the computer's."""
    publish_clock: bool
    """Whether /clock is published."""
    stamped: bool
    """Whether commands are TwistStamped."""
    timer_period: float
    """Real time between two ticks, s."""
    tick_duration: float
    """Simulated time of a tick, s."""
    command_timeout: float
    """Simulated time without a command after which the robot brakes, s."""
    frames: Frames
    """Names of the frames."""
    kinematics: str
    """How the robot moves."""
    robot_visible: bool
    """Whether pedestrians see the robot."""

    def scenario(self, name: str) -> Scenario:
        """
        Return a world of the kind that is wanted.

        :param name: of the scenario.
        :raises ConfigError: when there is none.
        """
        return resolve_scenario(
            {'name': name, 'kinematics': self.kinematics, 'robot_visible': self.robot_visible}
        )


def simulator_settings(values: dict[str, Any]) -> SimulatorSettings:
    """
    Return the settings that the parameters ask for.

    :param values: all parameters of the simulator node.
    """
    lockstep, tick = values['lockstep'], 1 / values['publish_rate']
    return SimulatorSettings(
        lockstep=lockstep,
        simulated_time=lockstep or values['publish_clock'],
        publish_clock=values['publish_clock'],
        stamped=lockstep or values['enable_stamped_cmd_vel'],
        timer_period=REPEAT_PERIOD if lockstep else tick,
        tick_duration=tick * values['real_time_factor'],
        command_timeout=values['cmd_vel_timeout'],
        frames=Frames(*(values[f'{name}_frame'] for name in ('map', 'odom', 'base'))),
        kinematics=values['kinematics'],
        robot_visible=values['robot_visible'],
    )
