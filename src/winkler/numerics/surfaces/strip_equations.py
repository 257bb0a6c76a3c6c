r"""The equations of strips of contact side by side, whose edges are unknown, and their derivatives.

With the potentials of `winkler.numerics.fields.strip_potential` they are, for lengths over the contact's and E* = 2,

.. math:: f'(x) - \theta = \Re\sum_jF_j(x) \quad\text{on the strips,} \qquad
          \Big[f-\theta x-\int\Re\sum_jF_j\Big]_{b_i}^{a_{i+1}} = 0 , \qquad \int d = P \;(, \int d\,x = M) ,

at one Chebyshev node more than the series of a strip has terms: a strip with two free edges has as many equations as
unknowns, series and edges.  An edge at a wall stays where it is; its infinite pressure is unknown instead.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.fields.strip_potential import StripTerms, in_circle, powers
from winkler.numerics.fields.strips_below import Below, loads_of
from winkler.numerics.types import Array, Curve

DIFFERENCE = 1e-6
"""Step of the numerical derivatives by the edges, over the half-width."""


class LineCurve(NamedTuple):
    """A two-dimensional profile, as the equations take it.

    Parameters
    ----------
    height, slope
        f and f', at corners that on the right.
    corners
        (place, jump of the slope, jump of the curvature), (k, 3).
    below
        The layers below the surface; none of a half-plane.
    """

    height: Curve
    slope: Curve
    corners: Array
    below: Below | None = None

    def inside(self, start: float, end: float) -> Array:
        """Return the corners between two places."""
        return np.asarray(self.corners[(self.corners[:, 0] > start) & (self.corners[:, 0] < end)])


class Spots(NamedTuple):
    """All strips under one load.

    Parameters
    ----------
    strips
        From left to right.
    pinned
        Whether the left and the right edge of each strip is a wall, (m, 2).
    tilt
        theta.
    """

    strips: tuple[StripTerms, ...]
    pinned: Array
    tilt: float


def nodes_of(strip: StripTerms) -> Array:
    """Return the places t at which the equations of a strip are met."""
    count = strip.series.size + 1
    return np.cos(math.pi * (np.arange(count) + 0.5) / count)


def bare(curve: LineCurve, strip: StripTerms, t: Array) -> Array:
    """Return f' less the jumps of the corners, and less what these bend beside them."""
    x = strip.middle + strip.half * t
    smooth = curve.slope(x) - strip.polynomial(x)
    for place, jump, bend in strip.corners:
        smooth = smooth - np.where(x >= place, jump + bend * (x - place), 0.0)
    return np.asarray(smooth)


def _with_edges(curve: LineCurve, strip: StripTerms, start: float, end: float) -> StripTerms:
    return strip._replace(start=start, end=end, corners=curve.inside(start, end))


