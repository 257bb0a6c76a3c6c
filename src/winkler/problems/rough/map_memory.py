"""Whether a machine has the memory that a height map takes."""

from __future__ import annotations

import os

from winkler.errors import InvalidInput
from winkler.numerics.surfaces.surface_grid import bytes_needed

__all__ = ["refuse_too_large"]


def refuse_too_large(shape: tuple[int, ...], periodic: bool) -> None:
    """Refuse a map of a `SurfaceContact` that takes more memory than there is.

    Raises
    ------
    InvalidInput
        If it does; systems that do not report their memory are trusted.
    """
    needed = bytes_needed((shape[0], shape[1]), periodic)
    try:
        there = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, ValueError, OSError):
        return
    if needed > there:
        raise InvalidInput(
            f"SurfaceContact: a map of {shape[0]} x {shape[1]} pixels takes {needed / 2**30:.3g} GiB of memory, "
            f"this machine has {there / 2**30:.3g} GiB; take topography.coarsened(2), or a part of it."
        )
