"""Two bodies by their own principal radii, hollow ones negative, with axes that may be turned against each other."""

from __future__ import annotations

import math
from typing import Annotated

import numpy as np

from winkler.profiles.ellipse import CurvedBodies
from winkler.values.checks.number_checks import Finite, Number
from winkler.values.value import value, words

Radius = Annotated[float, Number("give a number other than zero{unit}, negative where hollow, or infinite")]


@value
class CurvedPair:
    """Two bodies with two curvatures each, which touch on an ellipse.

    Parameters
    ----------
    first_longitudinal_radius, first_lateral_radius : float
        Principal radii of the first body along its x and y [m]; negative where it is hollow, infinite where straight.
    second_longitudinal_radius, second_lateral_radius : float
        The same of the second body.
    angle : float, optional
        Angle between the axes of the second body and those of the first [rad].

    Raises
    ------
    InvalidInput
        If a radius is zero, or the bodies do not touch in a point, because a hollow is as narrow as the body in it.

    The axes x and y of the contact, to which angles of friction and motion refer, are the principal directions of the
    pair. They are rotated by `turn` relative to those of the first body.

    Examples
    --------
    A ball of 5 mm in the groove of a ring:

    >>> pair = CurvedPair(5e-3, 5e-3, 26e-3, -5.2e-3)
    >>> round(pair.longitudinal_curvature_radius * 1e3, 3), round(pair.lateral_curvature_radius * 1e3, 1)
    (4.194, 130.0)
    """

    __words__ = words(
        first_longitudinal_radius=("R_{1x}", "m", "radius of the first body along x, negative where hollow"),
        first_lateral_radius=("R_{1y}", "m", "radius of the first body along y, negative where hollow"),
        second_longitudinal_radius=("R_{2x}", "m", "radius of the second body along its x, negative where hollow"),
        second_lateral_radius=("R_{2y}", "m", "radius of the second body along its y, negative where hollow"),
        angle=(r"\phi", "rad", "angle between the axes of both bodies"),
        turn=(r"\theta_0", "rad", "angle from x of the first body to x of both together"),
    )

    first_longitudinal_radius: Radius
    first_lateral_radius: Radius
    second_longitudinal_radius: Radius
    second_lateral_radius: Radius
    angle: Finite = 0.0

    def __post_init__(self) -> None:
        _ = self.together

    @property
    def _radii(self) -> tuple[tuple[float, float], tuple[float, float]]:
        first = (self.first_longitudinal_radius, self.first_lateral_radius)
        return first, (self.second_longitudinal_radius, self.second_lateral_radius)

    @property
    def together(self) -> CurvedBodies:
        """The combined radii of both bodies in the principal directions of their gap."""
        return CurvedBodies.of(*self._radii, self.angle)

    @property
    def turn(self) -> float:
        """Angle [rad] from x of the first body to x of the pair, at most 45 degrees."""
        return CurvedBodies.turn(*self._radii, self.angle)

    @property
    def longitudinal_curvature_radius(self) -> float:
        """Combined R_x [m], along the principal direction closest to x of the first body."""
        return self.together.longitudinal_curvature_radius

    @property
    def lateral_curvature_radius(self) -> float:
        """Combined R_y [m], along the other principal direction."""
        return self.together.lateral_curvature_radius

    @property
    def slenderness(self) -> float:
        """b/a [-], the semi-axis across over that along."""
        return self.together.slenderness

    @property
    def equivalent_radius(self) -> float:
        """R_eq [m] of the ball with the same force-depth curve as the bodies."""
        return self.together.equivalent_radius

    def semi_axes(self, modulus: float, force: float) -> tuple[float, float]:
        """Return the semi-axes a and b [m] for a modulus [Pa] and a force [N]."""
        return self.together.semi_axes(modulus, force)

    def steepest_slope(self, longitudinal: float, lateral: float) -> float:
        """Return the steepest slope [-] of a body, or of the distance, within an ellipse of these semi-axes [m]."""
        axes = np.array([longitudinal, lateral])
        slopes = [self.together.steepest_slope(longitudinal, lateral)]
        for radii, direction in zip(self._radii, (-self.turn, self.angle - self.turn), strict=True):
            along, across = math.cos(direction), math.sin(direction)
            frame = np.array([[along, -across], [across, along]])
            slopes.append(float(np.linalg.norm((frame / np.array(radii)) @ frame.T * axes, 2)))
        return max(slopes)
