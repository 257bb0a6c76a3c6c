"""What every impact says about itself, and which numbers it refuses."""

from __future__ import annotations

import numpy as np

from winkler.errors import InvalidInput
from winkler.numerics.types import Array
from winkler.validity import Assumption, Note, Standing

__all__ = ["PLANAR", "checked_count", "gravity_note"]

MAW = "N. Maw, J. R. Barber, J. N. Fawcett, Wear 38 (1976) 101-114, doi:10.1016/0043-1648(76)90201-5"
FEWEST, MOST = 2, 1_000_000

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


def checked_count(owner: str, count: int) -> None:
    """Refuse what is no sensible number of moments."""
    if isinstance(count, bool) or not isinstance(count, int) or not FEWEST <= count <= MOST:
        raise InvalidInput(f"{owner}: count is {count!r}; give a whole number of moments from {FEWEST} to {MOST}.")
