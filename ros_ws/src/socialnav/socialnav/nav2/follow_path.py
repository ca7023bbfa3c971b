"""The action follow_path, beside the timer that decides: it waits for nothing itself."""

from collections.abc import Callable
import dataclasses
from typing import Any

from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.action.server import ServerGoalHandle
from rclpy.lifecycle import LifecycleNode
from rclpy.task import Future

from socialnav.control.controller import Controller
from socialnav.control.decisions import Decision, NO_COMMAND, speed_of
from socialnav.control.following import (
    Code,
    Following,
    Outcome,
    REACHED,
    refusal,
    REPLACED,
    same_end,
)
from socialnav.messages.follow_requests import FollowRequest
from socialnav.neighbours import others_at

NAME = 'follow_path'
KEPT = 10.0
"""Time for which an outcome can be asked for, s."""
CANCELLED = Outcome(Code.NONE, 'cancelled')
STOPPED = Outcome(Code.UNKNOWN, 'the node was deactivated')


@dataclasses.dataclass(frozen=True)
class Task:
    """A path that somebody waits for."""

    handle: ServerGoalHandle
    """How it is answered."""
    outcome: Future
    """What the answer will be."""
    request: FollowRequest
    """The path."""


class FollowPathServer:
    """Hands paths to the controller, the newest in place of the former, and tells how they end."""

    def __init__(
        self, node: LifecycleNode, kind: Any, controller: Controller,
        stand: Callable[[Decision], None],
    ) -> None:  # fmt: skip
        """
        Offer the action; paths are refused until start().

        :param kind: the action's type, with requests that are FollowRequests.
        :param stand: publishes a decision to stand.
        """
        self.node = node
        self.kind = kind
        self.controller = controller
        self.stand = stand
        self.running = False
        self.task: Task | None = None
        self.following: Following | None = None
        self.outcomes: dict[bytes, Future] = {}
        self.server = ActionServer(
            node, kind, NAME, self.outcome_of, goal_callback=self.on_request,
            handle_accepted_callback=self.on_accepted, cancel_callback=self.on_cancel,
            result_timeout=KEPT,
        )  # fmt: skip

    def on_request(self, _: FollowRequest) -> GoalResponse:
        """Accept a request while the node drives; what is wrong with it becomes its outcome."""
        return GoalResponse.ACCEPT if self.running else GoalResponse.REJECT

    def on_cancel(self, _: ServerGoalHandle) -> CancelResponse:
        """Let the next tick cancel."""
        return CancelResponse.ACCEPT

    def on_accepted(self, handle: ServerGoalHandle) -> None:
        """Follow another path from now on, without a stop in between."""
        former, request = self.task, handle.request
        self.task = Task(handle, Future(executor=self.node.executor), request)
        self.outcomes[bytes(handle.goal_id.uuid)] = self.task.outcome
        handle.execute()
        if former is not None:
            self.answer(former, REPLACED)
        outcome = refusal(request, self.controller.settings)
        if outcome is not None:
            self.end(outcome)
            return
        now = self.node.get_clock().now().nanoseconds
        known = former is not None and same_end(former.request, request)
        self.controller.follow(request, now, same_goal=known)
        if former is None or self.following is None:
            self.following = Following(now)

    def tick(self, decision: Decision, now: int) -> None:
        """
        Tell how far the robot has come after a decision, and whether that was the last one.

        :param now: ns.
        """
        if self.task is None or self.following is None:
            return
        if self.task.handle.is_cancel_requested:
            self.end(CANCELLED)
            return
        controller = self.controller
        outcome = self.following.look(decision, controller.state, now, controller.settings)
        if outcome is None:
            speed = speed_of(decision, controller.settings.kinematics)
            left = controller.distance_left()
            feedback = self.kind.Feedback(speed=speed, distance_to_goal=left)
            self.task.handle.publish_feedback(feedback)
        else:
            self.end(outcome)

    def end(self, outcome: Outcome) -> None:
        """Answer the one who waits; the robot stands, and others may command it."""
        task, self.task, self.following = self.task, None, None
        if task is None:
            return
        self.controller.rest()
        if outcome != REACHED:
            self.controller.cancel_goal()
            self.stand(Decision(NO_COMMAND, f'{NAME}: {outcome.text}'))
        logger, text = self.node.get_logger(), f'{NAME}: {outcome.text or "goal reached"}'
        if outcome.code == Code.NONE:
            logger.info(text)
        else:
            logger.error(text)
        self.answer(task, outcome)

    def answer(self, task: Task, outcome: Outcome) -> None:
        """Tell an outcome to whoever waits for it."""
        if task.handle.is_cancel_requested:
            task.handle.canceled()
        elif outcome == REACHED:
            task.handle.succeed()
        else:
            task.handle.abort()
        result = self.kind.Result(error_code=int(outcome.code))
        if hasattr(result, 'error_msg'):  # from Kilted on
            result.error_msg = outcome.text
        task.outcome.set_result(result)

    async def outcome_of(self, handle: ServerGoalHandle) -> Any:
        """Return the outcome of a path once it is known; rclpy sends it."""
        return await self.outcomes.pop(bytes(handle.goal_id.uuid))

    def rivals(self) -> list[str]:
        """Return the other nodes that offer the action."""
        topic = self.node.resolve_topic_name(f'{NAME}/_action/feedback')
        return others_at(self.node, topic)

    def start(self) -> None:
        """Accept paths."""
        self.running = True

    def stop(self) -> None:
        """End what is being followed, and refuse what comes."""
        self.running = False
        self.end(STOPPED)

    def close(self) -> None:
        """Give up the action."""
        self.stop()
        self.server.destroy()
