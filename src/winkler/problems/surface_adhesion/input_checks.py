"""What is refused before an attracted map is solved: too large maps, missing heights, a path that closes a period."""

from __future__ import annotations

import numpy as np

from winkler.loading.loads import Depth
from winkler.loading.path import numbers_of
from winkler.numerics.attracted.elastic_surface import attracted_bytes
from winkler.problems.rough.map_memory import refuse_too_large
from winkler.profiles.rough.topography import Topography
from winkler.values.checks.number_checks import affordable
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.limits import MOST_NUMBERS

__all__ = ["check_adhesion", "memory_of"]


def memory_of(rough: Topography) -> int:
    """Return the memory [byte] that a map takes at most."""
    return attracted_bytes(rough.heights.shape, rough.periodic)


def check_adhesion(rough: Topography, path: Depth) -> None:
    """Raise if a map cannot be brought through these displacements.

    Raises
    ------
    InvalidInput
        If heights are missing, the path is no row, or the map is too large.
    OutsideValidity
        If a periodic map closes.
    """
    around = 1 if rough.periodic else 4
    affordable("SurfaceAdhesion", "pixels with their surroundings", around * rough.heights.size, MOST_NUMBERS)
    refuse_too_large(rough.heights.shape, rough.periodic, "SurfaceAdhesion", memory_of(rough))
    if rough.missing:
        raise InvalidInput(
            f"SurfaceAdhesion: {rough.missing} of {rough.heights.size} heights are missing; fill them with "
            "topography.filled(), or cut a complete part out with topography.cropped(...)."
        )
    given = numbers_of(path)
    if given.ndim != 1 or not given.size:
        raise InvalidInput(
            f"SurfaceAdhesion: the path has the shape {given.shape}; give its displacements one after the other in "
            "one row."
        )
    whole = float(np.mean(rough.gaps))
    if rough.periodic and np.any(given >= whole):
        raise OutsideValidity(
            f"SurfaceAdhesion: the displacement {np.max(given):.6g} m closes the periodic map, whose mean planes "
            f"can approach by less than {whole:.6g} m; stay below it."
        )
