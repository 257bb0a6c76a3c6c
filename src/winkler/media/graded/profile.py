r"""g(x), g'(x) and the integral of x^k g of a profile on a half-space whose modulus follows a power of the depth.

Shapes whose slope is made of powers have closed forms: with q = (1 + k)/2

.. math:: f = c\,r^n:\; g = \tfrac n2 B(\tfrac n2, q)\,c\,x^n , \qquad
          W_m(x, b) = \int_b^x r^m (x^2-r^2)^{q-1}\,\mathrm dr , \qquad
          W_m = \frac{(m-1)\,x^2\,W_{m-2} + b^{m-1}(x^2-b^2)^q}{m+k} ,

:math:`W_0` an incomplete beta function; :math:`g = x^{1-k}\sum_j c_j W_{m_j}(x, b_j)`.  Sums add, a cap is its own
profile, and every other shape goes through the quadratures of `winkler.numerics.transforms.graded_abel`.
"""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np

from winkler.media.graded.panels import designed, measured
from winkler.numerics.transforms import graded_abel
from winkler.numerics.types import Array
from winkler.profiles.designed import Designed
from winkler.profiles.flat import CappedCylinder, FlatPunch
from winkler.profiles.measured import Measured
from winkler.profiles.pieces import PowerPieces
from winkler.profiles.power import Paraboloid, PowerLaw
from winkler.profiles.profile import Profile, Sum
from winkler.profiles.sphere import Ellipsoid, Hyperboloid, Sphere
from winkler.values.errors import InvalidInput
from winkler.values.value import value


class Transform(Protocol):
    """What a graded medium needs of a profile; arrays in, arrays out."""

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]; at a kink, the value just below it."""

    def gap_integral(self, x: Array) -> Array:
        """The integral of x^k g from 0 to x [m^(2+k)]."""


def transform(profile: Profile, k: float) -> Transform:
    """Return the transform of `profile` for the exponent k of the grading.

    Raises
    ------
    InvalidInput
        If the profile has neither a closed form nor a `curvature`.
    """
    match profile:
        case Paraboloid():
            return _PowerTransform(0.5 / profile.curvature_radius, 2.0, k)
        case PowerLaw():
            return _PowerTransform(profile.coefficient, profile.exponent, k)
        case FlatPunch():
            return _PowerTransform(0.0, 1.0, k)
        case PowerPieces():
            return _PiecewiseTransform(profile, k)
        case Sphere():
            return _RoundTransform(profile.curvature_radius, profile.curvature_radius, -1.0, k)
        case Ellipsoid():
            return _RoundTransform(
                profile.radial_semi_axis, profile.radial_semi_axis**2 / profile.axial_semi_axis, -1.0, k
            )
        case Hyperboloid():
            return _RoundTransform(
                profile.curvature_radius / math.tan(profile.half_angle), profile.curvature_radius, 1.0, k
            )
        case Measured():
            return measured(profile, k)
        case Designed():
            return designed(profile, k)
        case Sum():
            return _SumTransform(tuple(transform(part, k) for part in profile.parts))
        case CappedCylinder():
            return transform(profile.cap, k)
        case _:
            return _QuadratureTransform(profile, k)


@value
class _PowerTransform:
    """f = c r^n."""

    coefficient: float
    exponent: float
    k: float

    @property
    def _factor(self) -> float:
        half, q = 0.5 * self.exponent, 0.5 * (1.0 + self.k)
        return self.coefficient * half * math.exp(math.lgamma(half) + math.lgamma(q) - math.lgamma(half + q))

    def gap(self, x: Array) -> Array:
        return np.asarray(self._factor * np.asarray(x, dtype=float) ** self.exponent)

    def gap_slope(self, x: Array) -> Array:
        x, n = np.asarray(x, dtype=float), self.exponent
        if n >= 1.0 or self.coefficient == 0.0:
            return np.asarray(self._factor * n * x ** (n - 1.0 if n >= 1.0 else 0.0))
        return np.where(x > 0.0, self._factor * n * np.where(x > 0.0, x, 1.0) ** (n - 1.0), math.inf)

    def gap_integral(self, x: Array) -> Array:
        n = self.exponent + self.k + 1.0
        return np.asarray(self._factor * np.asarray(x, dtype=float) ** n / n)


@value
class _RoundTransform:
    """f' = (r/R) / sqrt(1 + sign (r/A)^2), of an ellipsoid (-1) or a hyperboloid (+1)."""

    width: float
    curvature_radius: float
    sign: float
    k: float

    def _series(self, x: Array, second: float, third: float) -> Array:
        from scipy.special import hyp2f1

        z = -self.sign * (x / self.width) ** 2
        result: Array = np.asarray(hyp2f1(0.5, second, third, np.minimum(z, 1.0)))
        return np.where(z == 1.0, math.inf, result) if third <= second + 0.5 else result

    def gap(self, x: Array) -> Array:
        c = 0.5 * (3.0 + self.k)
        return np.asarray(x * x / ((1.0 + self.k) * self.curvature_radius) * self._series(x, 1.0, c))

    def gap_slope(self, x: Array) -> Array:
        c = 0.5 * (3.0 + self.k)
        return np.asarray(2.0 * x / ((1.0 + self.k) * self.curvature_radius) * self._series(x, 2.0, c))

    def gap_integral(self, x: Array) -> Array:
        n = self.k + 3.0
        factor = x**n / (n * (1.0 + self.k) * self.curvature_radius)
        return np.asarray(factor * self._series(x, 1.0, 0.5 * (5.0 + self.k)))


