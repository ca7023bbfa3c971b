"""All that changes while a planner is trained, and how it is stored."""

import copy
import math

import numpy as np

from socialnav_core.config.planner import PlannerConfig
from socialnav_core.config.policy import PolicyConfig
from socialnav_core.states import Observation
from socialnav_core.training.planner.driving import Examples
from socialnav_core.training.randomness import initial_network
from socialnav_core.training.resume import Arrays, network_arrays, restore_network


class PlannerRun:
    """A run: the network, the best one so far, all examples and counters."""

    def __init__(self, config: PlannerConfig) -> None:
        """Draw the weights; nothing is learned yet."""
        self.config = config
        kind = PolicyConfig(network=config.network, heads=config.heads)
        self.network = initial_network(kind, config.seed).eval()
        self.best = copy.deepcopy(self.network)
        self.examples: list[Examples] = []
        self.rounds = 0
        self.best_cost = math.inf
        self.cost_without = math.nan
        self.seconds = 0.0
        self.processor_seconds = 0.0

    @property
    def finished(self) -> bool:
        """Return whether the run is as long as it should be."""
        return self.rounds >= self.config.training.rounds

    def keep_best(self, cost: float) -> None:
        """Keep the network of now if it drives best on the validation worlds so far."""
        if cost < self.best_cost:
            self.best_cost, self.best = cost, copy.deepcopy(self.network)

    def sections(self) -> dict[str, Arrays]:
        """Return all that `restore` needs, part by part."""
        counters = ('rounds', 'best_cost', 'cost_without', 'seconds', 'processor_seconds')
        examples = Examples.concatenate(self.examples)
        return {
            'network': network_arrays(self.network),
            'best': network_arrays(self.best),
            'examples': vars(examples.observation) | {'cost': examples.cost},
            'counters': {name: np.array(getattr(self, name)) for name in counters},
        }

    def restore(self, sections: dict[str, Arrays]) -> None:
        """Go on from `sections` of a run with the same configuration."""
        restore_network(self.network, sections['network'])
        restore_network(self.best, sections['best'])
        arrays = sections['examples']
        seen = Observation(arrays['robot'], arrays['others'], arrays['mask'])
        self.examples = [Examples(seen, arrays['cost'])]
        for name, value in sections['counters'].items():
            setattr(self, name, value.item())
