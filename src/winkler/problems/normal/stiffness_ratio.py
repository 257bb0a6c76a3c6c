"""Ratio of tangential to normal stiffness of the springs: the same everywhere, or not."""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.directional import DirectionalBed
from winkler.foundation.footprint import EllipticOutline
from winkler.loading.path import Path
from winkler.values.errors import OutsideValidity

RATIO_TOLERANCE = 1e-9
"""Springs whose ratio differs by less, relatively, are alike."""
PLANE_TOLERANCE = 0.01
"""Springs of a map that yield along x and along y with less difference may be moved in the plane."""


def stiffness_ratios(bed: Bed, radius: float) -> tuple[float, float]:
    """Return the least and the greatest c_T / c_N of the springs up to a radius [m], at sampled places.

    On homogeneous and power-law media it is G*/E* for every spring; on layers it changes along the line.

    Raises
    ------
    OutsideValidity
        If the tangential stiffness of the bed is not known.
    """
    place = radius * np.linspace(0.0, 1.0, 129)[1:]
    ratio = bed.tangential_stiffness(place) / bed.normal_stiffness(place)
    return float(np.min(ratio)), float(np.max(ratio))


def refuse_plane(owner: str, bed: Bed, path: Path) -> None:
    """Refuse a path in the plane on a bed whose stiffness along the surface is known for one direction.

    Raises
    ------
    OutsideValidity
        With what to give instead.
    """
    if path.in_plane and isinstance(bed.footprint, EllipticOutline):
        raise OutsideValidity(
            f"{owner}: the path leaves its line, and an ellipse yields differently along and across; give a path in "
            "one direction, with EllipticFoundation(bodies, medium) for shear along x, its `turned` for y."
        )
    if path.in_plane and isinstance(bed, DirectionalBed) and bed.directional > PLANE_TOLERANCE:
        raise OutsideValidity(
            f"{owner}: the path leaves its line, and this contact yields differently along x and along y, by "
            f"{100.0 * bed.directional:.2g} %; give a path in one direction, with the bed for shear along x, its "
            "`turned` for y."
        )


def alike(ratios: tuple[float, float]) -> bool:
    """Return whether a least and a greatest ratio are the same but for rounding."""
    least, greatest = ratios
    return greatest - least <= RATIO_TOLERANCE * greatest


def common_ratio(owner: str, bed: Bed, radius: float, remedy: str) -> float:
    """Return c_T / c_N of the springs up to a radius [m].

    Raises
    ------
    OutsideValidity
        If it is not the same for all of them, with the end of the sentence: why it must be, and what to give.
    """
    least, greatest = ratios = stiffness_ratios(bed, radius)
    if not alike(ratios):
        raise OutsideValidity(
            f"{owner}: the springs' tangential stiffness is between {least:.4g} and {greatest:.4g} of their normal "
            f"one; {remedy}."
        )
    return least
