r"""Steps of the wear of a height map: implicit, each stage a contact with a film that is as soft as the step is long.

In a stage of the length :math:`\gamma\Delta s` every pixel loses :math:`\gamma\Delta s\,\kappa\,p`, in proportion to
its own pressure at the end of the stage: to the contact this is a film that yields by so much where it is pressed.
Two stages with :math:`\gamma=1-\sqrt{1/2}` make a step of second order that is L-stable, never gives back what has been
worn off, and takes off :math:`\kappa F\Delta s` to rounding.

R. Alexander, SIAM J. Numer. Anal. 14 (1977) 1006-1021, doi:10.1137/0714068
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.pixels.layered import SurfaceBelow
from winkler.numerics.surfaces.pressed_box import ByDepth, ByLoad
from winkler.numerics.surfaces.pressed_grid import PressedSurface, press
from winkler.numerics.types import Array

GAMMA = 1.0 - math.sqrt(0.5)
LEAST_ELASTIC_SHARE = 1e-5
"""Part of the approach that is elastic, below which contacts are not solved to less of it."""


class WearStep(NamedTuple):
    """What a step came to.

    Parameters
    ----------
    worn
        What has been lost [m], (nx, ny).
    load_distance
        Sum of p / E* over the pixels, integrated over the distance of the step [m].
    contact
        The contact at its end.
    """

    worn: Array
    load_distance: float
    contact: PressedSurface


class WornMap(NamedTuple):
    """A map that wears: all that does not change on its way.

    Parameters
    ----------
    gaps
        Distances below the highest point before wear [m], (nx, ny).
    pixel, periodic, layers, ceiling, tolerance
        As of `winkler.numerics.surfaces.pressed_grid.press`.
    drive
        What is prescribed all the way.
    softness
        Worn depth per distance under a pressure of E* [-].
    """

    gaps: Array
    pixel: tuple[float, float]
    periodic: bool
    layers: SurfaceBelow | None
    ceiling: float
    drive: ByDepth | ByLoad
    softness: float
    tolerance: float

    def pressed(self, worn: Array, film: float, start: Array | tuple[()], elastic: float = 1.0) -> PressedSurface:
        """Return the contact of the worn map under a film of this compliance [m].

        Parameters
        ----------
        worn, film
            [m].
        start
            Pressures nearby, over E*.
        elastic
            Part of the approach that was elastic before: the overlap left counts by that.
        """
        return press(
            self.gaps + worn, self.pixel, self.drive, periodic=self.periodic, ceiling=self.ceiling,
            tolerance=self.tolerance * min(max(elastic, LEAST_ELASTIC_SHARE), 1.0), start=start, layers=self.layers,
            film=film,
        )  # fmt: skip

    def elastic_share(self, worn: Array, contact: PressedSurface) -> float:
        """Return which part of the approach of a contact is elastic."""
        return 1.0 - float(np.min(self.gaps + worn)) / contact.depth

    def step(self, worn: Array, before: PressedSurface, length: float) -> WearStep:
        """Return what the map has lost after a step [m].

        Parameters
        ----------
        worn
            What it has lost at its beginning [m].
        before
            The contact there.
        length
            Of the step [m].

        Raises
        ------
        NotConverged
            If a contact is not solved.
        """
        lost = length * self.softness
        share = self.elastic_share(worn, before)
        one = self.pressed(worn, GAMMA * lost, before.pressure, share)
        base = worn + (1.0 - GAMMA) * lost * one.pressure
        two = self.pressed(base, GAMMA * lost, one.pressure, share)
        carried = (1.0 - GAMMA) * float(np.sum(one.pressure)) + GAMMA * float(np.sum(two.pressure))
        return WearStep(base + GAMMA * lost * two.pressure, length * carried, two)
