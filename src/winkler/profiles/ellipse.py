r"""The elliptic contact of Hertz: its semi-axes, given, or from the curvatures and the load.

Bodies whose distance is :math:`x^2/2R_x + y^2/2R_y` touch on an ellipse with semi-axes a along x and b across.  With
the larger one :math:`\alpha`, the smaller :math:`\beta` and :math:`m=1-\beta^2/\alpha^2`, in Carlson's integrals,

.. math:: \frac{1}{R_\alpha} = \frac{F}{\pi E^*\alpha^3}R_D(0,1-m,1),\qquad
          \frac{1}{R_\beta} = \frac{F}{\pi E^*\alpha^3}R_D(0,1,1-m) .
"""

from __future__ import annotations

import functools
import math
import numbers

import numpy as np

from winkler.numerics.equations.bracketing import between
from winkler.values.checks.number_checks import Positive
from winkler.values.errors import InvalidInput
from winkler.values.value import value

LEAST_AXES_RATIO = 1e-8
"""Smallest ratio of the semi-axes that is searched for; far beyond Kalker's table."""
ROUNDING = 1e-14
"""Curvature over the greatest one of the bodies that is rounding."""


@value
class ContactEllipse:
    """An elliptic contact of known size.

    Parameters
    ----------
    longitudinal_semi_axis : float
        a [m], along the direction of rolling.
    lateral_semi_axis : float
        b [m], across it.

    Raises
    ------
    InvalidInput
        If one is not positive and finite.
    """

    longitudinal_semi_axis: Positive
    lateral_semi_axis: Positive

    def semi_axes(self, modulus: float, force: float) -> tuple[float, float]:
        """Return the semi-axes a and b [m], which do not depend on modulus and force."""
        return self.longitudinal_semi_axis, self.lateral_semi_axis


@value
class CurvedBodies:
    """Two bodies with two curvatures each, given by the relative radii of curvature along x and y.

    Parameters
    ----------
    longitudinal_curvature_radius : float
        R_x [m], 1/R_x = sum of the curvatures of both bodies along x, the direction of rolling if they roll.
    lateral_curvature_radius : float
        R_y [m], the same along y.  The distance of the bodies has no term in xy.

    Raises
    ------
    InvalidInput
        If one is not positive and finite.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 4.2, doi:10.1017/CBO9781139171731

    Examples
    --------
    A wheel on a rail: the contact is longer along the rail, where the bodies are less curved.

    >>> a, b = CurvedBodies(0.46, 0.3).semi_axes(modulus=114e9, force=80e3)
    >>> round(1e3 * a, 3), round(1e3 * b, 3)
    (6.675, 5.021)
    """

    longitudinal_curvature_radius: Positive
    lateral_curvature_radius: Positive

    @classmethod
    def of(cls, first: tuple[float, float], second: tuple[float, float], angle: float = 0.0) -> CurvedBodies:
        """Return the combined radii of two bodies from the principal radii of each.

        Parameters
        ----------
        first, second : tuple of float
            R_x and R_y of the first body in its own axes, and of the second one in its axes [m]. Radii are negative for
            concave surfaces such as raceways, and infinite for straight ones.
        angle : float
            Angle between the axes of the second body and those of the first [rad].

        Returns
        -------
        CurvedBodies
            The combined radii in the principal directions of the gap; x is the direction closest to x of the first
            body, rotated by `turn`.

        Raises
        ------
        InvalidInput
            If a radius is zero, or the bodies do not touch in a point, because a hollow is as narrow as the body in
            it.

        Examples
        --------
        A ball in the groove of an inner ring, and crossed cylinders:

        >>> ring = CurvedBodies.of(first=(5e-3, 5e-3), second=(26e-3, -5.2e-3))
        >>> round(ring.longitudinal_curvature_radius * 1e3, 3), round(ring.lateral_curvature_radius * 1e3, 1)
        (4.194, 130.0)
        >>> CurvedBodies.of((math.inf, 1e-2), (math.inf, 2e-2), angle=0.5 * math.pi)
        CurvedBodies(longitudinal_curvature_radius=0.02, lateral_curvature_radius=0.01)
        """
        bends = _curvatures(first, second, angle)[:2]
        if not min(bends) > ROUNDING * max(abs(1.0 / radius) for radius in (*first, *second)):
            raise InvalidInput(
                f"CurvedBodies.of: bodies of the radii {first} m and {second} m do not touch in a point. A hollow is "
                "as narrow as the body in it, or both are straight; give a hollow wider than the body in it, and "
                "cylinders that touch along a line to LineFoundation."
            )
        return cls(1.0 / bends[0], 1.0 / bends[1])

    @staticmethod
    def turn(first: tuple[float, float], second: tuple[float, float], angle: float = 0.0) -> float:
        """Return the angle [rad] from x of the first body to x of both together, at most 45 degrees; as in `of`."""
        return _curvatures(first, second, angle)[2]

    def semi_axes(self, modulus: float, force: float) -> tuple[float, float]:
        """Return the semi-axes a and b of the contact [m].

        Parameters
        ----------
        modulus : float
            E* [Pa].
        force : float
            F_N [N], positive.

        Raises
        ------
        InvalidInput
            If the curvatures are so different that the contact is a line.
        """
        from scipy.special import elliprd

        slenderness = self.slenderness
        curvature = 1.0 / max(self.longitudinal_curvature_radius, self.lateral_curvature_radius)
        ratio = min(slenderness, 1.0 / slenderness)
        larger = (force * float(elliprd(0.0, ratio**2, 1.0)) / (math.pi * modulus * curvature)) ** (1.0 / 3.0)
        return (larger, ratio * larger) if slenderness <= 1.0 else (ratio * larger, larger)

    def steepest_slope(self, longitudinal: float, lateral: float) -> float:
        """Return the steepest slope [-] of the distance of both bodies within an ellipse of these semi-axes [m]."""
        return max(longitudinal / self.longitudinal_curvature_radius, lateral / self.lateral_curvature_radius)

    @property
    def together(self) -> CurvedBodies:
        """The bodies themselves, as for a `CurvedPair`."""
        return self

    @property
    def slenderness(self) -> float:
        """b/a [-], the semi-axis across over that along.

        Raises
        ------
        InvalidInput
            If the curvatures are so different that the contact is a line.
        """
        along, across = self.longitudinal_curvature_radius, self.lateral_curvature_radius
        ratio = _slenderness(max(along, across) / min(along, across))
        if ratio == 0.0:
            raise InvalidInput(
                f"CurvedBodies: the curvature radii {along:g} m and {across:g} m are too different: the "
                "contact is a line."
            )
        return ratio if along >= across else 1.0 / ratio

    @property
    def equivalent_radius(self) -> float:
        """R_eq [m] of the ball with the same force-depth curve as the bodies."""
        from scipy.special import elliprf

        a, b = self.semi_axes(1.0, 1.0)
        smaller, larger = sorted((a, b))
        depth = 1.5 * float(elliprf(0.0, (smaller / larger) ** 2, 1.0)) / (math.pi * larger)
        return 9.0 / (16.0 * depth**3)


