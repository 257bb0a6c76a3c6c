r"""A ball in a spherical socket that is a little wider: the conforming contact of ball joints.

The distance between them is the difference of two spheres, and so is g:

.. math:: f = \frac{r^2}{R_1+s_1} - \frac{r^2}{R_2+s_2} ,\quad s_i = \sqrt{R_i^2-r^2} , \qquad
          g = x\left[\mathrm{artanh}\frac{x}{R_1}-\mathrm{artanh}\frac{x}{R_2}\right] .

With the effective radius :math:`R_1R_2/(R_2-R_1)` alone nobody could see that the contact soon is as wide as the ball.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array
from winkler.profiles.profile import RisingShape
from winkler.profiles.sphere import shape_integral
from winkler.values.checks.number_checks import Positive, PositiveNotTiny
from winkler.values.errors import InvalidInput
from winkler.values.value import value


@value
class BallInSocket(RisingShape):
    """The distance between a ball and the socket around it.

    Parameters
    ----------
    curvature_radius : float
        R_1 [m] of the ball.
    socket_radius : float
        R_2 [m] of the socket, greater than that of the ball.

    Raises
    ------
    InvalidInput
        If a radius is not positive, or the ball is not smaller than the socket.

    Examples
    --------
    A ball of 10 mm in a socket with a clearance of one per cent is as flat as a ball of one metre.

    >>> joint = BallInSocket(curvature_radius=10e-3, socket_radius=10.1e-3)
    >>> round(joint.effective_radius, 6), joint.size
    (1.01, 0.01)
    """

    curvature_radius: PositiveNotTiny
    socket_radius: Positive

    def __post_init__(self) -> None:
        if self.socket_radius <= self.curvature_radius:
            raise InvalidInput(
                f"BallInSocket: socket_radius {self.socket_radius:g} m is not greater than the curvature_radius "
                f"{self.curvature_radius:g} m of the ball; give a socket that is wider than the ball."
            )

    @property
    def effective_radius(self) -> float:
        """R_1 R_2 / (R_2 - R_1) [m]: radius of a ball on a plane with the same relative curvature at the apex."""
        return self.curvature_radius * self.socket_radius / (self.socket_radius - self.curvature_radius)

    @property
    def reach(self) -> float:
        """The equator of the ball [m]."""
        return self.curvature_radius

    @property
    def size(self) -> float:
        """Radius of the ball [m]."""
        return self.curvature_radius

    def _roots(self, r: Array) -> tuple[Array, Array]:
        """Return s_1 and s_2 [m]."""
        r = np.asarray(r, dtype=float)
        first, second = self.curvature_radius, self.socket_radius
        return np.sqrt(np.maximum((first - r) * (first + r), 0.0)), np.sqrt(
            np.maximum((second - r) * (second + r), 0.0)
        )

    def height(self, r: Array) -> Array:
        """f(r) [m]; infinite beyond the equator."""
        first, second = self.curvature_radius, self.socket_radius
        s1, s2 = self._roots(r)
        apart = (second - first) * (1.0 + (second + first) / np.where(s1 + s2 > 0.0, s1 + s2, 1.0))
        inside = np.asarray(r) ** 2 * apart / ((first + s1) * (second + s2))
        return np.where(np.asarray(r) <= first, inside, math.inf)

    def slope(self, r: Array) -> Array:
        """f'(r) [-]; infinite from the equator on."""
        s1, s2 = self._roots(r)
        regular = s1 > 0.0
        rise = np.asarray(r) * (
            (self.socket_radius - self.curvature_radius) * (self.socket_radius + self.curvature_radius)
        )
        return np.where(regular, rise / np.where(regular, s1 * s2 * (s1 + s2), 1.0), math.inf)

    def curvature(self, r: Array) -> Array:
        """f''(r) [1/m]; infinite from the equator on."""
        s1, s2 = self._roots(r)
        regular = s1 > 0.0
        first = self.curvature_radius**2 / np.where(regular, s1, 1.0) ** 3
        second = self.socket_radius**2 / np.where(regular, s2, 1.0) ** 3
        return np.where(regular, first - second, math.inf)

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        return x * self._rotated(x)

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        t, u = x / self.curvature_radius, x / self.socket_radius
        return self._rotated(x) + t / ((1.0 - t) * (1.0 + t)) - u / ((1.0 - u) * (1.0 + u))

    def _rotated(self, x: Array) -> Array:
        """Return artanh(x/R_1) - artanh(x/R_2), without cancellation."""
        t, u = x / self.curvature_radius, x / self.socket_radius
        apart = x * ((self.socket_radius - self.curvature_radius) / (self.curvature_radius * self.socket_radius))
        return np.asarray(np.arctanh(apart / (1.0 - t * u)))

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2]."""
        first, second = (0.5 * R * R * shape_integral(x / R, -1.0) for R in (self.curvature_radius, self.socket_radius))
        return first - second
