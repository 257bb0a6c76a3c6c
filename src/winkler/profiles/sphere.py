r"""Spheres, ellipsoids and hyperboloids, without the parabolic approximation.

Sphere: :math:`f = R-\sqrt{R^2-r^2}` gives :math:`g = x\,\mathrm{artanh}(x/R)`.
Hyperboloid: :math:`f = c(\sqrt{1+r^2/A^2}-1)` gives :math:`g = (c/A)\,x\arctan(x/A)`.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array
from winkler.profiles.half_angle import HalfAngle
from winkler.profiles.profile import RisingShape
from winkler.values.checks.number_checks import Positive, PositiveNotTiny
from winkler.values.value import value

SERIES_LIMIT = 0.2
"""Below this radius over body radius the integral of g is summed as a series, because its closed form cancels."""
SERIES_COEFFICIENTS = tuple(2.0 / (4.0 * k * k - 1.0) for k in range(11, 0, -1))


def _series(t: Array, sign: float) -> Array:
    """Sum 2 (-sign)^(k+1) t^(2k+1) / (4 k^2 - 1) for small t."""
    step = -sign * t * t
    total = SERIES_COEFFICIENTS[0] * step + SERIES_COEFFICIENTS[1]
    for term in SERIES_COEFFICIENTS[2:]:
        total = total * step + term
    result: Array = t * t * t * total
    return result


def shape_integral(t: Array, sign: float) -> Array:
    """Return (1 + sign t^2) inv(t) - t, up to its sign, where inv is artanh (sign -1) or arctan (sign +1)."""
    t = np.asarray(t, dtype=float)
    if not np.any(t >= SERIES_LIMIT):
        return _series(t, sign)
    small = _series(np.minimum(t, SERIES_LIMIT), sign)
    large = np.maximum(t, SERIES_LIMIT)
    closed = large - (1.0 - large**2) * np.arctanh(large) if sign < 0 else (1.0 + large**2) * np.arctan(large) - large
    return np.where(t < SERIES_LIMIT, small, closed)


class _RoundBody(RisingShape):
    """An ellipsoid of revolution with semi-axes A (radial) and B (axial)."""

    @property
    def _axes(self) -> tuple[float, float]:
        raise NotImplementedError

    @property
    def reach(self) -> float:
        """The equator [m]."""
        return self._axes[0]

    @property
    def size(self) -> float:
        """Radius of the body, taken at its equator [m]."""
        return self._axes[0]

    def height(self, r: Array) -> Array:
        """f(r) [m]; infinite beyond the equator."""
        a, b = self._axes
        t = np.asarray(r) / a
        inside = np.sqrt(np.maximum((1.0 - t) * (1.0 + t), 0.0))
        return np.where(t <= 1.0, b * t * t / (1.0 + inside), math.inf)

    def slope(self, r: Array) -> Array:
        """f'(r) [-]; infinite from the equator on."""
        a, b = self._axes
        t = np.asarray(r) / a
        inside = np.sqrt(np.maximum((1.0 - t) * (1.0 + t), 0.0))
        return np.where(inside > 0.0, b / a * t / np.where(inside > 0.0, inside, 1.0), math.inf)

    def curvature(self, r: Array) -> Array:
        """f''(r) [1/m]; infinite from the equator on."""
        a, b = self._axes
        t = np.asarray(r) / a
        inside = np.maximum((1.0 - t) * (1.0 + t), 0.0)
        return np.where(inside > 0.0, b / (a * a) / np.where(inside > 0.0, inside, 1.0) ** 1.5, math.inf)

    def gap(self, x: Array) -> Array:
        """g(x) = (B/A) x artanh(x/A) [m]."""
        a, b = self._axes
        return b / a * x * np.arctanh(x / a)

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        a, b = self._axes
        t = x / a
        return b / a * (np.arctanh(t) + t / ((1.0 - t) * (1.0 + t)))

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2]."""
        a, b = self._axes
        return 0.5 * a * b * shape_integral(x / a, -1.0)


@value
class Sphere(_RoundBody):
    """A sphere, f = R - sqrt(R^2 - r^2), with its exact shape.

    Parameters
    ----------
    curvature_radius : float
        R [m], positive.

    See Also
    --------
    Paraboloid : the approximation behind Hertz' formulas; they agree for a << R.
    """

    curvature_radius: PositiveNotTiny

    @property
    def _axes(self) -> tuple[float, float]:
        return self.curvature_radius, self.curvature_radius


@value
class Ellipsoid(_RoundBody):
    """An ellipsoid of revolution whose axis is the axis of the contact.

    Parameters
    ----------
    radial_semi_axis : float
        A [m], in the plane of the surface.
    axial_semi_axis : float
        B [m], along the axis; the radius of curvature at the apex is A^2 / B.
    """

    radial_semi_axis: Positive
    axial_semi_axis: Positive

    @property
    def _axes(self) -> tuple[float, float]:
        return self.radial_semi_axis, self.axial_semi_axis


@value
class Hyperboloid(RisingShape):
    """A hyperboloid of revolution: a round apex that tends to a cone.

    Parameters
    ----------
    curvature_radius : float
        R [m], at the apex.
    half_angle : float
        Of the cone it approaches, measured from the axis [rad], between 0 and pi/2.
    """

    curvature_radius: PositiveNotTiny
    half_angle: HalfAngle

    @property
    def _scales(self) -> tuple[float, float]:
        """The slope m of the cone and the length A = R m."""
        m = 1.0 / math.tan(self.half_angle)
        return m, self.curvature_radius * m

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        m, a = self._scales
        t = np.asarray(r) / a
        return m * a * t * t / (np.sqrt(1.0 + t * t) + 1.0)

    def slope(self, r: Array) -> Array:
        """f'(r) [-]."""
        m, a = self._scales
        t = np.asarray(r) / a
        return m * t / np.sqrt(1.0 + t * t)

    def curvature(self, r: Array) -> Array:
        """f''(r) [1/m]."""
        m, a = self._scales
        t = np.asarray(r) / a
        return m / a / (1.0 + t * t) ** 1.5

    def gap(self, x: Array) -> Array:
        """g(x) = m x arctan(x/A) [m]."""
        m, a = self._scales
        return m * x * np.arctan(x / a)

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        m, a = self._scales
        t = x / a
        return m * (np.arctan(t) + t / (1.0 + t * t))

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2]."""
        m, a = self._scales
        return 0.5 * m * a * a * shape_integral(x / a, 1.0)
