"""Whether a machine has the memory that a height map takes, said before it is taken."""

from __future__ import annotations

import logging

from winkler.numerics.surfaces.surface_grid import bytes_needed
from winkler.values.checks.free_memory import free_memory, whole_memory
from winkler.values.errors import InvalidInput

LOG = logging.getLogger(__name__)
STATED_BYTES = 2**28
"""Memory from which on it is said how much a map takes; less is free on any machine."""
GIB = 2.0**30


def refuse_too_large(shape: tuple[int, ...], periodic: bool, owner: str = "SurfaceContact", takes: int = 0) -> None:
    """Refuse a map that takes more memory than the machine has.

    Parameters
    ----------
    shape
        (nx, ny) of the map.
    periodic
        Whether it is repeated.
    owner
        The problem that was solved.
    takes
        Its memory [byte]; that of a `SurfaceContact` unless given.

    Raises
    ------
    InvalidInput
        If it does; systems that do not report their memory are trusted.
    """
    needed, there = takes or bytes_needed((shape[0], shape[1]), periodic), whole_memory()
    if needed > there:
        raise InvalidInput(
            f"{owner}: a map of {shape[0]} x {shape[1]} pixels takes {needed / GIB:.3g} GiB of memory, "
            f"this machine has {there / GIB:.3g} GiB; use topography.coarsened(2), or a part of it."
        )


def state_memory(shape: tuple[int, ...], periodic: bool, owner: str = "SurfaceContact", takes: int = 0) -> None:
    """State how much memory a map takes, before it is taken; small ones are not mentioned.

    Parameters
    ----------
    shape, periodic, owner, takes
        As of `refuse_too_large`.

    Raises
    ------
    InvalidInput
        If it is more than is free now.
    """
    needed = takes or bytes_needed((shape[0], shape[1]), periodic)
    if needed < STATED_BYTES:
        return
    free = free_memory()
    sentence = (
        f"{owner}: a map of {shape[0]} x {shape[1]} pixels takes about {needed / GIB:.2g} GiB of memory, of "
        f"{max(free, 0.0) / GIB:.2g} GiB that are free"
    )
    if needed > free:
        raise InvalidInput(f"{sentence}; end other programs, use topography.coarsened(2), or a part of the map.")
    LOG.info("%s.", sentence)
