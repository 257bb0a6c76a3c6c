"""Whether the creepages of bodies that roll are small, as the theory of rolling takes them."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array, Quantity
from winkler.values.validity import Assumption, Note, standing_of

KALKER = "J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, doi:10.1007/978-94-015-7889-9"
SMALL, LARGE = 0.03, 0.1
"""Creepage [-] that is small, and from which on both bodies no longer pass the contact at one speed."""


def small_creep_note(greatest: float) -> Note:
    """Return whether the greatest creepage in a contact [-] is small against one."""
    standing = standing_of(greatest, SMALL, LARGE)
    limit = f"its limit is {100.0 * LARGE:.0f} per cent, beyond which the bodies slide more than they roll"
    return Note(
        Assumption.SMALL_SLOPES,
        standing,
        f"The theory of rolling assumes creepages small compared with one; here they reach {100.0 * greatest:.2g} "
        f"per cent{'' if greatest <= LARGE else ', and ' + limit}.",
        KALKER,
    )


def greatest_slip(longitudinal: Quantity, lateral: Quantity, spin: Quantity, touching: Array, pixel: Array) -> float:
    """Return the greatest slip of rigid bodies in a contact [-].

    Parameters
    ----------
    longitudinal, lateral, spin : float or ndarray
        Creepages [-], [-], [1/m].
    touching : ndarray of bool, (nx, ny)
        Which pixels touch.
    pixel : array_like, (2,)
        Their size [m].
    """
    places = np.argwhere(touching) - 0.5 * (np.array(touching.shape) - 1.0)
    far = float(np.max(np.hypot(*(places * pixel).T), initial=0.0))
    return float(np.max(np.hypot(longitudinal, lateral) + np.abs(spin) * far))
