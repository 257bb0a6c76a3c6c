"""Dissimilar bodies: tractions sink the surface, pressures draw it along; both are found by turns (Panagiotopoulos)."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Protocol, TypeVar

import numpy as np

from winkler.numerics.pixels.layered import SurfaceBelow
from winkler.numerics.plates.pressed_sums import overlap_and_work
from winkler.numerics.surfaces.pressed_box import ByDepth, ByLoad
from winkler.numerics.surfaces.pressed_grid import PressedSurface, press
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

MOST_TURNS = 60
"""How often pressures and tractions are found by turns; six are usual."""
COUPLED_TOLERANCE = 1e-5
"""Least bound on overlap and work on gaps where pressures and tractions are found by turns."""


class Rubbed(Protocol):
    """A surface whose tractions have been found."""

    @property
    def traction(self) -> Array:
        """q / E*, (2, nx, ny)."""
        ...


Found = TypeVar("Found", bound=Rubbed)
"""What the tractions are found with."""


def press_from(
    gaps: Array,
    pixel: tuple[float, float],
    drive: ByDepth | ByLoad,
    *,
    periodic: bool,
    start: Array,
    layers: SurfaceBelow | None = None,
) -> PressedSurface:
    """Press a surface whose lowest gap need not be zero; of a depth that does not reach it nothing touches.

    Parameters
    ----------
    gaps, pixel, drive, periodic, start, layers
        As of `winkler.numerics.surfaces.pressed_grid.press`.
    """
    lowest = float(np.min(gaps))
    deeper = ByDepth(drive.depth - lowest) if isinstance(drive, ByDepth) else drive
    if not max(deeper) > 0.0:
        return PressedSurface(np.zeros(gaps.shape), gaps - max(drive), max(drive), 0.0, 0.0, 0)
    pressed = press(gaps - lowest, pixel, deeper, periodic=periodic, start=start, layers=layers)
    return pressed._replace(depth=pressed.depth + lowest)


def by_turns(
    grid: TractionGrid,
    gaps: Array,
    length: float,
    pressed_on: Callable[[Array], PressedSurface],
    rubbed_under: Callable[[Array, Array], Found],
    start: Array,
    tolerance: float,
    *,
    by_load: bool,
) -> tuple[PressedSurface, Found]:
    """Return pressures and tractions that agree.

    Parameters
    ----------
    grid
        The surface, lengths in pixels.
    gaps, length
        Of the bodies before they touch [m], and of a pixel along x [m].
    pressed_on
        Presses these gaps [m].
    rubbed_under
        Finds tractions under pressures over E*, from tractions to begin with.
    start
        Tractions to begin with, over E*.
    tolerance
        Bound on overlap and work on gaps, as of `overlap_and_work`; `COUPLED_TOLERANCE` at least.
    by_load
        Whether the depth is sought.

    Raises
    ------
    NotConverged
        If they do not agree.
    """
    allowed, left = max(tolerance, COUPLED_TOLERANCE), math.inf
    for _ in range(MOST_TURNS):
        pressed = pressed_on(gaps + length * grid.sunk(start))
        p = pressed.pressure
        rubbed = rubbed_under(p, start)
        gap = gaps + length * (grid.grid.displaced(p) + grid.sunk(rubbed.traction)) - pressed.depth
        deeper = float(np.mean(gap[p > 0.0])) if by_load else 0.0
        overlap, work = overlap_and_work(p, gap - deeper, pressed.depth + deeper, math.inf)
        left, start = max(overlap, work), rubbed.traction
        if left <= allowed:
            depth = pressed.depth + deeper
            return pressed._replace(gap=gap - deeper, depth=depth, penetration=overlap, work=work), rubbed
    raise NotConverged(
        f"pressures and tractions of dissimilar bodies still miss each other by {left:.3g} of the depth after "
        f"{MOST_TURNS} turns; allowed are {allowed:.3g}. Take shorter steps, or bodies of closer elasticity"
    )
