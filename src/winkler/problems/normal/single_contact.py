r"""Is the contact one disc?  Contacts that are one disc are computed, others refused.

A disc is accepted only if the restored pressure is nowhere tensile and the bodies do not overlap outside.  Both
are sums over flat punches of radius x, which press with p1 and move the surface by u1,

.. math:: p(r) = \int_r^a p_1(r;x)\,g'(x)\,\mathrm dx , \qquad
          s(r) = \int_a^r (1 - u_1(r;x))\,g'(x)\,\mathrm dx ,

so that a g which never falls suffices where no flat punch pulls or sinks the surface farther than itself: on every
homogeneous or power-law half-space, and on layers as far as `winkler.media.medium.PunchFacts` states it.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Hashable
from typing import cast

import numpy as np

from winkler.errors import NotConverged, OutsideValidity
from winkler.foundation.bed import Bed, PressedSprings
from winkler.foundation.plane import PlaneFoundation
from winkler.media.medium import LEAST_SURFACE_RISE
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array

__all__ = [
    "MOST_TURNING_POINTS",
    "RISING_SAMPLES",
    "SLOPE_ROUNDING",
    "SLOPE_SAMPLES",
    "ended",
    "falling_kinks",
    "pulls",
    "refuse_overlap",
    "refuse_tension",
    "refuse_unless_disc",
    "rises",
    "surely_pressed",
    "too_many",
    "unfinished",
]

SLOPE_SAMPLES = 4096
"""How finely g' is searched for changes of sign; narrower waves are left out."""
RISING_SAMPLES = 1024
"""The same for bodies whose homogeneous g is known to rise."""
OVERLAP_DISTANCE = 1e6
"""How many contact radii away overlap is sought."""
MOST_TURNING_POINTS = 400
"""More turning points than this cannot be distinguished by the samples."""
SLOPE_ROUNDING = 1e-9
"""A slope of g below zero by this part of the steepest is rounding."""
QUICK_NODES = 24
CLEAR_PRESSURE = 1e-2
"""A pressure this far from zero, against the greatest, is trusted to one quick rule; both without their root."""


def too_many(end: float) -> str:
    """Return why a g that turns too often within `end` [m] is refused."""
    return (
        f"g(x) turns more than {MOST_TURNING_POINTS} times within {end:.3g} m; so many waves cannot be one contact: "
        "give a smaller load, or treat the body as rough."
    )


def rises(bed: Bed, radius: float) -> bool:
    """Return whether g never falls up to a radius; sought where it is not known."""
    if bed.certain or radius == 0.0:
        return True
    slope = bed.gap_slope(np.arange(1, RISING_SAMPLES) / RISING_SAMPLES * radius)
    return not (np.any(slope < -SLOPE_ROUNDING * np.max(slope[np.isfinite(slope)])) or falling_kinks(bed, radius))


def falling_kinks(bed: Bed, radius: float) -> list[float]:
    """Return the places within a radius at which g' drops."""
    return [b for b, strength in bed.kinks if strength < 0.0 and b < radius]


def refuse_unless_disc(bed: Bed, depth: float, radius: float, end: float) -> None:
    """Raise `OutsideValidity` if a disc of this radius would pull or overlap."""
    if radius == 0.0:
        return
    ended(lambda: refuse_tension(bed, depth, radius))
    ended(lambda: refuse_overlap(bed, depth, radius, end))


def ended(check: Callable[[], bool | None]) -> bool:
    """Return the result of a check, or true if it does not come to an end."""
    try:
        return bool(check())
    except NotConverged:
        return True


def pulls(bed: Bed, radius: float) -> bool:
    """Return whether a flat punch up to a radius pulls somewhere."""
    return bed.medium.punch_facts(radius).pulls


def unfinished(bed: Bed, depth: float, radius: float) -> str:
    """Return why the checks of a contact did not come to an end, or nothing if they did."""
    return _unfinished(cast(Hashable, bed), depth, radius)


@functools.lru_cache(maxsize=64)
def _unfinished(bed_key: Hashable, depth: float, radius: float) -> str:
    bed = cast(Bed, bed_key)
    end = min(bed.reach, bed.rim)
    try:
        if bed.medium.punch_facts(radius).pulls and not surely_pressed(bed, np.array([depth]), np.array([radius]))[0]:
            refuse_tension(bed, depth, radius)
        refuse_overlap(bed, depth, radius, end)
    except NotConverged as error:
        return str(error)
    except OutsideValidity:  # of a contact that is computed nevertheless
        pass
    return ""


