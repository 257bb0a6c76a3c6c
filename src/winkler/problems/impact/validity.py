"""Validity notes of every impact, and the number of its states."""

from __future__ import annotations

from typing import Annotated, TypeAlias

import numpy as np

from winkler.foundation.bed import Bed
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.direction import direction_notes
from winkler.problems.ring_slip.moving_notes import IN_IMPACTS, moving_ring_notes
from winkler.values.checks.number_checks import Whole
from winkler.values.validity import Assumption, Note, Standing

__all__ = ["PLANAR", "Moments", "gravity_note", "slip_notes"]

MAW = "N. Maw, J. R. Barber, J. N. Fawcett, Wear 38 (1976) 101-114, doi:10.1016/0043-1648(76)90201-5"

PLANAR = Note(
    Assumption.SLIP,
    Standing.ASYMPTOTIC,
    "Tractions are taken along the motion (Cattaneo-Mindlin); within that, sticking, sliding and turning back are "
    "followed exactly. Spin about the normal is left out.",
    MAW,
)


def gravity_note(force: Array) -> Note:
    """Return what was left out, against the forces of the contact [N]."""
    return Note(
        Assumption.INERTIA,
        Standing.ASYMPTOTIC,
        f"Gravity and other forces are left out: they must be small against the {np.max(force):.4g} N of the contact.",
        "equations of motion",
    )


def slip_notes(bed: Bed, coefficient: float, radius: float) -> tuple[Note, ...]:
    """Return what is assumed of slip in an impact whose widest contact has this radius [m]."""
    along = moving_ring_notes(bed, coefficient, radius, IN_IMPACTS) or (PLANAR,)
    return (*along, sticking_note(bed.medium, coefficient), *direction_notes(bed))


Moments: TypeAlias = Annotated[int, Whole(2, 1_000_000, "moments")]
