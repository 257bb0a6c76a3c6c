"""A layered surface whose compliance is a sum of those of others: one step of layers that relax each by its own law."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.pixels.layered import LayeredSurface
from winkler.numerics.types import Array

__all__ = ["MixedSurface"]

CACHED_PIXELS = 2**18
"""Pixels up to which the displacements of the parts are kept for the next step."""


class MixedSurface(NamedTuple):
    """A sum of layered surfaces; units as of `LayeredSurface`.

    Parameters
    ----------
    parts : tuple of LayeredSurface
    weights : tuple of float
        Of the compliances of the parts, each over its own modulus, in that of the sum; they add up to one.
    """

    parts: tuple[LayeredSurface, ...]
    weights: tuple[float, ...]

    def in_units_of(self, length: float) -> MixedSurface:
        """Return the same with lengths measured by this one."""
        return self._replace(parts=tuple(part.in_units_of(length) for part in self.parts))

    @property
    def mean(self) -> float:
        """Displacement under a uniform pressure of E*; zero where it is infinite, and the mean is left at rest."""
        return float(self._sum(lambda part: np.array(part.mean)))

    def whole(self, wave: Array) -> Array:
        """Return 1 + M at positive wave numbers of any shape."""
        return self._sum(lambda part: part.whole(wave))

    def pixels(self, shape: tuple[int, int], pixel: tuple[float, float]) -> Array:
        """Return the displacements beyond Love's, as of `LayeredSurface.pixels`."""
        found = _kept if shape[0] * shape[1] <= CACHED_PIXELS else LayeredSurface.pixels
        return self._sum(lambda part: found(part, shape, pixel))

    def _sum(self, answer: Callable[[LayeredSurface], Array]) -> Array:
        return np.asarray(sum(weight * answer(part) for part, weight in zip(self.parts, self.weights, strict=True)))


_kept = functools.lru_cache(maxsize=128)(LayeredSurface.pixels)
