"""The numbers that features, network and outputs share; a trained network fits these alone."""

import numpy as np

LAGS = 6
"""Motions that are seen of a person, now among them."""
LAG = 0.25
"""Time between two of them, s."""
MOTION = 4
"""Numbers of a motion: velocity, m/s, then position, m."""
NEIGHBOURS = 8
"""Nearest agents and obstacles that are seen."""
REACH = 8.0
"""Agents whose rims are farther apart are not seen, m."""
OWN = 3 + 2 * LAGS + 2 * (LAGS - 1) + 1 + 4
"""
Features of the person: speed, velocities, share of them that is known, radius, mean velocities
since the lags, jitter, and the crowd.
"""
EDGE = 18
"""Features of a neighbour."""
INPUTS = OWN + NEIGHBOURS * EDGE

STEPS = 12
"""Moments that are predicted."""
STEP = 0.25
"""Time between two of them, s."""
TIMES = STEP * np.arange(1, STEPS + 1)
"""The moments, s."""
SCALE = (0.05 * np.arange(1, STEPS + 1) ** 1.2).astype(np.float32)
"""Usual error of constant velocity at each moment, the unit of the network's outputs, m."""
DOUBT = 0.1
"""Residuals much smaller than this, in units of SCALE, are not believed: people walk on."""
OUTPUTS = 3 * STEPS
"""Residual to constant velocity (STEPS, 2), then logarithms of the deviations (STEPS)."""
