r"""The frictionless curve of a bed as an impact runs through it: stiffness, force and energy over the depth.

:math:`K(d)=k(a(d))` is laid on panels that resolve it to rounding, and integrated twice,

.. math:: F(d) = \int_0^d K\,\mathrm d\gamma , \qquad W(d) = \int_0^d F\,\mathrm d\gamma .

All springs that share one gap :math:`\gamma=g(x)` touch and part together, so that sums over springs are moments of
:math:`\mathrm dK`:

.. math:: \int_0^d(d-\gamma)\,\mathrm dK = F, \qquad \int_0^d (d-\gamma)^2\,\mathrm dK = 2W .
"""

from __future__ import annotations

import functools
import math
from bisect import bisect_left, bisect_right
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.directional import DirectionalBed
from winkler.loading.loads import Depth
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.offers import PressedWaves, offers
from winkler.numerics.equations.roots import between, invert, rough_root
from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.types import Array, Curve
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.overlap import rises
from winkler.problems.normal.solve_contact import at_depth, at_end, flat_radius
from winkler.values.errors import NotConverged, OutsideValidity

DEPTH_MARGIN = 1e-3
"""How far beyond the greatest depth the curve is computed, for the trial steps of the march."""
SHALLOWER = 32.0
"""A curve is read down to this part of its depth: F and W are known to the rounding of their greatest values."""
SEARCH_FACTOR = 1.3
SEARCH_START = 1e-3
"""Part of the radius at which a power profile would store the energy, where a search begins."""
PANEL_TOLERANCES = ((1e-15, 128), (1e-13, 512))
"""Relative errors that are tried one after the other, with so many panels: g by quadrature is not exact to rounding."""
LAST_TOLERANCE = 1e-11


class NormalCurve(NamedTuple):
    """K, F and W of one bed, read at one depth after the other.

    Parameters
    ----------
    edges : list of float
        Ends of the panels [m].
    rows : list of ndarray, (degree + 3, 3)
        Chebyshev coefficients of K [N/m], F [N] and W [J] on every panel.
    orders : ndarray
        0, 1, 2 ...
    """

    edges: list[float]
    rows: list[Array]
    orders: Array

    def at(self, depth: float) -> tuple[float, float, float]:
        """Return K [N/m], F [N] and W [J] at a depth [m]; all zero before touch."""
        if depth < 0.0:
            return 0.0, 0.0, 0.0
        edges = self.edges
        panel = min(bisect_right(edges, depth), len(edges) - 1) - 1
        low, high = edges[panel], edges[panel + 1]
        t = (2.0 * depth - low - high) / (high - low)
        angle = math.acos(t) if -1.0 < t < 1.0 else (0.0 if t > 0.0 else math.pi)
        stiffness, force, work = (np.cos(angle * self.orders) @ self.rows[panel]).tolist()
        return stiffness, force, work

    def between(self, gap: float, stiffness: float, depth: float) -> tuple[float, float]:
        r"""Return the sums of d - gap [N] and of its square [J] over the springs from a gap to a depth.

        From K alone, which a narrow ring needs: over it F and W hardly differ from their tangents,

        .. math:: \int_c^d (K-K(c))\,\mathrm d\gamma , \qquad 2\int_c^d (d-\gamma)(K-K(c))\,\mathrm d\gamma .

        Parameters
        ----------
        gap, stiffness : float
            c [m], and K [N/m] there.
        depth : float
            d [m].
        """
        if depth <= gap:
            return 0.0, 0.0
        edges = self.edges
        first, last = bisect_right(edges, gap), bisect_left(edges, depth)
        if first == last and depth - gap <= NARROW * (edges[first] - edges[first - 1]):
            return self._within(first - 1, gap, stiffness, depth)
        cuts = [gap, *edges[first:last], depth]
        linear = square = 0.0
        for low, high in pairwise(cuts):
            middle, half = 0.5 * (low + high), 0.5 * (high - low)
            panel = min(max(bisect_right(edges, middle), 1), len(edges) - 1) - 1
            start, stop = edges[panel], edges[panel + 1]
            place = middle + half * GAUSS_POINTS
            t = np.minimum(np.maximum((2.0 * place - start - stop) / (stop - start), -1.0), 1.0)
            stiffnesses = np.cos(np.arccos(t)[:, None] * self.orders) @ self.rows[panel][:, 0]
            excess = half * GAUSS_WEIGHTS * (stiffnesses - stiffness)
            linear += float(excess.sum())
            square += 2.0 * float(excess @ (depth - place))
        return linear, square

    def _within(self, panel: int, gap: float, stiffness: float, depth: float) -> tuple[float, float]:
        """Return as `between` for a small part of a panel: by few points, one after the other, without arrays."""
        low, high = self.edges[panel], self.edges[panel + 1]
        row = self.rows[panel][:, 0].tolist()
        half, linear, square = 0.5 * (depth - gap), 0.0, 0.0
        for point, weight in FEW_POINTS:
            rest = half * (1.0 - point)
            t = (2.0 * (depth - rest) - low - high) / (high - low)
            above, above_that = 0.0, 0.0
            for coefficient in row[:0:-1]:
                above, above_that = coefficient + 2.0 * t * above - above_that, above
            excess = half * weight * (row[0] + t * above - above_that - stiffness)
            linear += excess
            square += 2.0 * excess * rest
        return linear, square


