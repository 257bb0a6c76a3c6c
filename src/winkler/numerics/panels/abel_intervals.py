"""The intervals of an Abel integral, and the effect of rounding at their ends."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from winkler.numerics.types import Array

Kinks = Sequence[tuple[float, float]]


def root_difference(x: Array, b: float | Array) -> Array:
    """Return sqrt(x^2 - b^2) without cancellation; zero where x < b."""
    return np.sqrt(np.maximum(x - b, 0.0) * (x + b))


def clear_of_underflow(x: Array) -> Array:
    """Return places, those so close to the axis that their squares vanish put onto it."""
    x = np.asarray(x, dtype=float)
    return np.where(x > 1e-150, x, 0.0)


def noise(x: Array, low: float) -> Array | None:
    """Return how far rounding of places near x spoils a function of the distance from `low`, relative to it."""
    if low == 0.0:
        return None
    return np.asarray(np.finfo(float).eps * x / (x - low))


def pieces(edges: Sequence[float], end: float) -> list[tuple[float, float]]:
    """Return the pieces into which `edges` cut the interval from 0 to `end`."""
    inner = sorted({edge for edge in edges if 0.0 < edge < end})
    return list(pairwise([0.0, *inner, math.inf]))
