r"""The greatest pressure of a contact without friction, wherever it is.

Where the body is smooth it is finite, for a paraboloid in the middle, :math:`p_0 = 3F/(2\pi a^2)`; at a pointed apex,
at a jump of the slope and at a sharp rim it is infinite.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.foundation.footprint import EllipticOutline
from winkler.numerics.equations.highest import highest_of_curve
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged, OutsideValidity

__all__ = ["peak_pressure"]


def peak_pressure(pressed: PressedSprings) -> float:
    """Return the greatest pressure [Pa]: infinite at a sharp apex, kink or rim, zero without contact.

    Parameters
    ----------
    pressed : PressedSprings

    Raises
    ------
    OutsideValidity
        If the bed does not define the pressure, or the profile is too rough for its integral.
    """
    bed, a = pressed.bed, pressed.radius
    if a == 0.0:
        return 0.0
    outline = bed.footprint
    if isinstance(outline, EllipticOutline):
        radius = np.array([a])
        force = float((bed.stiffness(radius) * pressed.depth - bed.gap_load(radius))[0])
        return 1.5 * force / float(outline.area(radius)[0])
    if outline.unlike_disc:
        raise OutsideValidity(f"The pressure is not known: {outline.unlike_disc}.")

    def pressure(r: Array) -> Array:
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.asarray(bed.medium.pressure(pressed, r))

    kinks = np.array([place for place, strength in pressed.kinks if strength != 0.0 and place < a])
    try:
        if pressed.edge > 0.0 or np.any(np.isposinf(pressure(kinks))):
            return math.inf
        return highest_of_curve(pressure, a)
    except NotConverged as error:
        raise OutsideValidity(f"The greatest pressure is not known: {error}") from None
