r"""Powers of the radius, :math:`f = c\,r^n`, and the commonest of them, the paraboloid.

:math:`g = \kappa_n c\,x^n` with :math:`\kappa_n = \sqrt\pi\,n\,\Gamma(n/2)/(2\,\Gamma((n+1)/2))`.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array
from winkler.profiles.profile import RisingShape
from winkler.values.checks.number_checks import Positive, PositiveNotTiny, PositiveOfAnySize
from winkler.values.value import value, words


@value
class Paraboloid(RisingShape):
    """A paraboloid of revolution, f = r^2 / (2 R): Hertz's approximation of the sphere.

    Parameters
    ----------
    curvature_radius : float
        R [m]; of two balls, 1/R = 1/R1 + 1/R2.

    References
    ----------
    H. Hertz, J. reine angew. Math. 92 (1881) 156-171, doi:10.1515/crll.1882.92.156
    """

    curvature_radius: PositiveNotTiny

    @property
    def size(self) -> float:
        """Radius R [m] at the apex of the approximated body."""
        return self.curvature_radius

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        return r * r / (2.0 * self.curvature_radius)

    def slope(self, r: Array) -> Array:
        """f'(r) [-]."""
        return r / self.curvature_radius

    def curvature(self, r: Array) -> Array:
        """f''(r) [1/m]."""
        return np.full(np.shape(r), 1.0 / self.curvature_radius)

    def gap(self, x: Array) -> Array:
        """g(x) = x^2 / R [m]."""
        return x * x / self.curvature_radius

    def gap_slope(self, x: Array) -> Array:
        """g'(x) = 2 x / R [-]."""
        return 2.0 * x / self.curvature_radius

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x, x^3 / (3 R) [m^2]."""
        return x * x * x / (3.0 * self.curvature_radius)


@value
class PowerLaw(RisingShape):
    """A body of revolution with f = c r^n.

    Parameters
    ----------
    coefficient : float
        c [m^(1-n)], positive.
    exponent : float
        n [-], positive; 1 is a cone, 2 a paraboloid, large n almost a flat punch.

    References
    ----------
    L. A. Galin, Prikl. Mat. Mekh. 10 (1946) 425-448.
    """

    __words__ = words(
        coefficient=("c", "m^(1-n)", "coefficient of the shape f = c r^n"),
        exponent=("n", "", "exponent of the shape f = c r^n"),
    )

    coefficient: PositiveOfAnySize
    exponent: Positive

    @property
    def stretch(self) -> float:
        """kappa_n = g/f at equal radius [-]."""
        n = max(self.exponent, 1e-300)  # below it one all the same, but gamma functions overflow
        return 0.5 * math.sqrt(math.pi) * n * math.exp(math.lgamma(0.5 * n) - math.lgamma(0.5 * (n + 1.0)))

    def _power(self, factor: float, r: Array, exponent: float) -> Array:
        r = np.asarray(r, dtype=float)
        if exponent >= 0.0:
            return factor * r**exponent
        return np.where(r > 0.0, factor * np.where(r > 0.0, r, 1.0) ** exponent, math.copysign(math.inf, factor))

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        return self._power(self.coefficient, r, self.exponent)

    def slope(self, r: Array) -> Array:
        """f'(r) [-]; infinite at the axis for n < 1."""
        return self._power(self.coefficient * self.exponent, r, self.exponent - 1.0)

    def curvature(self, r: Array) -> Array:
        """f''(r) [1/m]."""
        n = self.exponent
        return np.zeros(np.shape(r)) if n == 1.0 else self._power(self.coefficient * n * (n - 1.0), r, n - 2.0)

    def gap(self, x: Array) -> Array:
        """g(x) = kappa_n c x^n [m]."""
        return self.stretch * self.height(x)

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        return self.stretch * self.slope(x)

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2]."""
        return np.asarray(x) * self.gap(x) / (self.exponent + 1.0)
