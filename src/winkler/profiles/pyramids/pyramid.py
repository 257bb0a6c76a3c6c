r"""Sharp pyramids of three to eight faces, as the cones with their force at every depth.

A rigid, regular pyramid of :math:`N` faces on an elastic half-space, without friction, is self-similar:

.. math:: F = C_N\,E^*\tan\theta\;d^2, \qquad A = \alpha_N\,(d\tan\theta)^2, \qquad
          \frac{\mathrm dF}{\mathrm dd} = 2E^*a, \quad a = C_N\,d\tan\theta,

with the angle :math:`\theta` between axis and face.  :math:`C_N` and :math:`\alpha_N` are pure numbers; they were
computed by boundary elements (`FORCE_CONSTANTS`).  The springs under :math:`g(x)=|x|/(C_N\tan\theta)` give the same
force, stiffness and energy at every depth.  They belong to the cone :math:`f = r/\tan\theta'`,
:math:`\tan\theta'=\tfrac\pi2C_N\tan\theta`, whose radius of contact is the :math:`a` above.  The contact of the pyramid
itself is a star with its tips on the edges, of another area, and with other pressures.

Angles of a regular pyramid of N faces, all measured from its axis unless stated otherwise.

- Face angle :math:`\theta`: between axis and face, in the plane through the axis that is perpendicular to the edge of
  the base.  It is half of the angle between opposite faces.
- Edge angle :math:`\theta_e`: between axis and edge, :math:`\tan\theta_e=\tan\theta/\cos(\pi/N)`.
- The angle between face and base plane is :math:`\pi/2-\theta`.

Heights above the apex are :math:`f = \max_i(\mathbf n_i\cdot\mathbf x)/\tan\theta`, with unit vectors
:math:`\mathbf n_i` across the faces.
"""

from __future__ import annotations

import math
from typing import Annotated

from winkler.profiles.half_angle import HalfAngle
from winkler.profiles.pieces import PowerPieces, Term
from winkler.values.checks.number_checks import Whole
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value

FORCE_CONSTANTS = {3: 0.882413, 4: 0.737617, 5: 0.693339, 6: 0.673299, 7: 0.662391, 8: 0.655758}
"""C_N [-], F over E* tan(theta) d^2, within 1e-5 of itself: up to 192 (of 3 and 4 faces 400) pixels per depth,
extrapolated; the cone on the same pixels is within 1e-6 of 2/pi."""
AREA_CONSTANTS = {3: 1.771, 4: 1.479, 5: 1.388, 6: 1.347, 7: 1.325, 8: 1.311}
"""Area of the contact over (d tan(theta))^2 [-], within 2e-3 of itself."""
CONTACT_OUTLINES = {
    3: (0.515, 1.59),
    4: (0.563, 1.06),
    5: (0.586, 0.90),
    6: (0.598, 0.82),
    7: (0.606, 0.78),
    8: (0.611, 0.75),
}
"""Distances of the outline of the contact from the axis over d tan(theta) [-], across a face and along an edge, within
2 %."""
CONSTANTS = "own boundary elements (tests/profiles/pyramids); a cone on the same pixels is within 1e-6 of 2/pi"

Sides = Annotated[int, Whole(3, 8, "faces")]
"""Number of faces for which the constants are known."""


def cross_section_constant(sides: int) -> float:
    """Return the area of the cross-section at a height h of a pyramid, over (h tan(theta))^2 [-]."""
    return sides * math.tan(math.pi / sides)


