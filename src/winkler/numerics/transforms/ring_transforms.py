r"""The transforms of contact on a grid of radii: functions that are straight in :math:`y = r^2` between its nodes.

Every integral of `winkler.numerics.transforms.graded_abel` is then known in closed form, cell by cell: with
:math:`q = (1+k)/2` and a slope :math:`\beta` of f or u over y in the cell from s to t

.. math:: g(x) \mathrel{+}= \frac{x^{1-k}\beta}{q}\,\big[(x^2-s^2)^q-(x^2-t^2)^q\big] , \qquad
          \int_r^a 2\pi r\,p\,\mathrm dr \mathrel{+}=
          -\frac{\beta}{q(q+1)}\,\big[(t^2-r^2)^{q+1}-(s^2-r^2)^{q+1}\big] ,

brackets counting where they are positive.  Pressures are means over rings about the nodes, so that nothing of the force
is lost, and that they change steadily when the edge of the contact passes a node; the displacement of the surface is
made of incomplete beta functions.  For a paraboloid this is exact.  A function that is cut off at zero within a cell is
cut off there, not at the next node: what the cells miss is added.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array

__all__ = ["Cuts", "RingTransforms", "SurfaceTransform", "ring_means"]


class Cuts:
    """Where a function given at nodes passes zero: cells, places in y, and the two slopes over y.

    Parameters
    ----------
    squares, values : ndarray, (n,)
        y [m^2] of the nodes, and the function there.
    """

    def __init__(self, squares: Array, values: Array) -> None:
        signs = values > 0.0
        (self.cells,) = np.nonzero(signs[:-1] != signs[1:])
        low, high = values[self.cells], values[self.cells + 1]
        self.start, self.stop = squares[self.cells], squares[self.cells + 1]
        width = self.stop - self.start
        self.place = self.start + width * (low / (low - high))
        self.falls = low > 0.0
        self.slope = (high - low) / width
        # what the nodes alone give: zero instead of what is negative
        self.cut_slope = (np.maximum(high, 0.0) - np.maximum(low, 0.0)) / width
        # where the positive part begins and ends
        self.first = np.where(self.falls, self.start, self.place)
        self.last = np.where(self.falls, self.place, self.stop)

    @property
    def edge(self) -> float:
        """Where the function falls below zero for the last time, in y [m^2]; zero if nowhere."""
        return float(self.place[self.falls][-1]) if np.any(self.falls) else 0.0


def ring_means(squares: Array, values: Array, targets: Array) -> Array:
    """Return the means over the rings about other nodes, so that nothing of a volume is lost.

    Parameters
    ----------
    squares, values : ndarray, (n,)
        y = r^2 of the nodes, and a function there, straight in y between them and zero beyond.
    wanted : ndarray, (m,)
        y of the other nodes.
    """
    borders = np.concatenate(([0.0], 0.5 * (targets[1:] + targets[:-1]), targets[-1:]))
    below = np.concatenate(([0.0], np.cumsum(0.5 * np.diff(squares) * (values[1:] + values[:-1]))))
    cell = np.clip(np.searchsorted(squares, borders, side="right") - 1, 0, squares.size - 2)
    part = np.minimum(borders, squares[-1]) - squares[cell]
    slope = (values[cell + 1] - values[cell]) / (squares[cell + 1] - squares[cell])
    upto = below[cell] + part * (values[cell] + 0.5 * slope * part)
    return np.asarray(np.diff(upto) / np.diff(borders))


class RingTransforms:
    """Matrices of the transforms on one grid; all take what is given at the nodes to what is there.

    Parameters
    ----------
    nodes : ndarray, (n,)
        Radii [m], rising from zero.
    exponent : float
        k of the grading, above -1 and at most 1; zero for a homogeneous half-space.
    """

    def __init__(self, nodes: Array, exponent: float) -> None:
        self.k, self.q = exponent, 0.5 * (1.0 + exponent)
        self.nodes, self.squares = nodes, nodes * nodes
        self.widths = np.diff(self.squares)
        y = self.squares
        # (y_j - y_i)^q where positive: for the gap rows are x, for the pressure rows are r
        reach = np.maximum(y[:, None] - y[None, :], 0.0) ** self.q
        with np.errstate(divide="ignore"):
            scale = np.where(nodes > 0.0, nodes ** (1.0 - exponent), 0.0 if exponent < 1.0 else 1.0)
        self.gap = self._by_values(scale[:, None] / self.q * (reach[:, :-1] - reach[:, 1:]))
        self.force = self._force_weights()
        # rings between the middles (in y) of the cells: what they bear is known exactly, and they part the whole area
        self.borders = np.concatenate(([0.0], 0.5 * (y[1:] + y[:-1])))
        self.areas = math.pi * np.diff(np.append(self.borders, y[-1]))
        reach = np.maximum(y[None, :] - self.borders[:, None], 0.0) ** (self.q + 1.0)
        self.outside = self._by_values((reach[:, :-1] - reach[:, 1:]) / (self.q * (self.q + 1.0)))

    def _by_values(self, by_slopes: Array) -> Array:
        """Return the matrix that takes values, from the one that takes slopes over y."""
        ratio = by_slopes / self.widths
        matrix = np.zeros((by_slopes.shape[0], self.nodes.size))
        matrix[:, 1:] += ratio
        matrix[:, :-1] -= ratio
        return matrix

    def _moments(self, low: Array, high: Array) -> tuple[Array, Array]:
        """Return the integrals of x^k and x^(k+2) between places in y."""
        k = self.k
        return (
            (high**self.q - low**self.q) / (1.0 + k),
            (high ** (self.q + 1.0) - low ** (self.q + 1.0)) / (3.0 + k),
        )

    def _force_weights(self) -> Array:
        low, high = self.squares[:-1], self.squares[1:]
        zeroth, second = self._moments(low, high)
        weights = np.zeros(self.nodes.size)
        weights[1:] += (second - low * zeroth) / self.widths
        weights[:-1] += (high * zeroth - second) / self.widths
        return weights

    def integral(self, values: Array, cut: Cuts) -> float:
        """Return the integral of x^k values(x)+ from 0 to the last node."""
        total = float(self.force @ np.maximum(values, 0.0))
        if cut.cells.size:
            zeroth, second = self._moments(cut.first, cut.last)
            total += float(np.sum(cut.slope * (second - cut.place * zeroth)))
            base = np.where(cut.falls, cut.stop, cut.start)
            zeroth, second = self._moments(cut.start, cut.stop)
            total -= float(np.sum(cut.cut_slope * (second - base * zeroth)))
        return total

    def inside(self, cut: Cuts, upto: float) -> float:
        """Return the integral of x^k over where a function is positive, if it is so at the axis."""
        zeroth, _ = self._moments(np.zeros(1), np.array([upto]))
        if not cut.cells.size:
            return float(zeroth[0])
        ends, _ = self._moments(np.zeros(cut.cells.size), cut.place)
        total = float(np.sum(np.where(cut.falls, ends, -ends)))
        return total if cut.falls[-1] else total + float(zeroth[0])

    def in_rings(self, values: Array, cut: Cuts) -> Array:
        """Return what the rings about the nodes bear, their mean pressure times c_0^k / E*, under springs values+."""
        beyond = self.outside @ np.maximum(values, 0.0) - self._missed(cut, self.borders, self.q + 1.0) / self.q
        if values[-1] > 0.0:
            beyond = beyond + values[-1] / self.q * (self.squares[-1] - self.borders) ** self.q
        return np.asarray(-np.diff(np.append(beyond, 0.0)) / self.areas)

    def _missed(self, cut: Cuts, places: Array, power: float) -> Array | float:
        """Return the integral of (y - place)^(power - 1) over y > place, times the slopes that the nodes alone miss."""
        if not cut.cells.size:
            return 0.0
        y = places[:, None]

        def span(low: Array, high: Array) -> Array:
            return np.asarray(np.maximum(high - y, 0.0) ** power - np.maximum(low - y, 0.0) ** power)

        missed = cut.slope * span(cut.first, cut.last) - cut.cut_slope * span(cut.start, cut.stop)
        return np.asarray(np.sum(missed, axis=1) / power)


class SurfaceTransform:
    """The displacement of the surface of what the springs do, on one grid."""

    def __init__(self, rings: RingTransforms) -> None:
        self.rings = rings
        y = rings.squares
        zeroth, second = self._parts(np.broadcast_to(y[None, :], (y.size, y.size)))
        zeroth, second = np.diff(zeroth, axis=1), np.diff(second, axis=1)
        matrix = np.zeros((y.size, y.size))
        matrix[:, 1:] += (second - y[:-1] * zeroth) / rings.widths
        matrix[:, :-1] += (y[1:] * zeroth - second) / rings.widths
        matrix[0, 0] = 1.0
        self.matrix = matrix

    def _parts(self, upto: Array) -> tuple[Array, Array]:
        """Return the transforms of 1 and of x^2 from the axis up to places in y, at every node (rows)."""
        from scipy.special import betainc

        rings = self.rings
        y = rings.squares[:, None]
        part = np.minimum(upto / np.where(y > 0.0, y, 1.0), 1.0)
        part = np.where(y > 0.0, part, 0.0)
        rest = 0.5 * (1.0 - rings.k)
        return betainc(rings.q, rest, part), rings.q * y * betainc(rings.q + 1.0, rest, part)

    def __call__(self, values: Array, cut: Cuts) -> Array:
        """Return u(r) [m] of springs displaced by values+."""
        restored = self.matrix @ np.maximum(values, 0.0)
        if cut.cells.size:
            zeroth, second = (
                last - first
                for last, first in zip(self._parts(cut.last[None, :]), self._parts(cut.first[None, :]), strict=True)
            )
            restored = restored + np.sum(cut.slope * (second - cut.place * zeroth), axis=1)
            base = np.where(cut.falls, cut.stop, cut.start)
            zeroth, second = (
                last - first
                for last, first in zip(self._parts(cut.stop[None, :]), self._parts(cut.start[None, :]), strict=True)
            )
            restored = restored - np.sum(cut.cut_slope * (second - base * zeroth), axis=1)
        return np.asarray(restored)
