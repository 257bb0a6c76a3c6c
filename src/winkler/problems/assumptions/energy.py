"""Whether a march keeps account of energy: what is put in is stored or lost, and the three are compared."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import ArrayLike
from winkler.values.validity import Assumption, Note, Standing

ENERGY_ROUNDING, LARGE_MISSING_ENERGY = 1e-9, 1e-3
"""Part of the greatest energy [-] up to which what is missing is rounding, and from which on energies are not known."""
CHECK = (
    "work, stored and dissipated energy compared at each point; the page on validity states where one follows "
    "from others"
)


def missing_energy(work: ArrayLike, stored: ArrayLike, lost: ArrayLike) -> float:
    """Return what is missing at worst in work = stored + lost, over the greatest of these energies [-].

    Parameters
    ----------
    work, stored, lost : array_like, (steps,)
        Spent since the beginning, stored, and lost since the beginning [J].
    """
    three = [np.atleast_1d(np.asarray(each, dtype=float)) for each in (work, stored, lost)]
    if not all(np.all(np.isfinite(each)) for each in three):
        return float("inf")
    scale = max(float(np.max(np.abs(each), initial=0.0)) for each in three)
    missing = float(np.max(np.abs(three[0] - three[1] - three[2]), initial=0.0))
    return missing / scale if scale > 0.0 else 0.0


def energy_note(work: ArrayLike, stored: ArrayLike, lost: ArrayLike) -> Note:
    """Return whether the energies of a march add up; they are those of `missing_energy`."""
    missing = missing_energy(work, stored, lost)
    if missing <= ENERGY_ROUNDING:
        standing = Standing.EXACT
        verdict = "nothing but rounding"
    elif missing <= LARGE_MISSING_ENERGY:
        standing = Standing.APPROXIMATE
        verdict = "dissipated energies below this error are not meaningful"
    else:
        standing = Standing.OUTSIDE
        verdict = "do not use the energies of this solution"
    return Note(
        Assumption.ENERGY,
        standing,
        f"The energy balance (work, stored energy, dissipated energy) has an error of {missing:.2g} of the "
        f"largest of them: {verdict}.",
        CHECK,
    )
