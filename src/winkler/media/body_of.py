r"""The body that belongs to given springs: the inverse transform, for every medium.

Displaced by g(x) itself, the springs move the surface by f(r): that is what a body glued to it would do.  So the
inverse of g is nothing but the surface displacement, which each medium computes,

.. math:: f(r) = \frac{2\cos(k\pi/2)}\pi\int_0^r \frac{x^k\,h(x)}{(r^2-x^2)^{(1+k)/2}}\,\mathrm dx ,

where h = g on a homogeneous (k = 0) or graded half-space, and on layers (k = 0)

.. math:: h = \varphi + K\varphi , \qquad
          \varphi(x) = w(x) - \int_x^a \rho(x;t)\,w(t)\,\mathrm dt , \qquad w(x) = \varphi(x;x)\,g(x) .

This h solves the Volterra equation :math:`h(a) - \int_0^a\rho(x;a)\,h(x)\,\mathrm dx = \varphi(a;a)\,g(a)` of the
forward transform without solving anything (see `winkler.numerics.transforms.fredholm`).  f, to 1e-11 of its greatest
value, does not depend on the radius a up to which the springs are displaced; f', to about 1e-9 of the steepest slope.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Protocol

import numpy as np

from winkler.media.halfspace import HomogeneousMedium
from winkler.media.medium import Displacement, Medium
from winkler.media.offers import PowerOfDepth, PressedWaves, offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.numerics.transforms import graded_abel
from winkler.numerics.types import Array, Curve
from winkler.values.errors import OutsideValidity
from winkler.values.value import value, words


class EquivalentProfile(Protocol):
    """An equivalent profile; equal content, equal hash.  `kinks` as those of a bed."""

    def __hash__(self) -> int:
        """A key of caches."""

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(x, strength)`` where g is not smooth, ascending."""

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""


@value
class Imprint:
    """Springs displaced by the equivalent profile itself, u(x) = g(x), up to a radius.

    Parameters
    ----------
    springs : Springs
        A bed, or whatever has gap, gap_slope and kinks.
    radius : float
        Up to where the body is wanted [m].
    """

    __words__ = words(
        springs=("", None, "the springs whose body is wanted"), radius=("", "m", "up to where the body is wanted")
    )

    springs: EquivalentProfile
    radius: float

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(x, strength)`` inside; opposite to those of a pressed bed, which lacks g of its depth."""
        return tuple((b, -strength) for b, strength in self.springs.kinks if b < self.radius)

    @property
    def edge(self) -> float:
        """g at the radius [m]."""
        return float(self.springs.gap(np.array([self.radius]))[0])

    def value(self, x: Array) -> Array:
        """u(x) [m]."""
        return self.springs.gap(x)

    def slope(self, x: Array) -> Array:
        """u'(x) [-]."""
        return self.springs.gap_slope(x)


def exponent_of(medium: Medium) -> float:
    """Return k [-] of a graded medium, zero of the others.

    Raises
    ------
    OutsideValidity
        If the medium cannot be read backwards.
    """
    if offers(medium, PowerOfDepth):
        return medium.exponent
    if isinstance(medium, HomogeneousMedium) or offers(medium, PressedWaves):
        return 0.0
    raise OutsideValidity(
        f"The medium is a {type(medium).__name__}, whose inverse transform is not known; give a HalfSpace, "
        "TransverselyIsotropicHalfSpace, GradedHalfSpace, CoatedHalfSpace or DepthGradedHalfSpace."
    )


def thickness_of(medium: Medium) -> float:
    """Return how thick the layers of a medium are [m]; infinite if it has none."""
    if offers(medium, RelaxingMedium):
        return thickness_of(medium.elastic)
    return medium.thickness if offers(medium, PressedWaves) else math.inf


def height(medium: Medium, imprint: Displacement, r: Array) -> Array:
    """Return the body that has these springs.

    Parameters
    ----------
    medium : Medium
        What it will be pressed into.
    imprint : Imprint
        Its equivalent profile.
    r : ndarray
        Not beyond the radius of the imprint [m].

    Returns
    -------
    ndarray of the shape of r
        f(r) [m].
    """
    medium = _elastic(medium)
    exponent_of(medium)
    return medium.displacement(imprint, r)


def slope(medium: Medium, imprint: Displacement, r: Array) -> Array:
    """Return f'(r) [-] of the body that has these springs; parameters as of `height`."""
    medium = _elastic(medium)
    edges = [b for b, _ in imprint.kinks if b < imprint.radius]
    r = np.asarray(r, dtype=float)
    return surface_slope(transformed_slope(medium, imprint), edges, exponent_of(medium), r, imprint.radius)


def _elastic(medium: Medium) -> Medium:
    """Return the medium as if it did not relax, which changes no shape."""
    if not offers(medium, RelaxingMedium):
        return medium
    if not medium.in_proportion:
        raise medium.timeless()
    return medium.elastic


def surface_slope(rise: Curve, edges: list[float], exponent: float, r: Array, radius: float) -> Array:
    """Return f'(r) [-] of the body with the transform h, given by its slope h'(x), smooth between the `edges`.

    It is the transform of x h'(x), over r.  `radius` [m] sets the scale below which a place counts as the axis.
    """
    flat = np.asarray(r, dtype=float).ravel()
    places = np.maximum(flat, 1e-12 * radius)
    moment = graded_abel.surface(lambda x: x * rise(x), edges, exponent, places)
    return np.asarray((moment / places).reshape(np.shape(r)))


def transformed_slope(medium: Medium, imprint: Displacement) -> Callable[[Array], Array]:
    """Return h'(x) [-] as a function of 0 <= x <= a."""
    exponent_of(medium)
    return medium.transformed_slope(imprint) if offers(medium, PressedWaves) else imprint.slope
