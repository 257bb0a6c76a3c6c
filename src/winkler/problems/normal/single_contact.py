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

from winkler.foundation.bed import Bed, PressedSprings
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array
from winkler.problems.normal.overlap import SLOPE_SAMPLES, falling_kinks, refuse_overlap
from winkler.values.errors import NotConverged, OutsideValidity

MOST_TURNING_POINTS = 400
"""More turning points than this cannot be distinguished by the samples."""
QUICK_NODES = 24, 40
_INNER = np.geomspace(2e-3, 0.5, 12), np.linspace(0.53, 0.95, 15)
QUICK_SHARES = np.concatenate([*_INNER, 1.0 - np.geomspace(0.04, 2e-3, 9)])
EDGE_SHARES = np.concatenate([*_INNER, 1.0 - np.geomspace(0.04, 1e-5, 25)])
"""Parts of the radius at which pressures are computed quickly."""
CLEAR_PRESSURE, CLEAR_BESIDE = 1e-2, 0.1
"""A pressure this far from zero is trusted to quick rules, all without their root: one rule, against the greatest; two,
less four times their difference, against those beside it."""


def too_many(end: float) -> str:
    """Return why a g that turns too often within `end` [m] is refused."""
    return (
        f"g(x) turns more than {MOST_TURNING_POINTS} times within {end:.3g} m; so many waves cannot be one contact: "
        "give a smaller load, or treat the body as rough."
    )


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
    """Return of which contacts the pressure, by quick rules, is far from zero: the others are examined closely."""
    sure = np.zeros(radius.shape, dtype=bool)
    for index, a in enumerate(radius):
        if bed.rim <= a or any(strength != 0.0 and b < a for b, strength in bed.kinks):
            continue
        pressure = _quickly(bed, a, QUICK_SHARES, QUICK_NODES[0])
        sure[index] = np.min(pressure) > CLEAR_PRESSURE * np.max(pressure)
        if not sure[index]:  # edges that bear much
            coarse, fine = (_quickly(bed, a, EDGE_SHARES, count) for count in QUICK_NODES)
            beside = np.maximum(np.append(fine[1:], 0.0), np.append(0.0, fine[:-1]))
            sure[index] = np.all(fine - 4.0 * np.abs(fine - coarse) > CLEAR_BESIDE * beside)
    return sure


def _quickly(bed: Bed, a: float, share: Array, count: int) -> Array:
    """Return the pressure [Pa] at parts of the radius over the root with which it ends at the edge.

    It is the integral of p1(r; x) g'(x) from r to a, with x = r cosh(w) to take away the root of p1.
    """
    nodes, weights = gauss_legendre(count)
    r, width = a * share[:, None], np.arccosh(1.0 / share)[:, None]
    x = np.minimum(r * np.cosh(width * nodes), np.nextafter(a, 0.0))
    flat, place = np.broadcast_to(r, x.shape).ravel(), x.ravel()
    punches = (bed.medium.punch_pressure(flat, place) * bed.gap_slope(place)).reshape(x.shape)
    pressure = np.sum(punches * r * np.sinh(width * nodes) * width * weights, axis=1)
    return np.asarray(pressure / np.sqrt((1.0 - share) * (1.0 + share)))
