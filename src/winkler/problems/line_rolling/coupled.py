r"""Dissimilar cylinders that roll steadily: pressure drags the surfaces, and traction changes the pressure.

With Dundurs' constant beta both act on each other within the strip, where the slope of the gap and the slip over the
speed of rolling are (Bentall and Johnson)

.. math:: \frac{x-m}R = \frac2{\pi E^*}\int\frac{p(s)}{x-s}\,\mathrm ds - \frac{2\beta}{E^*}q , \qquad
          s(x) = \xi - \frac2{\pi E^*}\int\frac{q(s)}{x-s}\,\mathrm ds - \frac{2\beta}{E^*}p .

Neither has a length of its own: on a strip from -1 to 1 the pressure follows from the traction, with the middle m as
one unknown more, and the load gives the width afterwards.  Pressure and traction are linear between nodes that are
dense at both edges, and both equations hold at the middles of the elements.  Where everything sticks,

.. math:: a^2 = \frac{4PR}{\pi E^*(1+4\eta^2)} , \qquad \xi = \frac{2\eta a}R , \qquad
          \eta = \frac{\operatorname{artanh}\beta}\pi .

Without friction to speak of all slips, and the free cylinder creeps by :math:`0.9140\,\beta a/R`.

References
----------
R. H. Bentall, K. L. Johnson, Int. J. Mech. Sci. 9 (1967) 389-404, doi:10.1016/0020-7403(67)90043-4
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.errors import NotConverged
from winkler.numerics.surfaces.strip_elements import linear_slope
from winkler.numerics.surfaces.strip_grid import first_to_stick
from winkler.numerics.types import Array

__all__ = ["CoupledStrip", "coupled_strip", "creepage_error", "loss_error"]

COUNT = 400
"""Elements of the strip."""
ALL_AT_ONCE, MOST_ROUNDS, MOST_WIDTHS = 30, 60, 60
"""Rounds in which all nodes change that are wrong, rounds in all, and widths that are tried under a creepage."""
ACCEPTED = 1e-5
"""Part of the load on nodes that break Coulomb's law, with which the search may end: zones of few edge elements."""
STEPS = (1, 4)
"""Steps in which Dundurs' constant is brought up from that of similar bodies."""
ELEMENT_ERROR, ZONE_ERROR = 5e-5, 3e-3
"""Of the creepage on all elements, and by the elements that stick: twice what random strips miss with finer ones."""
SLIP_LOSS, STICK_LOSS, LEAST_LOSS = 32.0, 6e-3, 1e-7
"""Of the loss over it, by the elements that slip squared and those that stick; over the load times a/R: likewise."""
ROUNDING, WIDE = 1e-12, 1e-10
"""Of nodes, and of the width under a creepage."""


class CoupledStrip(NamedTuple):
    """The strip of dissimilar cylinders under one drive; lengths over a of similar bodies, stresses over E*.

    Parameters
    ----------
    x, pressure, traction
        At the nodes ``(m,)``, ascending, with both edges: the leading edge is last.
    slip
        Over the speed of rolling, of the second surface over the first ``(m - 1,)``, in the middle of each element.
    slips
        -1, 0 or 1 where it slips backwards, sticks, slips forwards ``(m - 1,)``, of each element.
    creepage, force
        xi [-], Q over E* a.
    """

    x: Array
    pressure: Array
    traction: Array
    slip: Array
    slips: Array
    creepage: float
    force: float

    @property
    def stick_share(self) -> float:
        """Part of the width that sticks [-]."""
        return float(np.diff(self.x) @ (self.slips == 0.0)) / float(self.x[-1] - self.x[0])

    @property
    def loss(self) -> float:
        """What friction loses per distance rolled, over E* a, with the mean traction of each element."""
        mean = 0.5 * (self.traction[1:] + self.traction[:-1])
        return float(np.diff(self.x) @ np.abs(mean * self.slip))


def creepage_error(strip: CoupledStrip) -> float:
    """Return the bound of the error of a creepage, over it or that of a free strip that sticks, if that is greater."""
    return ELEMENT_ERROR + ZONE_ERROR / max(1, int(np.count_nonzero(strip.slips == 0.0)))


def loss_error(strip: CoupledStrip, slope: float) -> float:
    """Return the bound of the error of a loss, over E* a, under a slope a/R [-]."""
    sticking = int(np.count_nonzero(strip.slips == 0.0))
    slipping = strip.slips.size - sticking
    share = min(1.0, SLIP_LOSS / max(1, slipping) ** 2 + STICK_LOSS / max(1, sticking))
    return share * strip.loss + LEAST_LOSS * slope * float(np.trapezoid(strip.pressure, strip.x))


