r"""A line of springs that rolls steadily: where they stick and where they slide, spring after spring.

A spring enters unstrained at the leading edge and, while it sticks, gains :math:`\kappa` of line load per distance
rolled.  It never bears more than its bound :math:`b(x)=\mu c_N(d-g)`, so that

.. math:: q_x(x) = \min_{x\le y\le a}\,\bigl[q_x^0(y) + \kappa\,(y-x)\bigr],\qquad q_x^0 = b,\quad q_x^0(a)=0 .

Which springs begin and cease to slide is determined on sampled springs; the places are then refined, and the force is
summed in closed form over the pieces.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.equations.bracketing import between
from winkler.numerics.integrals.bisected_quadrature import towards
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array
from winkler.problems.normal.indentation import IndentationSolution
from winkler.values.value import value, words

SAMPLES = 256
"""Springs on half of the line by which sliding is noticed, evenly spaced."""
EDGE_HALVINGS = 40
"""And how often more of them halve the distance from the edge."""
PLACES, STRIPS, NODES = 96, 129, 32
"""Places of the pressure on a radius, strips of half a contact whose load is summed, and nodes across each."""
TINY = 1e-12
BLOCK = 256
"""How many creepages are computed together."""


class StickZones(NamedTuple):
    """Pieces of the line that stick, of all creepages together; each array ``(pieces,)``.

    Parameters
    ----------
    creepage
        Which creepage a piece belongs to.
    front, back
        Where it begins, measured from the leading edge, and where it ends [m].
    load
        Line load at its front [N/m].
    """

    creepage: Array
    front: Array
    back: Array
    load: Array


class SpringLoad(NamedTuple):
    """q_z = c_N (d - g) of springs on a homogeneous medium."""

    contact: IndentationSolution[float]

    def load(self, x: Array) -> Array:
        """Return q_z [N/m] at 0 <= x <= a."""
        bed, pressed, a = self.contact.problem.bed, self.contact.pressed, float(self.contact.radius)
        rim = float(bed.normal_stiffness(np.array([a]))[0] * max(pressed.edge, 0.0))
        return np.asarray(np.where(x >= a, rim, bed.normal_stiffness(x) * np.maximum(pressed.value(x), 0.0)))

    def before(self, x: Array) -> Array:
        """Return its integral from 0 to x [N]."""
        bed = self.contact.problem.bed
        return np.asarray(0.5 * (bed.stiffness(x) * float(self.contact.depth) - bed.gap_load(x)))

    def slope(self, x: Array) -> Array:
        """Return q_z' [Pa]."""
        bed = self.contact.problem.bed
        return np.asarray(-bed.normal_stiffness(x) * bed.gap_slope(x))


class StripLoad(NamedTuple):
    """q_z of strips across the rolling, of a pressure: splines over the angle, x = a sin(angle)."""

    radius: float
    loads: Any
    sums: Any

    def _angle(self, x: Array) -> Array:
        return np.asarray(np.arcsin(np.minimum(x / self.radius, 1.0)))

    def load(self, x: Array) -> Array:
        """Return q_z [N/m] at 0 <= x <= a."""
        return np.asarray(np.maximum(self.loads(self._angle(x)), 0.0))

    def before(self, x: Array) -> Array:
        """Return its integral from 0 to x [N]."""
        return np.asarray(self.sums(self._angle(x)))

    def slope(self, x: Array) -> Array:
        """Return q_z' [Pa], for x < a."""
        angle = self._angle(x)
        return np.asarray(self.loads(angle, 1) / (self.radius * np.maximum(np.cos(angle), TINY)))


def strip_load(contact: IndentationSolution[float]) -> StripLoad:
    """Return what strips of a contact bear, on any medium: the integral of its pressure across the rolling.

    Over the angle of r = a sin(angle), p cos(angle) is smooth and even about both ends, whether the edge is.
    """
    from scipy.interpolate import CubicSpline

    a, medium = float(contact.radius), contact.problem.bed.medium
    angle = 0.5 * np.pi * (np.arange(PLACES) + 0.5) / PLACES
    even = medium.pressure(contact.pressed, a * np.sin(angle)) * np.cos(angle)
    pressure = CubicSpline(
        np.concatenate([-angle[::-1], angle, np.pi - angle[::-1]]), np.concatenate([even[::-1], even, even[::-1]])
    )
    angle = np.linspace(0.0, 0.5 * np.pi, STRIPS)
    aside, weight = gauss_legendre(NODES)
    share = np.cos(angle)[:, None] * np.cos(0.5 * np.pi * aside)
    load = np.pi * a * (pressure(np.arccos(share)) @ weight)
    sums = CubicSpline(angle, load * a * np.cos(angle)).antiderivative()
    return StripLoad(a, CubicSpline(angle, load, bc_type=("not-a-knot", "clamped")), sums)


