r"""The elliptic contact of Hertz: its semi-axes, given, or from the curvatures and the load.

Bodies whose distance is :math:`x^2/2R_x + y^2/2R_y` touch on an ellipse with semi-axes a along x and b across.  With
the larger one :math:`\alpha`, the smaller :math:`\beta` and :math:`m=1-\beta^2/\alpha^2`, in Carlson's integrals,

.. math:: \frac{1}{R_\alpha} = \frac{F}{\pi E^*\alpha^3}R_D(0,1-m,1),\qquad
          \frac{1}{R_\beta} = \frac{F}{\pi E^*\alpha^3}R_D(0,1,1-m) .
"""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.checks.number_checks import Positive
from winkler.errors import InvalidInput
from winkler.numerics.equations.bracketing import between
from winkler.values import value

__all__ = ["ContactEllipse", "CurvedBodies"]

LEAST_AXES_RATIO = 1e-8
"""Smallest ratio of the semi-axes that is searched for; far beyond Kalker's table."""


@value
class ContactEllipse:
    """A contact of known size.

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
        """Return a and b [m], whatever presses the bodies."""
        return self.longitudinal_semi_axis, self.lateral_semi_axis


@value
class CurvedBodies:
    """Two bodies whose distance has the same principal directions as the rolling.

    Parameters
    ----------
    longitudinal_curvature_radius : float
        R_x [m], 1/R_x = sum of the curvatures of both bodies along the direction of rolling.
    lateral_curvature_radius : float
        R_y [m], the same across it.

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

    def semi_axes(self, modulus: float, force: float) -> tuple[float, float]:
        """Return a and b [m].

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
        """R_eq [m] of the ball whose force grows with depth as that of the bodies."""
        from scipy.special import elliprf

        a, b = self.semi_axes(1.0, 1.0)
        smaller, larger = sorted((a, b))
        depth = 1.5 * float(elliprf(0.0, (smaller / larger) ** 2, 1.0)) / (math.pi * larger)
        return 9.0 / (16.0 * depth**3)


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
