r"""The equivalent profile g(x) of a force curve: the profile that gives this curve on a medium.

The slope k(d) = dF/dd is the stiffness of the contact, which the medium has at one contact radius alone; the depth
there is the equivalent profile, :math:`g(a) = d` where :math:`k_\mathrm{medium}(a) = k(d)`, with the slope

.. math:: g'(a) = \frac{k'_\mathrm{medium}(a)}{\mathrm dk/\mathrm dd} .

Between the knots of the curve g is smooth; it is kept as polynomials.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.media.body_of import EquivalentProfile
from winkler.media.medium import Medium
from winkler.media.offers import PressedWaves, offers
from winkler.numerics.equations.roots import invert, rough_root
from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.panels.convex_spline import ConvexCurve
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.value import value, words

LARGEST_RADIUS_RATIO = 500.0
"""Greatest contact radius for which layers are solved, over their total thickness."""
LEAST_RADIUS_RISE = 1e-5
"""Rise of the contact radius with the variable of the curve, relative to the greatest radius, that is none."""
LEAST_RADIUS_RATIO = 1e-4
"""Panels closer to the axis, relative to the greatest radius, are too small to be followed."""
FLAT_END_RATIO = 1e-9
"""A contact starts with a flat end if its first radius is more than this part of the last."""


@value
class CurveProfile:
    """The equivalent profile behind a force curve, exactly.

    Parameters
    ----------
    curve : ConvexCurve
    medium : Medium
    flat : float
        Radius of the flat end [m], or zero.
    reach : float
        Greatest contact radius [m].
    joints : tuple of float
        Contact radii at the joints of the curve [m].
    """

    __words__ = words(
        flat=("b", "m", "radius of the flat end behind a force curve"),
        joints=("a_i", "m", "contact radii where one piece of a force curve meets the next"),
    )

    curve: ConvexCurve
    medium: Medium
    flat: float
    reach: float
    joints: tuple[float, ...]

    @property
    def singular(self) -> bool:
        """Whether g starts at the end of a flat with a power that is no polynomial."""
        power = 1.0 / self.curve.beta
        return self.flat > 0.0 and abs(power - round(power)) > 1e-9

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Where g is not smooth."""
        return tuple((b, 0.0) for b in (self.flat, *self.joints) if b > 0.0)

    def _place(self, x: Array) -> tuple[Array, Array, Array]:
        """Return whether x is beyond the flat end, a place that is, and the curve's variable there."""
        inside = x > self.flat
        place = np.where(inside, x, self.reach)
        return inside, place, self.curve.place(self.medium.punch_stiffness(place))

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        inside, _, s = self._place(np.asarray(x, dtype=float))
        return np.where(inside, self.curve.depth_at(s), 0.0)

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        inside, place, s = self._place(np.asarray(x, dtype=float))
        rise = self.curve.rise(s) * self.curve.beta * s / np.where(s > 0.0, self.curve.depth_at(s), 1.0)
        slope = 2.0 * self.medium.normal_stiffness(place) / np.where(rise > 0.0, rise, np.inf)
        return np.where(inside, slope, 0.0)


@value
class TabulatedProfile:
    """The same on panels, much faster.

    Parameters
    ----------
    slopes : Panels
        g'(x) [-] from the axis on.
    """

    __words__ = words(slopes=("g'", None, "slope of the equivalent plane profile on panels"))

    slopes: Panels

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Where panels meet: they are narrow where g bends much, and rules for integrals must follow them."""
        edges = self.slopes.edges
        return tuple((float(b), 0.0) for b in edges[1:-1] if b > LEAST_RADIUS_RATIO * edges[-1])

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        return self.slopes.integral(x)

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        return self.slopes(x)


def springs_of_curve(curve: ConvexCurve, medium: Medium, tolerance: float) -> tuple[EquivalentProfile, CurveProfile]:
    """Return springs for quick use, with an error of g' relative to its greatest value, and the exact ones.

    They are the same where g starts at the end of a flat with a broken power.

    Raises
    ------
    OutsideValidity
        If the stiffness stands still, or is that of a contact much wider than the layers of the medium.
    """
    knots = curve.panels.edges
    radii = _radii(medium, curve.stiffness(knots))
    growth = np.diff(radii) / np.diff(knots)
    if np.any(growth <= LEAST_RADIUS_RISE * radii[-1]):
        still = int(np.flatnonzero(growth <= LEAST_RADIUS_RISE * radii[-1])[0])
        low, high = curve.depth_at(knots[still : still + 2])
        raise OutsideValidity(
            f"dF/dd hardly increases between the depths {low:.6g} m and {high:.6g} m: the contact would stop "
            "growing at a vertical wall. Give a curve whose slope increases, or use CappedCylinder."
        )
    end = float(radii[-1])
    flat = float(radii[0]) if radii[0] > FLAT_END_RATIO * end else 0.0
    joints = _radii(medium, curve.stiffness(np.append(curve.joints, 1.0)))[:-1]
    exact = CurveProfile(curve, medium, flat, end, tuple(float(b) for b in joints))
    if exact.singular:
        return exact, exact
    bounds = np.array([0.0, *(b for b, _ in exact.kinks), end])
    steepest = float(np.max(exact.gap_slope(np.linspace(0.0, end, 513)[1:])))
    return TabulatedProfile(fit_panels(exact.gap_slope, bounds, tolerance * steepest)), exact


def _radii(medium: Medium, stiffness: Array) -> Array:
    """Return the contact radii with these stiffnesses."""
    result = np.zeros(stiffness.shape)
    positive = stiffness > 1e-12 * stiffness[-1]
    upper = _wide_enough(medium, float(stiffness[-1])) if offers(medium, PressedWaves) else math.inf
    result[positive] = invert(
        lambda a: (medium.punch_stiffness(a), 2.0 * medium.normal_stiffness(a)),
        stiffness[positive],
        lower=0.0,
        upper=upper,
        guess=0.5 * upper if math.isfinite(upper) else rough_root(medium.punch_stiffness, float(stiffness[-1])),
    )
    return result


def _wide_enough(medium: PressedWaves, stiffness: float) -> float:
    """Return a radius at which the stiffness is exceeded: far wider ones cost time, or cannot be carried."""
    whole = medium.thickness
    radius = min(0.25 * whole, 2.0 * stiffness / medium.modulus)
    while True:
        try:
            if float(medium.punch_stiffness(np.array([radius]))[0]) > stiffness:
                return radius
        except NotConverged:
            radius = math.inf
        radius *= 2.0
        if radius > LARGEST_RADIUS_RATIO * whole:
            raise OutsideValidity(
                f"dF/dd reaches {stiffness:.6g} N/m, the stiffness of a contact more than {LARGEST_RADIUS_RATIO:g} "
                f"times as wide as "
                f"the layers are thick ({whole:.6g} m), where they cannot be carried; give smaller forces, or the "
                "medium below the layers."
            )
