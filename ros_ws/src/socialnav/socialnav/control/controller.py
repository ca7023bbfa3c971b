"""All of the decision: from the newest inputs to a velocity of the robot, or a reason to stand."""

from collections.abc import Callable, Sequence
import dataclasses
import time
from typing import Any

from geometry_msgs.msg import PoseStamped
import numpy as np

from socialnav.control.arrival import Arrival, turning, wanted_heading
from socialnav.control.covering import covering_complaint
from socialnav.control.decisions import Decision, Intention, NO_COMMAND
from socialnav.control.doubts import Doubts
from socialnav.control.extrapolation import extrapolate
from socialnav.control.inputs import Inputs
from socialnav.control.leaps import believed
from socialnav.control.plan import PlanFollower
from socialnav.control.progress import distance, ProgressCheck
from socialnav.control.reasons import ARRIVED, Cause, NO_GOAL, STALLED
from socialnav.control.runs import Run
from socialnav.control.tally import Tally
from socialnav.messages.conversions import ConversionError, crowd_state, FrameError
from socialnav.messages.follow_requests import FollowRequest
from socialnav.messages.frames import Locate, not_asked
from socialnav.messages.grids import grid_discs, with_discs
from socialnav.messages.stamps import header_message
from socialnav.parameters.policy import PolicyParameters
from socialnav_core.policies import Policy
from socialnav_core.simulation.kinematics import kinematics_of
from socialnav_core.states import CrowdState


