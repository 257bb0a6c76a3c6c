"""How the tangential stiffness of the springs compares with the normal one: the same everywhere, or not."""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import Bed

__all__ = ["alike", "stiffness_ratios"]

LIKENESS = 1e-9
"""Springs whose ratio differs by less, relatively, are alike."""


def stiffness_ratios(bed: Bed, radius: float) -> tuple[float, float]:
    """Return the least and the greatest c_T / c_N of the springs up to a radius [m], at sampled places.

    On homogeneous and power-law media it is G*/E* for every spring; on layers it changes along the line.

    Raises
    ------
    OutsideValidity
        If the bed does not know its tangential stiffness.
    """
    place = radius * np.linspace(0.0, 1.0, 129)[1:]
    ratio = bed.tangential_stiffness(place) / bed.normal_stiffness(place)
    return float(np.min(ratio)), float(np.max(ratio))


def alike(ratios: tuple[float, float]) -> bool:
    """Return whether a least and a greatest ratio are the same but for rounding."""
    least, greatest = ratios
    return greatest - least <= LIKENESS * greatest
