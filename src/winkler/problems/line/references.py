r"""Finite bodies against which the approach of a line contact is counted: the centre of a roller, the base of a plate.

Against a point at the depth d below a half-plane a narrow strip sinks by :math:`P(1-\nu^2)/(\pi E)\,[2\ln(2d/a) -
\nu/(1-\nu)]` (a cylinder).  What the other surface of a body adds does not depend on how the strip presses, as long as
it is narrow: it is :math:`P(1-\nu^2)/(\pi E)` times a number.

- Roller: on its axis the opposite load adds :math:`2\ln 2`, and the tension :math:`P/(\pi R)` in all directions, which
  frees its surface, :math:`-(1-2\nu)/(1-\nu)`: for a cylinder :math:`2\ln(4R/a) - 1` in all.
- Plate of the thickness t on a rigid base: with the kernel K of the layer,

.. math:: \frac1{1-\nu} + 2\int_0^\infty \frac{K(s) - 1 + e^{-s}}s\,\mathrm ds , \qquad
          K = \frac{\sinh^2 s}{\sinh s\cosh s + s} , \quad
          K = \frac{2\kappa\sinh 2s - 4s}{2\kappa\cosh 2s + 1 + \kappa^2 + 4s^2}

  on a base without friction, and bonded to it (:math:`\kappa = 3-4\nu`).

References
----------
K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 5.6 and 5.8, doi:10.1017/CBO9781139171731
"""

from __future__ import annotations

import functools
import math

from winkler.values.checks.number_checks import Positive
from winkler.values.value import value, words

LAST = 40.0
"""Where the kernel of a layer is one to rounding."""


@value
class RollerCentre:
    """The centre of a solid roller with the same force per length on its opposite side.

    Parameters
    ----------
    radius : float
        R [m], positive.
    """

    __words__ = words(radius=("R", "m", "radius of the roller"))

    radius: Positive

    @property
    def depth(self) -> float:
        """Depth below the surface [m]."""
        return self.radius

    def added(self, poisson: float) -> float:
        """Return the change of the approach due to the opposite contact, over P (1 - nu^2) / (pi E)."""
        return 2.0 * math.log(2.0) - (1.0 - 2.0 * poisson) / (1.0 - poisson)


@value
class PlateBase:
    """The rigid base under a plate.

    Parameters
    ----------
    thickness : float
        t [m], positive.
    bonded : bool
        Whether the plate sticks to the base; by default, it slides on it without friction.
    """

    __words__ = words(bonded=("", None, "whether the plate sticks to its base"))

    thickness: Positive
    bonded: bool = False

    @property
    def depth(self) -> float:
        """Depth below the surface [m]."""
        return self.thickness

    def added(self, poisson: float) -> float:
        """Return the change of the approach due to the base, over P (1 - nu^2) / (pi E)."""
        return 1.0 / (1.0 - poisson) + 2.0 * _layer(3.0 - 4.0 * poisson if self.bonded else math.inf)


Reference = RollerCentre | PlateBase
"""A finite body, and a place in it."""


@functools.lru_cache(maxsize=64)
def _layer(kappa: float) -> float:
    """Return the integral of the kernel of a layer; kappa is infinite on a base without friction."""
    from scipy.integrate import quad

    def integrand(s: float) -> float:
        if kappa == math.inf:
            kernel = math.sinh(s) ** 2 / (math.sinh(s) * math.cosh(s) + s)
        else:
            above = 2.0 * kappa * math.sinh(2.0 * s) - 4.0 * s
            kernel = above / (2.0 * kappa * math.cosh(2.0 * s) + 1.0 + kappa * kappa + 4.0 * s * s)
        return (kernel + math.expm1(-s)) / s

    return float(quad(integrand, 0.0, LAST, epsabs=1e-13, epsrel=1e-13, limit=200)[0])
