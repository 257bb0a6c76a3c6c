"""Validity notes of a line contact of bodies that relax."""

from __future__ import annotations

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.media.offers import offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.numerics.types import Array
from winkler.problems.assumptions.times import path_notes
from winkler.problems.line.validity import shape_notes
from winkler.problems.line_viscoelastic.layered_strips import RelaxingBed, elastic_line
from winkler.problems.normal.unknown_yield import relaxing_yield
from winkler.values.validity import Assumption, Note, Standing

TING = "T. C. T. Ting, J. Appl. Mech. 33 (1966) 845-854, doi:10.1115/1.3625192"


def relaxing_line_notes(bed: RelaxingBed, time: Array, half_width: float) -> tuple[Note, ...]:
    """Return the notes on bed, contact, times and yield.

    Parameters
    ----------
    bed : LineFoundation or LayeredLineFoundation
    time : ndarray
        Moments of the path [s].
    half_width : float
        Greatest half-width [m].
    """
    medium = bed.medium
    assert offers(medium, RelaxingMedium)
    layered = elastic_line(bed).layered_body if isinstance(bed, LayeredLineFoundation) else None
    bodies = medium.described if layered else "Linear viscoelastic half-planes"  # type: ignore[attr-defined]
    alike = medium.in_proportion
    carried = (
        "the hereditary integral applies to each flat strip that makes up its pressure"
        if alike
        else "each wavelength of the pressure creeps separately"
    )
    beside = "of the widest elastic contact" if alike else "of it"
    response = Note(
        Assumption.RESPONSE,
        layered.in_plane[0] if layered else Standing.EXACT,
        f"{bodies} in plane strain with constant Poisson's ratios, without friction and inertia. While the "
        f"contact is one strip, {carried}. Effects at the ends of a body of finite length are neglected.",
        TING,
    )
    examined = Note(
        Assumption.SINGLE_CONTACT,
        Standing.EXACT,
        "It was checked that the contact is one strip: no tension inside at each point of the path, and no "
        f"overlap outside {beside}.",
        "a-posteriori check of pressure and separation, at sampled places",
    )
    own = (*shape_notes(bed, half_width, response, examined=False), *((examined,) if layered else ()))
    return (*own, *path_notes(medium, time), *relaxing_yield(medium))
