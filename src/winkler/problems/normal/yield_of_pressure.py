"""Whether contacts of which only the pressure is known stay elastic: ellipses and rough surfaces."""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Quantity
from winkler.problems.normal.elliptic_fields import greatest_below_ellipse, traction_of
from winkler.problems.normal.elliptic_stress import greatest_under_ellipse
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.problems.normal.unknown_yield import MISES, unknown_yield
from winkler.problems.normal.yield_statement import share_of
from winkler.values.validity import Assumption, Note, Standing

THOMAS = "H. R. Thomas, V. A. Hoersch, Univ. Illinois Eng. Exp. Station Bulletin 212 (1930); R. von Mises (1913)"
HERTZ = "K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 6.1, doi:10.1017/CBO9781139171731"
SACKFIELD = "A. Sackfield, D. A. Hills, J. Strain Anal. 18 (1983) 107-110, doi:10.1243/03093247V182107"
OVER_MEAN = 1.5
"""Greatest pressure of a round contact of Hertz over the mean."""
SAFE_PRESSURE = 0.1
"""Pressure over that at which a round contact of Hertz yields, below which spots of usual shapes do not."""


def ellipse_yield_notes(
    medium: object,
    semi_axes: tuple[Quantity, Quantity],
    force: Quantity,
    friction: float = 0.0,
    angle: float | None = None,
) -> tuple[Note, ...]:
    """Return whether an elliptic contact of Hertz stays elastic; of many loads the greatest.

    Parameters
    ----------
    medium
        A homogeneous one.
    semi_axes : tuple of float or ndarray
        [m].
    force : float or ndarray
        [N].
    friction : float
        Greatest traction over pressure [-].
    angle : float, optional
        Of the tractions to x [rad], where all of the contact slides in one direction; not known unless given.
    """
    parts = strong_parts(medium)
    most = float(np.max(force))
    if not parts or most <= 0.0:
        return ()
    smaller, larger = sorted(float(np.max(axis)) for axis in semi_axes)
    pressure = 1.5 * most / (math.pi * smaller * larger)
    if friction > 0.0 and angle is not None:
        along, across = (float(np.max(axis)) for axis in semi_axes)
        return (_slid_note(parts, (along, across), most, traction_of(friction, angle)),)
    peaks = [greatest_under_ellipse(smaller / larger, part.solid.poisson) for part in parts]
    shares = [peak.value * pressure / part.solid.strength for peak, part in zip(peaks, parts, strict=True)]
    worst = int(np.argmax(shares))
    share, part, depth = shares[worst], parts[worst], peaks[worst].depth * smaller
    where = f"{share_of(share, part)}, at a depth of {depth:.3g} m below the middle"
    onset = most / share**3
    if share >= 1.0:
        statement = (
            f"By von Mises' criterion yielding began at {onset:.4g} N: the greatest elastic stress is {where}; beyond "
            "it the result is not elastic."
        )
        return (Note(Assumption.ELASTIC, Standing.OUTSIDE, statement, THOMAS),)
    if friction > 0.0:
        a, b = (float(np.max(axis)) for axis in semi_axes)
        slid = max(
            greatest_below_ellipse("von_mises", a, b / a, pressure, part.solid.poisson, direction).value
            for direction in ((friction, 0.0), (0.0, friction))
        )
        added = (
            f"Without friction the greatest von Mises stress is {where}; if all of it slid along x or along y with the "
            f"coefficient {friction:.3g} it would be {share_of(slid / part.solid.strength, part)}."
        )
        return unknown_yield(medium, "the tractions of rolling differ in direction from place to place", added)
    statement = (
        f"By von Mises' criterion yielding begins at {onset:.4g} N; the contact stays elastic: its greatest stress is "
        f"{where}."
    )
    return (Note(Assumption.ELASTIC, Standing.EXACT, statement, THOMAS),)


def _slid_note(
    parts: tuple[StrongPart, ...], semi_axes: tuple[float, float], force: float, traction: tuple[float, float]
) -> Note:
    """Return the verdict on an ellipse all of which slides in one direction, with tractions over the pressure."""
    a, b = semi_axes
    pressure = 1.5 * force / (math.pi * a * b)
    found = [greatest_below_ellipse("von_mises", a, b / a, pressure, part.solid.poisson, traction) for part in parts]
    share, spot, part = max(
        ((spot.value / part.solid.strength, spot, part) for spot, part in zip(found, parts, strict=True)),
        key=lambda each: each[0],
    )
    yielded = share >= 1.0
    verdict = "; beyond it the result is not elastic" if yielded else "; the contact stays elastic"
    statement = (
        f"By von Mises' criterion yielding {'began' if yielded else 'begins'} at {force / share**3:.4g} N under the "
        f"friction of a contact that slides, with mu = {math.hypot(*traction):.3g}: the greatest elastic stress is "
        f"{share_of(share, part)}, at a depth of {spot.z:.3g} m{verdict}."
    )
    return Note(Assumption.ELASTIC, Standing.OUTSIDE if yielded else Standing.EXACT, statement, SACKFIELD)


def spots_yield_notes(medium: object, pressure: float) -> tuple[Note, ...]:
    """Return the yield note of the mean pressure in the true area of a rough contact.

    Parameters
    ----------
    medium
        A homogeneous one.
    pressure : float
        Force over true area [Pa].
    """
    parts = strong_parts(medium)
    if not parts or not pressure > 0.0:
        return ()
    limits = [1.0 / greatest_under_ellipse(1.0, part.solid.poisson).value for part in parts]
    part, limit = min(zip(parts, limits, strict=True), key=lambda pair: pair[1] * pair[0].solid.strength)
    share, onset = pressure / part.solid.strength, limit / OVER_MEAN
    if share / onset >= 1.0:
        standing, verdict = (
            Standing.OUTSIDE,
            "contact spots at this pressure have yielded, and the result is not elastic",
        )
    elif share / onset <= SAFE_PRESSURE:
        standing, verdict = Standing.ASYMPTOTIC, "far below this limit the spots stay elastic, unless they are sharp"
    else:
        standing, verdict = Standing.APPROXIMATE, "the onset of yield is not known because the spots are not round"
    statement = (
        f"The mean pressure in the true area of contact is {share_of(share, part)}; single summits carry more. "
        f"Under a round Hertzian contact yielding begins at a mean pressure of {onset:.3g} times the strength: "
        f"{verdict}."
    )
    return (Note(Assumption.ELASTIC, standing, statement, f"{MISES}; {HERTZ}"),)