def _curvatures(first: tuple[float, float], second: tuple[float, float], angle: float) -> tuple[float, float, float]:
    """Return the principal curvatures of the distance, along and across, and the angle of their axes.

    The smaller one is the determinant of the curvatures over the larger one: it does not cancel where cylinders cross
    at a small angle.
    """
    for radii in (first, second):
        if not _are_radii(radii):
            raise InvalidInput(
                f"CurvedBodies: the radii {radii!r} are not two numbers other than zero; give R_x and R_y [m], "
                "negative where hollow, math.inf where straight."
            )
    if not (isinstance(angle, numbers.Real) and math.isfinite(angle)):
        raise InvalidInput(f"CurvedBodies: the angle is {angle!r}; give one in radians.")
    (own_x, own_y), (other_x, other_y) = ((1.0 / radius for radius in radii) for radii in (first, second))
    own, other = own_x - own_y, other_x - other_y
    quarters = angle / (0.5 * math.pi)
    on_axis = quarters == round(quarters)
    sine = float(round(quarters) % 2) if on_axis else math.sin(angle) ** 2
    along = 1.0 - 2.0 * sine if on_axis else math.cos(2.0 * angle)
    across = 0.0 if on_axis else math.sin(2.0 * angle)
    real, imaginary = own + other * along, other * across
    difference = math.hypot(real, imaginary)
    sign = -1.0 if real < 0.0 else 1.0
    turned = 0.5 * math.atan2(sign * imaginary, sign * real) if difference > 0.0 else 0.0
    mixed = (own_x * other_y + own_y * other_x) * (1.0 - sine) + (own_x * other_x + own_y * other_y) * sine
    larger = 0.5 * (own_x + own_y + other_x + other_y + difference)
    smaller = (own_x * own_y + other_x * other_y + mixed) / larger if larger > 0.0 else larger
    return (larger, smaller, turned) if sign > 0.0 else (smaller, larger, turned)


def _are_radii(radii: object) -> bool:
    if not isinstance(radii, (tuple, list, np.ndarray)) or len(radii) != 2:
        return False
    return all(isinstance(radius, numbers.Real) and not math.isnan(radius) and radius != 0.0 for radius in radii)


@functools.lru_cache(maxsize=256)
def _slenderness(ratio: float) -> float:
    """Return the smaller over the larger semi-axis under bodies of this ratio of radii; zero if it is too small."""
    from scipy.special import elliprd

    def missing(logarithm: np.ndarray, _: np.ndarray) -> np.ndarray:
        squared = np.exp(2.0 * logarithm)
        return np.asarray(elliprd(0.0, 1.0, squared) / elliprd(0.0, squared, 1.0) - ratio)

    most = np.array([math.log(LEAST_AXES_RATIO)])
    if float(missing(most, most)[0]) < 0.0:
        return 0.0
    return math.exp(float(between(missing, most, np.zeros(1))[0]))
