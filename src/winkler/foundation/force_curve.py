r"""The bed under a measured force curve: stiffness and depth at every contact radius.

A convex curve is fitted, its slope is the stiffness k = dF/dd, and on a medium of known modulus the stiffness gives the
radius of the disc that is as stiff, :math:`a = k/(2E^*)`.  Depths must be counted from first touch: a curve that holds
the approach, or starts in contact, is refused with the shift it seems to need.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.panels.convex_spline import ConvexCurve, fit_convex
from winkler.numerics.types import Array, ArrayLike
from winkler.profiles.smoothing import Spline, choose
from winkler.values.errors import InvalidInput

FEWEST_POINTS = 6
METHOD = "MeasuredBed.from_curve"
SCATTER_RATIO = 3.0
"""More than so many times its scatter is not scatter."""
LARGEST_SCATTER = 0.05
"""Scatter, over the greatest force, beyond which the points are not one curve."""
LARGEST_MISFIT = 0.02
"""Misfit of the convex curve, over the greatest force, beyond which the points are no contact."""
LEAST_SLOPE_FALL = 0.05
"""Fall of the slope, over the greatest one, that is named."""
LARGEST_FORCE_JUMP = 0.005
"""Force at depth zero, over the greatest force, beyond which the contact had begun before."""
BALL_DEPTH_RISE = 2.0 ** (2.0 / 3.0) - 1.0
"""By how much of its depth a ball must go deeper for twice the force."""
LARGEST_FIRST_DEPTH = 0.1
"""The first depth must lie within this part of the last for the force at depth zero to be determined."""
LEAST_POINTS = 96
"""Least number of points of the bed, spread over the pieces of the curve: splines between them add about 1e-9."""
LEAST_POINTS_PER_PIECE = 8
"""Least number of points in each piece."""
FIRST_STEP_PARTS = np.geomspace(1e-3, 1.0, 24)[:-1]
"""More of them towards the touch, as parts of the first step."""


class BedPoints(NamedTuple):
    """Contact radii [m], stiffnesses [N/m] and depths [m], ``(n,)``; and the scatter of the curve [N]."""

    radii: Array
    stiffnesses: Array
    depths: Array
    scatter: float


def bed_points(depth: ArrayLike, force: ArrayLike, modulus: float) -> BedPoints:
    """Return the points of the bed behind a force curve.

    Parameters
    ----------
    depth, force : array_like, (n,)
        d [m] and F [N], in any order.
    modulus : float
        E* [Pa].

    Raises
    ------
    InvalidInput
        If the data are too few or not finite, are not counted from first touch, or are no growing contact.
    """
    if isinstance(modulus, bool) or not isinstance(modulus, int | float) or not 0.0 < modulus < math.inf:
        raise InvalidInput(f"{METHOD}: modulus is {modulus!r}; give E* as a positive number in Pa.")
    d, f = _points(depth, force)
    free = choose(d, f)
    if free.residual > LARGEST_SCATTER * np.max(f):
        raise InvalidInput(
            f"{METHOD}: the points lie {free.residual:.3g} N from any smooth curve, "
            f"{free.residual / np.max(f):.0%} of the maximum force; they are not one loading: cut unloading, "
            "holding and what comes before first touch."
        )
    _refuse_approach(d, f, free)
    curve = fit_convex(d, f)
    far = curve.misfit > SCATTER_RATIO * free.scatter + LARGEST_MISFIT * float(np.max(f))
    if far:
        _refuse_hollow(d, curve, free)
    _refuse_late_start(d, f, free)
    if far:
        raise InvalidInput(
            f"{METHOD}: the points lie {curve.misfit:.3g} N from the nearest convex curve through zero but "
            f"{free.residual:.3g} N from a smooth one; give the loading of one growing contact, from first touch on."
        )
    knots = curve.panels.edges
    each = max(LEAST_POINTS_PER_PIECE, LEAST_POINTS // (len(knots) - 1))
    inner = (knots[:-1, None] + np.diff(knots)[:, None] * (np.arange(1, each + 1) / each)).ravel()
    s = np.unique(np.concatenate([inner[0] * FIRST_STEP_PARTS, inner]))
    stiffness = curve.stiffness(s)
    depths = curve.depth_at(s)
    start = float(curve.stiffness(np.zeros(1))[0])
    if start > 1e-9 * stiffness[-1]:
        stiffness, depths = np.concatenate([[start], stiffness]), np.concatenate([[0.0], depths])
    return BedPoints(stiffness / (2.0 * modulus), stiffness, depths, curve.misfit)


def _points(depth: ArrayLike, force: ArrayLike) -> tuple[Array, Array]:
    """Return depths, positive and ascending, and forces; equal depths averaged."""
    try:
        d, f = np.asarray(depth, dtype=float), np.asarray(force, dtype=float)
    except (TypeError, ValueError):
        raise InvalidInput(f"{METHOD}: depth or force are not numbers; give arrays in m and N.") from None
    if d.ndim != 1 or d.shape != f.shape:
        raise InvalidInput(
            f"{METHOD}: depth has the shape {d.shape} and force {f.shape}; give two one-dimensional arrays of equal "
            "length."
        )
    bad = np.flatnonzero(~(np.isfinite(d) & np.isfinite(f)))
    if bad.size:
        raise InvalidInput(
            f"{METHOD}: depth or force is not finite at index {bad[0]} ({bad.size} in all); remove these points."
        )
    if np.any(d < 0.0):
        raise InvalidInput(
            f"{METHOD}: a depth is negative ({np.min(d):.6g} m); count depths from first touch: subtract the depth at "
            "which the force begins to rise, and leave out what lies before."
        )
    places, index = np.unique(d, return_inverse=True)
    means = np.bincount(index, weights=f) / np.bincount(index)
    places, means = places[places > 0.0], means[places > 0.0]
    if places.size < FEWEST_POINTS:
        raise InvalidInput(
            f"{METHOD}: {places.size} different depths above zero were given; at least {FEWEST_POINTS} are needed."
        )
    if means[-1] <= 0.0:
        raise InvalidInput(
            f"{METHOD}: the force at the maximum depth is {means[-1]:.6g} N; compression is positive: give "
            "loading alone, with its sign."
        )
    return places, means


def _refuse_approach(d: Array, f: Array, free: Spline) -> None:
    """Refuse a curve that stays at zero longer than even the sharpest cone would."""
    most = float(np.max(f))
    noise, smooth = free.scatter + 1e-6 * most, free.evaluate(d)
    above = np.flatnonzero(smooth > noise)
    first = int(above[0]) if above.size else len(d)
    if np.any(smooth[:first] < -SCATTER_RATIO * noise):
        pull = int(np.argmin(smooth[:first]))
        raise InvalidInput(
            f"{METHOD}: the bodies pull with {-smooth[pull]:.3g} N at the depth {d[pull]:.6g} m; a bed without "
            "adhesion cannot: correct the zero of the force, or treat the contact as adhesive."
        )
    silent = float(d[first - 1]) if first else 0.0
    if silent > 2.0 * math.sqrt(noise / most) * d[-1]:
        raise InvalidInput(
            f"{METHOD}: the force stays within its scatter ({noise:.3g} N) up to the depth {silent:.6g} m, so the "
            f"curve holds the approach; depths count from first touch: subtract about {silent:.3g} m and leave out "
            "what lies before."
        )


def _refuse_late_start(d: Array, f: Array, free: Spline) -> None:
    """Refuse a curve whose force does not go to zero with the depth."""
    if d[0] > LARGEST_FIRST_DEPTH * d[-1]:
        return
    start = float(free.evaluate(np.zeros(1))[0])
    bound = SCATTER_RATIO * free.scatter + LARGEST_FORCE_JUMP * float(np.max(f))
    if start > bound:
        doubled = np.flatnonzero(free.evaluate(d) >= 2.0 * start)
        missing = float(d[doubled[0] if doubled.size else -1]) / BALL_DEPTH_RISE
        raise InvalidInput(
            f"{METHOD}: at depth zero the force is already {start:.3g} N, so the contact began before; depths count "
            f"from first touch: add to them {'about' if doubled.size else 'more than'} {missing:.3g} m (as much as a "
            "ball would need)."
        )


def _refuse_hollow(d: Array, curve: ConvexCurve, free: Spline) -> None:
    """Refuse a curve whose slope falls, and state where it begins to do so."""
    places = np.linspace(d[0], d[-1], 401)
    slopes = free.evaluate(places, 1)
    fall = np.maximum.accumulate(slopes) - slopes
    if np.max(fall) <= LEAST_SLOPE_FALL * np.max(slopes):
        return
    low = int(np.flatnonzero(fall > 0.5 * np.max(fall))[0])
    first = float(places[int(np.argmax(slopes[: low + 1]))])
    raise InvalidInput(
        f"{METHOD}: the points lie {curve.misfit:.3g} N from the nearest convex curve but {free.residual:.3g} N from a "
        f"smooth one; from the depth {first:.6g} m on the slope falls, but the stiffness of a growing contact never "
        "does: cut unloading, drift or a pop-in."
    )
