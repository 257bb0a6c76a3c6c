"""What is stated of a line contact: its assumptions, and whether it stays elastic where a body has a strength."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np

from winkler.foundation.line import LineFoundation
from winkler.foundation.line_bed import LineBed
from winkler.media.offers import PlaneMedium, offers
from winkler.numerics.equations.highest import highest
from winkler.numerics.types import Array, Quantity
from winkler.problems.line.greatest_stress import Placed, von_mises
from winkler.problems.line.layered_stress import NEAR, greatest_in_part
from winkler.problems.line.peak_pressure import is_sharp, rim_load
from winkler.problems.line.stress import LineContact, Strip, stresses
from winkler.problems.line.validity import line_notes
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.problems.normal.unknown_yield import MISES
from winkler.problems.normal.yield_statement import elastic_note, share_of
from winkler.values.validity import Assumption, Note, Standing

WIDTH_SHARES = (0.25, 0.5, 0.75, 1.0)
"""Parts of the half-width that are examined where the profile may fall."""
AWAY = 0.1
"""Distance from a sharp place at which its infinite stress is judged, over the half-width."""
DIRECTIONS = 33
SAME_PLACE = 1e-6
"""Distance from the middle, over the depth, that is said to be none."""


def line_contact_notes(bed: LineBed, force: Quantity, half_width: Quantity, friction: float = 0.0) -> tuple[Note, ...]:
    """Return how far line contacts can be trusted.

    Parameters
    ----------
    bed : LineBed
    force, half_width : float or ndarray
        P [N/m] and a [m].
    friction : float
        Traction over pressure [-] of a contact that slides everywhere.
    """
    widest = int(np.argmax(force))
    a = float(np.ravel(half_width)[widest])
    strip = Strip(a, rim_load(bed, float(np.ravel(force)[widest]), a))
    return (*line_notes(bed, *strip), *line_yield_notes(bed, strip, friction))


def line_yield_notes(bed: Any, strip: Strip, friction: float = 0.0) -> tuple[Note, ...]:
    """Return whether the body or layer that comes nearest to its strength stays elastic.

    Parameters
    ----------
    bed : LineBed or PeriodicBed
    strip : Strip
    friction : float
        Traction over pressure [-] of a contact that slides everywhere.

    Returns
    -------
    tuple of Note
        Nothing where the bodies do not touch or none has a strength.
    """
    parts = strong_parts(bed.medium)
    if strip.half_width == 0.0 or not parts:
        return ()
    layered = offers(bed.medium, PlaneMedium)
    search = greatest_in_part if layered else _stress
    share, where = nearest_to_strength((search(bed, strip, part, friction), part) for part in parts)
    if is_sharp(bed, *strip):
        edge = "at the edge, which adhesion pulls" if strip.edge_load < 0.0 else "at a sharp tip, kink or rim"
        sharp = (
            f"The elastic stress is infinite {edge}, which yields under the smallest load; "
            f"{NEAR if layered else AWAY:g} half-widths away from there the greatest von Mises stress is {where}"
        )
        beyond = "" if share < 1.0 else ": the result is not elastic"
        standing = Standing.APPROXIMATE if share < 1.0 else Standing.OUTSIDE
        return (Note(Assumption.ELASTIC, standing, f"{sharp}{beyond}.", MISES),)
    load = bed.medium.modulus * float(bed.load_profile(np.array([strip.half_width]))[0]) if bed.hertzian else 0.0
    onset = f"{load / share**2:.4g} N/m" if bed.hertzian else ""
    return (elastic_note(share, where, Standing.APPROXIMATE if layered else Standing.EXACT, onset),)


def nearest_to_strength(found: Iterable[tuple[Placed, StrongPart]]) -> tuple[float, str]:
    """Return the greatest share of a strength, and in words what it is and where it stands; z < 0 in second bodies."""
    place, part = max(found, key=lambda one: one[0].value / one[1].solid.strength)
    share = place.value / part.solid.strength
    x = place.x if abs(place.x) > SAME_PLACE * abs(place.z) else 0.0
    return share, f"{share_of(share, part)}, at x = {x:.3g} m, z = {place.z:.3g} m"


def _stress(bed: LineFoundation, strip: Strip, part: StrongPart, friction: float) -> Placed:
    """Return the greatest stress of a body without layers; under a falling profile, of lesser loads, too."""
    if is_sharp(bed, *strip):
        place = _beside_sharp(LineContact(bed, *strip, part.solid.poisson, friction))
        return place if part.first else place._replace(z=-place.z)
    strips = [strip]
    if not bed.profile.rising and strip.half_width < bed.rim:
        earlier = (share * strip.half_width for share in WIDTH_SHARES[:-1])
        strips += [
            strip._replace(half_width=width)
            for width in earlier
            if width > bed.flat and float(bed.load_profile(np.array([width]))[0]) > 0.0
        ]
    return max((greatest_in_part(bed, one, part, friction) for one in strips), key=lambda place: place.value)


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
