"""A node under fire: hostile messages, parameters and transitions, and what it must still do."""

import dataclasses
import os
from pathlib import Path
import time
from typing import Any

from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetState
import numpy as np
from rcl_interfaces.srv import GetParameters, SetParameters
from rclpy.parameter import Parameter

from helpers.cores import added, RAN, shares, WAITED
from helpers.graph import Graph, UNSEEN_MATCH
from helpers.hostile import Hostile
from socialnav.parameters.fields import Entry

LIFETIME = 3600.0
"""Time after which a node under fire ends whatever became of the test, s."""
PATIENCE = 10.0
"""Time after which a service counts as one that never answers, s."""


@dataclasses.dataclass
class Figures:
    """What was measured under fire."""

    messages: int = 0
    """Messages that were sent."""
    calls: int = 0
    """Requests that were answered."""
    longest: dict[str, float] = dataclasses.field(default_factory=dict)
    """Longest time from a request to its answer, by service, s."""
    recoveries: list[float] = dataclasses.field(default_factory=list)
    """Times from good inputs to motion, s."""
    answers: list[float] = dataclasses.field(default_factory=list)
    """Times from a request to its answer, s."""
    own: list[float] = dataclasses.field(default_factory=list)
    """The same without the times in which node or test waited for a core, s."""
    busy: list[float] = dataclasses.field(default_factory=list)
    """Times for which the node's own thread ran until the answer, s."""
    stops: list[float] = dataclasses.field(default_factory=list)
    """Times from an input that is bad to standstill, s."""
    memory: list[float] = dataclasses.field(default_factory=list)
    """Memory of the node after each round, MB."""
    fastest: float = 0.0
    """Fastest command, or motion, m/s."""

    def text(self) -> str:
        """Return all of it as lines."""
        return '\n'.join([
            f'{self.messages} messages, {self.calls} requests, {len(self.recoveries)} rounds',
            f'fastest: {self.fastest:.3f} m/s',
            *(
                f'{name}: median {np.median(times):.2f} s, 99 % {np.percentile(times, 99):.2f} s, '
                f'longest {max(times):.2f} s'
                for name, times in (
                    ('answer', self.answers), ('without waits for a core', self.own),
                    ("the node's thread ran", self.busy),
                    ('motion after good inputs', self.recoveries),
                    ('standstill after a bad input', self.stops),
                )
                if times
            ),
            'longest answers: '
            + ', '.join(f'{name} {time:.2f} s' for name, time in self.longest.items()),
            'memory: ' + ' '.join(f'{one:.0f}' for one in thinned(self.memory)) + ' MB',
        ])  # fmt: skip


class Target:
    """A node, its services, and how long they take."""

    def __init__(self, graph: Graph, name: str, services: dict[str, type]) -> None:
        """
        Wait until a node that was started has all of its services.

        :param services: by name within the node, besides those of every node.
        """
        self.graph, self.name, self.figures = graph, name, Figures()
        everybody = {'set_parameters': SetParameters, 'get_parameters': GetParameters}
        self.clients = {
            one: graph.node.create_client(kind, f'{name}/{one}')
            for one, kind in (everybody | services).items()
        }
        for one, client in self.clients.items():
            graph.wait(client.service_is_ready, f'service {one}')
        graph.spin(3 * UNSEEN_MATCH)
        self.pid = self._pid()

    def call(self, service: str, request: Any) -> Any:
        """Call a service; return its answer, and note how long that took."""
        began, before = time.monotonic(), shares(self.pid, os.getpid())
        future = self.clients[service].call_async(request)
        self.graph.wait(future.done, f'answer of {service} to {request}'[:300], PATIENCE)
        duration = time.monotonic() - began
        self.figures.answers.append(duration)
        after = shares(self.pid, os.getpid())
        self.figures.own.append(max(0.0, duration - added(before, after, WAITED)))
        self.figures.busy.append(added(before, after, RAN, self.pid))
        self.figures.longest[service] = max(self.figures.longest.get(service, 0.0), duration)
        self.figures.calls += 1
        return future.result()

    def state(self) -> str:
        """Return the state of a managed node."""
        return self.call('get_state', GetState.Request()).current_state.label

    def change_state(self, **transition: Any) -> bool:
        """Ask for a transition by id or label; return whether it was made."""
        request = ChangeState.Request(transition=Transition(**transition))
        return self.call('change_state', request).success

    def set_parameters(self, values: dict[str, Any]) -> None:
        """Set parameters, whatever comes of it."""
        request = SetParameters.Request()
        request.parameters = [
            Parameter(name, value=value).to_parameter_msg() for name, value in values.items()
        ]
        self.call('set_parameters', request)

    def note_memory(self) -> None:
        """Note the memory of the node, MB."""
        status = Path(f'/proc/{self.pid}/status').read_text()
        kilobytes = status.split('VmRSS:')[1].split()[0]
        self.figures.memory.append(int(kilobytes) / 1024)

    def _pid(self) -> str:
        """Return the process of the node, which runs under a guard."""
        guard = self.graph.living[-1].pid
        return Path(f'/proc/{guard}/task/{guard}/children').read_text().split()[0]


def hostile_value(hostile: Hostile, entry: Entry) -> Any:
    """Return a value for a parameter: one in its range, at its end, beyond it, or of any kind."""
    low, high = entry.range or (0, 1)
    largest = 1e300 if isinstance(entry.default, float) else 2**60
    inside = low + (min(high, largest, low + 10) - low) * hostile.generator.random()
    options = {
        bool: (True, False, True, False, 'yes', 1),
        int: (int(inside), int(low), int(min(high, largest)), -1, 2**62, 0.5, 'many'),
        float: (float(inside), float(low), float(high), -1.0, np.nan, -np.inf, 1, 'much', 'inf'),
        str: (*entry.choices, entry.default, 'nonsense', '', 'x' * 10_000, 7),
    }[type(entry.default)]
    return hostile.choice(options)


def thinned(values: list[float], most: int = 12) -> list[float]:
    """Return some of many values, the first and the last among them."""
    if len(values) <= most:
        return values
    return [values[round(one)] for one in np.linspace(0, len(values) - 1, most)]
