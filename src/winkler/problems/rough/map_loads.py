"""Loads that a height map cannot be pressed with."""

from __future__ import annotations

import numpy as np

from winkler.loading.loads import Depth, Force
from winkler.loading.path import numbers_of
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput, OutsideValidity

__all__ = ["check_loads"]


def check_loads(rough: Topography, load: Force | Depth, hardness: float, compressible: bool) -> None:
    """Refuse loads that do not press, depths that close a periodic map, and forces that its hardness does not bear.

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
    InvalidInput
        Of a load that is not positive.
    OutsideValidity
        Of one that is too great.
    """
    flat = numbers_of(load).ravel()
    bad = np.flatnonzero(~(flat > 0.0))
    if bad.size:
        raise InvalidInput(
            f"SurfaceContact: load {bad[0]} is {flat[bad[0]]:.6g}; without adhesion bodies are pressed together, "
            "give positive loads."
        )
    most = float(np.max(flat))
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
