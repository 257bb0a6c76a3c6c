r"""Do the bodies overlap outside a disc?  How far their springs rise there decides, else the computed separation.

The bodies are apart outside where g never falls and no flat punch sinks the surface farther than itself,

.. math:: s(r) = \int_a^r (1 - u_1(r;x))\,g'(x)\,\mathrm dx \ge 0 .
"""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings
from winkler.foundation.plane import PlaneFoundation
from winkler.media.medium import LEAST_SURFACE_RISE
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged, OutsideValidity

SLOPE_SAMPLES = 4096
"""How finely g' is searched for changes of sign; narrower waves are left out."""
RISING_SAMPLES = 1024
"""The same for bodies whose homogeneous g is known to rise."""
OVERLAP_DISTANCE = 1e6
"""How many contact radii away overlap is sought."""
SLOPE_ROUNDING = 1e-9
"""A slope of g below zero by this part of the steepest is rounding."""


def rises(bed: Bed, radius: float) -> bool:
    """Return whether g never falls up to a radius; sought where it is not known."""
    if bed.certain or radius == 0.0:
        return True
    slope = bed.gap_slope(np.arange(1, RISING_SAMPLES) / RISING_SAMPLES * radius)
    return not (np.any(slope < -SLOPE_ROUNDING * np.max(slope[np.isfinite(slope)])) or falling_kinks(bed, radius))


def falling_kinks(bed: Bed, radius: float) -> list[float]:
    """Return the places within a radius at which g' drops."""
    return [b for b, strength in bed.kinks if strength < 0.0 and b < radius]


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
