"""Loads that a height map cannot be pressed with."""

from __future__ import annotations

import numpy as np

from winkler.errors import OutsideValidity
from winkler.loading import Depth, Force
from winkler.path import numbers_of
from winkler.profiles.rough.topography import Topography

__all__ = ["refuse_too_deep"]


def refuse_too_deep(rough: Topography, load: Force | Depth, hardness: float, compressible: bool) -> None:
    """Refuse depths that close a periodic map, and forces that its hardness does not bear.

    Parameters
    ----------
    rough : Topography
    load : Force or Depth
        What is prescribed of a `SurfaceContact`.
    hardness : float
        Greatest pressure [Pa].
    compressible : bool
        Whether a uniform pressure of all the surface has a depth.

    Raises
    ------
    OutsideValidity
    """
    most = float(np.max(numbers_of(load)))
    whole = float(np.mean(rough.gaps))
    if rough.periodic and not compressible and isinstance(load, Depth) and most >= whole:
        raise OutsideValidity(
            f"SurfaceContact: the depth {most:.6g} m closes the periodic map, whose mean planes can "
            f"approach by less than {whole:.6g} m; prescribe a Force."
        )
    if isinstance(load, Force) and most >= hardness * rough.area:
        raise OutsideValidity(
            f"SurfaceContact: the force {most:.6g} N is more than hardness times the area of the map, "
            f"{hardness * rough.area:.6g} N; press less."
        )
