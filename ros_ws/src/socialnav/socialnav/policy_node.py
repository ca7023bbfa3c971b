"""The node that drives a robot, managed: it can be configured, activated and stopped by others."""

import sys

from diagnostic_msgs.msg import DiagnosticArray
from rclpy.clock import Clock, ClockType
from rclpy.lifecycle import LifecycleNode, LifecycleState, TransitionCallbackReturn
from rclpy.parameter import Parameter

from socialnav import qos
from socialnav.control.announcer import Announcer
from socialnav.control.diagnostics import diagnostics_message
from socialnav.control.requirements import requirements, risks
from socialnav.driver import Driver
from socialnav.lifecycle import answer_every_transition
from socialnav.nav2.bond import Bond, bond_of
from socialnav.nav2.interface import ABSENT, is_installed
from socialnav.parameters.declaring import declare, updated
from socialnav.parameters.fields import same_but_live
from socialnav.parameters.policy import PolicyParameters
from socialnav.realtime.memory import set_aside
from socialnav.running import run

SUCCESS, FAILURE = TransitionCallbackReturn.SUCCESS, TransitionCallbackReturn.FAILURE
STEADY = ClockType.STEADY_TIME
ALL_IS_WELL = 'nothing else is wrong any more'
DIAGNOSIS_PERIOD = 1.0
"""Time between two diagnoses, even where no other clock runs, s."""


class PolicyNode(LifecycleNode):
    """Makes a driver when it is configured, lets it drive while it is active."""

    def __init__(self) -> None:
        """
        Read the parameters and, with autostart, begin to drive.

        :raises ParameterError: a parameter that cannot be used.
        """
        super().__init__('policy_node')
        answer_every_transition(self)
        self.driver: Driver | None = None
        self.bond: Bond | None = None
        self.label = 'unconfigured'
        self.problem: str | None = None
        self.alarmist = Announcer(self.get_logger().warning)
        self.health = self.create_publisher(DiagnosticArray, '/diagnostics', qos.DIAGNOSTICS)
        self.create_timer(DIAGNOSIS_PERIOD, self.diagnose, clock=Clock(clock_type=STEADY))
        self.settings = declare(self, PolicyParameters, lambda: self.driving() is not None)
        self.add_post_set_parameters_callback(self.on_parameters)
        if self.settings.autostart and self.trigger_configure() == SUCCESS:
            self.trigger_activate()

    def driving(self) -> Driver | None:
        """Return the driver while it commands the robot."""
        return self.driver if self.driver is not None and self.driver.running else None

    def on_parameters(self, changes: list[Parameter]) -> None:
        """Use what was changed: at once while driving, else from the next activation."""
        self.settings = updated(self.settings, changes)
        if (driver := self.driving()) is not None:
            driver.use(self.settings)

    def prepared(self) -> Driver | None:
        """Return a driver that has its model and listens; say why where that is impossible."""
        try:
            return Driver(self, self.settings, self.diagnose)
        except Exception as error:  # rclpy would swallow it without a word
            kind = '' if isinstance(error, ValueError) else f'{type(error).__name__}: '
            self.problem = f'not configured: {kind}{error}'
            self.get_logger().error(self.problem)
            return None

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Load the model and listen."""
        self.driver = self.prepared()
        if self.driver is None:
            return FAILURE
        self.enter('inactive')
        return super().on_configure(state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Begin to drive, with another model or other frames where they have been changed."""
        driver = self.driver
        if driver is None or not same_but_live(driver.made_for, self.settings):
            self.release()
            driver = self.driver = self.prepared()
        if driver is None:
            return FAILURE
        result = super().on_activate(state)
        set_aside()
        driver.start(self.settings)
        self.bond = bond_of(self, managed=not self.settings.autostart)
        self.enter('active')
        self.announce()
        return result

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Stop the robot, then fall silent."""
        self.part()
        if self.driver is not None:
            self.driver.stop()
        self.enter('inactive')
        return super().on_deactivate(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Forget model and inputs."""
        self.release()
        self.enter('unconfigured')
        return super().on_cleanup(state)

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Stop the robot, if it drives, for good."""
        self.release()
        self.enter('finalized')
        return super().on_shutdown(state)

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Stop the robot after a transition that broke; the node is unconfigured then."""
        self.get_logger().error(f'a transition from {state.label} broke')
        self.release()
        self.enter('unconfigured')
        return super().on_error(state)

    def announce(self) -> None:
        """Say what the robot needs to drive; warn of what it drives without."""
        if self.settings.lockstep:
            return
        logger = self.get_logger()
        logger.info(requirements(self.settings))
        if not is_installed():
            logger.info(ABSENT)
        if (risk := risks(self.settings)) is not None:
            logger.warning(risk)

    def enter(self, label: str) -> None:
        """Remember a state of the life cycle."""
        self.label, self.problem = label, None
        self.diagnose()

    def diagnose(self) -> None:
        """Publish how the node is; log what else is wrong while it drives."""
        driving, driver = self.driving(), self.driver
        reason = self.problem if driving is None else driving.outputs.trouble
        facts = {} if driver is None else driver.facts()
        concerns = [] if driver is None else driver.concerns()
        if driving is not None:
            self.alarmist.tell(
                '; '.join(concerns) or 'nothing else is wrong', aloud=bool(concerns)
            )
            concerns = [one for one in (driving.outputs.concern, *concerns) if one]
        now = self.get_clock().now().nanoseconds
        name = self.get_name()
        self.health.publish(diagnostics_message(now, name, self.label, reason, facts, concerns))

    def part(self) -> None:
        """Give no sign of life any more."""
        if self.bond is not None:
            self.bond.close()
        self.bond = None

    def release(self) -> None:
        """Give up everything that was made at configuration."""
        self.part()
        if self.driver is not None:
            self.driver.close()
        self.driver = None

    def close(self) -> None:
        """Stop the robot: a zero command is the last one."""
        self.release()


def main() -> None:
    """Run the node."""
    sys.exit(run(PolicyNode))
