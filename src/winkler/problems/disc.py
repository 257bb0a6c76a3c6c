r"""Contacts under a g(x) that rises and falls: answered while they are one disc, refused when they are not.

A disc of radius a needs every spring inside compressed, so g(a) must be a record: :math:`g(a)\ge g(x)` for
:math:`x<a`.  Beyond a crest of g the radius jumps to where g is back at the crest; forces in between belong to rings.
A candidate is accepted only if the restored pressure is nowhere tensile and the bodies do not overlap outside,

.. math:: h(r) = \frac2\pi\int_a^r \frac{g(x)-d}{\sqrt{r^2-x^2}}\,\mathrm dx \ge 0 .
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from winkler.errors import NotConverged, OutsideValidity
from winkler.foundation.bed import Bed, Pressed
from winkler.foundation.plane import PlaneFoundation
from winkler.numerics.types import Array

__all__ = ["radius_at_depth", "radius_at_force", "refuse_unless_disc"]

SAMPLES = 4096
"""How finely g' is searched for changes of sign; narrower waves are not seen."""
FAR = 1e6
"""How many contact radii away overlap is looked for."""
MOST_TURNS = 400
"""More turning points than this cannot be told apart by the samples."""


class Climb(NamedTuple):
    """An interval of x on which g rises above everything before it."""

    start: float
    stop: float


def _root(function, low: float, high: float) -> float:  # type: ignore[no-untyped-def]
    from scipy.optimize import brentq

    return float(brentq(function, low, high, xtol=1e-300, rtol=8.9e-16, maxiter=300))


def _turns(bed: Bed, end: float) -> list[float]:
    """Return the places up to `end` where g' changes sign."""
    x = np.linspace(0.0, end, SAMPLES + 1)[1:]
    slope = bed.gap_slope(x)
    changes = np.flatnonzero(np.sign(slope[1:]) * np.sign(slope[:-1]) < 0)
    if changes.size > MOST_TURNS:
        raise OutsideValidity(_too_many(end))
    return [_root(lambda t: float(bed.gap_slope(np.array([t]))[0]), x[i], x[i + 1]) for i in changes]


def _too_many(end: float) -> str:
    return (
        f"g(x) turns more than {MOST_TURNS} times within {end:.3g} m; so many waves cannot be one contact: ask for a "
        "smaller load, or treat the body as rough."
    )


def _gap(bed: Bed, x: float) -> float:
    return float(bed.gap(np.array([x]))[0])


def _climbs(bed: Bed, end: float) -> list[Climb]:
    bounds = [0.0, *_turns(bed, end), end]
    record = 0.0
    climbs = []
    for low, high in pairwise(bounds):
        top = _gap(bed, high)
        if top <= record:
            continue
        start = low if _gap(bed, low) >= record else _root(lambda t, r=record: _gap(bed, t) - r, low, high)
        climbs.append(Climb(start, high))
        record = top
    return climbs


def _horizon(bed: Bed, reached, end: float, guess: float) -> float:  # type: ignore[no-untyped-def]
    """Return a place beyond which the target is met, by doubling or halving the guess."""
    place = guess
    for _ in range(400):
        if reached(place):
            if not reached(0.5 * place):
                return min(2.0 * place, end)
            place *= 0.5
        elif place >= end:
            return end
        else:
            place = min(2.0 * place, end)
    raise NotConverged("The load is not met at any contact radius that can be represented; check the profile's units.")


def _force(bed: Bed, a: float) -> float:
    place = np.array([a])
    return float((bed.stiffness(place) * bed.gap(place) - bed.gap_load(place))[0])


def radius_at_depth(bed: Bed, depth: float, end: float, guess: float) -> float:
    """Return the contact radius at a depth, or refuse."""
    horizon = _horizon(bed, lambda x: _gap(bed, x) >= depth, end, guess)
    for climb in _climbs(bed, horizon):
        if _gap(bed, climb.stop) >= depth:
            radius = _root(lambda t: _gap(bed, t) - depth, climb.start, climb.stop)
            refuse_unless_disc(bed, depth, radius, end)
            return radius
    _refuse_unless_pinned(bed, f"depth {depth:.6g} m", end)
    refuse_unless_disc(bed, depth, end, end)
    return end


def radius_at_force(bed: Bed, force: float, end: float, guess: float) -> float:
    """Return the contact radius under a force, or refuse."""
    horizon = _horizon(bed, lambda x: _force(bed, x) >= force, end, guess)
    for climb in _climbs(bed, horizon):
        low, high = _force(bed, climb.start), _force(bed, climb.stop)
        if force < low:
            raise OutsideValidity(
                f"force {force:.6g} N lies where the contact is no disc: up to {_gap(bed, climb.start):.6g} m depth it "
                f"closes inside, from {low:.6g} N on as a disc of {climb.start:.6g} m; ask for a force outside."
            )
        if force <= high:
            radius = _root(lambda t: _force(bed, t) - force, climb.start, climb.stop)
            refuse_unless_disc(bed, _gap(bed, radius), radius, end)
            return radius
    _refuse_unless_pinned(bed, f"force {force:.6g} N", end)
    place = np.array([end])
    refuse_unless_disc(bed, float(((force + bed.gap_load(place)) / bed.stiffness(place))[0]), end, end)
    return end