NARROW = 1.0 / 32.0
"""Part of a panel on which its polynomial is one of fifth order to rounding."""
FEW_POINTS = tuple(zip(*(each.tolist() for each in np.polynomial.legendre.leggauss(4)), strict=True))
"""Exact for polynomials of sixth order, times a straight line."""
GAUSS_POINTS, GAUSS_WEIGHTS = np.polynomial.legendre.leggauss(10)
"""Exact for the panels' polynomials, times a straight line."""


class NormalCurves:
    """K, F and W of one bed, each to a small part of itself, however little of the greatest depth is left.

    Parameters
    ----------
    bed : Bed
    depth : float
        The greatest depth [m].
    """

    def __init__(self, bed: Bed, depth: float) -> None:
        self.bed, self.depth = bed, depth
        self._curves = {0: normal_curve(bed, depth)}

    def _of(self, depth: float) -> NormalCurve:
        """Return the curve that was made for a depth [m]."""
        if depth * SHALLOWER >= self.depth or depth <= 0.0:
            return self._curves[0]
        return self.level(int(math.log(self.depth / depth) / math.log(SHALLOWER)))

    def level(self, number: int) -> NormalCurve:
        """Return the curve up to the greatest depth (0), or to 1/32 of that (1), 1/1024 (2) and so on."""
        if number not in self._curves:
            self._curves[number] = normal_curve(self.bed, self.depth * SHALLOWER**-number)
        return self._curves[number]

    def at(self, depth: float) -> tuple[float, float, float]:
        """Return as `NormalCurve.at`."""
        return self._of(depth).at(depth)

    def between(self, gap: float, stiffness: float, depth: float) -> tuple[float, float]:
        """Return as `NormalCurve.between`."""
        return self._of(depth).between(gap, stiffness, depth)


def normal_curve(bed: Bed, depth: float) -> NormalCurve:
    """Return the curve of a bed up to a depth [m] and a little beyond.

    K is laid to rounding where the bed's g is; to 1e-13 or 1e-11 of its greatest value where g itself is no better.

    Raises
    ------
    OutsideValidity
        If a contact along the path is no disc.
    NotConverged
        If the profile is too rough.
    """
    return _normal_curve(bed.pressed if isinstance(bed, DirectionalBed) else bed, depth)


@functools.lru_cache(maxsize=32)
def _normal_curve(bed: Bed, depth: float) -> NormalCurve:
    """Return the curve; the histories of a bed share it."""
    end = _limit(bed)
    last = min(depth * (1.0 + DEPTH_MARGIN), end)
    kinks = np.array([b for b, _ in bed.kinks if b < min(bed.reach, bed.rim)])
    breaks = bed.gap(kinks) if kinks.size else kinks
    if math.isfinite(bed.rim) and bed.rim <= bed.reach:
        breaks = np.append(breaks, at_end(bed)[0])
    inner = breaks[(breaks > 1e-12 * last) & (breaks < (1.0 - 1e-12) * last)]
    edges = np.unique(np.concatenate([[0.0], inner, [last]]))

    widest = float(at_depth(bed, np.array([last]))[1][0])

    def stiffness(depths: Array) -> Array:
        return np.asarray(bed.stiffness(_radii(bed, depths.ravel(), widest).reshape(depths.shape)))

    greatest = float(stiffness(np.array([last]))[0])
    first = _panels(stiffness, edges, greatest)
    second = first.integral
    third = second.integral
    count = third.coefficients.shape[1]
    rows = [
        np.stack([np.pad(each, (0, count - each.size)) for each in (one, two, three)], axis=1)
        for one, two, three in zip(first.coefficients, second.coefficients, third.coefficients, strict=True)
    ]
    return NormalCurve(first.edges.tolist(), rows, np.arange(count, dtype=float))


