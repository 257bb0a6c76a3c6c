r"""Which contact radius meets a load, where g may turn: the radius jumps from crest to crest.

A disc of radius a needs every spring inside compressed, so g(a) must be a record: :math:`g(a)\ge g(x)` for
:math:`x<a`.  Beyond a crest of g the radius jumps to where g is back at the crest; forces in between belong to rings.
Every radius found is looked at by `winkler.problems.one_disc`.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from winkler.errors import NotConverged, OutsideValidity
from winkler.foundation.bed import Bed
from winkler.problems.one_disc import MOST_TURNS, SAMPLES, refuse_unless_disc, too_many

__all__ = ["radius_at_depth", "radius_at_force"]


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
        raise OutsideValidity(too_many(end))
    return [_root(lambda t: float(bed.gap_slope(np.array([t]))[0]), x[i], x[i + 1]) for i in changes]


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
