r"""The dent that a yielded contact leaves, as the profile against which it is elastic from then on.

At its greatest load the springs bear :math:`q(x) = E^* u(x)`: a share of the shape that an elastic contact of the same
radius has, the rest that of an even pressure,

.. math:: u(x) = d_e\left[\theta\left(1 - \frac{g(x)}{g(a)}\right) + (1-\theta)\sqrt{1 - x^2/a^2}\right] .

Taking the load away is elastic, so that the surfaces spring back by what this pressure displaces them.  The gap left
between body and dent has the transform :math:`g_r(x) = u(0) - u(x)`.  It is a profile like any other: on its bed
the contact is let go, pressed again, pulled, sheared, or conducts.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array
from winkler.profiles.profile import Profile, Shape
from winkler.values.checks.number_checks import Finite, Positive
from winkler.values.validity import Note
from winkler.values.value import value, words

SERIES_BELOW = 0.3
"""Part of the radius below which the dimple and the integral of its transform are summed as series: their closed forms
lose digits."""
SERIES_TERMS = 14


@value
class Dent(Shape):
    """The gap between a body and the dent that it has left.

    Parameters
    ----------
    profile : Profile
        The gap between the bodies before they yielded.
    radius : float
        a [m], of the contact under the greatest load.
    recovery : float
        d_e [m], by which the bodies spring back from it.
    elastic_share : float
        theta [-], the part of it that has the shape of an elastic contact; the rest has that under an even pressure.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, section 3.4 (even pressure on a circle),
    doi:10.1017/CBO9781139171731
    """

    __words__ = words(
        recovery=("d_e", "m", "by which the bodies spring back from the greatest load"),
        elastic_share=(r"\theta", "", "part of the recovery that has the shape of an elastic contact"),
    )

    profile: Profile
    radius: Positive
    recovery: Positive
    elastic_share: Finite

    rising = True
    """g rises: a rising profile and the dimple of an even pressure, in parts of which neither outweighs the other."""

    @property
    def reach(self) -> float:
        """a [m]: beyond, the surface has been moved by more than its own pressure."""
        return self.radius

    @property
    def size(self) -> float:
        """As of the profile [m]."""
        return self.profile.size

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Those of the profile within the dent."""
        return tuple((b, jump * self._profile_part) for b, jump in self.profile.kinks if b < self.radius)

    @property
    def notes(self) -> tuple[Note, ...]:
        """As of the profile."""
        return self.profile.notes

    @property
    def _profile_part(self) -> float:
        return self.recovery * self.elastic_share / float(self.profile.gap(np.array([self.radius]))[0])

    @property
    def _dimple(self) -> float:
        """The depth of what an even pressure adds [m], as its springs have it."""
        return self.recovery * (1.0 - self.elastic_share)

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        from scipy.special import ellipe

        square = np.minimum((r / self.radius) ** 2, 1.0)
        closed = 1.0 - (2.0 / np.pi) * ellipe(square)
        near = square < SERIES_BELOW**2
        dimple = np.where(near, _surface_series(np.where(near, square, 0.0)), closed)
        return self._profile_part * self.profile.height(r) + self._dimple * dimple

    def slope(self, r: Array) -> Array:
        """f'(r) [-]; infinite at the edge, where the pressure ended suddenly."""
        from scipy.special import elliprd

        rho = r / self.radius
        # K(m) - E(m) = m R_D(0, 1 - m, 1) / 3, which keeps its digits near the axis
        dimple = (
            (2.0 / (3.0 * np.pi * self.radius)) * rho * elliprd(0.0, np.maximum((1.0 - rho) * (1.0 + rho), 0.0), 1.0)
        )
        return np.asarray(self._profile_part * self.profile.slope(r) + self._dimple * dimple)

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        y = np.minimum((x / self.radius) ** 2, 1.0)
        return self._profile_part * self.profile.gap(x) + self._dimple * y / (1.0 + np.sqrt(1.0 - y))

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]; infinite at the edge."""
        rho = x / self.radius
        root = np.sqrt(np.maximum((1.0 - rho) * (1.0 + rho), 0.0))
        with np.errstate(divide="ignore"):
            dimple = rho / (self.radius * root)
        return self._profile_part * self.profile.gap_slope(x) + self._dimple * dimple

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2]."""
        dimple = dimple_integral(np.minimum(x / self.radius, 1.0))
        return self._profile_part * self.profile.gap_integral(x) + self._dimple * self.radius * dimple


def dimple_integral(rho: Array) -> Array:
    """Return the integral of 1 - sqrt(1 - t^2) from 0 to rho, up to one."""
    root = np.sqrt((1.0 - rho) * (1.0 + rho))
    closed = rho - 0.5 * (rho * root + np.arcsin(rho))
    return np.where(rho < SERIES_BELOW, _dimple_series(np.minimum(rho, SERIES_BELOW)), closed)


def _surface_series(square: Array) -> Array:
    """Return 1 - 2 E(m) / pi for small m."""
    total, power, root = np.zeros_like(square), np.ones_like(square), 1.0
    for n in range(1, SERIES_TERMS + 1):
        root *= (2 * n - 1) / (2 * n)
        power = power * square
        total += root * root / (2 * n - 1) * power
    return total


def _dimple_series(rho: Array) -> Array:
    """Return the integral of 1 - sqrt(1 - t^2) from 0 to rho, for small ones."""
    total, power, factor = np.zeros_like(rho), rho.copy(), 1.0
    square = rho * rho
    for n in range(1, SERIES_TERMS + 1):
        factor *= 0.5 if n == 1 else (2 * n - 3) / (2 * n)  # of y^n in 1 - sqrt(1 - y)
        power = power * square
        total += factor * power / (2 * n + 1)
    return total