def _radii(bed: Bed, depths: Array, widest: float) -> Array:
    """Return the contact radii at depths that are not beyond that of the widest contact, which is known to be a disc.

    Where g rises up to its edge the smaller contacts are discs as well, and need not be checked one by one.
    """
    if bed.rising or widest == 0.0 or not (isinstance(bed.medium, HomogeneousMedium) and rises(bed, widest)):
        return at_depth(bed, depths)[1]
    radii = np.zeros(depths.shape)
    met = depths >= float(bed.gap(np.array([widest]))[0])
    radii[met] = widest
    free = (depths > 0.0) & ~met
    flat = flat_radius(bed)
    if free.any():
        radii[free] = invert(
            lambda a: (bed.gap(a), bed.gap_slope(a)),
            depths[free],
            lower=flat,
            upper=widest,
            guess=0.5 * (flat + widest),
        )
    return radii


def _panels(stiffness: Curve, edges: Array, greatest: float) -> Panels:
    """Return the stiffness on panels, to rounding or as well as its own errors allow."""
    for tolerance, most in PANEL_TOLERANCES:
        try:
            return fit_panels(stiffness, edges, tolerance * greatest, most)
        except NotConverged:
            continue
    return fit_panels(stiffness, edges, LAST_TOLERANCE * greatest)


def _limit(bed: Bed) -> float:
    """Return the depth beyond which nothing is known of the bed [m]."""
    if math.isfinite(bed.rim) and bed.rim <= bed.reach:
        return math.inf
    return at_end(bed)[0]


def deepest(bed: Bed, energy: float) -> float:
    """Return the depth at which a bed has stored an energy [J].

    Raises
    ------
    OutsideValidity
        If the profile ends before.
    """
    end = _limit(bed)

    def excess(depth: float) -> float:
        return float(Indentation(bed, Depth(depth)).solve().energy) / energy - 1.0

    if math.isfinite(end) and excess(end) < 0.0:
        raise OutsideValidity(
            f"Impact: {energy:.6g} J press the body beyond its reach ({bed.reach:.6g} m, reached at a depth of "
            f"{end:.6g} m); describe more of the profile, or give a slower or lighter body."
        )
    low = high = min(rough_depth(bed, energy), end)
    while excess(low) > 0.0:
        low /= SEARCH_FACTOR
    while high < end and excess(high) < 0.0:  # with small steps: what is pressed far too deep may be no disc
        high = min(SEARCH_FACTOR * high, end)
    return between(excess, low, high, relative=1e-14)


HALVINGS, ENERGY_FACTOR = 60, 1e3
"""How often, and above which multiple of an energy, a depth is sought again."""


def rough_depth(bed: Bed, energy: float) -> float:
    """Return a depth [m] of the order of that at which a bed has stored an energy [J]."""
    end = min(bed.reach, bed.rim)

    def stored(radius: Array) -> Array:
        gap = bed.gap(radius)
        return np.asarray(0.4 * (bed.stiffness(radius) * gap - bed.gap_load(radius)) * gap)

    # from the thickness on: discs of another order may be out of reach of the tables of a layer, and cost time
    unit = bed.medium.thickness if offers(bed.medium, PressedWaves) else 1.0
    start = 1e-6 * end if math.isfinite(end) else SEARCH_START * unit * rough_root(lambda x: stored(unit * x), energy)
    radius = np.array([start])
    low = np.zeros(1)
    while radius[0] < end and float(stored(radius)[0]) < energy:
        low, radius = radius, np.minimum(2.0 * radius, end)
    for _ in range(HALVINGS):  # beside a flat part, where it begins to rise, twice as wide may be very much deeper
        if float(stored(0.999 * radius)[0]) <= ENERGY_FACTOR * energy:  # at the end itself a gap may be infinite
            break
        middle = 0.5 * (low + radius)
        low, radius = (low, middle) if float(stored(middle)[0]) >= energy else (middle, radius)
    depth = float(bed.gap(radius if float(bed.gap(0.999 * radius)[0]) == 0.0 else 0.999 * radius)[0])
    if radius[0] == bed.rim:
        depth += math.sqrt(2.0 * energy / float(bed.stiffness(radius)[0]))
    return depth