def _moment(m: int, x: Array, b: float, k: float) -> Array:
    """Return W_m(x, b), for x > 0; zero where x <= b."""
    q = 0.5 * (1.0 + k)
    above = np.maximum(x - b, 0.0) * (x + b)
    if m == 0:
        from scipy.special import betainc

        whole = graded_abel.half_beta(k) * x**k
        return whole if b == 0.0 else np.asarray(whole * betainc(q, 0.5, np.minimum(above / (x * x), 1.0)))
    if m == 1:
        return np.asarray(above**q / (2.0 * q))
    first = (m - 1) * x * x * _moment(m - 2, x, b, k)
    return np.asarray((first + (b ** (m - 1) * above**q if b > 0.0 else 0.0)) / (m + k))


@value
class _PiecewiseTransform:
    """A slope of truncated powers."""

    profile: PowerPieces
    k: float

    def _total(self, x: Array, at_axis: float, term) -> Array:  # type: ignore[no-untyped-def]
        x = np.asarray(x, dtype=float)
        inner = x[x > 0.0]
        result = np.full(x.shape, at_axis)
        result[x > 0.0] = sum((term(inner, *each) for each in self.profile.terms), 0.0 * inner)
        return result

    def gap(self, x: Array) -> Array:
        return self._total(x, 0.0, lambda x, b, m, c: c * x ** (1.0 - self.k) * _moment(m, x, b, self.k))

    def gap_slope(self, x: Array) -> Array:
        def term(x: Array, b: float, m: int, c: float) -> Array:
            smooth = c * (m + 1) * x**-self.k * _moment(m, x, b, self.k)
            if b == 0.0:
                return np.asarray(smooth)
            return np.asarray(smooth + c * b ** (m + 1) * graded_abel.kink_slope(x, b, self.k))

        start = sum(c for b, m, c in self.profile.terms if b == 0.0 and m == 0)
        return self._total(x, graded_abel.half_beta(self.k) * start, term)

    def gap_integral(self, x: Array) -> Array:
        k = self.k
        return self._total(
            x,
            0.0,
            lambda x, b, m, c: c * (x * x * _moment(m, x, b, k) - _moment(m + 2, x, b, k)) / (1.0 + k),
        )


@value
class _SumTransform:
    """The transform is linear."""

    parts: tuple[Transform, ...]

    def gap(self, x: Array) -> Array:
        return np.asarray(np.sum([part.gap(x) for part in self.parts], axis=0))

    def gap_slope(self, x: Array) -> Array:
        return np.asarray(np.sum([part.gap_slope(x) for part in self.parts], axis=0))

    def gap_integral(self, x: Array) -> Array:
        return np.asarray(np.sum([part.gap_integral(x) for part in self.parts], axis=0))


@value
class _QuadratureTransform:
    """Any smooth shape: from its slope and curvature between the kinks."""

    profile: Profile
    k: float

    @property
    def _edges(self) -> list[float]:
        return [b for b, _ in self.profile.kinks]

    def gap(self, x: Array) -> Array:
        return graded_abel.gap(self.profile.slope, self._edges, self.k, x)

    def gap_slope(self, x: Array) -> Array:
        curvature = getattr(self.profile, "curvature", None)
        if curvature is None:
            raise InvalidInput(
                f"GradedHalfSpace: the profile {type(self.profile).__name__} has no curvature(r), which its transform "
                "in a graded medium needs; subclass winkler.Shape and give it."
            )
        return graded_abel.gap_slope(self.profile.slope, curvature, self.profile.kinks, self.k, x)

    def gap_integral(self, x: Array) -> Array:
        return graded_abel.gap_integral(self.profile.slope, self._edges, self.k, x)
