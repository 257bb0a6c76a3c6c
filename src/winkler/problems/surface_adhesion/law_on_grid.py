r"""A law of adhesion on a grid: its zone must span some pixels, or surfaces stick to single ones.

Where an edge peels, the attraction acts over a zone of about :math:`\ell = E^*w/\sigma^2`, with the strength
:math:`\sigma`.  A pixel in it is held by the stiffness of the surface over a pixel, about :math:`E^*/\Delta x`, against
the softening of the law; where the law softens faster, single pixels jump, and the edge is pinned by the grid.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.laws.adhesion import Dugdale, ShortRange
from winkler.laws.attraction import ExponentialAttraction, LennardJones
from winkler.numerics.attracted.attraction import Attraction, EightTwo, Exponential, RoundedStep
from winkler.problems.adhesion.tabor import tabor_parameter
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput, OutsideValidity

RangedLaw = ShortRange | Dugdale | ExponentialAttraction | LennardJones
"""What may attract height maps."""
LEAST_SPAN = {Exponential: 2.0, EightTwo: 2.5, RoundedStep: 4.0}
"""Pixels that the zone must span: then the law softens half as fast as the surface over a pixel is stiff."""
ROUNDED = 0.4
"""Half the width over which Dugdale's stress ends on a grid, over its range."""
ROUNDING = 1e-9


class AttractionOnGrid(NamedTuple):
    """A law on a grid.

    Parameters
    ----------
    law
        In units of its work and range.
    work
        w [J/m^2].
    range
        The unit of gaps [m].
    span
        Pixels that the zone spans.
    """

    law: Attraction
    work: float
    range: float
    span: float


def attraction_on_grid(stated: RangedLaw, modulus: float, pixel: tuple[float, float]) -> AttractionOnGrid:
    """Return a law on a grid.

    Raises
    ------
    OutsideValidity
        If its zone is shorter than the grid resolves.
    InvalidInput
        If closing and opening take different work.
    """
    longest = max(pixel)
    match stated:
        case ShortRange():
            if stated.work_closing != stated.work:
                raise InvalidInput(
                    "SurfaceAdhesion: a law that gains less in closing than opening takes has no energy to be minimal; "
                    "give ShortRange(work), and jumps make the hysteresis."
                )
            reach = math.sqrt(LEAST_SPAN[Exponential] * longest * stated.work / modulus)
            return AttractionOnGrid(Exponential(), stated.work, reach, LEAST_SPAN[Exponential])
        case Dugdale():
            law: Attraction = RoundedStep(ROUNDED)
            work, reach = stated.work, stated.range
        case ExponentialAttraction():
            law, work, reach = Exponential(), stated.work, stated.range
        case LennardJones():
            law, work, reach = EightTwo(), stated.work, stated.spacing
    span = modulus * reach * reach / (work * law.peak**2 * longest)
    least = LEAST_SPAN[type(law)]
    if span < least * (1.0 - ROUNDING):
        longer = reach * math.sqrt(least / span)
        word = {"EightTwo": "spacing", "Exponential": "range", "RoundedStep": "range work / strength"}[
            type(law).__name__
        ]
        raise OutsideValidity(
            "SurfaceAdhesion: where surfaces part, the attraction acts over a zone E* w / strength^2 of "
            f"{span * longest:.3g} m, {span:.2g} pixels. This law needs {least:g}, or the grid pins the edge. Take "
            f"pixels of at most {span * longest / least:.3g} m, a {word} of at least {longer:.3g} m, or "
            "ShortRange(work), whose range is as short as the grid allows."
        )
    return AttractionOnGrid(law, work, reach, span)


def curvature_radius(rough: Topography) -> float:
    """Return R [m], one over the root mean square of the mean curvature between the pixels of a map; may be inf."""
    z, (dx, dy) = rough.heights, rough.pixel
    if rough.periodic:
        bent = [np.roll(z, 1, i) - 2.0 * z + np.roll(z, -1, i) for i in (0, 1)]
        mean = 0.5 * (bent[0] / dx**2 + bent[1] / dy**2)
    elif min(z.shape) > 2:
        inner = z[1:-1, 1:-1]
        mean = 0.5 * (
            (z[2:, 1:-1] - 2.0 * inner + z[:-2, 1:-1]) / dx**2 + (z[1:-1, 2:] - 2 * inner + z[1:-1, :-2]) / dy**2
        )
    else:
        return math.inf
    curved = math.sqrt(float(np.mean(mean**2)))
    return 1.0 / curved if curved > 0.0 else math.inf


def tabor_of_map(rough: Topography, modulus: float, on_grid: AttractionOnGrid) -> float:
    """Return Tabor's parameter of a ball as curved as the map [-]; infinite of a flat one."""
    radius = curvature_radius(rough)
    if math.isinf(radius):
        return math.inf
    return tabor_parameter(curvature_radius=radius, modulus=modulus, work=on_grid.work, distance=on_grid.range)