def equations(curve: LineCurve, spots: Spots, force: float, moment: float) -> tuple[Array, Array]:
    """Return what is left of the equations and their derivatives by the unknowns.

    Parameters
    ----------
    curve
    spots
    force
        2 P / E*.
    moment
        2 M / E*; NaN where the tilt is prescribed.

    Returns
    -------
    left : ndarray, (u,)
    slopes : ndarray, (u, u)
        Unknowns: of each strip the series, the left and the right edge (or wall), last the tilt if it is free.
    """
    strips, free = spots.strips, not math.isnan(moment)
    m = len(strips)
    nodes = [nodes_of(strip) for strip in strips]
    rows = np.cumsum([0, *(t.size for t in nodes)])
    columns = np.cumsum([0, *(strip.series.size + 2 for strip in strips)])
    places = np.concatenate([strip.middle + strip.half * t for strip, t in zip(strips, nodes, strict=True)])
    edges = np.array([[strip.start, strip.end] for strip in strips])
    size = int(columns[-1]) + free
    left, slopes = np.zeros(size), np.zeros((size, size))
    heights = curve.height(edges) - spots.tilt * edges
    by_edge = np.zeros((2 * m, size))  # of the heights at the edges
    bent, steeper = np.zeros(places.size), np.zeros(places.size)  # by all other strips
    beside = curve.slope(edges) - spots.tilt  # slope of the heights at the edges, without the strip's own part
    last, balance = int(rows[-1]), int(rows[-1]) + m - 1
    for j, strip in enumerate(strips):
        mine, first = slice(int(rows[j]), int(rows[j + 1])), int(columns[j])
        count, t, h = strip.series.size, nodes[j], strip.half
        others = np.delete(np.arange(places.size), mine)
        far = places[others] + 0.0j
        at_edges = edges.copy()
        old, old_heights = strip.potential(far).real, strip.raised(edges)
        heights -= old_heights
        bent[others] += old
        steeper[others] += strip.gradient(far).real
        foreign = np.arange(m) != j
        beside[foreign] -= strip.potential(edges[foreign] + 0.0j).real
        _, w, _ = in_circle((far - strip.middle) / h)
        slopes[others, first : first + count] = -powers(w, count).real
        slopes[mine, first : first + count] = -np.cos(np.arccos(t)[:, None] * np.arange(1, count + 1))
        by_edge[:, first : first + count] = -h * _raised_powers(strip, edges.ravel(), count)
        slopes[balance, first] = 0.5 * math.pi * h
        if free:
            slopes[balance + 1, first : first + min(count, 2)] = [
                0.5 * math.pi * h * strip.middle, 0.25 * math.pi * h**2
            ][: min(count, 2)]  # fmt: skip
        left[mine] = bare(curve, strip, t) - spots.tilt + strip.walls[1]
        left[mine] -= np.cos(np.arccos(t)[:, None] * np.arange(1, count + 1)) @ strip.series
        for side in (0, 1):
            column = first + count + side
            if spots.pinned[j, side]:
                unit = StripTerms(strip.start, strip.end, np.zeros(1), (1.0, 2.0 * side - 1.0))
                slopes[others, column] = -unit.potential(far).real
                slopes[mine, column] = unit.walls[1]
                by_edge[:, column] = -unit.raised(edges).ravel()
                slopes[balance, column] = unit.force
                if free:
                    slopes[balance + 1, column] = unit.moment
                continue
            step = DIFFERENCE * h
            pair = []
            for sign in (1.0, -1.0):
                ends = edges[j].copy()
                ends[side] += sign * step
                new = _with_edges(curve, strip, *ends)
                at_edges[j] = ends
                pair.append((new.potential(far).real, bare(curve, new, t), new.raised(at_edges), new.force, new.moment))
            source, own, raised, pushed, turned = (
                (one - other) / (2.0 * step) for one, other in zip(*pair, strict=True)
            )
            slopes[others, column] -= source
            slopes[mine, column] += own
            by_edge[:, column] -= raised.ravel()
            slopes[balance, column] = pushed
            if free:
                slopes[balance + 1, column] = turned
    if curve.below is not None:
        bent, steeper, beside, heights = (
            one + other
            for one, other in zip(
                (bent, steeper, beside, heights),
                _of_layers(curve, spots, curve.below, places, edges, columns, slopes[:last], by_edge),
                strict=True,
            )
        )
    left[:last] -= bent
    for j in range(m):  # the places move with the edges
        mine, first = slice(int(rows[j]), int(rows[j + 1])), int(columns[j]) + strips[j].series.size
        for side, sign in ((0, -1.0), (1, 1.0)):
            if not spots.pinned[j, side]:
                slopes[mine, first + side] -= steeper[mine] * 0.5 * (1.0 + sign * nodes[j])
                by_edge[2 * j + side, first + side] += beside[j, side]
    left[last:balance] = heights[1:, 0] - heights[:-1, 1]
    slopes[last:balance] = by_edge[2::2] - by_edge[1:-1:2]
    left[balance] = sum(strip.force for strip in strips) - force
    if free:
        left[balance + 1] = sum(strip.moment for strip in strips) - moment
        slopes[:last, -1] = -1.0
        slopes[last:balance, -1] = edges[:-1, 1] - edges[1:, 0]
    return left, slopes


