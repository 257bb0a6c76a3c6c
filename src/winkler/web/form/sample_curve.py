"""The curve with which the form of a fit begins: a made one, a ball on a gel with seeded noise."""

from __future__ import annotations

import numpy as np

__all__ = ["SAMPLE", "SAMPLE_REMARK", "sample_curve"]

SAMPLE = "sample_curve.csv"
RADIUS, YOUNG, POISSON, NOISE = 5e-6, 4e3, 0.5, 2e-11
"""Of the tip [m], E [Pa] and Poisson's ratio of the gel, and the standard deviation of the force [N]."""

SAMPLE_REMARK = "A made curve, not a measurement: a ball of 5 um on a gel of 4 kPa, with noise. Upload your own."


def sample_curve() -> bytes:
    """Return the text of the curve: Hertz's force over the depth, with white noise."""
    depth = np.linspace(-1e-6, 8e-7, 300)
    force = 4.0 / 3.0 * YOUNG / (1.0 - POISSON**2) * np.sqrt(RADIUS) * np.maximum(depth, 0.0) ** 1.5
    force = force + NOISE * np.random.default_rng(1).standard_normal(depth.size)
    rows = (f"{1e9 * d:.2f}, {1e9 * f:.5f}" for d, f in zip(depth, force, strict=True))
    lines = ("# NOT a measurement: a ball of 5 um on a gel of 4 kPa, with noise", "depth [nm], force [nN]", *rows)
    return ("\n".join(lines) + "\n").encode()
