"""What operators see of the policy node."""

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue

from socialnav.control.reasons import ARRIVED, DRIVING, GIVEN_UP, NO_GOAL, STALLED
from socialnav.control.tally import Tally
from socialnav.messages.stamps import header_message

ACTIVE = 'active'


def diagnostics_message(
    nanoseconds: int,
    name: str,
    state: str,
    reason: str | None,
    facts: dict[str, str],
    concerns: list[str],
) -> DiagnosticArray:
    """
    Return the health of a node.

    :param reason: why the robot stands, or why the node is not configured; None for no reason.
    :param concerns: what is wrong besides; no fault of a node that is not active.
    """
    told = [reason or (DRIVING if state == ACTIVE else state)]
    level = level_of(state, reason)
    if concerns and state == ACTIVE:
        told += concerns
        level = max(level, DiagnosticStatus.WARN)
    message = '; '.join(told)
    values = {'state': state} | facts
    status = DiagnosticStatus(
        level=level,
        name=name,
        message=message,
        values=[KeyValue(key=key, value=value) for key, value in values.items()],
    )
    return DiagnosticArray(header=header_message(nanoseconds, ''), status=[status])


def level_of(state: str, reason: str | None) -> bytes:
    """Return how bad it is: standing without a goal is no fault, for another reason it is."""
    if reason in (None, ARRIVED, NO_GOAL):
        return DiagnosticStatus.OK
    if state != ACTIVE or reason == STALLED or reason.endswith(GIVEN_UP):
        return DiagnosticStatus.ERROR
    return DiagnosticStatus.WARN


def controller_facts(
    model: str, plan: str, idle: float, ages: dict[str, float], tally: Tally
) -> dict[str, str]:
    """
    Return what is known of a controller, by name.

    :param plan: whether one is followed.
    :param idle: time of driving since the latest progress, s.
    :param ages: of its inputs, s.
    """
    return {
        'model': model,
        'plan': plan,
        'driven without progress [s]': f'{idle:.1f}',
        **{f'age of {name} [s]': f'{age:.2f}' for name, age in ages.items()},
        'decisions': str(tally.decisions),
        'late decisions': str(tally.late),
        'clamped commands': str(tally.clamped),
        'decision time [s]': f'{tally.decision_time:.4f}',
    }


def is_unusable(status: DiagnosticStatus) -> bool:
    """Return whether a node will not drive until somebody changes its parameters."""
    unconfigured = KeyValue(key='state', value='unconfigured') in status.values
    return unconfigured and status.level == DiagnosticStatus.ERROR
