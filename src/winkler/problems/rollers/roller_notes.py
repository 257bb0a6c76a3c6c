"""Validity of the contact of a roller of finite length: grid, sharp ends, half-space, slopes, yield."""

from __future__ import annotations

import math

from winkler.foundation.line import LineFoundation
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium
from winkler.problems.line.greatest_stress import greatest, von_mises
from winkler.problems.line.stress import LineContact
from winkler.problems.normal.strong_parts import strong_parts
from winkler.problems.normal.unknown_yield import MISES, unknown_yield
from winkler.problems.normal.validity import large_body_note, steepness_note
from winkler.problems.normal.yield_statement import share_of
from winkler.problems.pressed_shape.notes import PIXELS_ON_LAYERS, graded_notes
from winkler.profiles.power import Paraboloid
from winkler.values.validity import Assumption, Note, Standing, standing_of

__all__ = ["roller_notes"]

HARTNETT = "M. J. Hartnett, J. Lubr. Technol. 101 (1979) 105-109, doi:10.1115/1.3453270"
JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 5.4, doi:10.1017/CBO9781139171731"
ELEMENTS_ON_HALF_SPACES = Note(
    Assumption.RESPONSE,
    Standing.EXACT,
    "Frictionless contact of homogeneous, linear elastic half-spaces, every element pressing on all others.",
    HARTNETT,
)
EDGES_ON_LAYERS = Note(
    Assumption.RESOLUTION,
    Standing.APPROXIMATE,
    "On layers and gradings half-widths, and the area with them, are known to one element across: an eighth of the "
    "elements along lie across each half of the widest contact.",
    "elements that bear",
)
FINE, COARSE = 0.02, 0.1
"""Change from half as many elements up to which results count as fine, and as coarse."""


def roller_notes(
    medium: MappedMedium,
    radius: float,
    pressures: tuple[float, float],
    half_width: float,
    slope: float,
    grid_error: float,
) -> tuple[Note, ...]:
    """Return what was assumed of a roller, and what the grid leaves.

    Parameters
    ----------
    medium
        Both bodies.
    radius
        Of the roller across [m].
    pressures
        The greatest one, infinite at sharp ends, and that in the middle [Pa].
    half_width
        The greatest one [m].
    slope
        The greatest one along the roller, of its ends or its tilt [-].
    grid_error
        Relative change from half as many elements.
    """
    changes = (
        f"From half as many elements force, depth and pressures change by up to {100.0 * grid_error:.2g} per cent; the "
        "error that is left is smaller where they converge."
        if math.isfinite(grid_error)
        else "On half as many elements the very end of the roller bears and on these it does not, so that the greatest "
        "pressure is not resolved: take more elements."
    )
    homogeneous = isinstance(medium, HomogeneousMedium)
    notes = [
        *((ELEMENTS_ON_HALF_SPACES,) if homogeneous else (PIXELS_ON_LAYERS, *graded_notes(medium))),
        Note(
            Assumption.HALF_SPACE,
            Standing.APPROXIMATE,
            f"The roller is {'a half-space' if homogeneous else 'flat below its surface'} as well, as if it went on "
            "beyond its ends. A free end face beside the contact would give way and lessen the pressure near the end.",
            JOHNSON,
        ),
        Note(
            Assumption.RESOLUTION,
            standing_of(grid_error, FINE, COARSE),
            changes,
            "comparison of two grids",
            grid_error if math.isfinite(grid_error) else None,
        ),
        *(() if homogeneous else (EDGES_ON_LAYERS,)),
        steepness_note(max(half_width / radius, slope)),
        large_body_note(half_width / radius, strip=True),
    ]
    if math.isinf(pressures[0]):
        notes.append(
            Note(
                Assumption.SHAPE,
                Standing.ASYMPTOTIC,
                "A sharp end of the roller bears: the elastic pressure grows there without bound, like that at the "
                "edge of a punch. So there is no greatest pressure and no edge factor; a real edge yields or is "
                "rounded.",
                JOHNSON,
            )
        )
    return (*notes, *_yield_notes(medium, radius, *pressures))


def _yield_notes(medium: MappedMedium, radius: float, peak: float, middle: float) -> tuple[Note, ...]:
    """Return whether the most loaded slice stays elastic, taken as an endless line contact of the same pressure."""
    if not isinstance(medium, HomogeneousMedium):
        return unknown_yield(medium, "the stresses below the roller are not computed in layers")
    parts = strong_parts(medium)
    sharp = math.isinf(peak)
    pressure = middle if sharp else peak
    if not parts or pressure == 0.0:
        return ()
    bed = LineFoundation(Paraboloid(radius), medium)
    half_width = 2.0 * radius * pressure / medium.modulus
    found = [greatest(LineContact(bed, half_width, 0.0, part.solid.poisson, 0.0), von_mises) for part in parts]
    shares = [place.value / part.solid.strength for place, part in zip(found, parts, strict=True)]
    worst = max(range(len(parts)), key=shares.__getitem__)
    share = shares[worst]
    where = f"{share_of(share, parts[worst])}, {found[worst].z:.3g} m below the surface"
    if sharp:
        text = (
            f"A sharp end yields under the smallest load; in the middle of the roller the von Mises stress is {where}"
        )
    else:
        text = (
            "Taken as an endless line contact of the same greatest pressure, the most loaded slice has a von Mises "
            f"stress of {where}, which is an estimate"
        )
    beyond = "" if share < 1.0 else ": the result is not elastic"
    standing = Standing.APPROXIMATE if share < 1.0 else Standing.OUTSIDE
    return (Note(Assumption.ELASTIC, standing, f"{text}{beyond}.", MISES),)
