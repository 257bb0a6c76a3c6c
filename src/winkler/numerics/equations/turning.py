r"""The path of a point along a curve of rises and falls while a level rises and falls.

A level that rises from below carries the point from :math:`x_0` to
:math:`\inf\{x : \max_{[x_0,x]} y > \text{level}\}`: up every rising piece, and from each summit in one leap to the next
place that is higher.  Where the point stands follows from the highest and lowest levels alone, however finely the path
there is divided.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.equations.bracketing import between
from winkler.numerics.types import Array, Curve


class Leap(NamedTuple):
    """One leap: at `level` from `start` to `end`, on the path to the level of the number `aim`."""

    level: float
    start: float
    end: float
    aim: int


class _RisingPiece(NamedTuple):
    """A rising piece from `low` to `high` over the levels from `bottom` to `top`."""

    bottom: float
    top: float
    low: float
    high: float


class Slopes(NamedTuple):
    """A continuous curve between its turning points.

    Parameters
    ----------
    curve
        y(x).
    places : ndarray, (n,)
        The first place, the turning points, the last place; ascending.
    levels : ndarray, (n,)
        y there.
    """

    curve: Curve
    places: Array
    levels: Array

    def rise(self, x: float, levels: Array) -> tuple[Array, list[Leap]]:
        """Return where a point at x stands while the level rises through `levels`, and its leaps.

        Parameters
        ----------
        x : float
            Where it stands before.
        levels : ndarray, (m,)
            Ascending.

        Returns
        -------
        ndarray, (m,), and list of Leap
            Beyond the last place there is a wall.
        """
        first = float(self.curve(np.array([x]))[0])
        pieces, leaps, last = self._route(x, first, levels)
        standing = np.full(levels.shape, x)
        moved = levels >= first
        standing[moved] = last
        if pieces and moved.any():
            piece = np.searchsorted([each.bottom for each in pieces], levels[moved], side="right") - 1
            _, top, low, high = np.array(pieces)[piece].T
            below = levels[moved] < top
            standing[moved] = np.where(below, self._roots(levels[moved], low, high), last)
        return standing, leaps

    def fall(self, x: float, levels: Array) -> tuple[Array, list[Leap]]:
        """Return where a point at x stands while the level falls through `levels`, descending, and its leaps."""
        mirrored = Slopes(lambda z: -self.curve(-z), -self.places[::-1], -self.levels[::-1])
        standing, leaps = mirrored.rise(-x, -levels)
        return 0.0 - standing, [Leap(-level, 0.0 - start, 0.0 - end, aim) for level, start, end, aim in leaps]

    def _route(self, x: float, here: float, levels: Array) -> tuple[list[_RisingPiece], list[Leap], float]:
        """Return the pieces that are passed, the leaps between them, and the last stable place."""
        pieces: list[_RisingPiece] = []
        leaps: list[Leap] = []
        index = int(np.searchsorted(self.places, x, side="right")) - 1
        while here <= levels[-1] and index < len(self.places) - 1:
            next_place, top = float(self.places[index + 1]), float(self.levels[index + 1])
            if top > here:
                pieces.append(_RisingPiece(here, top, x, next_place))
                x, here, index = next_place, top, index + 1
                continue
            at = int(np.searchsorted(levels, here, side="left"))
            above = np.flatnonzero((self.levels[index + 2 :] > here) & (self.levels[index + 1 : -1] <= here))
            if not above.size:
                leaps.append(Leap(here, x, float(self.places[-1]), at))
                return pieces, leaps, float(self.places[-1])
            index += 1 + int(above[0])
            low, high = self.places[index : index + 1], self.places[index + 1 : index + 2]
            end = float(self._roots(np.array([here]), low, high)[0])
            leaps.append(Leap(here, x, end, at))
            x = end
        return pieces, leaps, x

    def _roots(self, levels: Array, low: Array, high: Array) -> Array:
        """Return where rising pieces pass levels; an end where rounding has put the root beyond it."""
        short = self.curve(high) <= levels
        crossings = between(lambda x, index: self.curve(x) - levels[index], low, high)
        return np.where(short, high, crossings)
