"""How far worn profiles can be trusted."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from winkler.foundation.bed import Bed
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.problems.assumptions.coupling import sliding_note, sticking_note
from winkler.problems.normal.stiffness_ratio import alike, stiffness_ratios
from winkler.problems.normal.strong_parts import strong_parts
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.normal.validity import indentation_notes
from winkler.problems.normal.yield_statement import SurfaceFriction
from winkler.problems.wear.states import WearState
from winkler.validity import Assumption, Note, Standing

__all__ = ["debris_note", "fretting_notes", "limiting_notes", "sliding_notes", "slip_note"]

DIMAKI = "A. V. Dimaki, A. I. Dmitriev, Y. S. Chai, V. L. Popov, Int. J. Solids Struct. 51 (2014) 4215-4220"
POPOV = "V. L. Popov, Sci. Rep. 4 (2014) 3749, doi:10.1038/srep03749"
JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge 1985, sect. 7.2, doi:10.1017/CBO9781139171731"


def debris_note() -> Note:
    """Return the note on debris."""
    return Note(
        Assumption.WEAR,
        Standing.APPROXIMATE,
        "Debris leaves the contact at once and the law of wear never changes; a layer of debris or oxide bears and "
        "slips by itself, and is not described.",
        "assumption of the law of wear",
    )


def slip_note(bed: Bed) -> Note:
    """Return the note on the slip of a fretting contact."""
    medium = bed.medium
    poisson = 0.0
    if isinstance(medium, HalfSpace):
        poisson = max(body.poisson for body in (medium.first, medium.second) if isinstance(body, Elastic))
    if poisson == 0.0 and isinstance(medium, HalfSpace):
        return Note(
            Assumption.SLIP,
            Standing.EXACT,
            "Slip is parallel to the motion and the same all around the axis, as without lateral contraction.",
            JOHNSON,
        )
    return Note(
        Assumption.SLIP,
        Standing.APPROXIMATE,
        "Slip is taken to be parallel to the motion and the same all around the axis (Cattaneo-Mindlin): with lateral "
        "contraction the worn profile would not be quite round.",
        JOHNSON,
    )


def limiting_notes(bed: Bed, radius: float) -> Iterator[Note]:
    """Yield the notes on the limiting profile around a core of a radius [m]."""
    yield Note(
        Assumption.WEAR,
        Standing.EXACT,
        "The limiting profile does not depend on the law of wear; the pressure is infinite at the edge of the core, "
        "where a real one yields or cracks.",
        POPOV,
    )
    if not alike(stiffness_ratios(bed, radius)):
        yield Note(
            Assumption.SLIP,
            Standing.APPROXIMATE,
            "On layers the radius of the core is that of springs which stick or slip by themselves, an approximation; "
            "the shape around a core of this radius is exact.",
            "flat punches have tangential tractions of another shape than pressures",
        )


def _march_notes(bed: Bed, tolerance: float, states: Sequence[WearState], rubbing: SurfaceFriction) -> list[Note]:
    # the notes on the profile's own slopes and yield before wear
    depth, radius = (np.array([getattr(states[0], word)]) for word in ("depth", "radius"))
    notes = [*indentation_notes(bed, depth, radius, rubbing), *_worn_yield(bed, states), debris_note()]
    notes.append(
        Note(
            Assumption.RESOLUTION,
            Standing.APPROXIMATE,
            f"The worn profile is known at {states[-1].radii.size} radii; each jump over many cycles errs by at most "
            f"{tolerance:.0e} of the depth. Take a finer grid or a smaller tolerance to see what that changes.",
            DIMAKI,
        )
    )
    return notes


def _worn_yield(bed: Bed, states: Sequence[WearState]) -> tuple[Note, ...]:
    """Return what is known of yield under the worn profile."""
    parts = strong_parts(bed.medium)
    if len(states) < 2 or not parts:
        return ()
    least = min(part.solid.strength for part in parts)
    share = max(float(np.max(state.pressure)) for state in states[1:]) / least
    fact = f"The greatest mean pressure of a ring is {share:.3g} of the least strength."
    return unknown_yield(bed.medium, "the stresses under the worn profile are not computed", fact)


def fretting_notes(bed: Bed, coefficient: float, tolerance: float, states: Sequence[WearState]) -> tuple[Note, ...]:
    """Return how far a fretting contact can be trusted.

    Parameters
    ----------
    bed : Bed
        Before wear.
    coefficient : float
        Of friction [-].
    tolerance : float
        Of each jump.
    states : sequence of WearState
    """
    coupled = sticking_note(bed.medium, coefficient)
    return (*_march_notes(bed, tolerance, states, SurfaceFriction(coefficient)), coupled, slip_note(bed))


def sliding_notes(bed: Bed, tolerance: float, states: Sequence[WearState]) -> tuple[Note, ...]:
    """Return how far a sliding contact can be trusted; parameters as `fretting_notes`."""
    return (
        *_march_notes(
            bed, tolerance, states, SurfaceFriction(math.inf)
        ),  # the law of wear does not define the friction
        sliding_note(bed.medium, math.nan),
        Note(
            Assumption.WEAR,
            Standing.APPROXIMATE,
            "Every point of the contact slides the whole distance: so does a body that stays in contact; on one that "
            "is rubbed along a track of many contact lengths the wear is spread, and is not counted.",
            "assumption of gross sliding",
        ),
    )
