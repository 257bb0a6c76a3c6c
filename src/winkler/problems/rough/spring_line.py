r"""One line of independent springs under given heights: all loads follow from one sort.

With gaps :math:`\gamma_1\le\gamma_2\le\dots` below the highest point,

.. math:: F(d) = E^*\Delta x\sum_{\gamma_i<d}(d-\gamma_i) , \qquad k(d) = E^*\Delta x\,\#\{\gamma_i<d\} .

Many random lines give a median, and between which forces eight surfaces of ten lie.
"""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Iterable
from typing import Annotated, NamedTuple

import numpy as np

from winkler.loading.loads import Depth, Force
from winkler.loading.path import numbers_of
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import Numbers, Positive
from winkler.values.value import value, words

QUANTILES = (0.1, 0.9)
"""Quantiles between which eight of ten surfaces lie."""


def _none() -> Array:
    return np.zeros(0)


@value
class RoughLine:
    """A one-dimensional foundation of independent springs under given heights, all loads at once.

    Parameters
    ----------
    heights : ndarray, (n,)
        [m], in any order.
    length : float
        Length of the profiles [m].
    modulus : float
        E* [Pa], stiffness of the springs per length.
    stiffnesses : ndarray, (n,), optional
        Stiffness [N/m] of the first 1, 2, ..., n springs in contact, increasing; for layers, where the effective
        modulus depends on the contact width.  Proportional to E* by default.

    Examples
    --------
    >>> line = RoughLine(np.array([0.0, -1.0, -2.0]), 3.0, 1.0)
    >>> line.force(np.array([1.0, 1.5])), line.depth(np.array([1.0, 2.0]))
    (array([1., 2.]), array([1. , 1.5]))
    """

    __words__ = words(length=("L", "m", "length of the line"))

    heights: Annotated[Array, Numbers(fewest=2)]
    length: Positive
    modulus: Positive
    stiffnesses: Array = dataclasses.field(default_factory=_none)

    @functools.cached_property
    def _stiffness(self) -> Array:
        """Stiffness [N/m] of no spring, one, two, ..., all of them."""
        if self.stiffnesses.size:
            return np.concatenate(([0.0], self.stiffnesses))
        return np.asarray(self.modulus * self.length / self.heights.size * np.arange(self.heights.size + 1.0))

    @functools.cached_property
    def _sorted(self) -> tuple[Array, Array]:
        """Gaps in rising order [m], and the force [N] at which each spring comes in."""
        gaps = np.sort(np.max(self.heights) - self.heights)
        # summed up from one spring to the next nothing cancels, and the forces never fall
        return gaps, np.concatenate(([0.0], np.cumsum(self._stiffness[1:-1] * np.diff(gaps))))

    def force(self, depth: Array) -> Array:
        """Return F [N] at depths [m] below the highest point."""
        gaps, forces = self._sorted
        d = np.maximum(np.asarray(depth, dtype=float), 0.0)
        last = np.maximum(np.searchsorted(gaps, d, side="right") - 1, 0)
        return np.asarray(forces[last] + self.stiffness(d) * (d - gaps[last]))

    def depth(self, force: Array) -> Array:
        """Return d [m] under forces [N], zero or positive."""
        gaps, forces = self._sorted
        f = np.asarray(force, dtype=float)
        last = np.maximum(np.searchsorted(forces, f, side="right") - 1, 0)
        return np.asarray(gaps[last] + (f - forces[last]) / self._stiffness[last + 1])

    def stiffness(self, depth: Array) -> Array:
        """Return dF/dd [N/m] at depths [m]: on homogeneous bodies E* times the length in contact."""
        gaps, _ = self._sorted
        count = np.searchsorted(gaps, np.asarray(depth, dtype=float), side="right")
        return np.asarray(self._stiffness[count])


class LineStatistics(NamedTuple):
    """Statistics of many lines: medians in the shape of the load, bands with one more axis in front."""

    depth: Array
    """d [m]."""
    depth_band: Array
    """Between these two lie eight of ten."""
    force: Array
    """F [N]."""
    force_band: Array
    """Between these two lie eight of ten."""
    stiffness: Array
    """dF/dd [N/m]."""
    stiffness_band: Array
    """Between these two lie eight of ten."""


def line_seeds(seed: int, realisations: int) -> list[int]:
    """Return one seed for every line; other seeds share no line, and more lines begin with the same ones."""
    return [int(word) for word in np.random.SeedSequence(seed).generate_state(realisations)]


def ensemble(lines: Iterable[RoughLine], load: Force | Depth) -> LineStatistics:
    """Return the statistics of lines under a load, one after the other so that no two need be stored.

    Parameters
    ----------
    lines : iterable of RoughLine
    load : Force or Depth
        Not negative.
    """
    loads = numbers_of(load)
    flat = loads.ravel()
    rows: list[tuple[Array, Array, Array]] = []
    for line in lines:
        depth = line.depth(flat) if isinstance(load, Force) else flat
        rows.append((depth, flat if isinstance(load, Force) else line.force(flat), line.stiffness(depth)))
    columns = [np.stack(column) for column in zip(*rows, strict=True)]
    statistics: list[Array] = []
    for column in columns:
        statistics.append(np.median(column, axis=0).reshape(loads.shape))
        statistics.append(np.quantile(column, QUANTILES, axis=0).reshape((2, *loads.shape)))
    return LineStatistics(*statistics)