class _EdgeDenseGrid(NamedTuple):
    """A strip from -1 to 1: the equations at the middles of its elements, the unknowns at the nodes inside.

    Parameters
    ----------
    nodes, weights
        ``(n + 1,)``; widths of the nodes inside ``(n - 1,)``.
    slope, mean
        2/pi times the integral of q(s)/(x - s), and q, at the middles ``(n, n - 1)``.
    alone, follows
        Pressure without traction ``(n - 1,)``, and by what q the pressure rises if 2 beta is one ``(n - 1, n - 1)``.
    """

    nodes: Array
    weights: Array
    slope: Array
    mean: Array
    alone: Array
    follows: Array


@functools.cache
def _grid(count: int) -> _EdgeDenseGrid:
    nodes = -np.cos(np.pi * np.arange(count + 1) / count)
    widths, middles = np.diff(nodes), 0.5 * (nodes[1:] + nodes[:-1])
    slope = 2.0 * linear_slope(nodes, middles)
    mean = 0.5 * (np.eye(count, count - 1) + np.eye(count, count - 1, -1))
    solved = np.linalg.solve(np.hstack([slope, -np.ones((count, 1))]), np.column_stack([middles, mean]))[:-1]
    return _EdgeDenseGrid(nodes, 0.5 * (widths[1:] + widths[:-1]), slope, mean, solved[:, 0], solved[:, 1:])


class _UnitStrip(NamedTuple):
    """A strip from -1 to 1 with a slope of the gap of one: at nodes inside; slip at elements, the last one first."""

    traction: Array
    pressure: Array
    slip: Array
    slips: Array
    creepage: float


class _StripEquations:
    """The strip under one coefficient of friction and one of Dundurs' constants.

    Of each element but the one at the trailing edge the node behind it sticks or slips as the element does.
    """

    def __init__(self, grid: _EdgeDenseGrid, beta: float, friction: float) -> None:
        self.grid, self.friction = grid, friction
        self.follows = 2.0 * beta * grid.follows
        self.passing = grid.slope + 2.0 * beta * grid.mean @ self.follows
        self.drawn = -2.0 * beta * grid.mean @ grid.alone

    def state(self, slips: Array, ratio: float | None, creepage: float) -> _UnitStrip:
        """Return the strip whose nodes stick or slip so, under a force of this part of the load or with a creepage."""
        grid, sticks = self.grid, slips == 0.0
        rubs = (slips * self.friction)[:, None]
        system = np.where(sticks[:, None], self.passing[1:], np.eye(slips.size) - rubs * self.follows)
        right = np.where(sticks, self.drawn[1:], rubs[:, 0] * grid.alone)
        if ratio is None:
            traction = np.linalg.solve(system, right + creepage * sticks)
        else:
            sums = grid.weights - ratio * (grid.weights @ self.follows)
            bordered = np.block([[system, -1.0 * sticks[:, None]], [sums[None, :], np.zeros((1, 1))]])
            *rest, creepage = np.linalg.solve(bordered, np.append(right, ratio * float(grid.weights @ grid.alone)))
            traction = np.array(rest)
        slip = creepage + self.drawn - self.passing @ traction
        slip[1:][sticks] = 0.0
        return _UnitStrip(traction, grid.alone + self.follows @ traction, slip, slips, float(creepage))

    def sliding(self, side: float) -> _UnitStrip:
        """Return the strip that slips everywhere to one side, with the least creepage at which it does."""
        slips = np.full(self.grid.alone.size, side)
        free = self.state(slips, None, 0.0)
        least = float(side * np.max(-side * free.slip[1:]))
        return free._replace(slip=free.slip + least, creepage=least)

    def settled(self, slips: Array, ratio: float | None, creepage: float) -> _UnitStrip | None:
        """Return the strip that obeys Coulomb's law, from a guess of what slips; None if it is not found."""
        least, best = math.inf, None
        for turn in range(MOST_ROUNDS):
            if ratio is not None and slips.all():
                slips = self._resting(slips, ratio)
            found = self.state(slips, ratio, creepage)
            load = float(self.grid.weights @ found.pressure)
            bound, slip = self.friction * found.pressure, found.slip[1:]
            allowed = np.maximum(bound, 0.0)
            broken = np.abs(found.traction - np.clip(found.traction + slip, -allowed, allowed))
            share = float(self.grid.weights @ broken) / (min(self.friction, 1.0) * load) if load > 0.0 else math.inf
            if share < least:
                least, best = share, found
            rounding = ROUNDING * float(np.max(np.abs(self.passing @ found.traction)))
            over = np.where(np.abs(found.traction) > bound * (1.0 + ROUNDING), np.sign(found.traction), 0.0)
            better = np.where(slips == 0.0, over, np.where(slip * slips < -rounding, 0.0, slips))
            wrong = np.flatnonzero(better != slips)
            if wrong.size == 0 and load > 0.0:
                return found
            if turn >= ALL_AT_ONCE and least < ACCEPTED:
                return best
            changed = wrong if turn < ALL_AT_ONCE else wrong[-1:]
            slips = slips.copy()
            slips[changed] = better[changed]
        return None

    def _resting(self, slips: Array, ratio: float) -> Array:
        """Return a strip that slips everywhere with the node at rest that comes to rest first."""
        moving = self.state(slips, None, 0.0)
        surplus = float(self.grid.weights @ (moving.traction - ratio * moving.pressure))
        slips = slips.copy()
        slips[first_to_stick(slips, moving.slip[1:], surplus)] = 0.0
        return slips