class PyramidShape(PowerPieces):
    """A sharp pyramid as a body of revolution; subclasses have `sides` and an angle."""

    sides: Sides

    @property
    def _tangent(self) -> float:
        """Tangent of the angle between axis and face."""
        raise NotImplementedError

    @property
    def half_angle(self) -> float:
        """Half-angle of the cone with the force of the pyramid, from the axis [rad]."""
        return math.atan(0.5 * math.pi * FORCE_CONSTANTS[self.sides] * self._tangent)

    @property
    def terms(self) -> tuple[Term, ...]:
        """A constant slope."""
        return ((0.0, 0, 1.0 / math.tan(self.half_angle)),)

    def cross_section(self, height: float) -> float:
        """Return the cross-section [m^2] of the pyramid itself at a height above its apex [m]."""
        return cross_section_constant(self.sides) * (height * self._tangent) ** 2

    def contact_area(self, depth: float) -> float:
        """Return the area [m^2] of the true contact on a half-space at a depth [m], within 0.2 %."""
        return AREA_CONSTANTS[self.sides] * (depth * self._tangent) ** 2

    @property
    def notes(self) -> tuple[Note, ...]:
        """What the cone has of the pyramid, and what it has not."""
        constant = FORCE_CONSTANTS[self.sides]
        near, far = (place / constant for place in CONTACT_OUTLINES[self.sides])
        share = AREA_CONSTANTS[self.sides] / (math.pi * constant**2)
        return (
            Note(
                Assumption.SHAPE,
                Standing.APPROXIMATE,
                f"The pyramid of {self.sides} faces is replaced by the cone with the same force (half-angle "
                f"{math.degrees(self.half_angle):.2f} deg). On a homogeneous half-space, force, depth, stiffness "
                "and energy of both agree within 1e-5. The radius is that of a round contact of equal stiffness. "
                f"The contact of the pyramid has {share:.1%} of its area. Its edge lies between {near:.2f} "
                f"(across a face) and {far:.2f} (along an edge) of that radius. Pressures, stresses and adhesion "
                "are those of the cone.",
                CONSTANTS,
            ),
        )


@value
class Pyramid(PyramidShape):
    """A sharp, regular pyramid, given by the angle between its axis and its faces.

    Force, depth and stiffness on a homogeneous half-space are those of the pyramid within 1e-5; see the notes.

    Parameters
    ----------
    sides : int
        Number of faces, 3 to 8.
    face_angle : float
        Angle between axis and face [rad], between 0 and pi/2: half of the angle between opposite faces. It is measured
        in the plane through the axis perpendicular to the edge of the base.  65.27 degrees for a (modified) Berkovich
        tip, 68 for Vickers, 35.26 for a cube corner. Pyramids moulded in etched pits of silicon have 35.26 too; makers
        of cantilevers state 35.  It is 90 degrees minus the angle between face and base plane.

    See Also
    --------
    PyramidByEdges : the same, given by the angle between axis and edges. the cones of equal cross-section, with 2.6 and
    7.2 % less force.

    References
    ----------
    G. G. Bilodeau, J. Appl. Mech. 59 (1992) 519-523, doi:10.1115/1.2893754, approximate (0.8887 and 0.7453 in place of
    C_3 and C_4); A. E. H. Love, Quart. J. Math. 10 (1939) 161-175, doi:10.1093/qmath/os-10.1.161

    Examples
    --------
    >>> import winkler as wk
    >>> tip = wk.Pyramid(sides=4, face_angle=math.radians(45.0))
    >>> bed = wk.Foundation(tip, wk.HalfSpace(wk.Elastic(1.0, 0.0)))
    >>> round(float(wk.Indentation(bed, wk.Depth(1.0)).solve().force), 5)
    0.73762
    """

    sides: Sides
    face_angle: HalfAngle

    @property
    def edge_angle(self) -> float:
        """Angle between axis and edge [rad]."""
        return edge_angle_of(self.face_angle, self.sides)

    @property
    def _tangent(self) -> float:
        return math.tan(self.face_angle)


@value
class PyramidByEdges(PyramidShape):
    """A sharp, regular pyramid, given by the angle between its axis and its edges.

    Parameters
    ----------
    sides : int
        Number of faces, 3 to 8.
    edge_angle : float
        Angle between axis and edge [rad], between 0 and pi/2; its tangent is that of the angle to the faces over
        cos(pi/sides).

    See Also
    --------
    Pyramid : the same, given by the angle between axis and faces.
    """

    sides: Sides
    edge_angle: HalfAngle

    @property
    def face_angle(self) -> float:
        """Angle between axis and face [rad]."""
        return face_angle_of(self.edge_angle, self.sides)

    @property
    def _tangent(self) -> float:
        return math.tan(self.face_angle)


def edge_angle_of(face_angle: float, sides: int) -> float:
    """Return the angle between axis and edge [rad] of a pyramid with this angle between axis and face [rad].

    Examples
    --------
    A cube corner, whose edges are at right angles to each other:

    >>> round(math.degrees(edge_angle_of(math.atan(math.sqrt(0.5)), 3)), 4)
    54.7356
    """
    return math.atan(math.tan(face_angle) / math.cos(math.pi / sides))


def face_angle_of(edge_angle: float, sides: int) -> float:
    """Return the angle between axis and face [rad] of a pyramid with this angle between axis and edge [rad]."""
    return math.atan(math.tan(edge_angle) * math.cos(math.pi / sides))
