r"""What springs of which only the gap is known add up to: shear force, stored energy, and what sliding has cost.

Sums over springs are integrals over the stiffness :math:`K(\gamma)` of the frictionless contact pressed to the depth
:math:`\gamma`.  With its force F and its work W (:math:`F'=K`, :math:`W'=F`) those between two gaps are

.. math:: \int_a^b\mathrm dK = K_b-K_a ,\quad \int_a^b(b-\gamma)\,\mathrm dK = F_b-F_a-(b-a)K_a ,\quad
          \int_a^b(b-\gamma)^2\,\mathrm dK = 2(W_b-W_a)-2(b-a)F_a-(b-a)^2K_a :

whatever the shape, the solution needs its normal curve only.  What was straight over the gap is then summed exactly.
"""

from __future__ import annotations

import math
from typing import NamedTuple, Protocol

import numpy as np

from winkler.numerics.types import Array
from winkler.problems.friction.slip_memory import SlipMemory
from winkler.problems.friction.slip_stack import Moments, shear, stored, within
from winkler.problems.normal.force_curve import GAUSS_POINTS, GAUSS_WEIGHTS, SHALLOWER, NormalCurves

MOST_GAPS = 256
"""Gaps that are remembered at most."""
GAUSS_NODES, GAUSS_SHARES = (tuple(each.tolist()) for each in (GAUSS_POINTS, GAUSS_WEIGHTS))
NARROW_RING = 2e-3
"""Part of its outer gap below which a ring of springs is summed by itself, lest nothing be left of it by rounding."""


class NormalStates(Protocol):
    """The frictionless contact over its depth."""

    def at(self, depth: float) -> Moments:
        """Return K [N/m], F [N] and W [J] at a depth [m]."""
        ...

    def between(self, gap: float, stiffness: float, depth: float) -> tuple[float, float]:
        """Return the sums of d - gap [N] and of its square [J] over the springs from a gap to a depth."""
        ...


class SlipSums:
    """Sums over the springs of one bed, over the ratio of tangential to normal stiffness.

    Parameters
    ----------
    states : NormalStates
        The frictionless contact of that bed.
    """

    def __init__(self, states: NormalStates) -> None:
        self.states = states
        self._points: dict[float, Moments] = {0.0: (0.0, 0.0, 0.0)}

    def at(self, gap: float) -> Moments:
        """Return K, F and W at a gap [m]; nothing at zero, where a flat end comes into contact at once."""
        sums = self._points.get(gap)
        if sums is None:
            if len(self._points) > MOST_GAPS:
                self._points = {0.0: self._points[0.0]}
            sums = self._points[gap] = self.states.at(gap)
        return sums

    def ring(self, start: float, stop: float) -> Moments:
        """Return the sums of 1 [N/m], of stop - gap [N] and of its square [J] over the springs between two gaps."""
        points = self._points
        zeroth, first, second = points.get(start) or self.at(start)
        outer, width = points.get(stop) or self.at(stop), stop - start
        if width < NARROW_RING * stop and start > 0.0:
            return outer[0] - zeroth, *self.states.between(start, zeroth, stop)
        return (
            outer[0] - zeroth,
            outer[1] - first - width * zeroth,
            2.0 * (outer[2] - second) - width * (2.0 * first + width * zeroth),
        )

    def within(self, memory: SlipMemory) -> Moments:
        """Return the sums of 1 [N/m], of u_t [N] and of u_t^2 [J] over springs, u_t counted from that on the axis."""
        return within(memory.pieces.sums_of(self), self, memory.top)

    def shear(self, memory: SlipMemory) -> float:
        """Return the integral of u_t dK [N]: the shear force over the ratio."""
        return shear(memory.pieces.sums_of(self), self, memory.top, memory.dragged)

    def stored(self, memory: SlipMemory) -> float:
        """Return half the integral of u_t^2 dK [J]: the stored energy over the ratio."""
        return stored(memory.pieces.sums_of(self), self, memory.top, memory.dragged)