def coupled_strip(
    beta: float, friction: float, slope: float, *, force: float | None = None, creepage: float = 0.0, count: int = COUNT
) -> CoupledStrip:
    """Return the strip under a force, or with a creepage.

    Parameters
    ----------
    beta : float
        Dundurs' second constant [-], positive where the first surface is drawn in.
    friction : float
        mu [-].
    slope : float
        a/R [-].
    force : float, optional
        Q over E* a.
    creepage : float, optional
        xi [-], where no force is given.
    count : int, optional
        Elements.

    Raises
    ------
    NotConverged
        If pressure and traction are not found.
    """
    grid = _grid(count)
    ratio = None if force is None else force / (0.25 * math.pi * slope)
    found = next(
        filter(None, (_searched(grid, beta, friction, steps, ratio, creepage / slope) for steps in STEPS)), None
    )
    if found is None:
        raise NotConverged(
            f"LineRolling: pressure and traction of dissimilar cylinders (Dundurs' beta {beta:.3g}, friction "
            f"{friction:.3g}) were not found; give less friction, or leave the coupling out."
        )
    half, middle = _half(grid, found), _middle(grid, beta, found)
    pressure, traction = (slope * half * np.pad(row, 1) for row in (found.pressure, found.traction))
    slips = np.append(found.slips[:1], found.slips)
    return CoupledStrip(
        half * (grid.nodes + middle), pressure, traction, np.where(slips == 0.0, 0.0, slope * half * found.slip), slips,
        slope * half * found.creepage, slope * half**2 * float(grid.weights @ found.traction),
    )  # fmt: skip


def _searched(
    grid: _EdgeDenseGrid, beta: float, friction: float, steps: int, ratio: float | None, creepage: float
) -> _UnitStrip | None:
    """Return the strip of a slope of one under Q/P or a creepage, from Carter's zones or a strip that sticks."""
    drive = creepage if ratio is None else ratio
    side, used = math.copysign(1.0, drive), abs(drive) / friction
    strips = [_StripEquations(grid, beta * step / steps, friction) for step in range(1, steps + 1)]
    if ratio is not None and used >= 1.0 - ROUNDING:
        return strips[-1].sliding(side)
    share = max(1.0 - used, 0.0) if ratio is None else math.sqrt(1.0 - used)
    carter = np.where(grid.nodes[1:-1] < 1.0 - 2.0 * share, side, 0.0)
    for slips in (carter, np.zeros(carter.size)):
        found: _UnitStrip | None = None
        for strip in strips:
            found = _wide(strip, slips if found is None else found.slips, ratio, creepage)
            if found is None:
                break
        if found is not None:
            return found
    return None


def _wide(strip: _StripEquations, slips: Array, ratio: float | None, creepage: float) -> _UnitStrip | None:
    """Return the strip at its own width: a creepage is that of the strip from -1 to 1 times the half-width."""
    half = 1.0
    for _ in range(MOST_WIDTHS):
        found = strip.settled(slips, ratio, creepage / half)
        if found is None or ratio is not None:
            return found
        before, half, slips = half, _half(strip.grid, found), found.slips
        if abs(half - before) <= WIDE * half:
            return found
    return None


def _half(grid: _EdgeDenseGrid, found: _UnitStrip) -> float:
    """Return the half-width over that of similar bodies under the same load."""
    return math.sqrt(0.25 * math.pi / float(grid.weights @ found.pressure))


def _middle(grid: _EdgeDenseGrid, beta: float, found: _UnitStrip) -> float:
    """Return how far ahead of the axis the middle of the strip is, over its half-width."""
    sloped = grid.slope[0] @ found.pressure - 2.0 * beta * grid.mean[0] @ found.traction
    return float(sloped) - 0.5 * float(grid.nodes[0] + grid.nodes[1])
