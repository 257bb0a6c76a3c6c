r"""Shapes whose slope is a sum of truncated powers: cones, paraboloids, and whatever is cut or blended from them.

The slope is :math:`f'(r) = \sum_j c_j\, r^{m_j}\, H(r-b_j)`; each term enters g through

.. math:: W_m(x, b) = \int_b^x \frac{r^m}{\sqrt{x^2-r^2}}\,\mathrm dr,\qquad
          W_m = \frac{(m-1)\,x^2\,W_{m-2} + b^{m-1}\sqrt{x^2-b^2}}{m},

all of it positive, so nothing cancels within a term: :math:`g = x\sum c_j W_{m_j}`,
:math:`g' = \sum c_j[(m_j+1)W_{m_j} + b_j^{m_j+1}/\sqrt{x^2-b_j^2}]` and :math:`\int_0^x g = \sum c_j V_{m_j}` with

.. math:: V_m(x, b) = \int_b^x r^m\sqrt{x^2-r^2}\,\mathrm dr,\qquad
          V_m = \frac{(m-1)\,x^2\,V_{m-2} + b^{m-1}(x^2-b^2)^{3/2}}{m+2} .
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.panels.abel_intervals import root_difference
from winkler.numerics.types import Array
from winkler.profiles.profile import Shape
from winkler.profiles.sphere import shape_integral

Term = tuple[float, int, float]
"""``(b, m, c)``: the slope holds c r^m beyond the radius b."""


def _moment(m: int, x: Array, b: float) -> Array:
    """Return W_m(x, b), zero where x <= b; W_0(x, 0) is a right angle even at the axis."""
    root = root_difference(x, b)
    if m == 0:
        return np.where(x > b, np.arctan2(root, b), 0.0) if b > 0.0 else np.full(x.shape, 0.5 * np.pi)
    if m == 1:
        return root
    return ((m - 1) * x * x * _moment(m - 2, x, b) + b ** (m - 1) * root) / m


def _integral_moment(m: int, x: Array, b: float) -> Array:
    """Return V_m(x, b), zero where x <= b."""
    root = root_difference(x, b)
    if m == 0:
        return 0.5 * b * b * shape_integral(root / b, 1.0) if b > 0.0 else 0.25 * np.pi * x * x
    if m == 1:
        return root**3 / 3.0
    return ((m - 1) * x * x * _integral_moment(m - 2, x, b) + b ** (m - 1) * root**3) / (m + 2)


class PowerPieces(Shape):
    """A `Shape` given by the terms of its slope; subclasses are values that derive `terms` from their fields."""

    @property
    def terms(self) -> tuple[Term, ...]:
        """``(b, m, c)`` of every truncated power of the slope."""
        raise NotImplementedError

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(radius, jump of the slope)``, ascending."""
        places = sorted({b for b, _, _ in self.terms if b > 0.0})
        return tuple((b, sum(c * b**m for start, m, c in self.terms if start == b)) for b in places)

    @property
    def rising(self) -> bool:
        """These shapes are convex wherever their slope never drops at a kink."""
        return all(jump >= 0.0 for _, jump in self.kinks)

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        r = np.asarray(r, dtype=float)
        return sum((c * (np.maximum(r, b) ** (m + 1) - b ** (m + 1)) / (m + 1) for b, m, c in self.terms), 0.0 * r)

    def slope(self, r: Array) -> Array:
        """f'(r) [-]."""
        r = np.asarray(r, dtype=float)
        return sum((np.where(r > b, c * r**m, 0.0) if b > 0.0 else c * r**m for b, m, c in self.terms), 0.0 * r)

    def curvature(self, r: Array) -> Array:
        """f''(r) [1/m]."""
        r = np.asarray(r, dtype=float)
        return sum((np.where(r > b, c * m * r ** max(m - 1, 0), 0.0) for b, m, c in self.terms), 0.0 * r)

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        x = np.asarray(x, dtype=float)
        return x * sum((c * _moment(m, x, b) for b, m, c in self.terms), 0.0 * x)

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]; at a kink, the value just below it."""
        x = np.asarray(x, dtype=float)
        total = 0.0 * x
        for b, m, c in self.terms:
            total = total + c * (m + 1) * _moment(m, x, b)
            if b > 0.0:
                root = root_difference(x, b)
                total = total + np.where(x > b, c * b ** (m + 1) / np.where(x > b, root, 1.0), 0.0)
        return total

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2]."""
        x = np.asarray(x, dtype=float)
        return sum((c * _integral_moment(m, x, b) for b, m, c in self.terms), 0.0 * x)
