r"""Designed bodies: a slope as Chebyshev series on panels, with the tolerance they were made to.

The result of `winkler.problems.normal.design`.  On every panel the slope f' is a polynomial of the radius; height and
curvature are its integral and derivative, and the transform of a homogeneous half-space is a quadrature over the
panels, kept on panels of its own.
"""

from __future__ import annotations

import functools
from typing import Annotated, NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array
from winkler.profiles.profile import Shape
from winkler.values.checks.number_checks import NON_NEGATIVE, Advice, Finite, Numbers
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

GAP_TOLERANCE = 1e-10
"""Error of g' on its panels, relative to the steepest slope."""
NARROW_PANEL_LIMITS = 1e-6, 1e-8
"""Panels narrower than this, of the reach, hold a singular point, where g' has this error from rounding."""
LEAST_GAP_RATIO = 1e-7
"""Part of the greatest g below which rounding matters: from there to the axis g goes on as a power of x."""
ROUNDING = 1e-14
"""Slope of the apex, over the sum of the first panel's coefficients, that is none."""
SMALLEST_JUMP = 1e-7
"""A jump of the slope between panels, relative to the steepest slope, from which on it counts as a kink."""


@value
class Designed(Shape):
    """A body of revolution whose slope is a polynomial of the radius on each of many panels.

    `design_profile` and `design_for_pressure` return this class. `height(r)` gives the heights at any radii, for
    manufacturing.

    Parameters
    ----------
    edges : ndarray, (n + 1,)
        Radii [m] between which the panels lie, ascending from 0.
    slopes : ndarray, (n, m)
        Chebyshev coefficients of f' [-] on each panel, in its own variable from -1 to 1.
    tolerance : float
        Maximum deviation from the prescribed curve, over its maximum.

    Raises
    ------
    InvalidInput
        If the arrays do not fit one another.
    """

    __words__ = words(
        edges=("r_i", "m", "radii where one panel ends and the next begins"),
        slopes=("f'_{ij}", "", "Chebyshev coefficients of the slope, one row for each panel"),
        tolerance=(r"\epsilon", "", "relative misfit of what was prescribed"),
    )

    edges: Annotated[Array, Numbers(NON_NEGATIVE, order="rising"), Advice("ascend from 0")]
    slopes: Annotated[Array, Numbers(any_shape=True)]
    tolerance: Finite

    def __post_init__(self) -> None:
        if np.ndim(self.slopes) != 2 or len(self.edges) != len(self.slopes) + 1:
            raise InvalidInput(
                f"Designed: edges have the shape {np.shape(self.edges)} and slopes {np.shape(self.slopes)}; give one "
                "more edge than rows of coefficients."
            )
        if self.edges[0] != 0.0:
            raise InvalidInput("Designed: edges must ascend from 0.")

    @property
    def reach(self) -> float:
        """The outermost radius [m]."""
        return float(self.edges[-1])

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """The panel edges at which g is not smooth."""
        start = _gap(self).start
        return tuple((b, jump) for b, jump in self.joints if b >= start)

    @property
    def joints(self) -> tuple[tuple[float, float], ...]:
        """Where panels meet, with the jump of the slope, which is zero unless a kink was requested."""
        return _joints(self)

    @property
    def rising(self) -> bool:
        """Whether g on a homogeneous half-space rises everywhere."""
        samples = _gap(self).slope(np.linspace(0.0, self.reach, 4097)[:-1])
        return bool(np.min(samples) >= -1e-8 * np.max(samples))

    @property
    def notes(self) -> tuple[Note, ...]:
        """The deviation of the body from the prescribed curve."""
        text = f"The designed body differs from the prescribed curve by {self.tolerance:.2g} of its maximum."
        standing = Standing.ASYMPTOTIC if self.tolerance < 1e-4 else Standing.APPROXIMATE
        return (Note(Assumption.SHAPE, standing, text, "misfit of the convex curve through the prescribed points"),)

    @property
    def gap_tolerance(self) -> float:
        """Absolute error [-] to which g' can be known."""
        steepest = float(np.max(np.abs(self.slope(np.linspace(0.0, self.reach, 1001)))))
        crowded = float(np.min(np.diff(self.edges))) < NARROW_PANEL_LIMITS[0] * self.reach
        return steepest * (NARROW_PANEL_LIMITS[1] if crowded else GAP_TOLERANCE)

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        return _derived(self)[0](np.asarray(r, dtype=float))

    def slope(self, r: Array) -> Array:
        """f'(r) [-]."""
        r = np.asarray(r, dtype=float)
        found = Panels(self.edges, self.slopes)(r)
        quotient, end = _over_radius(self), float(self.edges[1])
        if quotient.size == 0:
            return found
        near = 2.0 * r / end * chebyshev.chebval(np.clip(2.0 * r / end - 1.0, -1.0, 1.0), quotient)
        return np.asarray(np.where(r < end, near, found))

    def curvature(self, r: Array) -> Array:
        """f''(r) [1/m]."""
        return _derived(self)[1](np.asarray(r, dtype=float))

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        return _gap(self)(np.asarray(x, dtype=float), 0)

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        return _gap(self)(np.asarray(x, dtype=float), 1)

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2]."""
        return _gap(self)(np.asarray(x, dtype=float), -1)


@functools.lru_cache(maxsize=64)
def _derived(profile: Designed) -> tuple[Panels, Panels]:
    """Return height and curvature."""
    slope = Panels(profile.edges, profile.slopes)
    return slope.integral, slope.derivative


@functools.lru_cache(maxsize=64)
def _over_radius(profile: Designed) -> Array:
    """Return the series of f' over 2 r / edge on the first panel, so that f' keeps its digits near a round apex.

    Empty for a sharp tip, where f' does not vanish.
    """
    series = profile.slopes[0]
    signs = np.where(np.arange(series.size) % 2 == 0, 1.0, -1.0)
    if series.size < 2 or abs(float(series @ signs)) > ROUNDING * float(np.sum(np.abs(series))):
        return np.zeros(0)
    return np.asarray(chebyshev.chebdiv(series, [1.0, 1.0])[0])


@functools.lru_cache(maxsize=64)
def _joints(profile: Designed) -> tuple[tuple[float, float], ...]:
    signs = np.where(np.arange(profile.slopes.shape[1]) % 2 == 0, 1.0, -1.0)
    jumps = profile.slopes[1:] @ signs - profile.slopes[:-1].sum(axis=1)
    steepest = float(np.max(np.abs(profile.slopes).sum(axis=1)))
    jumps = np.where(np.abs(jumps) > SMALLEST_JUMP * steepest, jumps, 0.0)
    return tuple((float(b), float(jump)) for b, jump in zip(profile.edges[1:-1], jumps, strict=True))


class Transformed(NamedTuple):
    """g on a homogeneous half-space: panels, and below `start` a power, g = value (x / start)^power."""

    slope: Panels
    gap: Panels
    whole: Panels
    start: float
    value: float
    power: float

    def __call__(self, x: Array, order: int) -> Array:
        """Return g (order 0), its slope (1), or its integral from 0 (-1)."""
        panels = (self.gap, self.slope, self.whole)[order]
        if self.start == 0.0:
            return panels(x)
        t = np.minimum(x / self.start, 1.0)
        if order == 1:
            near = self.value * self.power / self.start * np.where(t > 0.0, t, 1.0) ** (self.power - 1.0)
            near = np.where((t > 0.0) | (self.power == 1.0), near, 0.0)
        else:
            near = self.value * t**self.power
        if order == -1:
            near = near * t * self.start / (1.0 + self.power)
        return np.where(x < self.start, near, panels(np.maximum(x, self.start)))


@functools.lru_cache(maxsize=64)
def _gap(profile: Designed) -> Transformed:
    def gap_slope(x: Array) -> Array:
        return abel.gap_slope(profile.slope, profile.curvature, profile.joints, x)

    slope = fit_panels(gap_slope, profile.edges, profile.gap_tolerance)
    gap = slope.integral
    if not np.any(profile.slopes[0]):
        return Transformed(slope, gap, gap.integral, 0.0, 0.0, 1.0)  # a flat end
    x = profile.reach * np.geomspace(1e-6, 1.0, 601)
    g = gap(x)
    start = x[np.flatnonzero(g <= LEAST_GAP_RATIO * g[-1])[-1] + 1] if g[0] <= LEAST_GAP_RATIO * g[-1] else x[0]
    value, rise = float(gap(start[None])[0]), float(slope(start[None])[0])
    return Transformed(slope, gap, gap.integral, float(start), value, max(rise * float(start) / value, 1.0))
