r"""Cones, sharp, cut and rounded, and the cones of equal cross-section that commonly replace pyramids.

Half-angles are measured from the axis, :math:`f = r/\tan\theta`.
"""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from winkler.numerics.panels.abel_intervals import root_difference
from winkler.numerics.types import Array
from winkler.profiles.half_angle import HalfAngle
from winkler.profiles.pieces import PowerPieces, Term
from winkler.profiles.power import Paraboloid, PowerLaw
from winkler.profiles.profile import Profile, RisingShape
from winkler.values.checks.number_checks import Positive, PositiveNotTiny
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value


@value
class Cone(PowerPieces):
    """A cone, f = r / tan(half_angle).

    Parameters
    ----------
    half_angle : float
        Measured from the axis [rad], between 0 and pi/2.

    References
    ----------
    A. E. H. Love, Quart. J. Math. 10 (1939) 161-175, doi:10.1093/qmath/os-10.1.161
    """

    half_angle: HalfAngle

    @property
    def terms(self) -> tuple[Term, ...]:
        """A constant slope."""
        return ((0.0, 0, 1.0 / math.tan(self.half_angle)),)


@value
class TruncatedCone(PowerPieces):
    """A cone with its tip cut off: flat up to `flat_radius`, then conical.

    Parameters
    ----------
    half_angle : float
        Measured from the axis [rad], between 0 and pi/2.
    flat_radius : float
        b [m], positive.
    """

    half_angle: HalfAngle
    flat_radius: Positive

    @property
    def terms(self) -> tuple[Term, ...]:
        """A constant slope beyond the flat."""
        return ((self.flat_radius, 0, 1.0 / math.tan(self.half_angle)),)


@value
class RoundedCone(PowerPieces):
    """A cone with a parabolic tip and a continuous slope.

    Parameters
    ----------
    curvature_radius : float
        R [m], at the apex; the cone begins at r = R / tan(half_angle).
    half_angle : float
        Measured from the axis [rad], between 0 and pi/2.

    See Also
    --------
    SpheroConical : the same with a spherical tip.

    References
    ----------
    D. Maugis, M. Barquins, J. Phys. Lett. 42 (1981) L95-L97, doi:10.1051/jphyslet:0198100420509500
    """

    curvature_radius: PositiveNotTiny
    half_angle: HalfAngle

    @property
    def blend_radius(self) -> float:
        """Radius at which the tip joins the cone [m]."""
        return self.curvature_radius / math.tan(self.half_angle)

    @property
    def terms(self) -> tuple[Term, ...]:
        """A paraboloid that joins a cone."""
        m, b = 1.0 / math.tan(self.half_angle), self.blend_radius
        return ((0.0, 1, m / b), (b, 1, -m / b), (b, 0, m))

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """The blend, where the slope is continuous."""
        return ((self.blend_radius, 0.0),)


