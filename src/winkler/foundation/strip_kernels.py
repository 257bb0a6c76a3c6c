"""How layers let surfaces move by even tractions up to a place: kernels twice integrated, of which elements differ."""

from __future__ import annotations

import numpy as np

from winkler.numerics.caching import cached_by_value
from winkler.numerics.chunks import wave_sums
from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.transforms.cosine_transform import WaveResponse
from winkler.numerics.transforms.strips.strip_equation import Waves, waves
from winkler.numerics.types import Array, Curve

KERNEL_TOLERANCE = 1e-12
"""Error of what the layers add to the displacement of an element, over its greatest value."""
SUMMED = 2e-15
"""Rounding of a sum of waves, over the sum of their sizes."""


@cached_by_value(64)
def twists(response: WaveResponse, octave: int) -> Panels:
    """Return the integral of M (sin kx - kx) / k^2 by k as of x, both over the greatest half-width of the octave."""
    found, unit = waves(response, octave), response.smooth * 2.0**octave
    level = float(np.sum(found.weights) + np.sum(found.shares))

    def turned(t: Array) -> Array:
        return wave_sums(np.sin, unit * t, found.k, found.weights / found.k) / unit - level * t

    return _panels(turned, found)


@cached_by_value(64)
def bends(response: WaveResponse, octave: int) -> Panels:
    """Return the same of M (1 - cos kx) / k^2."""
    found, unit = waves(response, octave), response.smooth * 2.0**octave

    def bent(t: Array) -> Array:
        return wave_sums(risen, unit * t, found.k, found.weights / found.k) / unit

    return _panels(bent, found)


def risen(phase: Array) -> Array:
    """Return 1 - cos without cancellation."""
    return np.asarray(2.0 * np.sin(0.5 * phase) ** 2)


def _panels(function: Curve, found: Waves) -> Panels:
    """Return a sum of these waves from 0 to 2 as panels, no more precise than its rounding."""
    greatest = float(np.max(np.abs(function(np.array([1.0, 2.0])))))
    rounding = SUMMED * float(np.sum(np.abs(found.weights)))
    return fit_panels(function, np.array([0.0, 2.0]), max(KERNEL_TOLERANCE * max(1.0, greatest), rounding))