def _of_layers(
    curve: LineCurve,
    spots: Spots,
    below: Below,
    places: Array,
    edges: Array,
    columns: Array,
    slopes: Array,
    by_edge: Array,
) -> tuple[Array, Array, Array, Array]:
    """Add the layers to the derivatives; return their slopes, the slopes of these, and slopes and heights at edges."""
    ends, bent, steeper = edges.ravel(), np.zeros(places.size), np.zeros(places.size)
    beside, raised = np.zeros(ends.size), np.zeros(ends.size)
    for j, strip in enumerate(spots.strips):
        first, count = int(columns[j]), strip.series.size
        loads = below.loads(strip)
        t = (loads.places - strip.middle) / strip.half
        slope, curvature = below.slope(places, loads.places), below.curvature(places, loads.places)
        at_ends, sunk = below.slope(ends, loads.places), below.raised(ends, loads.places)
        bent += slope @ loads.loads
        steeper += curvature @ loads.loads
        beside -= at_ends @ loads.loads
        raised -= sunk @ loads.loads
        angle = np.arccos(t)
        changed = np.zeros((t.size, count + 2))  # line loads by the unknowns
        changed[:, :count] = (
            np.sin(np.outer(angle, np.arange(1, count + 1))) * (np.sin(angle) * math.pi * strip.half / t.size)[:, None]
        )
        for side, sign in ((0, -1.0), (1, 1.0)):
            if spots.pinned[j, side]:
                changed[:, count + side] = math.pi * strip.half / t.size * (1.0 + sign * t)
                continue
            step = DIFFERENCE * strip.half
            wider, narrower = (
                loads_of(_with_edges(curve, strip, *(edges[j] + move)), t.size).loads
                for move in (step * np.eye(2)[side], -step * np.eye(2)[side])
            )
            changed[:, count + side] = (wider - narrower) / (2.0 * step)
            moved_loads = 0.5 * (1.0 + sign * t) * loads.loads  # with the places on the strip
            slopes[:, first + count + side] += curvature @ moved_loads
            by_edge[:, first + count + side] += at_ends @ moved_loads
        slopes[:, first : first + count + 2] -= slope @ changed
        by_edge[:, first : first + count + 2] -= sunk @ changed
    return bent, steeper, beside.reshape(edges.shape), raised.reshape(edges.shape)


def _raised_powers(strip: StripTerms, x: Array, count: int) -> Array:
    """Return the integrals of w, w^2, ... over z at places beside the strip or at its edges, in columns."""
    _, w, _ = in_circle((x - strip.middle) / strip.half + 0.0j)
    w = w.real
    power = powers(w, count + 1)
    order = np.arange(2.0, count + 1.0)
    found = np.empty((x.size, count))
    found[:, 0] = 0.25 * w**2 - 0.5 * np.log(np.abs(w))
    found[:, 1:] = power[:, 2:] / (2.0 * (order + 1.0)) - power[:, : count - 1] / (2.0 * (order - 1.0))
    return found


def moved(curve: LineCurve, spots: Spots, step: Array, free: bool) -> Spots:
    """Return the strips after a step of all unknowns."""
    strips, first = [], 0
    for strip, pinned in zip(spots.strips, spots.pinned, strict=True):
        count = strip.series.size
        series = strip.series + step[first : first + count]
        ends, walls = [strip.start, strip.end], list(strip.walls)
        for side in (0, 1):
            change = float(step[first + count + side])
            if pinned[side]:
                walls = [walls[0] + change, walls[1] + change * (2 * side - 1)]
            else:
                ends[side] += change
        changed = strip._replace(series=series, walls=(walls[0], walls[1]))
        strips.append(_with_edges(curve, changed, *ends))
        first += count + 2
    return Spots(tuple(strips), spots.pinned, spots.tilt + (float(step[-1]) if free else 0.0))
