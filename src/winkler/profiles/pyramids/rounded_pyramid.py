r"""Pyramids with a rounded apex and rounded edges, as the bodies of revolution with their force at every depth.

The rounded pyramid is the envelope of paraboloids :math:`r^2/(2R)` that stand on the sharp one,
:math:`f(\mathbf x)=\min_{\mathbf y}\,[P(\mathbf y)+|\mathbf x-\mathbf y|^2/(2R)]`: a paraboloid at the apex, edges
rounded with the same radius, and plane faces, which would meet :math:`R/(2\tan^2\theta)` beyond the rounded apex.  In
lengths :math:`b=R/\tan\theta` and heights :math:`b/\tan\theta` it has no parameter but the number of faces.  While the
contact is narrower than :math:`b\cos(\pi/N)` it is round, and Hertz's; far above, the force is that of the sharp
pyramid, :math:`C_NE^*\tan\theta\,(d+R/(2\tan^2\theta))^2`.  Between, the slope of the body of revolution is a polygon
that was fitted to forces of boundary elements (`SLOPES`).
"""

from __future__ import annotations

import math
from typing import Annotated

from winkler.profiles.half_angle import HalfAngle
from winkler.profiles.pieces import PowerPieces, Term
from winkler.profiles.pyramids.pyramid import CONSTANTS, FORCE_CONSTANTS
from winkler.values.checks.number_checks import PositiveNotTiny, Whole
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value

SLOPES = {
    3: (
        (1.08, 0.73555),
        (1.25, 0.78452),
        (1.6, 0.83434),
        (2.5, 0.89749),
        (4.5, 0.95652),
        (9.0, 0.98641),
        (22.0, 0.9977),
        (100.0, 1.0),
    ),
    4: (
        (1.05, 0.85158),
        (1.2, 0.89509),
        (1.5, 0.92636),
        (2.2, 0.95961),
        (3.6, 0.9823),
        (6.5, 0.99394),
        (14.0, 0.9987),
        (55.0, 1.0),
    ),
}
"""Radii over b cos(pi/N), and the slope there over that of the cone of the sharp pyramid; straight between them."""
LARGEST_ERROR = 3e-4
"""Of the force at depths of 0.2 to 40 times R / tan(theta)^2, against boundary elements; less outside."""


@value
class RoundedPyramid(PowerPieces):
    """A pyramid of three or four faces with rounded apex and edges: a blunt AFM tip.

    Force, depth and stiffness on a homogeneous half-space are those of the pyramid within 0.03 %, from the paraboloid
    at small depths to the sharp pyramid at large depths.

    Parameters
    ----------
    sides : int
        Number of faces, 3 or 4.
    face_angle : float
        Angle between axis and face [rad], as in `Pyramid`.
    curvature_radius : float
        R [m], of the apex and across the edges.

    See Also
    --------
    RoundedCone, SpheroConical : bodies of revolution.

    Notes
    -----
    Rico's blunted pyramid has a ball as apex and sharp edges, and circles and squares as contacts; at large depths its
    force tends to 0.7071, 4 % below C_4 = 0.7376.

    References
    ----------
    F. Rico et al., Phys. Rev. E 72 (2005) 021914, doi:10.1103/PhysRevE.72.021914
    """

    sides: Annotated[int, Whole(3, 4, "faces")]
    face_angle: HalfAngle
    curvature_radius: PositiveNotTiny

    @property
    def blend_radius(self) -> float:
        """Distance from the axis up to which the tip is a paraboloid of revolution [m]."""
        return self.curvature_radius / math.tan(self.face_angle) * math.cos(math.pi / self.sides)

    @property
    def half_angle(self) -> float:
        """Half-angle of the cone with the force of the sharp pyramid, from the axis [rad]."""
        return math.atan(0.5 * math.pi * FORCE_CONSTANTS[self.sides] * math.tan(self.face_angle))

    @property
    def terms(self) -> tuple[Term, ...]:
        """A paraboloid, a polygon, and a constant slope."""
        unit, end = self.blend_radius, 1.0 / math.tan(self.half_angle)
        knots = [(0.0, 0.0), (unit, unit / self.curvature_radius)]
        knots += [(unit * place, end * share) for place, share in SLOPES[self.sides]]
        bends = [
            (high - low) / (after - before) for (before, low), (after, high) in zip(knots, knots[1:], strict=False)
        ]
        terms: list[Term] = [(0.0, 1, bends[0])]
        for (b, _), before, after in zip(knots[1:], bends, [*bends[1:], 0.0], strict=True):
            terms += [(b, 1, after - before), (b, 0, (before - after) * b)]
        return tuple(terms)

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Corners of the polygon, where the slope is continuous."""
        return tuple((b, 0.0) for b in sorted({b for b, _, _ in self.terms if b > 0.0}))

    @property
    def rising(self) -> bool:
        """The slope never falls."""
        return True

    @property
    def notes(self) -> tuple[Note, ...]:
        """Properties of the pyramid that the body of revolution represents, and those that it does not."""
        return (
            Note(
                Assumption.SHAPE,
                Standing.APPROXIMATE,
                f"The rounded pyramid of {self.sides} faces is replaced by the body of revolution with the same "
                "force. On a homogeneous half-space, force, depth, stiffness and energy of both agree within "
                f"{LARGEST_ERROR:.2%}. The radius is that of a round contact of equal stiffness; contacts wider "
                f"than {self.blend_radius:.3g} m are not round. Pressures, stresses and adhesion are those of the "
                "body of revolution.",
                CONSTANTS,
            ),
        )
