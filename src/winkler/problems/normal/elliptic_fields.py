"""Stresses and displacements below Hertz's ellipse: what is requested, in which body, the greatest of each kind."""

from __future__ import annotations

import math
import numbers

from winkler.foundation.sheared_fields import BodyFields
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.media.interior import tensor
from winkler.media.interior.half_ellipsoid import greatest_in_half_ellipsoid, half_ellipsoid_stresses
from winkler.media.interior.half_ellipsoid_displacement import half_ellipsoid_displacements
from winkler.media.interior.peak import StressSpot
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.value import value, words


@value
class EllipticFields(BodyFields):
    """Stresses and displacements inside one body under an elliptic contact, in its own axes: z into the body.

    Parameters
    ----------
    x, y, z : ndarray
        Coordinates [m]; z as requested: positive in the first body, negative in the second.
    xx_stress, yy_stress, zz_stress, xy_stress, xz_stress, yz_stress : ndarray
        [Pa], tension positive.
    x_displacement, y_displacement, z_displacement : ndarray
        Displacements relative to points far away [m].
    """

    __words__ = words(
        x=("x", "m", "place along the surface"),
        y=("y", "m", "place along the surface, across x"),
        principal_stresses=(r"\sigma_1, \sigma_2, \sigma_3", "Pa", "principal stresses, greatest first"),
    )

    @property
    def principal_stresses(self) -> Array:
        """Principal stresses [Pa], largest first, along a new last axis of length 3."""
        return self.principal

    @property
    def orthogonal_shear(self) -> Array:
        """Shear stress in the plane along the surface [Pa], whatever its direction."""
        return tensor.orthogonal_shear(self._stress)


def traction_of(friction: float, angle: float) -> tuple[float, float]:
    """Return the tractions along x and y over the pressure, of friction in a direction given by its angle to x."""
    if not all(isinstance(each, numbers.Real) and math.isfinite(each) for each in (friction, angle)):
        raise InvalidInput(
            f"EllipticSolution: friction {friction!r} at the angle {angle!r}; give a finite coefficient and angle in "
            "radians."
        )
    quarters = angle / (0.5 * math.pi)
    if quarters == round(quarters):  # along an axis, without rounding
        turns = round(quarters) % 4
        along, across = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[turns]
    else:
        along, across = math.cos(angle), math.sin(angle)
    return friction * along + 0.0, friction * across + 0.0


def solid_below(medium: object, below: bool) -> Elastic:
    """Return the first body (`below`) or the second; refuse one without stresses."""
    body = getattr(medium, "first" if below else "second", None) if isinstance(medium, HalfSpace) else None
    if not isinstance(body, Elastic):
        raise OutsideValidity(
            f"The {'first body (z >= 0)' if below else 'second body (z < 0)'} is rigid, layered or not isotropic; the "
            "stresses are known in the isotropic bodies of a HalfSpace: request the other body, or on layers take a "
            "SurfaceContact."
        )
    return body


def below_ellipse(
    places: tuple[Array, Array, Array],
    semi_axes: tuple[float, float],
    pressure: float,
    solid: Elastic,
    traction: tuple[float, float],
) -> EllipticFields:
    """Return stresses and displacements at places x, y, z >= 0 [m] of one shape, under this greatest pressure [Pa]."""
    stress = half_ellipsoid_stresses(*places, semi_axes, solid.poisson, traction)
    moved = half_ellipsoid_displacements(*places, semi_axes, solid.poisson, traction)
    strain = 0.5 * pressure / solid.shear
    return EllipticFields(*places, *(pressure * part for part in stress), *(strain * part for part in moved))


def greatest_below_ellipse(
    measure: str,
    semi_axis: float,
    slenderness: float,
    pressure: float,
    poisson: float,
    traction: tuple[float, float],
) -> StressSpot:
    """Return the greatest stress of a kind [Pa] and its place [m], z >= 0.

    Parameters
    ----------
    measure : {'von_mises', 'max_shear', 'orthogonal_shear', 'longitudinal_shear', 'lateral_shear'}
    semi_axis, slenderness : float
        a along x [m], and b/a of b along y.
    pressure : float
        The greatest one [Pa].
    poisson : float
    traction : tuple of float
        As in `traction_of`.

    Raises
    ------
    InvalidInput
        If there is no such measure.
    """
    compared = tensor.measure_named(measure, "EllipticSolution")
    a, b = semi_axis, slenderness * semi_axis
    mirror = 1.0 if traction >= (0.0, 0.0) else -1.0  # the opposite traction has its place mirrored in the axis
    rubbed = (mirror * traction[0] + 0.0, mirror * traction[1] + 0.0)
    spot = greatest_in_half_ellipsoid(compared, slenderness, poisson, rubbed)
    return StressSpot(pressure * spot.value, mirror * spot.x * a + 0.0, mirror * spot.y * b + 0.0, spot.z * min(a, b))