class Controller:
    """Holds what is known and decides; one caller at a time."""

    def __init__(
        self,
        policy: Policy,
        settings: PolicyParameters,
        steady: Callable[[], float] = time.monotonic,
        locate: Locate = not_asked,
    ) -> None:
        """
        Start without any input.

        :param settings: may be replaced at any time.
        :param steady: a clock that always runs, s.
        """
        self.settings = settings
        self.arrival = Arrival()
        self.state: CrowdState | None = None
        self.tally = Tally()
        self.intention: Intention | None = None
        self.plan = PlanFollower()
        self.progress = ProgressCheck()
        self.doubts = Doubts()
        self._policy = policy
        self._steady = steady
        self._locate = locate
        self._inputs = Inputs(steady)
        self._run = Run()
        self._latency = 0.0
        self._standing_since: float | None = None
        self._latest: Decision | None = None
        self._cause = Cause.CONTROL
        self._turn_rate = 0.0
        self._resting = not settings.goal_topics

    @property
    def goal_reached(self) -> bool:
        """Return whether the run is over."""
        return self.arrival.reached

    def store(self, name: str, message: Any) -> None:
        """
        Take an input.

        :param name: odom, pedestrians, obstacles, goal_pose, plan or map.
        """
        if name == 'goal_pose':
            self._resting = False
        self._inputs.store(name, message, merged=not self.settings.lockstep)

    def hear_of(self, name: str, publishers: Sequence[str]) -> None:
        """
        Take note of who publishes pedestrians or obstacles.

        :param publishers: full names of their nodes.
        """
        self._inputs.hear_of(name, publishers)

    def cancel_goal(self) -> bool:
        """Forget the goal, so that the robot stands; return whether there was one."""
        self.progress.begin()
        return self._inputs.cancel_goal()

    def follow(self, request: FollowRequest, now: int, *, same_goal: bool) -> None:
        """
        Head for the end of a path, along it.

        :param now: ns, on the clock of the stamps.
        :param same_goal: whether only the way to the present goal is another one.
        """
        header = header_message(now, request.end.header.frame_id)
        self.store('plan', dataclasses.replace(request.path, header=header))
        if not same_goal:
            self.store('goal_pose', PoseStamped(header=header, pose=request.end.pose))

    def rest(self) -> None:
        """Be silent until there is another goal: somebody else may command the robot."""
        self._inputs.forget('plan')
        self._resting = True

    def distance_left(self) -> float:
        """Return the way to the goal, along the plan where one is followed, m; 0 if unknown."""
        if self.state is None:
            return 0.0
        straight = distance(self.state.robot.goal[0], self.state.robot.position[0])
        return straight if self.plan.way is None else self.plan.way

    def input_ages(self, now: int) -> dict[str, float]:
        """
        Return how old each input is that has come, s.

        :param now: ns, on the clock of the stamps.
        """
        return self._inputs.ages(now)

    def concerns(self) -> list[str]:
        """Return what is assumed of inputs that do not tell it, and what of them cannot be."""
        odometry, doubts = None, self.doubts.concerns(self._steady())
        if self._latest:
            odometry = self._inputs.newest('odom')
        if odometry is None or odometry.child_frame_id:
            return doubts
        base = self.settings.base_frame
        return [f'odom has no child_frame_id: its twist is taken to be in {base}', *doubts]

    def time_left(self, now: int) -> float:
        """
        Return for how long the inputs that made the robot drive can be acted on, s.

        :param now: ns, on the clock of the stamps.
        """
        return self._inputs.time_left(now, self.settings)

    def attention(self) -> np.ndarray | None:
        """Return how much the policy looked at each agent, (agents,); None where it tells not."""
        if self.intention is None:
            return None
        weights = self._policy.attention(self.intention.state)
        return None if weights is None else weights[0]

    def take_complete_state(self) -> bool:
        """Return whether a whole state of a world in lockstep waits for its decision."""
        return self._inputs.take_complete_state()

    def decide(self, now: int) -> Decision:
        """
        Return what to do; the robot stands where anything is wrong.

        :param now: ns, on the clock of the stamps.
        """
        lockstep = self.settings.lockstep
        stamp = self._inputs.stamp('odom') if lockstep else 0
        if lockstep and self._latest is not None and self._latest.stamp == stamp:
            return self._latest  # the state came again because the answer was lost
        command, reason = self._choose(now)
        published = self._to_be_published(reason)
        concern = None if reason else self.progress.complaint or self.arrival.complaint
        cause = None if reason is None else self._cause
        turn = self._turn_rate if reason is None else 0.0
        self._latest = Decision(command, reason, published, stamp, concern, turn, cause)
        return self._latest

    def stall(self) -> Decision:
        """Return what to do when decide() is not called any more; another thread may ask."""
        return Decision(NO_COMMAND, STALLED, self._to_be_published(STALLED))

    def _choose(self, now: int) -> tuple[np.ndarray, str | None]:
        """Return a command, or a zero one and the reason; an error or a late end is one too."""
        settings, began = self.settings, self._steady()
        self.intention = self.state = None
        self._cause, self._turn_rate = Cause.CONTROL, 0.0
        try:
            command, reason = self._considered(now)
        except ConversionError as error:
            if isinstance(error, FrameError):
                self._cause = Cause.FRAME
            return NO_COMMAND, str(error)
        except Exception as error:  # whatever it is, the robot must not drive on
            if settings.lockstep:
                raise
            return NO_COMMAND, f'the decision failed: {type(error).__name__}: {error}'
        if reason is not None:
            return NO_COMMAND, reason
        elapsed = self._steady() - began
        self._latency = min(elapsed, settings.period)
        self.tally.decisions += 1
        self.tally.decision_time = elapsed
        if not settings.lockstep and elapsed > settings.period:
            self.tally.late += 1
            self.intention = None
            return NO_COMMAND, f'the decision took {elapsed:.2f} s, longer than a period'
        return command, None

    def _considered(self, now: int) -> tuple[np.ndarray, str | None]:
        """Return a command and, where the robot must stand instead, the reason."""
        reason = self._inputs.complaint(now, self.settings)
        if reason is not None:
            self._cause = Cause.NO_GOAL if reason == NO_GOAL else Cause.INPUT
            return NO_COMMAND, reason
        state = self._known_state(now)
        reason = None if self.settings.lockstep else self._doubt()
        if reason is not None:
            self._cause = Cause.INPUT
            return NO_COMMAND, reason
        state = self.state = believed(state)
        heading = wanted_heading(self._inputs.newest('goal_pose'), self.settings, self._locate)
        self.arrival.look(state, heading, self.settings)
        if self.arrival.reached:
            self._cause = Cause.ARRIVED
            return NO_COMMAND, ARRIVED
        reason = None if self.settings.lockstep else covering_complaint(state)
        if reason is not None:
            return NO_COMMAND, reason
        coming = self._coming_state(state, now)
        if self.arrival.at_place and heading is not None:
            command, self._turn_rate = turning(coming, heading, self.settings)
            return command, None
        command, reason = self._drive(self._on_plan(coming, now))
        if reason is None and not self.settings.lockstep:
            self._watch_progress(coming, command)
        if self.progress.stopped:
            self.intention, self._cause = None, Cause.PROGRESS
            return NO_COMMAND, self.progress.complaint
        return command, reason

    def _doubt(self) -> str | None:
        """Compare inputs with what they said before; return why the robot must stand, or None."""
        self.doubts.look_at_people(self._inputs.lists('pedestrians'), self._steady())
        odometry, goal = map(self._inputs.newest, ('odom', 'goal_pose'))
        return self.doubts.reason(odometry, goal, self.settings)

    def _known_state(self, now: int) -> CrowdState:
        """Return the world at the inputs' own times, the nearest agents; begin a run if new."""
        settings, goal = self.settings, self._inputs.newest('goal_pose')
        state = self._read_state()
        moment = self._inputs.stamp('odom') if settings.lockstep else now
        if self._run.begins(goal, moment, 1.5 * settings.period if settings.lockstep else None):
            self.arrival.begin()
            self.progress.aim(state.robot.goal[0], self._steady(), settings)
            self._policy.reset()
        state.time[:] = self._run.time
        return self._with_map(state.nearest(settings.max_agents))

    def _read_state(self) -> CrowdState:
        """Return the world as the inputs tell it, at their own times."""
        settings = self.settings
        odometry, goal = map(self._inputs.newest, ('odom', 'goal_pose'))
        pedestrians, obstacles = map(self._inputs.lists, ('pedestrians', 'obstacles'))
        return crowd_state(
            odometry, goal, pedestrians, obstacles, settings.body, settings.planning_frame,
            locate=self._locate, base_frame=settings.base_frame,
        )  # fmt: skip

    def _with_map(self, state: CrowdState) -> CrowdState:
        """Return the state with what the map shows near the robot, where that is wanted."""
        if not self.settings.use_map:
            return state
        grid, frame = self._inputs.newest('map'), self.settings.planning_frame
        return with_discs(state, *grid_discs(grid, state.robot.position[0], frame, self._locate))

    def _on_plan(self, state: CrowdState, now: int) -> CrowdState:
        """Return the state with the next point of the plan for its goal, where there is a plan."""
        settings = self.settings
        point = self.plan.heading_point(
            self._inputs.newest('plan'),
            state.robot.position[0],
            state.robot.goal[0],
            settings.plan_lookahead_distance,
            settings.planning_frame,
            self._locate,
            self._inputs.plan_complaint(now, settings),
        )
        return state.with_robot(goal=np.asarray(point)[None])

    def _coming_state(self, state: CrowdState, now: int) -> CrowdState:
        """Return the state at the moment when a command that is chosen now takes effect."""
        if self.settings.lockstep:
            return state
        effect = now * 1e-9 + self._latency
        robot, people = (
            effect - self._inputs.stamp(name) * 1e-9 for name in ('odom', 'pedestrians')
        )
        turn_rate = self._inputs.newest('odom').twist.twist.angular.z
        return extrapolate(state, max(robot, 0.0), turn_rate, max(people, 0.0))

    def _watch_progress(self, state: CrowdState, command: np.ndarray) -> None:
        """
        See whether the robot comes nearer to its goal.

        :param state: with the goal itself, batch of one.
        :param command: that the policy chose, in the frame of the robot, (2,).
        """
        settings, robot, plan = self.settings, state.robot, self.plan
        self.progress.look(robot.position[0], robot.goal[0], plan.followed, plan.way, settings)
        speeds = kinematics_of(settings.kinematics).twist(command)[:2]
        self.progress.choose(float(np.hypot(*speeds)), settings)

    def _drive(self, state: CrowdState) -> tuple[np.ndarray, str | None]:
        """Return the command that the policy chooses, within the limits."""
        command = np.asarray(self._policy.act(state, self.settings.limits)[0], dtype=float)
        executable = self._executable(command, state)
        kinematics = kinematics_of(self.settings.kinematics)
        sent = kinematics.to_base(executable, float(state.robot.heading[0]))
        if not np.isfinite([command, sent]).all():
            return NO_COMMAND, f'the policy chose {command.tolist()}, which is no velocity'
        plan = self._policy.plan
        self.intention = Intention(state, executable, None if plan is None else plan[0])
        self.tally.clamped += not np.allclose(executable, command, rtol=0, atol=1e-9)
        return sent, None

    def _executable(self, command: np.ndarray, state: CrowdState) -> np.ndarray:
        """Return a command of the policy within the limits, where it should be already."""
        settings, kinematics = self.settings, kinematics_of(self.settings.kinematics)
        present = kinematics.present_command(state.robot)[0]
        return kinematics.reachable(command, present, settings.limits, settings.period)

    def _to_be_published(self, reason: str | None) -> bool:
        """Return whether a decision is worth a message; count how long the robot has stood."""
        if self._resting:
            return False
        if reason is None:
            self._standing_since = None
            return True
        now, since = self._steady(), self._standing_since  # the watchdog may ask in between
        if since is None:
            self._standing_since = since = now
        timeout = self.settings.stop_publish_timeout
        return timeout == 0 or now - since <= timeout
