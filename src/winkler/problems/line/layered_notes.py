"""What is stated of a line contact on layers."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.problems.assumptions.film import film_note
from winkler.problems.line.greatest_stress import Placed
from winkler.problems.line.layered_approach import has_depth, layered_approach
from winkler.problems.line.layered_stress import layered_fields
from winkler.problems.line.peak_pressure import is_sharp
from winkler.problems.line.strip import Strip
from winkler.problems.line.validity import shape_notes
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.problems.normal.unknown_yield import MISES
from winkler.problems.normal.yield_statement import share_of
from winkler.values.validity import Assumption, Note, Standing

__all__ = ["WAVES", "greatest_of_part", "layered_notes", "strip_notes", "yield_notes"]

WAVES = "P. Meijers, Appl. Sci. Res. 18 (1968) 353-383, doi:10.1007/BF00382359; K. L. Johnson (1985) sec. 5.8"
PLACES, DEPTHS = 33, 25
DEEPEST = 4.0
"""How deep the greatest stress is sought, over the half-width and the depth of a part."""
NEAR = 0.05
"""Distance from a sharp place at which the stress is read, over the half-width."""


def layered_notes(
    bed: LayeredLineFoundation, half_width: float, rim_load: float, friction: float = 0.0
) -> tuple[Note, ...]:
    """Return the notes of the widest of several line contacts on layers.

    Parameters
    ----------
    bed : LayeredLineFoundation
    half_width : float
        a [m].
    rim_load : float
        Load per length over E* that a rim bears [m].
    friction : float
        Traction over pressure [-] of a contact that slides everywhere.
    """
    return (*strip_notes(bed, half_width, rim_load), *yield_notes(bed, half_width, rim_load, friction))


def strip_notes(
    bed: LayeredLineFoundation, half_width: float, rim_load: float, *, sticking: bool = False
) -> tuple[Note, ...]:
    """Return these notes but for that on yield, and of edges that may pull without that on a single strip."""
    standing, body = bed.layered_body.in_plane
    response = Note(
        Assumption.RESPONSE,
        standing,
        f"{body}, solved in Chebyshev modes; the ends of a body of finite length are not included.",
        WAVES,
    )
    notes = shape_notes(bed, half_width, response, examined=not sticking)
    if half_width > 0.0 and has_depth(bed.medium):
        strain = layered_approach(bed, half_width, rim_load, None, None) / bed.medium.thickness
        notes = (*notes, film_note(strain, strain))
    return notes


def yield_notes(bed: Any, half_width: float, rim_load: float, friction: float = 0.0) -> tuple[Note, ...]:
    """Return whether the layer that comes nearest to its strength stays elastic, as of `layered_notes`."""
    parts = strong_parts(bed.medium)
    if half_width == 0.0 or not parts:
        return ()
    sharp = is_sharp(bed, half_width, rim_load)
    found = [(greatest_of_part(bed, Strip(half_width, rim_load), part, friction), part) for part in parts]
    (level, x, z), part = max(found, key=lambda one: one[0].value / one[1].solid.strength)
    share = level / part.solid.strength
    place = f"{share_of(share, part)}, at x = {x:.3g} m, z = {z if part.first else -z:.3g} m"
    if share >= 1.0:
        text = f"By von Mises' criterion yielding has begun: the elastic stress reaches {place}; it is not elastic."
        return (Note(Assumption.ELASTIC, Standing.OUTSIDE, text, MISES),)
    if sharp:
        text = f"The stress is infinite at a sharp tip, kink or rim, which yields; away from there it is {place}."
    else:
        text = f"By von Mises' criterion the contact stays elastic: its greatest stress, sampled, is {place}."
    return (Note(Assumption.ELASTIC, Standing.APPROXIMATE, text, MISES),)


def greatest_of_part(bed: Any, strip: Strip, part: StrongPart, friction: float) -> Placed:
    """Return the greatest von Mises stress of a part at sampled places, and its place."""
    a, sharp = strip.half_width, is_sharp(bed, *strip)
    x = 2.0 * math.hypot(a, part.top) * np.linspace(0.0, 1.0, PLACES)  # as far as the load has spread
    x = x if friction == 0.0 else np.concatenate([-x[:0:-1], x])
    bottom = min(part.bottom, part.top + DEEPEST * (a + part.top))
    z = part.top + (bottom - part.top) * np.linspace(0.0, 1.0, DEPTHS) ** 2
    if part.top > 0.0:
        z[0] = np.nextafter(part.top, math.inf)
    elif sharp:
        z = np.maximum(z, min(NEAR * a, 0.5 * bottom))
    signed = z if part.first else -z
    level = layered_fields(bed, strip, x[:, None], signed[None, :], part.first, friction=friction).von_mises
    i, j = np.unravel_index(int(np.argmax(level)), level.shape)
    return Placed(float(level[i, j]), float(x[i]), float(z[j]))
