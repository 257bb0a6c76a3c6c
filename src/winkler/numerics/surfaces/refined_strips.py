r"""Strips of contact side by side, refined from a first guess of their edges until pressure and edges are smooth.

Newton's method on the equations of `winkler.numerics.surfaces.strip_equations`: pressures are series of Chebyshev
polynomials of which as many terms are taken as their last ones vanish with.  What is found is examined: no pressure may
pull, no gap overlap, and the equations must hold between the places where they were met.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.fields.strip_potential import StripTerms
from winkler.numerics.surfaces.strip_equations import LineCurve, Spots, bare, equations, moved, nodes_of
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

FIRST_TERMS, MOST_TERMS, MOST_UNKNOWNS, MOST_LOADS = 12, 400, 2600, 12000
TAIL = 3e-13
"""Last terms of a series over the greatest term of all, that count as none."""
STEPS, SETTLED, LEFT = 40, 1e-13, 1e-9
"""Newton's steps; change of the edges over the half-width at which they end; what may be left of the equations, over
the greatest slope."""
LONGEST = 0.3
"""Longest step of an edge, over half the width of its strip or gap."""


class Examined(NamedTuple):
    """What was found when a contact was examined.

    Parameters
    ----------
    tension
        The greatest tension over the greatest pressure.
    overlap
        The greatest overlap over the greatest gap.
    residual
        How far the slope under the strips is from that of the profile, between the nodes, over the steepest.
    """

    tension: float
    overlap: float
    residual: float


def refined(
    curve: LineCurve, edges: Array, pinned: Array, force: float, *, tilt: float = 0.0, moment: float = math.nan
) -> Spots:
    """Return the strips.

    Parameters
    ----------
    curve
    edges
        First guess, (m, 2), in units of the contact's extent.
    pinned
        Whether edges are walls, (m, 2).
    force, moment
        2 P / E* and, if the tilt is free, 2 M / E*.
    tilt
        theta, or a first guess.

    Raises
    ------
    NotConverged
        If strips vanish or merge on the way, or need more terms than are computed with.
    """
    terms = [_terms(curve, start, end) for start, end in edges]
    while True:
        strips = tuple(
            StripTerms(start, end, np.zeros(count), corners=curve.inside(start, end))
            for (start, end), count in zip(edges.tolist(), terms, strict=True)
        )
        _affordable(curve, strips)
        spots = _begun(curve, Spots(strips, pinned, tilt), force, moment)
        spots = _newton(curve, spots, force, moment)
        most = max(max(float(np.max(np.abs(strip.series))), strip.force / strip.half) for strip in spots.strips)
        short = [float(np.max(np.abs(strip.series[-2:]))) > TAIL * most for strip in spots.strips]
        if not any(short) or all(2 * count > MOST_TERMS for count, longer in zip(terms, short, strict=True) if longer):
            return spots
        terms = [
            2 * count if longer and 2 * count <= MOST_TERMS else count
            for count, longer in zip(terms, short, strict=True)
        ]
        edges, tilt = np.array([[strip.start, strip.end] for strip in spots.strips]), spots.tilt


def _affordable(curve: LineCurve, strips: tuple[StripTerms, ...]) -> None:
    if sum(strip.series.size + 2 for strip in strips) > MOST_UNKNOWNS:
        raise NotConverged(f"{len(strips)} strips need more than {MOST_UNKNOWNS} numbers")
    if curve.below is not None and sum(curve.below.count(strip) for strip in strips) > MOST_LOADS:
        raise NotConverged(f"{len(strips)} strips on so thin layers need more than {MOST_LOADS} line loads")


def _terms(curve: LineCurve, start: float, end: float) -> int:
    """Return how many terms the slope of the profile needs on a strip, without corners."""
    count = FIRST_TERMS
    while 2 * count <= MOST_TERMS // 2:
        strip = StripTerms(start, end, np.zeros(count), corners=curve.inside(start, end))
        t = nodes_of(strip)
        slope = bare(curve, strip, t)
        order = np.arange(max(count - 3, 0), count + 1)
        last = 2.0 / t.size * np.cos(np.arccos(t)[None, :] * order[:, None]) @ slope
        if float(np.max(np.abs(last))) <= TAIL * float(np.max(np.abs(slope)) or 1.0):
            break
        count *= 2
    return count


def _begun(curve: LineCurve, spots: Spots, force: float, moment: float) -> Spots:
    """Return the pressures between the guessed edges, infinite there; what is infinite at free edges is left out."""
    held = spots._replace(pinned=np.ones(spots.pinned.shape, dtype=bool))
    left, slopes = equations(curve, held, force, moment)
    found = moved(curve, held, -_solution(slopes, left), not math.isnan(moment))
    strips = []
    for strip, (first, second) in zip(found.strips, spots.pinned, strict=True):
        s0, s1 = strip.walls
        on_left, on_right = 0.5 * (s0 - s1) * bool(first), 0.5 * (s0 + s1) * bool(second)
        strips.append(strip._replace(walls=(on_left + on_right, on_right - on_left)))
    return Spots(tuple(strips), spots.pinned, found.tilt)


def _solution(slopes: Array, left: Array) -> Array:
    try:
        return np.asarray(np.linalg.solve(slopes, left))
    except np.linalg.LinAlgError:
        raise NotConverged("the strips do not determine each other") from None


def _newton(curve: LineCurve, spots: Spots, force: float, moment: float) -> Spots:
    free = not math.isnan(moment)
    least, waited = math.inf, 0
    best = spots
    for _ in range(STEPS):
        left, slopes = equations(curve, spots, force, moment)
        error = float(np.max(np.abs(left)))
        if not math.isfinite(error):
            raise NotConverged("the strips fell apart")
        if error < least:
            best = spots
        waited = 0 if error < 0.5 * least else waited + 1
        least = min(error, least)
        step = -_solution(slopes, left)
        share = _share(spots, step)
        change = _edge_change(spots, step)
        spots = moved(curve, spots, share * step, free)
        if (share == 1.0 and change < SETTLED) or (waited > 2 and least <= LEFT * _steepest(curve, best)):
            break
    if least > LEFT * _steepest(curve, best):
        raise NotConverged(f"the edges of {len(spots.strips)} strips were not found")
    left, _ = equations(curve, spots, force, moment)
    return spots if float(np.max(np.abs(left))) <= least else best


def _steepest(curve: LineCurve, spots: Spots) -> float:
    slopes = [curve.slope(strip.middle + strip.half * nodes_of(strip)) - spots.tilt for strip in spots.strips]
    level = max(float(np.max(np.abs(slope))) for slope in slopes)
    return max(level, *(float(np.max(np.abs(strip.series))) for strip in spots.strips), *_walls(spots))


def _walls(spots: Spots) -> list[float]:
    return [abs(part) for strip in spots.strips for part in strip.walls]


def _edge_steps(spots: Spots, step: Array) -> Array:
    found, first = np.zeros((len(spots.strips), 2)), 0
    for j, strip in enumerate(spots.strips):
        first += strip.series.size
        found[j] = np.where(spots.pinned[j], 0.0, step[first : first + 2])
        first += 2
    return found


def _edge_change(spots: Spots, step: Array) -> float:
    halves = np.array([strip.half for strip in spots.strips])
    return float(np.max(np.abs(_edge_steps(spots, step)) / halves[:, None]))


def _share(spots: Spots, step: Array) -> float:
    """Return which part of a step leaves strips and gaps their widths."""
    change = np.abs(_edge_steps(spots, step))
    edges = np.array([[strip.start, strip.end] for strip in spots.strips])
    halves = 0.5 * np.diff(edges, axis=1)
    clearance = np.full(edges.shape, np.inf)
    between = 0.5 * (edges[1:, 0] - edges[:-1, 1])
    clearance[1:, 0], clearance[:-1, 1] = between, between
    allowed = LONGEST * np.minimum(halves, clearance)
    with np.errstate(divide="ignore", invalid="ignore"):
        shares = np.where(change > allowed, allowed / change, 1.0)
    return float(np.min(shares))


def gaps(curve: LineCurve, spots: Spots, x: Array) -> Array:
    """Return the distance of the deformed surfaces at places beside the strips."""
    reference = np.array([spots.strips[0].start])
    at = np.concatenate([reference, x])
    raised = np.asarray(sum(strip.raised(at) for strip in spots.strips))
    if curve.below is not None:
        loads = [curve.below.loads(strip) for strip in spots.strips]
        raised = raised + np.sum([curve.below.raised(at, one.places) @ one.loads for one in loads], axis=0)
    level = curve.height(at) - spots.tilt * at - raised
    return np.asarray(level[1:] - level[0])


def examined(curve: LineCurve, spots: Spots, places: Array) -> Examined:
    """Return how well a contact meets its conditions.

    Parameters
    ----------
    curve
    spots
    places
        At which gaps are examined where they lie beside the strips.
    """
    tension, most, residual, steepest = 0.0, 0.0, 0.0, _steepest(curve, spots)
    covered = np.zeros(places.shape, dtype=bool)
    below = [] if curve.below is None else [curve.below.loads(strip) for strip in spots.strips]
    for j, strip in enumerate(spots.strips):
        covered |= (places >= strip.start) & (places <= strip.end)
        t = np.cos(math.pi * (np.arange(2 * strip.series.size + 9) + 0.3) / (2 * strip.series.size + 9.0))
        x = strip.middle + strip.half * t
        own = strip.potential(x + 0.0j)
        pressure = -own.imag
        finite = np.isfinite(pressure)
        most = max(most, float(np.max(pressure[finite])))
        tension = max(tension, -float(np.min(pressure)))
        others = sum(
            (other.potential(x + 0.0j).real for i, other in enumerate(spots.strips) if i != j), np.zeros(x.shape)
        )
        slope = curve.slope(x) - spots.tilt - others - own.real
        if curve.below is not None:
            slope = slope - np.sum([curve.below.slope(x, one.places) @ one.loads for one in below], axis=0)
        residual = max(residual, float(np.max(np.abs(slope[finite]))))
    beside = places[~covered]
    apart = gaps(curve, spots, beside) if beside.size else np.zeros(1)
    wide = float(np.max(np.abs(curve.height(beside)), initial=0.0)) or 1.0
    return Examined(tension / (most or 1.0), max(0.0, -float(np.min(apart))) / wide, residual / (steepest or 1.0))
