"""What is stated of a line contact on layers."""

from __future__ import annotations

from typing import Any

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.problems.assumptions.film import film_note
from winkler.problems.line.layered_approach import has_depth, layered_approach
from winkler.problems.line.layered_stress import greatest_in_part
from winkler.problems.line.peak_pressure import is_sharp
from winkler.problems.line.strip import Strip
from winkler.problems.line.validity import shape_notes
from winkler.problems.line.yield_statement import strip_yield_notes
from winkler.problems.normal.strong_parts import strong_parts
from winkler.problems.normal.unknown_yield import MISES
from winkler.values.validity import Assumption, Note, Standing

__all__ = ["WAVES", "layered_notes", "strip_notes", "yield_notes"]

WAVES = "P. Meijers, Appl. Sci. Res. 18 (1968) 353-383, doi:10.1007/BF00382359; K. L. Johnson (1985) sec. 5.8"

SAME_PLACE = 1e-6
"""Distance from the middle, over the half-width, that is said to be none."""


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
        f"{body}. The pressure is expanded in Chebyshev modes. Effects at the ends of a body of finite length are "
        "neglected.",
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
    found = [(greatest_in_part(bed, Strip(half_width, rim_load), part, friction), part) for part in parts]
    found = [(each if abs(each.x) > SAME_PLACE * half_width else each._replace(x=0.0), part) for each, part in found]
    (note,) = strip_yield_notes(found, Standing.APPROXIMATE)
    if is_sharp(bed, half_width, rim_load) and note.standing is not Standing.OUTSIDE:
        place = note.statement.partition("stress is ")[2]
        text = f"The stress is infinite at a sharp tip, kink or rim, which yields; away from there it is {place}"
        return (Note(Assumption.ELASTIC, Standing.APPROXIMATE, text, MISES),)
    return (note,)