@value
class RollingLine:
    """The springs of one pressed contact, rolling along +x.

    Parameters
    ----------
    coefficient : float
        mu [-].
    contact : IndentationSolution
        The contact under its normal load, one number.
    """

    __words__ = words(most=(r"\mu F_N", "N", "shear force from which all springs slide"))

    coefficient: float
    contact: IndentationSolution[float]

    @property
    def radius(self) -> float:
        """The contact radius a [m]."""
        return float(self.contact.radius)

    @property
    def most(self) -> float:
        """The sliding force mu F_N [N]."""
        return self.coefficient * float(self.contact.force)

    @functools.cached_property
    def _load(self) -> SpringLoad | StripLoad:
        homogeneous = isinstance(self.contact.problem.bed.medium, HomogeneousMedium)
        return SpringLoad(self.contact) if homogeneous else strip_load(self.contact)

    def bound(self, x: Array) -> Array:
        """Return mu q_z [N/m] at places within the contact [m]."""
        return np.asarray(self.coefficient * self._load.load(np.abs(x)))

    def _bound_before(self, x: Array) -> Array:
        """Return the force that springs between the axis and x can bear [N], odd in x."""
        return np.asarray(self.coefficient * np.sign(x) * self._load.before(np.abs(x)))

    def bearing(self, inner: Array, outer: Array) -> Array:
        """Return the force that springs between two places [m] can bear [N], either side of the axis."""
        return np.asarray(self._bound_before(outer) - self._bound_before(inner))

    @property
    def _places(self) -> Array:
        """Sampled springs [m], from the leading edge to the trailing one."""
        a = self.radius
        near = towards(a, [b for b, _ in self.contact.problem.bed.kinks], EDGE_HALVINGS)
        half = np.union1d(near, a * np.linspace(0.0, 1.0, SAMPLES + 1))
        return np.concatenate([half[::-1], -half[1:]])

    def sticking(self, rate: Array) -> StickZones:
        """Return the pieces that stick.

        Parameters
        ----------
        rate : ndarray, (m,)
            kappa [Pa]: how much line load a sticking spring gains per distance rolled, not negative.
        """
        x = self._places
        bound = self.bound(x)
        roots = [
            self._refined(rate, begin + which, front, back, x, bound)
            for begin in range(0, rate.size, BLOCK)
            for which, front, back in self._sampled(rate[begin : begin + BLOCK], x, bound)
        ]
        return StickZones(*(np.concatenate(part) for part in zip(*roots, strict=True)))

    def _sampled(self, rate: Array, x: Array, bound: Array) -> Iterator[tuple[Array, Array, Array]]:
        """Yield creepage, last spring that slides before a sticking piece (or the edge), first that slides after it."""
        reduced = bound + rate[:, None] * x
        reduced[:, 0] = rate * x[0]
        slides = np.minimum.accumulate(reduced, axis=1) == reduced
        changes = np.diff(slides.astype(np.int8), axis=1)
        which, front = np.nonzero(changes == -1)
        ends = np.where(changes == 1, np.arange(1, x.size), x.size)
        nearest = np.minimum.accumulate(ends[:, ::-1], axis=1)[:, ::-1]
        yield which, front, nearest[which, front]

    def _refined(self, rate: Array, which: Array, front: Array, back: Array, x: Array, bound: Array) -> StickZones:
        """Return the pieces with their ends where they are, not where the next sampled spring is."""
        kappa = rate[which]
        start, load = x[front], np.where(front == 0, 0.0, bound[front])
        inner = np.flatnonzero(front > 0)
        if inner.size:
            ahead, behind = x[front[inner] - 1], x[front[inner] + 1]

            def falls(place: Array, index: Array) -> Array:
                slope = self.coefficient * np.sign(place) * self._load.slope(np.abs(place))
                return np.asarray(kappa[inner[index]] + slope)

            every = np.arange(inner.size)
            turns = falls(ahead, every) * falls(behind, every) < 0.0
            some = np.flatnonzero(turns)
            if some.size:
                place = between(lambda p, index: falls(p, some[index]), ahead[some], behind[some])
                better = self.bound(place) + kappa[inner[some]] * place < (load + kappa * start)[inner[some]]
                chosen = inner[some[better]]
                start[chosen], load[chosen] = place[better], self.bound(place[better])
        end = np.full(which.size, x[-1])
        slid = np.flatnonzero(back < x.size)

        def spare(place: Array, index: Array) -> Array:
            this = slid[index]
            return np.asarray(self.bound(place) - load[this] - kappa[this] * (start[this] - place))

        if slid.size:
            before, behind, every = x[back[slid] - 1], x[back[slid]], np.arange(slid.size)
            left, missing = spare(before, every), spare(behind, every)
            # a sampled spring may be the very one that begins to slide, and rounding may put it on either side
            end[slid] = np.where(np.abs(left) < np.abs(missing), before, behind)
            crossed = np.flatnonzero((left > 0.0) & (missing < 0.0))
            if crossed.size:
                end[slid[crossed]] = between(
                    lambda place, index: spare(place, crossed[index]), before[crossed], behind[crossed]
                )
        return StickZones(which, start, np.minimum(end, start), load)

    def force(self, rate: Array, pieces: StickZones) -> Array:
        """Return the force of the springs along the line [N], ``(m,)``."""
        width = pieces.front - pieces.back
        stuck = width * (pieces.load + 0.5 * rate[pieces.creepage] * width)
        spared = self._bound_before(pieces.front) - self._bound_before(pieces.back) - stuck
        return np.asarray(self.most - np.bincount(pieces.creepage, spared, rate.size))

    def stick_share(self, rate: Array, pieces: StickZones) -> Array:
        """Return the part of the line that sticks [-], ``(m,)``."""
        width = (pieces.front - pieces.back) / (2.0 * self.radius)
        return np.asarray(np.bincount(pieces.creepage, width, rate.size))

    def shear_load(self, rate: float, x: Array) -> Array:
        """Return q_x [N/m] at places within the contact [m], of one creepage."""
        pieces = self.sticking(np.array([rate]))
        load = self.bound(x)
        for front, back, start in zip(pieces.front, pieces.back, pieces.load, strict=True):
            load = np.where((x <= front) & (x >= back), start + rate * (front - x), load)
        return np.asarray(np.where(np.abs(x) <= self.radius, load, 0.0))
