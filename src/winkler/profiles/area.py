r"""Indenters known by their area function, :math:`A(h) = C_0h^2 + C_1h + C_2h^{1/2} + C_3h^{1/4} + \dots`

A calibrated nanoindenter tip is given by its cross-section A at the distance h from the apex.  The body of
revolution with the same cross-sections has :math:`f(r)=h` where :math:`A(h)=\pi r^2`.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.errors import InvalidInput
from winkler.numerics.roots import invert
from winkler.numerics.types import Array
from winkler.profiles.profile import Shape
from winkler.validity import Note, Standing
from winkler.values import value

__all__ = ["AreaFunction"]

NOTHING = 1e-150
"""Heights below this [m] count as zero: h^(1/128) is still 0.07 there."""
HEIGHTS = np.geomspace(1e-15, 1e3, 3000)
"""Heights [m] at which the area function is searched for a maximum."""


@value
class AreaFunction(Shape):
    """The body of revolution with the cross-sections of a calibrated indenter.

    Parameters
    ----------
    coefficients : sequence of float
        C0 [-], C1 [m], C2 [m^(3/2)], C3 [m^(7/4)], ...: the n-th belongs to h^(2^(1-n)). C0 = 24.5 alone is a perfect
        Berkovich tip as a cone; C0 = -pi, C1 = 2 pi R a sphere.

    Raises
    ------
    InvalidInput
        If the area does not grow from the apex on.

    References
    ----------
    W. C. Oliver, G. M. Pharr, J. Mater. Res. 7 (1992) 1564-1583, doi:10.1557/JMR.1992.1564
    """

    coefficients: tuple[float, ...]

    def __post_init__(self) -> None:
        numbers = np.ravel(np.asarray(self.coefficients, dtype=float))
        if not numbers.size or not np.all(np.isfinite(numbers)) or not np.any(numbers):
            raise InvalidInput(
                f"AreaFunction: coefficients are {self.coefficients!r}; give finite numbers C0, C1, ... of which at "
                "least one is not zero."
            )
        object.__setattr__(self, "coefficients", tuple(float(number) for number in numbers))
        first = self._derivatives(HEIGHTS[:1])
        if first[0][0] <= 0.0 or first[1][0] <= 0.0:
            raise InvalidInput(
                f"AreaFunction: with the coefficients {self.coefficients} the area does not grow from the apex on; the "
                "last coefficient that is not zero must be positive."
            )

    @property
    def _terms(self) -> list[tuple[float, float]]:
        """``(coefficient, exponent)`` of the terms that are not zero."""
        return [(c, 2.0 ** (1 - n)) for n, c in enumerate(self.coefficients) if c != 0.0]

    def _derivatives(self, h: Array) -> tuple[Array, Array, Array]:
        """Return A, A' and A''."""
        powers = [(c, n, h**n) for c, n in self._terms]
        area = sum((c * p for c, _, p in powers), 0.0 * h)
        first = sum((c * n * p / h for c, n, p in powers), 0.0 * h)
        second = sum((c * n * (n - 1.0) * p / h**2 for c, n, p in powers), 0.0 * h)
        return area, first, second

    @property
    def _top(self) -> float:
        """The height at which the area stops growing [m]; infinite if it never does."""
        growth = self._derivatives(HEIGHTS)[1]
        (shrinking,) = np.nonzero(growth <= 0.0)
        if not shrinking.size:
            return math.inf
        from scipy.optimize import brentq

        low, high = HEIGHTS[shrinking[0] - 1], HEIGHTS[shrinking[0]]
        return float(brentq(lambda h: self._derivatives(np.array([h]))[1][0], low, high, xtol=1e-300, rtol=8.9e-16))

    @property
    def reach(self) -> float:
        """Radius up to which the area grows [m]."""
        top = self._top
        return math.inf if top == math.inf else math.sqrt(self._derivatives(np.array([top]))[0][0] / math.pi)

    @property
    def size(self) -> float:
        """Where the area stops growing [m]."""
        return self.reach

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Radii at which one term of a blunt tip takes over from the next: smooth, but sharply bent."""
        if len(self._terms) < 2 or self._terms[-1][1] >= 1.0:
            return ()
        heights = np.geomspace(1e-15, 1e-3, 13)
        heights = heights[heights < self._top]
        radii = np.sqrt(self._derivatives(heights)[0] / math.pi)
        return tuple((float(radius), 0.0) for radius in radii)

    @property
    def notes(self) -> tuple[Note, ...]:
        """That the indenter is taken for its axisymmetric equivalent."""
        return (
            Note(
                Standing.APPROXIMATE,
                "The indenter is replaced by the body of revolution with the same cross-sections; for a pyramid the "
                "force at a given depth is then 3 to 7 % low.",
                "boundary-element solution of the sharp pyramid, theory sheet 1.3",
            ),
        )

    def height(self, r: Array) -> Array:
        """f(r) [m], the root of A(f) = pi r^2."""
        r = np.asarray(r, dtype=float)
        result = np.zeros(r.shape)
        above = r > self._blunt
        if above.any():
            result[above] = self._heights(r[above])
        return result

    @property
    def _blunt(self) -> float:
        """Radius within which the height counts as zero [m]."""
        return math.sqrt(self._derivatives(np.array([NOTHING]))[0][0] / math.pi)

    def _heights(self, r: Array) -> Array:
        top = self._top
        if len(self._terms) == 1:
            c, n = self._terms[0]
            return (math.pi * r * r / c) ** (1.0 / n)
        return invert(
            lambda h: self._derivatives(h)[:2],
            math.pi * r * r,
            lower=NOTHING,
            upper=top,
            guess=0.5 * top if math.isfinite(top) else 1e-6,
        )

    def slope(self, r: Array) -> Array:
        """f'(r) = 2 pi r / A'(f) [-]."""
        r = np.asarray(r, dtype=float)
        return self._implicit(r)[0]

    def curvature(self, r: Array) -> Array:
        """f''(r) [1/m]."""
        return self._implicit(np.asarray(r, dtype=float))[1]

    def _implicit(self, r: Array) -> tuple[Array, Array]:
        apex_slope, apex_bend = self._apex
        slope, bend = np.where(r > 0.0, 0.0, apex_slope), np.where(r > 0.0, 0.0, apex_bend)
        above = r > self._blunt
        if above.any():
            inner = r[above]
            _, first, second = self._derivatives(self._heights(inner))
            rise = 2.0 * math.pi * inner / first
            slope[above] = rise
            bend[above] = (2.0 * math.pi - second * rise**2) / first
        return slope, bend

    @property
    def _apex(self) -> tuple[float, float]:
        """f' and f'' at the apex: of a cone, a paraboloid, or something flatter."""
        c, n = self._terms[-1]
        if n == 2.0:
            return math.sqrt(math.pi / c), 0.0
        return 0.0, 2.0 * math.pi / c if n == 1.0 else 0.0