@value
class SpheroConical(RisingShape):
    """A cone with a spherical tip and a continuous slope: the usual AFM or nanoindenter tip.

    Parameters
    ----------
    curvature_radius : float
        R [m], of the tip; the cone begins at r = R cos(half_angle).
    half_angle : float
        Measured from the axis [rad], between 0 and pi/2.

    References
    ----------
    B. J. Briscoe, K. S. Sebastian, M. J. Adams, J. Phys. D 27 (1994) 1156-1162, doi:10.1088/0022-3727/27/6/013
    """

    curvature_radius: PositiveNotTiny
    half_angle: HalfAngle

    @property
    def blend_radius(self) -> float:
        """Radius at which the tip joins the cone [m]."""
        return self.curvature_radius * math.cos(self.half_angle)

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """The blend, where the slope is continuous."""
        return ((self.blend_radius, 0.0),)

    def _tip(self, r: Array) -> tuple[Array, Array]:
        """Return r within the tip, and sqrt(R^2 - r^2) there."""
        inner = np.minimum(r, self.blend_radius)
        big = self.curvature_radius
        return inner, np.sqrt((big - inner) * (big + inner))

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        r = np.asarray(r, dtype=float)
        inner, root = self._tip(r)
        return inner**2 / (self.curvature_radius + root) + (r - inner) / math.tan(self.half_angle)

    def slope(self, r: Array) -> Array:
        """f'(r) [-]."""
        inner, root = self._tip(np.asarray(r, dtype=float))
        return inner / root

    def curvature(self, r: Array) -> Array:
        """f''(r) [1/m]."""
        r = np.asarray(r, dtype=float)
        _, root = self._tip(r)
        return np.where(r < self.blend_radius, self.curvature_radius**2 / root**3, 0.0)

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        x = np.asarray(x, dtype=float)
        tip, cone = self._parts(x)
        result: Array = x * (tip + cone)
        return result

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        x = np.asarray(x, dtype=float)
        big, b = self.curvature_radius, self.blend_radius
        tip, cone = self._parts(x)
        high = big * math.sin(self.half_angle)
        root = root_difference(x, b)
        inner = np.minimum(x, b)
        within = x * big / ((big - inner) * (big + inner))
        beyond = x / (big + x) + (b * b - high * root) / (high * (high + root))
        result: Array = np.add(tip + cone, np.where(x <= b, within, beyond))
        return result

    def _parts(self, x: Array) -> tuple[Array, Array]:
        """Return what tip and flank add to g(x)/x."""
        big, b = self.curvature_radius, self.blend_radius
        root = root_difference(x, b)
        beyond = np.log1p((big + x - big * math.sin(self.half_angle) - root) / (big * math.sin(self.half_angle) + root))
        tip = np.where(x <= b, np.arctanh(np.minimum(x, b) / big), beyond)
        return tip, np.arctan2(root, b) / math.tan(self.half_angle)


class _EqualAreaCone(PowerPieces):
    """The cone whose cross-section at every height has the area of the pyramid's."""

    _area: ClassVar[float]
    """Cross-section over height squared [-]."""
    _error: ClassVar[str]
    """How much less force it takes than the pyramid."""

    @property
    def half_angle(self) -> float:
        """Half-angle of the equal-area cone, from the axis [rad]."""
        return math.atan(math.sqrt(self._area / math.pi))

    @property
    def terms(self) -> tuple[Term, ...]:
        """A constant slope."""
        return ((0.0, 0, 1.0 / math.tan(self.half_angle)),)

    @property
    def notes(self) -> tuple[Note, ...]:
        """That a cone stands for a pyramid, and what it costs."""
        return (
            Note(
                Assumption.SHAPE,
                Standing.APPROXIMATE,
                "The pyramid is replaced by the cone of equal cross-section (half-angle "
                f"{math.degrees(self.half_angle):.2f} deg). On an elastic half-space the force of the cone at a "
                f"given depth is {self._error} below that of the pyramid. `Pyramid` has the force of the pyramid.",
                "boundary-element solution of the sharp pyramid, theory sheet 1.3",
            ),
        )


def _three_sided(face_angle: float) -> float:
    return 3.0 * math.sqrt(3.0) * math.tan(math.radians(face_angle)) ** 2


@value
class Berkovich(_EqualAreaCone):
    """The modified Berkovich pyramid (three faces, 65.27 deg to the axis) as the cone of equal area."""

    _area = _three_sided(65.27)
    _error = "7.2 %"


@value
class CubeCorner(_EqualAreaCone):
    """The cube corner (three faces, 35.264 deg to the axis) as the cone of equal area."""

    _area = 1.5 * math.sqrt(3.0)
    _error = "7.2 %"


@value
class Vickers(_EqualAreaCone):
    """The Vickers pyramid (four faces, 68 deg to the axis) as the cone of equal area."""

    _area = 4.0 * math.tan(math.radians(68.0)) ** 2
    _error = "2.6 %"


def power_of(profile: Profile) -> tuple[float, float]:
    """Return c and n of a profile c r^n; zeros if it is none."""
    match profile:
        case PowerLaw(coefficient, exponent):
            return coefficient, exponent
        case Paraboloid(radius):
            return 0.5 / radius, 2.0
        case Cone(half_angle):
            return 1.0 / math.tan(half_angle), 1.0
        case _:
            return 0.0, 0.0
