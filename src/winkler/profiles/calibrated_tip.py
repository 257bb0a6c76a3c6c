r"""Tips of which calibration knows the cross-section over the contact depth, as bodies of revolution.

Instrumented indentation calibrates :math:`A(h)` between two contact depths.  The body of revolution whose
cross-section at a height :math:`h` above its apex has the radius

.. math:: r(h) = \beta\,\sqrt{A(h)/\pi}

has, at the contact depth :math:`h=f(a)`, the stiffness :math:`2E^*a = 2\beta E^*\sqrt{A/\pi}` of Oliver and Pharr's
evaluation with the shape factor :math:`\beta`; an elastic curve fitted with it gives the modulus of that evaluation.
Below the shallowest depth of the calibration the area is continued by the power of the depth with which it grows there.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.numerics.equations.roots import between
from winkler.numerics.types import Array
from winkler.profiles.area_coefficients import AreaCoefficients
from winkler.profiles.measured import Measured
from winkler.profiles.profile import Shape
from winkler.values.checks.number_checks import Positive, PositiveRow
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

POINTS_PER_OCTAVE = 8
"""Of the depth, at which an area function is sampled; the spline through them is within 3e-5 of the depths."""
CONTINUED = 10
"""Points below the shallowest depth."""
LEAST_POWER, MOST_POWER = 0.25, 2.0
"""Exponents of A ~ h^q with which an apex is continued: from blunt to a cone."""
OLIVER = "W. C. Oliver, G. M. Pharr, J. Mater. Res. 7 (1992) 1564-1583, doi:10.1557/JMR.1992.1564"


class _TipOfArea(Shape):
    """A tip given by cross-sections at depths; subclasses give `_samples`."""

    shape_factor: float

    @property
    def _samples(self) -> tuple[Array, Array, float]:
        """Depths [m], areas [m^2], and the exponent with which the area grows at the first depth."""
        raise NotImplementedError

    @property
    def _curve(self) -> Measured:
        return _curve(self)

    @property
    def reach(self) -> float:
        """Radius at the deepest depth of the calibration [m]."""
        return self._curve.reach

    @property
    def size(self) -> float:
        """Radius at the deepest depth of the calibration [m]; infinite, because the tip goes on beyond it."""
        return math.inf

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Knots of the spline."""
        return self._curve.kinks

    @property
    def rising(self) -> bool:
        """Whether g of the curve rises everywhere."""
        return self._curve.rising

    @property
    def notes(self) -> tuple[Note, ...]:
        """What the body of revolution has of the tip."""
        depths, _, power = self._samples
        text = (
            "The tip is replaced by the body of revolution with its calibrated cross-sections. Its radii are "
            f"multiplied by the shape factor {self.shape_factor:g} (elastic pyramids of four and three faces have "
            f"1.027 and 1.078). The calibration covers contact depths from {depths[0]:.3g} to {depths[-1]:.3g} m. "
            f"Below this range the area is extrapolated with the power {power:.3g} of the depth; contacts beyond "
            "it are not supported."
        )
        return (Note(Assumption.SHAPE, Standing.APPROXIMATE, text, OLIVER), *self._curve.notes)

    def cross_section(self, height: float) -> float:
        """Return the calibrated cross-section [m^2] at a contact depth [m], without the shape factor.

        Raises
        ------
        OutsideValidity
            If the tip was not calibrated for that depth.
        """
        depths = self._samples[0]
        if not depths[0] <= height <= depths[-1]:
            raise OutsideValidity(
                f"{type(self).__name__}: the contact depth {height:.3g} m is outside the calibration, from "
                f"{depths[0]:.3g} to {depths[-1]:.3g} m; give another depth, or a calibration that includes it."
            )
        radius = between(
            lambda r: float(self.height(np.array([r]))[0]) - height, 0.0, self.reach * (1.0 - 1e-15), relative=1e-14
        )
        return math.pi * (radius / self.shape_factor) ** 2

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        return self._curve.height(r)

    def slope(self, r: Array) -> Array:
        """f'(r) [-]."""
        return self._curve.slope(r)

    def curvature(self, r: Array) -> Array:
        """f''(r) [1/m]."""
        return self._curve.curvature(r)

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        return self._curve.gap(x)

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        return self._curve.gap_slope(x)

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2]."""
        return self._curve.gap_integral(x)


@value
class CalibratedTip(_TipOfArea):
    """The body of revolution with a calibrated area function, A(h) = C0 h^2 + C1 h + C2 h^(1/2) + C3 h^(1/4) + ...

    Parameters
    ----------
    coefficients : sequence of float
        C0 [-], C1 [m], C2 [m^(3/2)], C3 [m^(7/4)], ...: the n-th belongs to h^(2^(1-n)).
    shallowest, deepest : float
        Contact depths [m] between which it was calibrated.  The polynomial is used only in this range.
    shape_factor : float, optional
        beta [-]; 1 by default, that of bodies of revolution.

    Raises
    ------
    InvalidInput
        If the depths do not grow, or the area is not positive or falls between them.

    See Also
    --------
    AreaFunction : the same polynomial from the apex on, without limits.
    CalibratedArea : what `OliverPharr` evaluates; its method `profile` returns this tip.

    References
    ----------
    W. C. Oliver, G. M. Pharr, J. Mater. Res. 7 (1992) 1564-1583, doi:10.1557/JMR.1992.1564
    """

    __words__ = words(
        shallowest=("h_c", "m", "smallest contact depth of the calibration"),
        deepest=("h_c", "m", "greatest contact depth of the calibration"),
        shape_factor=(r"\beta", "", "stiffness over that of a round contact with the same area"),
    )

    coefficients: AreaCoefficients
    shallowest: Positive
    deepest: Positive
    shape_factor: Positive = 1.0

    def __post_init__(self) -> None:
        if not self.shallowest < self.deepest:
            raise InvalidInput(
                f"CalibratedTip: it is calibrated from {self.shallowest:.6g} to {self.deepest:.6g} m; give two depths "
                "that grow."
            )
        _checked("CalibratedTip", *self._samples)

    @property
    def _samples(self) -> tuple[Array, Array, float]:
        count = max(math.ceil(POINTS_PER_OCTAVE * math.log2(self.deepest / self.shallowest)), 2 * POINTS_PER_OCTAVE)
        depths = np.geomspace(self.shallowest, self.deepest, count)
        powers = [2.0 ** (1 - n) for n in range(len(self.coefficients))]
        terms = [c * depths**power for c, power in zip(self.coefficients, powers, strict=True)]
        area = np.sum(terms, axis=0)
        growth = sum(float(term[0]) * power for term, power in zip(terms, powers, strict=True))
        return depths, area, float(growth / area[0]) if area[0] > 0.0 else math.nan


@value
class TabulatedTip(_TipOfArea):
    """The body of revolution with cross-sections measured at contact depths.

    Parameters
    ----------
    depths : sequence of float, (n,)
        Contact depths [m], positive and growing, at least five.
    areas : sequence of float, (n,)
        Cross-sections [m^2] there, positive and growing.
    shape_factor : float, optional
        beta [-]; 1 by default, that of bodies of revolution.

    Raises
    ------
    InvalidInput
        If depths or areas do not grow, or differ in number.

    See Also
    --------
    CalibratedTip : from the coefficients of an area function.
    """

    __words__ = words(
        depths=("h_i", "m", "contact depths of the calibration"),
        areas=("A_i", "m^2", "cross-sections at these depths"),
        shape_factor=(r"\beta", "", "stiffness over that of a round contact with the same area"),
    )

    depths: PositiveRow
    areas: PositiveRow
    shape_factor: Positive = 1.0

    def __post_init__(self) -> None:
        if self.depths.size != self.areas.size or self.depths.size < 5:
            raise InvalidInput(
                f"TabulatedTip: there are {self.depths.size} depths and {self.areas.size} areas; give two rows of "
                "equal length, of at least five numbers."
            )
        if np.any(np.diff(self.depths) <= 0.0):
            raise InvalidInput("TabulatedTip: depths do not grow from row to row; sort the table, one row a depth.")
        _checked("TabulatedTip", *self._samples)

    @property
    def _samples(self) -> tuple[Array, Array, float]:
        first = np.log(self.areas[:3]), np.log(self.depths[:3])
        return self.depths, self.areas, float(np.polyfit(first[1], first[0], 1)[0])


def _checked(name: str, depths: Array, areas: Array, power: float) -> None:
    """Refuse areas that are not those of a tip."""
    bad = np.flatnonzero(~(areas > 0.0))
    if bad.size:
        raise InvalidInput(
            f"{name}: the area is {areas[bad[0]]:.3g} m^2 at the depth {depths[bad[0]]:.3g} m; give a range of depths "
            "in which it is positive."
        )
    bad = np.flatnonzero(np.diff(areas) <= 0.0)
    if bad.size:
        raise InvalidInput(
            f"{name}: the area does not grow at the depth {depths[bad[0] + 1]:.3g} m; give a range of depths in which "
            "it does."
        )
    if not LEAST_POWER <= power <= MOST_POWER * 1.1:
        raise InvalidInput(
            f"{name}: at the shallowest depth, {depths[0]:.3g} m, the area grows like the power {power:.3g} of the "
            f"depth; a tip has {LEAST_POWER} to {MOST_POWER}, so begin the calibration deeper."
        )


@functools.lru_cache(maxsize=64)
def _curve(tip: _TipOfArea) -> Measured:
    """Return the curve through the cross-sections, with the apex continued."""
    depths, areas, power = tip._samples
    radii = tip.shape_factor * np.sqrt(areas / math.pi)
    # heights ~ r^(2/q), with places that gather at the apex as the heights do
    share = np.arange(CONTINUED) / CONTINUED
    return Measured(
        np.concatenate((radii[0] * share, radii)),
        np.concatenate((depths[0] * share ** (2.0 / min(power, MOST_POWER)), depths)),
    )
