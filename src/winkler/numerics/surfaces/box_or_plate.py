"""Layers of high contrast: conjugate gradients first, and Newton's steps where they go in circles."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from winkler.numerics.arrays import namespace_of, to_numpy
from winkler.numerics.plates.plate_contact import PlateContact
from winkler.numerics.surfaces.pressed_box import BoxContact
from winkler.numerics.surfaces.surface_grid import SurfaceGrid
from winkler.values.errors import NotConverged

__all__ = ["box_or_plate"]

STEPS_OF_PLATES = 60
"""Steps of conjugate gradients on layers of high contrast, after which Newton's are taken: smooth maps need forty."""


def box_or_plate(
    contact: BoxContact,
    plated: Callable[[], SurfaceGrid] | None,
    ceiling: float,
    tolerance: float,
    plate: bool,
) -> tuple[Any, int, bool]:
    """Solve a contact; return its pressures, the number of steps, and whether Newton's were needed.

    Parameters
    ----------
    contact : BoxContact
        The contact, whose depth is written.
    plated : callable or None
        Makes the grid in double digits, of numpy; none of layers of low contrast.
    ceiling, tolerance
        As for `BoxContact`.
    plate : bool
        Whether Newton's steps are taken at once.

    Raises
    ------
    NotConverged
        If it is not solved.
    """
    if plated is None:
        return contact.p, contact.solve(tolerance), False
    if not plate:
        try:
            return contact.p, contact.solve(tolerance, STEPS_OF_PLATES), False
        except NotConverged:
            pass  # pixels went in circles
    found = PlateContact(plated(), contact.load, ceiling, to_numpy(contact.p), to_numpy(contact.gap), contact.depth)
    count = found.solve(tolerance) + (0 if plate else STEPS_OF_PLATES)
    contact.depth = found.depth
    like, xp = contact.p, namespace_of(contact.p)
    return found.p if xp is np else xp.asarray(found.p, device=like.device), count, True