class PanelTable(NamedTuple):
    """The same sums for a kernel: the panels of normal curves, of the greatest one and of shallower ones.

    Parameters
    ----------
    edges : ndarray
        Ends of the panels [m], curve after curve.
    rows : ndarray, (panels, n, 3)
        As of `NormalCurve`.
    first : ndarray of int, (curves + 1,)
        Number of the first panel of each curve, and of all.
    depth : float
        The greatest depth [m].
    missing : ndarray of int, (1,)
        A curve that was needed and is not there; -1 for none.
    """

    edges: Array
    rows: Array
    first: Array
    depth: float
    missing: Array


def panel_table(curves: NormalCurves, count: int) -> PanelTable:
    """Return the panels of that many normal curves of one bed."""
    tables = [curves.level(number) for number in range(count)]
    width = max(table.orders.size for table in tables)
    rows = [np.pad(row, ((0, width - row.shape[0]), (0, 0))) for table in tables for row in table.rows]
    first = np.cumsum([0, *(len(table.rows) for table in tables)])
    edges = np.concatenate([np.array(table.edges) for table in tables])
    return PanelTable(edges, np.array(rows), first, curves.depth, np.full(1, -1))


def _curve(table: PanelTable, depth: float) -> int:
    """Return the curve that is made for a depth [m]."""
    if depth * SHALLOWER >= table.depth or depth <= 0.0:
        return 0
    number = int(math.log(table.depth / depth) / math.log(SHALLOWER))
    if number >= table.first.size - 1:
        table.missing[0] = number
        raise LookupError("a shallower curve is needed")
    return number


def _panel(table: PanelTable, curve: int, depth: float) -> int:
    """Return the place in `edges` of the panel in which a depth lies."""
    low: int = table.first[curve] + curve
    high: int = table.first[curve + 1] + curve
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if table.edges[middle] <= depth else (low, middle)
    return low


def _place(table: PanelTable, place: int, depth: float) -> float:
    """Return where a depth lies in a panel, from -1 to 1."""
    low: float = table.edges[place]
    high: float = table.edges[place + 1]
    return min(max((2.0 * depth - low - high) / (high - low), -1.0), 1.0)


def panel_at(table: PanelTable, depth: float) -> Moments:
    """Return as `SlipSums.at`."""
    if depth <= 0.0:
        return 0.0, 0.0, 0.0
    curve = _curve(table, depth)
    place = _panel(table, curve, depth)
    t, row, rows = _place(table, place, depth), place - curve, table.rows
    k1, k2, f1, f2, w1, w2 = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for order in range(rows.shape[1] - 1, 0, -1):
        k1, k2 = rows[row, order, 0] + 2.0 * t * k1 - k2, k1
        f1, f2 = rows[row, order, 1] + 2.0 * t * f1 - f2, f1
        w1, w2 = rows[row, order, 2] + 2.0 * t * w1 - w2, w1
    return rows[row, 0, 0] + t * k1 - k2, rows[row, 0, 1] + t * f1 - f2, rows[row, 0, 2] + t * w1 - w2


def panel_moments(table: PanelTable, start: float, stop: float) -> Moments:
    """Return as `SlipSums.ring`."""
    inner, outer, width = panel_at(table, start), panel_at(table, stop), stop - start
    zeroth = inner[0]
    if not (width < NARROW_RING * stop and start > 0.0):
        return (
            outer[0] - zeroth,
            outer[1] - inner[1] - width * zeroth,
            2.0 * (outer[2] - inner[2]) - width * (2.0 * inner[1] + width * zeroth),
        )
    curve, linear, square, low = _curve(table, stop), 0.0, 0.0, start
    place, last = _panel(table, curve, start), _panel(table, curve, stop)
    while place <= last:
        high = stop if place == last else table.edges[place + 1]
        half = 0.5 * (high - low)
        for k in range(len(GAUSS_NODES)):
            at = 0.5 * (low + high) + half * GAUSS_NODES[k]
            t, row, k1, k2 = _place(table, place, at), place - curve, 0.0, 0.0
            for order in range(table.rows.shape[1] - 1, 0, -1):
                k1, k2 = table.rows[row, order, 0] + 2.0 * t * k1 - k2, k1
            excess = half * GAUSS_SHARES[k] * (table.rows[row, 0, 0] + t * k1 - k2 - zeroth)
            linear += excess
            square += 2.0 * excess * (stop - at)
        low, place = high, place + 1
    return outer[0] - zeroth, linear, square
