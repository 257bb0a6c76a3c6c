"""Validity notes of a line contact: half-planes, slopes, size of the body, a pinned edge, one strip."""

from __future__ import annotations

import math

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line_bed import LineBed
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.problems.assumptions.film import film_note
from winkler.problems.line.layered_approach import has_depth, layered_approach
from winkler.problems.normal.validity import large_body_note, steepness_note
from winkler.values.validity import Assumption, Note, Standing

JAEGER = "J. Jaeger, Arch. Appl. Mech. 65 (1995) 478-487, doi:10.1007/BF00835661"
PALLOT = "A. E. Giannakopoulos, P. Pallot, J. Mech. Phys. Solids 48 (2000) 1597-1631"
WAVES = "P. Meijers, Appl. Sci. Res. 18 (1968) 353-383, doi:10.1007/BF00382359; K. L. Johnson (1985) sec. 5.8"
HALF_PLANES = "Homogeneous, linear elastic half-planes in plane strain under normal load"
POWER_LAW = "Linear elastic bodies whose modulus follows one power of the depth, in plane strain"
PUNCHES = "The sum of flat punches of all half-widths is the exact solution."
ENDS = "Effects at the ends of a body of finite length are neglected."


def line_notes(bed: LineBed, half_width: float, rim_load: float = 0.0, *, sticking: bool = False) -> tuple[Note, ...]:
    """Return the notes of the widest of several line contacts, but for that on yield.

    Parameters
    ----------
    bed : LineBed
    half_width : float
        a [m].
    rim_load : float
        Load per length over E* that a rim bears [m].
    sticking : bool
        Whether the edges may pull: then that the contact is one strip is examined elsewhere.
    """
    standing, bodies, solved, source = Standing.EXACT, HALF_PLANES, PUNCHES, JAEGER
    beside: tuple[Note, ...] = ()
    film: tuple[Note, ...] = ()
    if isinstance(bed, PowerLawLineFoundation):
        bodies, source = f"{POWER_LAW} under normal load", PALLOT
        beside = tuple(note for note in bed.medium.notes if note.standing is not Standing.EXACT)
    elif isinstance(bed, LayeredLineFoundation):
        standing, bodies = bed.layered_body.in_plane
        solved, source = "The pressure is expanded in Chebyshev modes.", WAVES
        if half_width > 0.0 and has_depth(bed.medium):
            strain = layered_approach(bed, half_width, rim_load, None, None) / bed.medium.thickness
            film = (film_note(strain, strain),)
    response = Note(Assumption.RESPONSE, standing, f"{bodies}. {solved} {ENDS}", source)
    return (*beside, *shape_notes(bed, half_width, response, examined=not sticking), *film)


def shape_notes(bed: LineBed, half_width: float, response: Note, *, examined: bool = True) -> tuple[Note, ...]:
    """Return what is stated of the shape of a line contact, after a note on how its bodies respond.

    Parameters
    ----------
    bed : LineBed
    half_width : float
        a [m].
    response : Note
    examined : bool
        Whether contacts that may part were examined when they were solved.
    """
    if half_width == 0.0:
        apart = "The bodies do not touch under this load."
        return (*bed.notes, response, Note(Assumption.EQUILIBRIUM, Standing.EXACT, apart, "the load is zero"))
    share = np.linspace(0.0, 1.0, 65)[1:]
    inside = half_width * (share[:-1] if half_width >= bed.rim else share)
    notes = [*bed.notes, response, steepness_note(float(np.max(np.abs(bed.slope(inside)))))]
    if math.isfinite(bed.size):
        notes.append(large_body_note(half_width / bed.size, strip=True))
    if half_width >= bed.rim:
        text = "The contact is pinned at the rim, where the pressure is infinite; a real edge yields or is rounded."
        notes.append(Note(Assumption.SHAPE, Standing.EXACT, text, "flat punch of Sadowsky"))
    if not bed.single and examined:
        notes.append(
            Note(
                Assumption.SINGLE_CONTACT,
                Standing.EXACT,
                "It was checked that the contact is one strip: no tension inside, no overlap outside.",
                "a-posteriori check of pressure and separation, at sampled places",
            )
        )
    return tuple(notes)