def refuse_overlap(bed: Bed, depth: float, radius: float, end: float) -> None:
    """Raise `OutsideValidity` if the bodies would overlap outside a disc of this radius."""
    if _clear_outside(bed, depth, radius, end):
        return
    # far outside heights may overflow: what is infinitely high does not overlap
    with np.errstate(over="ignore", invalid="ignore"):
        r = _where_it_may_overlap(bed, depth, radius, end)
    if not r.size:
        return
    separation = bed.height(r) - depth + bed.medium.displacement(PressedSprings(bed, depth, radius), r)
    if not np.all(np.isfinite(separation)):
        raise NotConverged("The separation outside the contact could not be computed.")
    overlap = separation < -1e-9 * depth
    if overlap.any():
        place = float(np.min(r[overlap]))
        raise OutsideValidity(
            f"At depth {depth:.6g} m the bodies would overlap outside the contact, at r = {place:.6g} m: there the "
            f"contact has begun as a ring around the disc of {radius:.6g} m; give a smaller load."
        )


def refuse_tension(bed: Bed, depth: float, radius: float) -> None:
    """Raise `OutsideValidity` if a disc of this radius would have to pull somewhere."""
    slope = bed.gap_slope(np.linspace(0.0, 1.0, SLOPE_SAMPLES + 1)[1:-1] * radius)
    falling = falling_kinks(bed, radius)
    pulling = bed.medium.punch_facts(radius).pulls
    if not (falling or pulling or np.any(slope < 0.0)):
        return
    turns = int(np.count_nonzero(np.diff(np.sign(slope))))
    if turns > MOST_TURNING_POINTS:
        raise OutsideValidity(too_many(radius))
    count = 400 + 4 * turns
    r = (np.arange(count) + 0.5) / count * radius
    # beside a kink where the slope drops the pressure falls logarithmically: a gap narrower than this is of no account
    beside = [b * (1.0 + side * 10.0**-k) for b in falling for side in (-1.0, 1.0) for k in range(2, 9)]
    r = np.concatenate([r, [place for place in beside if 0.0 < place < radius]])
    if pulling:  # a thin coating pulls close to the edge
        r = np.concatenate([r, radius * (1.0 - np.geomspace(1e-5, 1e-2, 49))])
    pressure = bed.medium.pressure(PressedSprings(bed, depth, radius), r)
    if np.min(pressure) < -1e-9 * np.max(np.abs(pressure[np.isfinite(pressure)])):
        place = r[np.argmin(pressure)]
        cause = (
            "the true contact has a gap there; the profile is too concave or wavy for this load"
            if bed.medium.punch_facts(radius).gives_separation
            else "the layers bend away from the body there; give another load, or a softer or thicker coating"
        )
        raise OutsideValidity(
            f"At depth {depth:.6g} m a round contact of {radius:.6g} m would need tension at r = {place:.6g} m: "
            f"{cause}."
        )


def surely_pressed(bed: Bed, depth: Array, radius: Array) -> Array:
    """Return of which contacts the pressure, by one quick rule, is far from zero: the others are examined closely.

    The pressure is the integral of p1(r; x) g'(x) from r to a, with x = r cosh(w) to take away the root of p1.
    """
    sure = np.zeros(radius.shape, dtype=bool)
    nodes, weights = gauss_legendre(QUICK_NODES)
    share = np.concatenate(
        [np.geomspace(2e-3, 0.5, 12), np.linspace(0.53, 0.95, 15), 1.0 - np.geomspace(2e-3, 0.04, 9)]
    )
    for index, a in enumerate(radius):
        if bed.rim <= a or any(strength != 0.0 and b < a for b, strength in bed.kinks):
            continue
        r = a * share[:, None]
        width = np.arccosh(1.0 / share)[:, None]
        x = np.minimum(r * np.cosh(width * nodes), np.nextafter(a, 0.0))
        flat, place = np.broadcast_to(r, x.shape).ravel(), x.ravel()
        punches = (bed.medium.punch_pressure(flat, place) * bed.gap_slope(place)).reshape(x.shape)
        pressure = np.sum(punches * r * np.sinh(width * nodes) * width * weights, axis=1)
        # it ends like a root at the edge
        pressure = pressure / np.sqrt((1.0 - share) * (1.0 + share))
        sure[index] = np.min(pressure) > CLEAR_PRESSURE * np.max(pressure)
    return sure


def _clear_outside(bed: Bed, depth: float, radius: float, end: float) -> bool:
    """Return whether the bodies are known not to overlap outside: g rises, and no punch sinks the surface too far.

    Looked at as far as the body, whose f never falls, is lower than what the surface may bulge to.
    """
    if radius >= end:
        return True
    if isinstance(bed, PlaneFoundation):  # its g is given up to its reach
        return rises(bed, min(1e3 * radius, end)) and bed.medium.punch_facts(4.0 * radius).most <= 1.0
    reached = _lowest_rise(bed, depth, radius, end) if bed.rising else _low_reach(bed, depth, radius, end)
    if not reached < np.inf or bed.medium.punch_facts(reached).most > 1.0:
        return False
    return rises(bed, reached) if bed.rising else _rises_between(bed, radius, reached)


