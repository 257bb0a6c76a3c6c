r"""Indenters described by their area function, :math:`A(h) = C_0h^2 + C_1h + C_2h^{1/2} + C_3h^{1/4} + \dots`

A calibrated nanoindenter tip is given by its cross-section A at the distance h from the apex.  The body of
revolution with the same cross-sections has :math:`f(r)=h` where :math:`A(h)=\pi r^2`.  Its transform is an integral
over heights, which :math:`h' = h\,e^{-w}` makes smooth for any exponents, however small:

.. math:: g(x) = x\int_0^h \frac{\mathrm dh'}{\sqrt D}, \qquad \int_0^x g = \int_0^h \sqrt D\,\mathrm dh', \qquad
          D = x^2 - \frac{A(h')}\pi = \sum_n \frac{C_n}\pi\,h^{p_n}\,(1-e^{-p_n w}) .

Integrals over the heights of a body that is given by its area function.

With :math:`h' = h\,e^{-w}` they are smooth for any exponents, however small:

.. math:: \int_0^\infty k(h, D, h D')\,e^{-w}\,\mathrm dw , \qquad
          D = x^2 - \frac{A(h')}\pi = \sum_n \frac{C_n}\pi\,h^{p_n}\,(1-e^{-p_n w}) .
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from winkler.numerics.equations.roots import between, invert
from winkler.numerics.integrals.adaptive_quadrature import settled
from winkler.numerics.panels.log_panels import Octaves
from winkler.numerics.types import Array
from winkler.profiles.area_coefficients import AreaCoefficients
from winkler.profiles.profile import Shape
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value

LEAST_HEIGHT = 1e-150
"""Heights below this [m] count as zero: h^(1/128) is still 0.07 there."""
SEARCHED_HEIGHTS = np.geomspace(1e-12, 1e6, 3000)
"""Heights, in terms of that above which the first term is the greatest, at which the area function is searched for a
maximum, and for places where it is not log-concave."""
SEARCHED_BENDS = np.geomspace(1e-9, 1e3, 13)
"""The same, between which one term of a blunt tip takes over from the next."""


@value
class AreaFunction(Shape):
    """The body of revolution with the cross-sections of a calibrated area function.

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

    coefficients: AreaCoefficients

    def __post_init__(self) -> None:
        first = self._derivatives(self._unit * SEARCHED_HEIGHTS[:1])
        if first[0][0] <= 0.0 or first[1][0] <= 0.0:
            raise InvalidInput(
                f"AreaFunction: with the coefficients {self.coefficients} the area does not grow from the apex on; the "
                "last coefficient that is not zero must be positive."
            )

    @property
    def _terms(self) -> list[tuple[float, float]]:
        """``(coefficient, exponent)`` of the terms that are not zero."""
        return [(c, 2.0 ** (1 - n)) for n, c in enumerate(self.coefficients) if c != 0.0]

    @property
    def _unit(self) -> float:
        """The height [m] above which the first term is the greatest; one term alone is self-similar."""
        (c, n), *others = self._terms
        return max((abs(other / c) ** (1.0 / (n - power)) for other, power in others), default=1.0)

    def _derivatives(self, h: Array) -> tuple[Array, Array, Array]:
        """Return A, A' and A''."""
        powers = [(c, n, h**n) for c, n in self._terms]
        area = sum((c * p for c, _, p in powers), 0.0 * h)
        first = sum((c * n * p / h for c, n, p in powers), 0.0 * h)
        second = sum((c * n * (n - 1.0) * p / h**2 for c, n, p in powers), 0.0 * h)
        return area, first, second

    @property
    def _pieces(self) -> _AreaPieces:
        return _area_pieces(self)

    @property
    def reach(self) -> float:
        """Radius up to which the area grows [m]."""
        return self._pieces.reach

    @property
    def size(self) -> float:
        """Radius at which the area stops growing [m]."""
        return self.reach

    @property
    def rising(self) -> bool:
        """Whether g rises everywhere, because r f' = 2 A / A' rises with h everywhere."""
        heights = self._unit * SEARCHED_HEIGHTS
        heights = heights[heights < _summit(self)]
        area, first, second = self._derivatives(heights)
        return bool(np.all(first**2 - area * second >= -1e-13 * first**2))

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Radii at which one term of the area function becomes larger than the next. The profile is smooth there, with
        strong curvature if the tip is blunt.
        """
        if len(self._terms) < 2:
            return ()
        heights = self._unit * (SEARCHED_BENDS if self._terms[-1][1] < 1.0 else np.ones(1))
        heights = heights[heights < _summit(self)]
        radii = np.sqrt(self._derivatives(heights)[0] / math.pi)
        return tuple((float(radius), 0.0) for radius in radii)

    notes = (
        Note(
            Assumption.SHAPE,
            Standing.APPROXIMATE,
            "The indenter is replaced by the body of revolution with the same cross-sections. For a pyramid the "
            "force at a given depth is then 3 to 7 % too low.",
            "boundary-element solution of the sharp pyramid, theory sheet 1.3",
        ),
    )
    """That the indenter is replaced by its axisymmetric equivalent."""

    def height(self, r: Array) -> Array:
        """f(r) [m], the root of A(f) = pi r^2."""
        r = np.asarray(r, dtype=float)
        result = np.zeros(r.shape)
        above = r > self._pieces.blunt
        if above.any():
            result[above] = self._heights(r[above])
        return result

    def _heights(self, r: Array) -> Array:
        top = _summit(self)
        if len(self._terms) == 1:
            c, n = self._terms[0]
            return (math.pi * r * r / c) ** (1.0 / n)
        return invert(
            lambda h: self._derivatives(h)[:2],
            math.pi * r * r,
            lower=LEAST_HEIGHT,
            upper=top,
            guess=0.5 * top if math.isfinite(top) else self._unit,
        )

    def slope(self, r: Array) -> Array:
        """f'(r) = 2 pi r / A'(f) [-]."""
        return self._implicit(np.asarray(r, dtype=float))[0]

    def curvature(self, r: Array) -> Array:
        """f''(r) [1/m]."""
        return self._implicit(np.asarray(r, dtype=float))[1]

    def _implicit(self, r: Array) -> tuple[Array, Array]:
        apex_slope, apex_bend = self._apex
        slope, bend = np.where(r > 0.0, 0.0, apex_slope), np.where(r > 0.0, 0.0, apex_bend)
        above = r > self._pieces.blunt
        if above.any():
            inner = r[above]
            _, first, second = self._derivatives(self._heights(inner))
            rise = 2.0 * math.pi * inner / first
            slope[above] = rise
            bend[above] = (2.0 * math.pi - second * rise**2) / first
        return slope, bend

    def gap(self, x: Array) -> Array:
        """g(x) [m]; infinite at the reach."""
        x = np.asarray(x, dtype=float)
        pieces = self._pieces
        result = np.where(x < pieces.reach, 0.0, math.inf)
        above = (x > pieces.blunt) & (x < pieces.reach)
        if above.any():
            result[above] = pieces.gap(x[above])
        return result

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]; infinite at the reach."""
        x = np.asarray(x, dtype=float)
        result = np.where(x < self.reach, np.where(x > 0.0, 0.0, 0.5 * math.pi * self._apex[0]), math.inf)
        above = (x > self._pieces.blunt) & (x < self.reach)
        if above.any():
            h, inner = self._heights(x[above]), x[above]
            growth = 2.0 * math.pi * inner / self._derivatives(h)[1]
            first = over_heights(self._terms, h, stretched, "g'(x)")
            bent = inner * growth  # what is added vanishes like rounding where one term rules, as far up a cone
            result[above] = first + bent * over_heights(self._terms, h, stretching, "g'(x)", first / bent)
        return result

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2]."""
        x = np.asarray(x, dtype=float)
        pieces = self._pieces
        result = np.zeros(x.shape)
        above = x > pieces.blunt
        if above.any():
            result[above] = pieces.gap_integral(x[above])
        return result

    def _gap(self, x: Array) -> Array:
        """Return g(x) by its integral; `gap` keeps a table of it."""
        return np.asarray(x * over_heights(self._terms, self._heights(x), stretched, "g(x)"))

    def _gap_integral(self, x: Array) -> Array:
        """Return the integral of g from 0 to x by its own integral; `gap_integral` keeps a table of it."""
        return over_heights(self._terms, self._heights(x), stored, "integral of g")

    @property
    def _apex(self) -> tuple[float, float]:
        """f' and f'' at the apex: of a cone, a paraboloid, or something flatter."""
        c, n = self._terms[-1]
        if n == 2.0:
            return math.sqrt(math.pi / c), 0.0
        return 0.0, 2.0 * math.pi / c if n == 1.0 else 0.0