def _refuse_unless_pinned(bed: Bed, asked: str, end: float) -> None:
    """Raise if a load that no free edge meets is not met by the rim either."""
    if not math.isfinite(end):
        raise OutsideValidity(_falling(bed, asked))
    if bed.rim > bed.reach:
        raise OutsideValidity(
            f"{asked} leads beyond the reach of the profile ({end:.6g} m), where nothing is known of it; ask for less."
        )


def _falling(bed: Bed, asked: str) -> str:
    return (
        f"{asked} is not met by a round contact: the profile falls with the distance from the axis, so that it touches "
        "as a ring; give a profile that rises from its apex."
    )


def refuse_unless_disc(bed: Bed, depth: float, radius: float, end: float) -> None:
    """Raise `OutsideValidity` if a disc of this radius would pull or overlap."""
    if radius == 0.0:
        return
    _refuse_tension(bed, depth, radius)
    # far outside heights may overflow: what is infinitely high does not overlap
    with np.errstate(over="ignore", invalid="ignore"):
        r = _where_it_may_overlap(bed, depth, radius, end)
    if not r.size:
        return
    separation = bed.height(r) - depth + bed.medium.displacement(Pressed(bed, depth, radius), r)
    if not np.all(np.isfinite(separation)):
        raise NotConverged("The separation outside the contact could not be computed.")
    overlap = separation < -1e-9 * depth
    if overlap.any():
        place = float(np.min(r[overlap]))
        raise OutsideValidity(
            f"At depth {depth:.6g} m the bodies would overlap outside the contact, at r = {place:.6g} m: there the "
            f"contact has begun as a ring around the disc of {radius:.6g} m; ask for a smaller load."
        )


def _refuse_tension(bed: Bed, depth: float, radius: float) -> None:
    slope = bed.gap_slope(np.linspace(0.0, 1.0, SAMPLES + 1)[1:-1] * radius)
    falling = [b for b, strength in bed.kinks if strength < 0.0 and b < radius]
    if not (falling or np.any(slope < 0.0)):
        return
    turns = int(np.count_nonzero(np.diff(np.sign(slope))))
    if turns > MOST_TURNS:
        raise OutsideValidity(_too_many(radius))
    count = 400 + 4 * turns
    r = (np.arange(count) + 0.5) / count * radius
    # beside a kink where the slope drops the pressure falls logarithmically: a gap narrower than this is of no account
    beside = [b * (1.0 + side * 10.0**-k) for b in falling for side in (-1.0, 1.0) for k in range(2, 9)]
    r = np.concatenate([r, [place for place in beside if 0.0 < place < radius]])
    pressure = bed.medium.pressure(Pressed(bed, depth, radius), r)
    if np.min(pressure) < -1e-9 * np.max(np.abs(pressure[np.isfinite(pressure)])):
        raise OutsideValidity(
            f"At depth {depth:.6g} m a round contact of {radius:.6g} m would need tension at r = "
            f"{r[np.argmin(pressure)]:.6g} m: the true contact has a gap there; the profile is too concave or wavy "
            "for this load."
        )


def _where_it_may_overlap(bed: Bed, depth: float, radius: float, end: float) -> Array:
    """Return places outside the contact at which the bodies might overlap.

    They cannot where g >= d all the way from the edge, nor where f >= d.
    """
    near = np.linspace(radius, min(3.0 * radius, end), SAMPLES + 1)[1:]
    near = near[near > radius]
    far = np.geomspace(3.0 * radius, min(FAR * radius, end), SAMPLES) if end > 3.0 * radius else near[:0]
    found = []
    if np.any(bed.gap(near) < depth):
        found += [near[:: SAMPLES // 400], _troughs(bed, near)]
    if isinstance(bed, PlaneFoundation):
        if np.any(bed.gap(far) < depth):
            found += [far, _troughs(bed, far)]
    else:
        found += [far[bed.height(far) < depth], _troughs(bed, far)]
    places = np.concatenate(found) if found else near[:0]
    return np.asarray(places[bed.height(places) < depth] if places.size else places)


def _troughs(bed: Bed, r: Array) -> Array:
    """Return the places between the first and last r where f is least, to rounding."""
    if r.size < 2:
        return r[:0]
    slope = bed.slope(r)
    (turns,) = np.nonzero((slope[:-1] < 0.0) & (slope[1:] >= 0.0))
    low, high = r[turns], r[turns + 1]
    for _ in range(60 if turns.size else 0):
        middle = 0.5 * (low + high)
        falls = bed.slope(middle) < 0.0
        low, high = np.where(falls, middle, low), np.where(falls, high, middle)
    return high