def _lowest_rise(bed: Bed, depth: float, radius: float, end: float) -> float:
    """Return how far outside a body whose f never falls may be met by the surface [m]; infinite if not found out."""
    beside = bed.medium.punch_facts(radius)
    bulge = max(0.0, -beside.least)
    far = min(1e3 * radius, end)
    r = np.geomspace(radius, far, 400)
    height = bed.height(r)
    high = (height >= (1.0 + bulge) * depth) | (
        (r >= radius + beside.flat_beyond) & (height >= (1.0 - LEAST_SURFACE_RISE) * depth)
    )
    if not high.any() and far < end:
        return np.inf
    return float(r[np.argmax(high)]) if high.any() else far


def _low_reach(bed: Bed, depth: float, radius: float, end: float) -> float:
    """Return the same of a body whose f may fall again."""
    near, far = _outside(radius, end)
    places = np.concatenate([near, _troughs(bed, near), far, _troughs(bed, far)])
    facts = bed.medium.punch_facts(radius)
    with np.errstate(over="ignore", invalid="ignore"):
        height = bed.height(places)
        high = (height >= depth + _bulge(bed, radius, facts.least)) | (
            (places >= radius + facts.flat_beyond) & (height >= depth + _bulge(bed, radius, LEAST_SURFACE_RISE))
        )
    low = places[~high]
    if not low.size:
        return radius
    # f may still be low up to the next sample
    reached = np.min(places[places > np.max(low)], initial=np.inf)
    if not np.isfinite(reached) and np.max(low) >= end * (1.0 - 1e-12):
        reached = end
    return float(reached) if reached <= 1e3 * radius else np.inf


def _rises_between(bed: Bed, low: float, high: float) -> bool:
    """Return whether g does not fall from one radius to another."""
    slope = bed.gap_slope(low + (high - low) * np.arange(1, SLOPE_SAMPLES) / SLOPE_SAMPLES)
    falls = np.any(slope < -SLOPE_ROUNDING * np.max(slope[np.isfinite(slope)])) if high > low else False
    return not (falls or any(b >= low for b in falling_kinks(bed, high)))


def _bulge(bed: Bed, radius: float, least: float) -> float:
    """Return how far the surface outside may rise [m]: where g' > 0 punches lift it by -`least`, else by one."""
    inside = np.diff(bed.gap(radius * np.linspace(0.0, 1.0, SLOPE_SAMPLES + 1)))
    return float(np.sum(np.maximum(inside, 0.0)) * max(-least, 0.0) - np.sum(np.minimum(inside, 0.0)))


def _outside(radius: float, end: float) -> tuple[Array, Array]:
    """Return places near outside a contact, and far."""
    near = np.linspace(radius, min(3.0 * radius, end), SLOPE_SAMPLES + 1)[1:]
    near = near[near > radius]
    return near, np.geomspace(
        3.0 * radius, min(OVERLAP_DISTANCE * radius, end), SLOPE_SAMPLES
    ) if end > 3.0 * radius else near[:0]


def _where_it_may_overlap(bed: Bed, depth: float, radius: float, end: float) -> Array:
    """Return places outside the contact at which the bodies might overlap.

    Where the springs determine the separation, the bodies cannot overlap where g >= d from the edge outwards, nor
    where f >= d; on layers the surface may bulge.
    """
    near, far = _outside(radius, end)
    facts = bed.medium.punch_facts(radius)
    if not facts.gives_separation:
        places = np.concatenate(
            [near[:: SLOPE_SAMPLES // 400], _troughs(bed, near), far[:: SLOPE_SAMPLES // 400], _troughs(bed, far)]
        )
        return np.asarray(places[bed.height(places) < depth + _bulge(bed, radius, facts.least)])
    crossings = []
    if np.any(bed.gap(near) < depth):
        crossings += [near[:: SLOPE_SAMPLES // 400], _troughs(bed, near)]
    if isinstance(bed, PlaneFoundation):
        if np.any(bed.gap(far) < depth):
            crossings += [far, _troughs(bed, far)]
    else:
        with np.errstate(over="ignore", invalid="ignore"):
            low = bed.height(far) < depth
        crossings += [far[low], _troughs(bed, far)]
    places = np.concatenate(crossings) if crossings else near[:0]
    return np.asarray(places[bed.height(places) < depth] if places.size else places)


def _troughs(bed: Bed, r: Array) -> Array:
    """Return the places between the first and last r where f is least, to rounding."""
    if r.size < 2:
        return r[:0]
    with np.errstate(over="ignore", invalid="ignore"):  # a million radii out a formula may end
        slope = bed.slope(r)
    (turns,) = np.nonzero((slope[:-1] < 0.0) & (slope[1:] >= 0.0))
    low, high = r[turns], r[turns + 1]
    for _ in range(60 if turns.size else 0):
        middle = 0.5 * (low + high)
        falls = bed.slope(middle) < 0.0
        low, high = np.where(falls, middle, low), np.where(falls, high, middle)
    return high