class _AreaPieces(NamedTuple):
    """What is found once: radius [m] up to which the area grows, within which the height is none, tables of g."""

    reach: float
    blunt: float
    gap: Octaves
    gap_integral: Octaves


@functools.lru_cache(maxsize=64)
def _area_pieces(profile: AreaFunction) -> _AreaPieces:
    top = _summit(profile)
    blunt, reach = (
        math.inf if h == math.inf else math.sqrt(profile._derivatives(np.array([h]))[0][0] / math.pi)
        for h in (LEAST_HEIGHT, top)
    )
    # at the reach g is singular: tables end an octave before; a power of two rounds no place of a blunt tip
    unit, high = (0.5 * reach,) * 2 if reach < math.inf else (2.0 ** round(math.log2(profile._unit)), math.inf)
    tables = (Octaves(function, unit, 1.2 * blunt, high) for function in (profile._gap, profile._gap_integral))
    return _AreaPieces(reach, blunt, *tables)


@functools.lru_cache(maxsize=64)
def _summit(profile: AreaFunction) -> float:
    """Return the height at which the area stops growing [m]; infinite if it never does."""
    heights = profile._unit * SEARCHED_HEIGHTS
    (shrinking,) = np.nonzero(profile._derivatives(heights)[1] <= 0.0)
    if not shrinking.size:
        return math.inf
    low, high = heights[shrinking[0] - 1], heights[shrinking[0]]
    return between(lambda h: float(profile._derivatives(np.array([h]))[1][0]), float(low), float(high))


