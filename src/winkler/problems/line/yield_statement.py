"""What is stated of a line contact: its assumptions, and whether it stays elastic where a body has a strength."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from winkler.foundation.line import LineFoundation
from winkler.numerics.equations.highest import highest
from winkler.numerics.types import Array, Quantity
from winkler.problems.line.greatest_stress import Placed, greatest, von_mises
from winkler.problems.line.peak_pressure import is_sharp, rim_load
from winkler.problems.line.stress import LineContact, stresses
from winkler.problems.line.validity import line_notes
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.problems.normal.unknown_yield import MISES
from winkler.problems.normal.yield_statement import share_of
from winkler.values.validity import Assumption, Note, Standing

__all__ = ["line_contact_notes", "line_yield_notes", "strip_yield_notes"]

WIDTH_SHARES = (0.25, 0.5, 0.75, 1.0)
"""Parts of the half-width that are examined where the profile may fall."""
AWAY = 0.1
"""Distance from a sharp place at which its infinite stress is judged, over the half-width."""
DIRECTIONS = 33


def line_contact_notes(
    bed: LineFoundation, force: Quantity, half_width: Quantity, friction: float = 0.0
) -> tuple[Note, ...]:
    """Return how far line contacts can be trusted.

    Parameters
    ----------
    bed : LineFoundation
    force, half_width : float or ndarray
        P [N/m] and a [m].
    friction : float
        Traction over pressure [-] of a contact that slides everywhere.
    """
    widest = int(np.argmax(force))
    a = float(np.ravel(half_width)[widest])
    on_rim = rim_load(bed, float(np.ravel(force)[widest]), a)
    return (*line_notes(bed, a), *line_yield_notes(bed, a, on_rim, friction))


def line_yield_notes(
    bed: LineFoundation, half_width: float, rim_load: float, friction: float = 0.0
) -> tuple[Note, ...]:
    """Return whether the body that comes nearest to its strength stays elastic.

    Parameters
    ----------
    bed : LineFoundation
    half_width : float
        a [m].
    rim_load : float
        Load per length over E* that a rim bears [m], or negative where adhesion pulls.
    friction : float
        Traction over pressure [-] of a contact that slides everywhere.

    Returns
    -------
    tuple of Note
        Nothing where the bodies do not touch or none has a strength.
    """
    parts = strong_parts(bed.medium)
    if half_width == 0.0 or not parts:
        return ()
    found = [(_stress(bed, half_width, rim_load, part, friction), part) for part in parts]
    place, part = max(found, key=lambda one: one[0].value / one[1].solid.strength)
    share = place.value / part.solid.strength
    if is_sharp(bed, half_width, rim_load):
        where = "at the edge, which adhesion pulls" if rim_load < 0.0 else "at a sharp tip, kink or rim"
        sharp = (
            f"The elastic stress is infinite {where}, which yields under the smallest load; "
            f"{AWAY:g} half-widths away from there the greatest von Mises stress is {share_of(share, part)}"
        )
        beyond = "" if share < 1.0 else ": the result is not elastic"
        standing = Standing.APPROXIMATE if share < 1.0 else Standing.OUTSIDE
        return (Note(Assumption.ELASTIC, standing, f"{sharp}{beyond}.", MISES),)
    force = bed.medium.modulus * float(bed.load_profile(np.array([half_width]))[0])
    return strip_yield_notes(found, Standing.EXACT, onset=force / share**2 if bed.hertzian else math.nan)


def strip_yield_notes(
    found: Sequence[tuple[tuple[float, float, float], StrongPart]],
    standing: Standing,
    near: str = "at",
    onset: float = math.nan,
) -> tuple[Note, ...]:
    """Return whether the body that comes nearest to its strength stays elastic.

    Parameters
    ----------
    found
        The greatest stress [Pa] in each part, and its place x and z [m].
    standing
        Of an elastic contact.
    near : str, optional
        How well the place is known.
    onset : float, optional
        Force per length at which yielding begins [N/m], where it is known.
    """
    if not found:
        return ()
    (level, x, z), part = max(found, key=lambda one: one[0][0] / one[1].solid.strength)
    share = level / part.solid.strength
    where = f"{share_of(share, part)}, {near} x = {x:.3g} m, z = {math.copysign(z, 1.0 if part.first else -1.0):.3g} m"
    if share < 1.0:
        begins = "" if math.isnan(onset) else f"yielding begins at {onset:.4g} N/m; "
        text = f"{begins}the contact stays elastic: its greatest stress is {where}"
    else:
        began = "has begun" if math.isnan(onset) else f"began at {onset:.4g} N/m"
        text = f"yielding {began}: the greatest elastic stress is {where}; the result is not elastic"
        standing = Standing.OUTSIDE
    return (Note(Assumption.ELASTIC, standing, f"By von Mises' criterion {text}.", MISES),)


def _stress(bed: LineFoundation, half_width: float, rim_load: float, part: StrongPart, friction: float) -> Placed:
    contact = LineContact(bed, half_width, rim_load, part.solid.poisson, friction)
    if is_sharp(bed, half_width, rim_load):
        return _beside_sharp(contact)
    contacts = [contact]
    if not bed.profile.rising and half_width < bed.rim:  # a falling profile may be stressed more under less load
        earlier = (share * half_width for share in WIDTH_SHARES[:-1])
        contacts += [
            contact._replace(half_width=width)
            for width in earlier
            if width > bed.flat and float(bed.load_profile(np.array([width]))[0]) > 0.0
        ]
    return max((greatest(one, von_mises) for one in contacts), key=lambda place: place.value)


def _beside_sharp(contact: LineContact) -> Placed:
    """Return the greatest von Mises stress on half-circles about the sharp places."""
    bed, a = contact.bed, contact.half_width
    marks = np.array([0.0, a, *(b for b, _ in bed.kinks if b < a)])

    def place(mark: Array | float, angle: Array | float) -> tuple[Array, Array]:
        return mark + AWAY * a * np.cos(angle), AWAY * a * np.sin(angle)

    def level(mark: Array, angle: Array) -> Array:
        x, z = place(mark, angle)
        others = np.min(np.hypot(np.abs(x) - marks[:, None], z), axis=0) < 0.5 * AWAY * a
        return np.where(others, 0.0, von_mises(stresses(contact, x, z)))

    top = highest(level, [marks, np.linspace(0.0, math.pi, DIRECTIONS)], rounds=0)
    return Placed(top.value, *map(float, place(*top.place)))
