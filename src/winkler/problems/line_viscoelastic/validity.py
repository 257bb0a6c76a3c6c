"""Validity notes of a line contact of bodies that relax."""

from __future__ import annotations

from winkler.foundation.line import LineFoundation
from winkler.media.offers import offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.numerics.types import Array
from winkler.problems.assumptions.times import path_notes
from winkler.problems.line.load_springs import LoadSprings
from winkler.problems.line.validity import line_notes
from winkler.problems.normal.unknown_yield import relaxing_yield
from winkler.validity import Assumption, Note, Standing

__all__ = ["relaxing_line_notes"]

TING = "T. C. T. Ting, J. Appl. Mech. 33 (1966) 845-854, doi:10.1115/1.3625192"


def relaxing_line_notes(bed: LineFoundation, time: Array, half_width: float) -> tuple[Note, ...]:
    """Return the notes on bed, contact, times and yield.

    Parameters
    ----------
    bed : LineFoundation
    time : ndarray
        Moments of the path [s].
    half_width : float
        Greatest half-width [m].
    """
    medium = bed.medium
    assert offers(medium, RelaxingMedium)
    response = Note(
        Assumption.RESPONSE,
        Standing.EXACT,
        "Linear viscoelastic half-planes in plane strain with Poisson's ratios that do not change in time, without "
        "friction and inertia: while the contact is one strip, the flat strips that make up its pressure relax one by "
        "one; the ends of a body of finite length are not included.",
        TING,
    )
    own = tuple(note for note in line_notes(bed, half_width) if note.assumption is not Assumption.RESPONSE)
    return (response, *own, *path_notes(LoadSprings(bed), time), *relaxing_yield(medium))
