"""All that changes while the prediction is trained, and how it is stored."""

import math

import numpy as np
import torch

from socialnav_core.config.prediction import PredictionConfig
from socialnav_core.training.prediction.dataset import record_crowds
from socialnav_core.training.prediction.network import (
    build_network,
    calibrated,
    inference_weights,
)
from socialnav_core.training.prediction.validation import Validation, validation_examples
from socialnav_core.training.resume import (
    Arrays,
    network_arrays,
    optimizer_arrays,
    restore_network,
    restore_optimizer,
)


class PredictionRun:
    """A run: crowds, network, optimizer, the best weights so far and counters."""

    def __init__(self, config: PredictionConfig) -> None:
        """Record the crowds and draw the weights; nothing is learned yet."""
        settings = config.training
        self.config = config
        self.crowds = record_crowds(config.crowds, config.seed, 'train')
        self.validation = validation_examples(config)
        self.network = build_network(settings.width, config.seed)
        self.optimizer = torch.optim.AdamW(
            self.network.parameters(), lr=settings.learning_rate,
            weight_decay=settings.weight_decay, fused=True,
        )  # fmt: skip
        self.updates = 0
        self.best_loss = math.inf
        self.best_weights = inference_weights(self.network)
        self.seconds = 0.0
        self.processor_seconds = 0.0

    @property
    def finished(self) -> bool:
        """Return whether the run is as long as it should be."""
        return self.updates >= self.config.training.updates

    def keep_best(self, found: Validation) -> None:
        """Keep the weights of now, calibrated, if they are the best on the validation crowds."""
        if found.loss < self.best_loss:
            self.best_loss = found.loss
            self.best_weights = calibrated(inference_weights(self.network), found.factors)

    def sections(self) -> dict[str, Arrays]:
        """Return all that `restore` needs, part by part; crowds follow from the seed."""
        counters = ('updates', 'best_loss', 'seconds', 'processor_seconds')
        return {
            'network': network_arrays(self.network),
            'optimizer': optimizer_arrays(self.optimizer),
            'best': self.best_weights,
            'counters': {name: np.array(getattr(self, name)) for name in counters},
        }

    def restore(self, sections: dict[str, Arrays]) -> None:
        """Go on from `sections` of a run with the same configuration."""
        restore_network(self.network, sections['network'])
        restore_optimizer(self.optimizer, sections.get('optimizer', {}))
        self.best_weights = sections['best']
        for name, value in sections['counters'].items():
            setattr(self, name, value.item())