Kernel = Callable[[Array, Array, Callable[[], Array]], Array]
"""Of the height, D and what gives h D', which not all need."""

LARGEST_ROOT = 6.3
"""Largest sqrt(w): exp(-w) is then 6e-18."""


def stretched(h: Array, fall: Array, steep: Callable[[], Array]) -> Array:
    """Return the kernel of g/x."""
    return np.asarray(h / np.sqrt(fall))


def stretching(h: Array, fall: Array, steep: Callable[[], Array]) -> Array:
    """Return the kernel of its derivative with respect to h."""
    return np.asarray((1.0 - 0.5 * steep() / fall) / np.sqrt(fall))


def stored(h: Array, fall: Array, steep: Callable[[], Array]) -> Array:
    """Return the kernel of the integral of g."""
    return np.asarray(h * np.sqrt(fall))


def over_heights(
    terms: Sequence[tuple[float, float]], h: Array, kernel: Kernel, what: str, against: Array | float = 0.0
) -> Array:
    """Integrate kernel(h, D, h dD/dh) exp(-w) over w from 0 on, for every height h; `against` as in `settled`."""
    exponents = np.array([n for _, n in terms])
    areas = np.stack([c / math.pi * h**n for c, n in terms], axis=-1)

    def integrand(node: Array, index: Array) -> Array:
        v = LARGEST_ROOT * node  # w = v^2, because D vanishes like w
        risen = -np.expm1(-exponents[:, None] * (v * v))
        parts = areas[index]  # sums over the terms are products of matrices, which cost least
        found = kernel(h[index, None], parts @ risen, lambda: (parts * exponents) @ risen)
        return found * (2.0 * LARGEST_ROOT * v * np.exp(-v * v))

    # where terms of opposite signs nearly cancel, as close to the reach, A' is not better known than that
    parts = [c * n * h**n for c, n in terms]
    lost = sum((np.abs(part) for part in parts), 0.0 * h) / np.abs(sum(parts, 0.0 * h))
    return settled(integrand, h.size, what, np.finfo(float).eps * lost, against)
