r"""Punches with rounded edges, and paraboloids that were cut off or worn.

Beyond the flat of a rounded punch, with :math:`t=\sqrt{x^2-b^2}/b`,

.. math:: g = \frac{b\,x}{R}\,(t-\arctan t), \qquad g' = \frac bR\,(2t-\arctan t), \qquad
          \int_0^x g = \frac{b^3}{R}\Big(\frac{t^3}{3} + \frac t2 - \frac{1+t^2}{2}\arctan t\Big) ,

where series stand for the differences at small t.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.panels.abel_intervals import root_difference
from winkler.numerics.types import Array
from winkler.profiles.pieces import PowerPieces, Term
from winkler.values.checks.number_checks import Positive, PositiveNotTiny
from winkler.values.value import value

SERIES_LIMIT = 0.3
"""Below this t the differences are summed as series, because their closed forms cancel."""
SERIES_COEFFICIENTS = tuple(1.0 / (2.0 * k + 1.0) for k in range(17, 1, -1))


def excess(t: Array) -> tuple[Array, Array]:
    """Return t - arctan(t) and t^3/3 + t/2 - (1 + t^2) arctan(t)/2 without cancellation."""
    near = np.asarray(t < SERIES_LIMIT)
    if not near.any():
        return _closed(t)
    if near.all():
        return _summed(t)
    summed, closed = _summed(np.minimum(t, SERIES_LIMIT)), _closed(np.maximum(t, SERIES_LIMIT))
    return np.where(near, summed[0], closed[0]), np.where(near, summed[1], closed[1])


def _closed(t: Array) -> tuple[Array, Array]:
    arc = np.arctan(t)
    return t - arc, t**3 / 3.0 + 0.5 * t - 0.5 * (1.0 + t**2) * arc


def _summed(t: Array) -> tuple[Array, Array]:
    square = t**2
    series = SERIES_COEFFICIENTS[1] - square * SERIES_COEFFICIENTS[0]
    for coefficient in SERIES_COEFFICIENTS[2:]:
        series = coefficient - square * series
    rest = t**5 * series  # t^3/3 - t + arctan(t)
    return t**3 / 3.0 - rest, t**5 / 6.0 - 0.5 * (1.0 + square) * rest


@value
class RoundedPunch(PowerPieces):
    """A flat punch with a rounded edge: f = 0 up to b, then (r - b)^2 / (2 R).

    Parameters
    ----------
    flat_radius : float
        b [m], positive.
    edge_radius : float
        R [m], of the rounding, positive.

    References
    ----------
    M. Ciavarella, D. A. Hills, G. Monno, Proc. Inst. Mech. Eng. C 212 (1998) 319-327, doi:10.1243/0954406981521231
    """

    flat_radius: Positive
    edge_radius: Positive

    @property
    def terms(self) -> tuple[Term, ...]:
        """(r - b) / R beyond the flat."""
        b, big = self.flat_radius, self.edge_radius
        return ((b, 1, 1.0 / big), (b, 0, -b / big))

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """The end of the flat, where the slope is continuous."""
        return ((self.flat_radius, 0.0),)

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        return np.asarray(np.maximum(r - self.flat_radius, 0.0) ** 2 / (2.0 * self.edge_radius))

    def slope(self, r: Array) -> Array:
        """f'(r) [-]."""
        return np.asarray(np.maximum(r - self.flat_radius, 0.0) / self.edge_radius)

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        t = self._ratio(x)
        return np.asarray(self.flat_radius / self.edge_radius * x * excess(t)[0])

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        t = self._ratio(x)
        return np.asarray(self.flat_radius / self.edge_radius * (t + excess(t)[0]))

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2]."""
        t = self._ratio(x)
        return np.asarray(self.flat_radius**3 / self.edge_radius * excess(t)[1])

    def _ratio(self, x: Array) -> Array:
        return root_difference(np.asarray(x, dtype=float), self.flat_radius) / self.flat_radius


@value
class TruncatedParaboloid(PowerPieces):
    """A paraboloid with its tip cut off: f = 0 up to b, then (r^2 - b^2) / (2 R).

    Parameters
    ----------
    curvature_radius : float
        R [m], positive.
    flat_radius : float
        b [m], positive.
    """

    curvature_radius: PositiveNotTiny
    flat_radius: Positive

    @property
    def terms(self) -> tuple[Term, ...]:
        """r / R beyond the flat."""
        return ((self.flat_radius, 1, 1.0 / self.curvature_radius),)


@value
class CappedParaboloid(PowerPieces):
    """A paraboloid with another curvature at its tip: worn flatter, or ground sharper.

    Parameters
    ----------
    curvature_radius : float
        R [m], beyond the cap.
    cap_curvature_radius : float
        R1 [m], within the cap.
    cap_radius : float
        b [m], where the cap ends; the heights agree there, the slopes do not.
    """

    curvature_radius: PositiveNotTiny
    cap_curvature_radius: Positive
    cap_radius: Positive

    @property
    def terms(self) -> tuple[Term, ...]:
        """r / R1 within the cap, r / R beyond."""
        cap = 1.0 / self.cap_curvature_radius
        return ((0.0, 1, cap), (self.cap_radius, 1, 1.0 / self.curvature_radius - cap))
