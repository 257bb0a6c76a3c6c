r"""The pull-off force of an attraction without range (JKR), from two attractions of short range.

Beside an edge that parts, an attraction acts over a zone of the length :math:`\ell = E^*w/\sigma^2`.  As long as it is
narrow, the pull-off force differs from that without range by about :math:`\ell^{4/5}`: of balls under the exponential
law by 3.6, 2.1 and 1.2 per cent at Tabor numbers of 2.5, 3.5 and 5, so that halving the zone takes off a factor of 1.7
to 1.8; as :math:`\ell` itself if the zone vanishes.  Two zones, the second twice as long, give the limit.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from winkler.laws.adhesion import ShortRange
from winkler.laws.attraction import ExponentialAttraction
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, OutsideValidity

__all__ = ["PullOffWithoutRange", "cut_off", "greatest_pull", "limit_of_two", "refuse_long_ranges", "two_ranges"]

SPANS = (3.0, 6.0)
"""Pixels in the zones: with three to six the grid changes the pull-off force of a ball by less than 0.1 per cent."""
LEAST_TABOR = 2.0
"""Of the shorter range on a ball as curved as the map: below it forces of both ranges come near to each other again, as
those without deformation do, and tell nothing of the limit."""
POWER = 0.8
"""Of the length of the zone, to which the force differs from that without range."""


class PullOffWithoutRange(NamedTuple):
    """The pull-off force without range.

    Parameters
    ----------
    force
        Lowest force [N], tension negative.
    error
        By how much the forces under both laws differ, and what the border of a map that stands alone cuts off [N]: of
        balls the limit is nearer than this.
    ranges
        Of both exponential laws [m].
    forces
        Lowest forces under them [N].
    """

    force: float
    error: float
    ranges: tuple[float, float]
    forces: tuple[float, float]


def two_ranges(law: object, modulus: float, pixel: tuple[float, float]) -> tuple[ExponentialAttraction, ...]:
    """Return exponential laws of two ranges in place of one without range.

    Raises
    ------
    InvalidInput
        If the law has a range of its own.
    """
    if not isinstance(law, ShortRange):
        raise InvalidInput(
            f"SurfaceAdhesion: {type(law).__name__} has a range, to which its pull-off force belongs; the limit "
            "without range is that of ShortRange(work)."
        )
    reach = [math.sqrt(span * max(pixel) * law.work / modulus) for span in SPANS]
    return tuple(ExponentialAttraction(law.work, each) for each in reach)


def refuse_long_ranges(tabor: float) -> None:
    """Refuse ranges that are too long for the limit.

    Parameters
    ----------
    tabor : float
        Tabor's parameter of a ball as curved as the map under the shorter range [-].

    Raises
    ------
    OutsideValidity
        If it is below two.
    """
    if tabor < LEAST_TABOR:
        raise OutsideValidity(
            f"SurfaceAdhesion: the shortest range that these pixels resolve has a Tabor number of {tabor:.3g} on a "
            f"ball as curved as the map. The pull-off force without range follows from {LEAST_TABOR:g} on: take "
            f"pixels of at most {(tabor / LEAST_TABOR) ** 2:.2g} times this size."
        )


def greatest_pull(depth: Array, force: Array) -> float:
    """Return the lowest force of a path, on the parabola through the lowest of its forces and those on both sides.

    Raises
    ------
    InvalidInput
        If the lowest force is at an end of the path.
    """
    k = int(np.argmin(force))
    if not 0 < k < force.size - 1:
        raise InvalidInput(
            f"SurfaceAdhesion: the lowest force is at the {'end' if k else 'beginning'} of the path, at the "
            f"displacement {depth[k]:.6g} m; give displacements on both sides of the pull-off."
        )
    x, y = depth[k - 1 : k + 2] - depth[k], force[k - 1 : k + 2] - force[k]
    if not x[0] * x[2] < 0.0:  # the path turns here
        return float(force[k])
    slopes = y[0] / x[0], y[2] / x[2]
    curvature = (slopes[1] - slopes[0]) / (x[2] - x[0])
    slope = slopes[0] - curvature * x[0]
    return float(force[k] - 0.25 * slope * slope / curvature) if curvature > 0.0 else float(force[k])


def cut_off(pressure: Array, pixel: tuple[float, float]) -> float:
    """Return about what a map that stands alone lacks beyond its border [N]: the pull there over the longer zone.

    Parameters
    ----------
    pressure : ndarray, (nx, ny)
        p [Pa] of the strongest pull, tension negative.
    pixel : tuple of float
        (dx, dy) [m].
    """
    edges = float(np.sum(pressure[[0, -1]])) + float(np.sum(pressure[:, [0, -1]]))
    return SPANS[1] * abs(min(edges, 0.0)) * pixel[0] * pixel[1]


def limit_of_two(
    laws: Sequence[ExponentialAttraction], forces: Sequence[float], cut: float = 0.0
) -> PullOffWithoutRange:
    """Return the limit of the forces under both laws, and its error with what the border cuts off."""
    short, long = forces
    change, ratio = short - long, SPANS[1] / SPANS[0]
    limit = short + change / (ratio**POWER - 1.0)
    return PullOffWithoutRange(limit, abs(change) + cut, (laws[0].range, laws[1].range), (short, long))
