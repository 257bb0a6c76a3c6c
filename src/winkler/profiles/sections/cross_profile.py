r"""A profile across the direction of rolling: points joined by a spline, so that its curvature is kept.

A cubic spline through the points along their chord gives y and z; where the profile is not steeper than 80 degrees the
height follows as a function z(y).  Straight lines between the points would be polyhedra: their edges press harder, on a
wheel of 400 points by half.
"""

from __future__ import annotations

import functools
import math
from typing import TYPE_CHECKING

import numpy as np

from winkler.numerics.types import Array
from winkler.values.checks.number_checks import FiniteRow, NonNegative
from winkler.values.errors import InvalidInput, NotConverged
from winkler.values.value import value, words

if TYPE_CHECKING:
    from scipy.interpolate import PPoly

FEWEST_POINTS = 5
STEEPEST = math.radians(80.0)
"""Steepest part that is kept [rad]: beyond it the height is no function of y."""
PIECES = 8
"""Pieces of the height z(y) for each interval of the points."""
SAME_PLACE = 1e-9
"""Distance of two points over the length of the profile within which they are one."""
LAST_USABLE, MOST_LEFT = 3, 4.0
"""Last state of FITPACK with a spline, and the sum of squares it may leave over that asked for."""
ROUNDING = 1e-13
"""Scatter over the greatest place or height below which it is rounding, and the spline goes through all points."""


@value
class CrossProfile:
    """A profile across the direction of rolling: of a rail, a wheel, a cam, a roller, a groove.

    Parameters
    ----------
    y : array_like, (n,)
        Places across [m], in order along the profile, in either direction.
    z : array_like, (n,)
        Heights [m], up.
    smoothing : float, optional
        Scatter of the measured points [m]; it determines the smoothing of the spline.  With zero (the default), or a
        value below the rounding of the data, the spline passes through all points.

    Raises
    ------
    InvalidInput
        If there are fewer than five points, the arrays differ in length, or the whole profile is steep.
    NotConverged
        If no spline with the requested smoothing is found.

    Examples
    --------
    An arc of 300 mm:

    >>> import numpy as np
    >>> y = np.linspace(-20e-3, 20e-3, 41)
    >>> arc = CrossProfile(y, np.sqrt(0.3**2 - y**2) - 0.3)
    >>> round(float(1.0 / arc.curvature(np.array(0.5e-3))), 3)
    -0.3
    """

    __words__ = words(
        y=("y", "m", "places across the direction of rolling"),
        z=("z", "m", "heights of the profile, up"),
        smoothing=(r"\sigma", "m", "scatter of the measured points"),
        ends=("", "m", "between which places the height is known"),
    )

    y: FiniteRow
    z: FiniteRow
    smoothing: NonNegative = 0.0

    def __post_init__(self) -> None:
        if self.y.shape != self.z.shape or self.y.size < FEWEST_POINTS:
            raise InvalidInput(
                f"CrossProfile: y has the shape {self.y.shape} and z {self.z.shape}; give two rows of at least "
                f"{FEWEST_POINTS} numbers each."
            )
        _ = self._heights

    @functools.cached_property
    def _heights(self) -> PPoly:
        """The height z(y)."""
        from scipy.interpolate import CubicHermiteSpline

        y, z, dy, dz = self._fine
        gentle = np.abs(np.arctan2(dz, np.abs(dy))) < STEEPEST
        forward = np.where(gentle, np.sign(dy), 0.0)
        stretches = np.split(np.arange(y.size), np.flatnonzero(np.diff(forward)) + 1)
        best = max((part for part in stretches if forward[part[0]] != 0.0), key=lambda part: float(np.ptp(y[part])),
                   default=np.zeros(1, dtype=int))  # fmt: skip
        order = best[np.argsort(y[best])]
        apart = np.concatenate([[True], np.diff(y[order]) > 0.0])
        order = order[apart]
        if order.size < FEWEST_POINTS:
            raise InvalidInput(
                "CrossProfile: the profile is steeper than 80 degrees everywhere; give y across and z up, both in m."
            )
        made: PPoly = CubicHermiteSpline(y[order], z[order], dz[order] / dy[order], extrapolate=False)
        return made

    @property
    def _fine(self) -> tuple[Array, Array, Array, Array]:
        """Places and heights along the spline, and their derivatives along it."""
        from scipy.interpolate import CubicSpline, splev, splprep

        steps = np.hypot(np.diff(self.y), np.diff(self.z))
        apart = np.concatenate([[True], steps > SAME_PLACE * float(np.sum(steps))])
        y, z = self.y[apart], self.z[apart]
        if y.size < FEWEST_POINTS:
            raise InvalidInput("CrossProfile: nearly all points lie at one place; give a profile in m.")
        along = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])
        share = (np.arange(PIECES) / PIECES)[None, :]
        fine = np.append((along[:-1, None] + share * np.diff(along)[:, None]).ravel(), along[-1])
        if self.smoothing > ROUNDING * max(float(np.max(np.abs(y))), float(np.max(np.abs(z)))):
            most = y.size * self.smoothing**2
            (knots, _), left, state, _ = splprep([y, z], u=along, s=most, full_output=True, quiet=1)
            if state > LAST_USABLE or not left <= MOST_LEFT * most:
                raise NotConverged(
                    f"CrossProfile: no spline is found that stays within the smoothing of {self.smoothing:.3g} m of "
                    "the points; give another smoothing, or zero."
                )
            (across, up), (dy, dz) = splev(fine, knots), splev(fine, knots, der=1)
            return np.asarray(across), np.asarray(up), np.asarray(dy), np.asarray(dz)
        spline = CubicSpline(along, np.stack([y, z], axis=1))
        places, slopes = spline(fine), spline(fine, 1)
        return places[:, 0], places[:, 1], slopes[:, 0], slopes[:, 1]

    @property
    def ends(self) -> tuple[float, float]:
        """The places [m] between which the height is known."""
        return float(self._heights.x[0]), float(self._heights.x[-1])

    def height(self, y: Array) -> Array:
        """z(y) [m]; not a number beyond the ends."""
        return np.asarray(self._heights(y))

    def slope(self, y: Array) -> Array:
        """z'(y) [-]."""
        return np.asarray(self._heights(y, 1))

    def curvature(self, y: Array) -> Array:
        """The curvature [1/m], negative where the profile is convex."""
        return np.asarray(self._heights(y, 2) / (1.0 + self._heights(y, 1) ** 2) ** 1.5)
