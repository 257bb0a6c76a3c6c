r"""The springs that stand for bodies of two curvatures: as deep and as stiff as Hertz's ellipse, but no disc.

:math:`F = \frac43E^*\sqrt{R_\mathrm{eq}}\,d^{3/2}` holds for an ellipse as well as for a ball; the radius of that ball
follows from the curvatures alone,

.. math:: R_\mathrm{eq} = \frac{9F^2}{16E^{*2}d^3} , \qquad d = \frac{3F}{2\pi E^*\alpha}R_F(0,1-m,1) .

Partial slip under Coulomb's law shrinks to similar ellipses, so it runs on the line, too, with the tangential
stiffness of the direction of shear (`winkler.foundation.footprint.EllipticOutline`).
"""

from __future__ import annotations

from typing import Annotated

import numpy as np

from winkler.foundation.footprint import DISC, EllipticOutline, RoundOutline
from winkler.foundation.on_medium import UnderProfile
from winkler.media.halfspace import HalfSpace, HomogeneousMedium
from winkler.media.medium import Medium
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.types import Array
from winkler.profiles.curved_pair import CurvedPair
from winkler.profiles.ellipse import CurvedBodies
from winkler.profiles.power import Paraboloid
from winkler.values.checks.field_checks import Condition
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value

JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge 1985, sections 4.2 and 7.2, doi:10.1017/CBO9781139171731"


HOMOGENEOUS_MEDIUM = Condition(
    lambda medium: isinstance(medium, HomogeneousMedium),
    "Hertz's ellipse is implemented for homogeneous half-spaces only, give HalfSpace or ViscoelasticHalfSpace",
)


@value
class EllipticFoundation(UnderProfile):
    """A spring foundation with the force, depth and stiffness of an elliptic contact.

    Problems that need a round contact (adhesion, wear, heating, rolling, torsion, subsurface fields) do not support it.

    Parameters
    ----------
    bodies : CurvedBodies or CurvedPair
        The bodies with R_x and R_y. Shear forces and displacements act along x, for `turned` along y.
    medium : HalfSpace, TransverselyIsotropicHalfSpace or ViscoelasticHalfSpace
        Both bodies, homogeneous.

    Raises
    ------
    InvalidInput
        If the medium is not homogeneous, or the curvatures are so different that the contact is a line.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge 1985, sections 4.2 and 7.2, doi:10.1017/CBO9781139171731

    Examples
    --------
    Curvature radii of 1:10, nu = 0.3: c_T/c_N of a disc is 0.8235, of this ellipse less along than across.

    >>> from winkler.materials.elastic import Elastic
    >>> steel = HalfSpace(Elastic(210e9, 0.3))
    >>> bed = EllipticFoundation(CurvedBodies(10e-3, 1e-3), steel)
    >>> [round(float(b.tangential_stiffness(np.ones(1))[0] / steel.modulus), 4) for b in (bed, bed.turned)]
    [0.7771, 0.8759]
    """

    bodies: CurvedBodies | CurvedPair
    medium: Annotated[Medium, HOMOGENEOUS_MEDIUM]

    def __post_init__(self) -> None:
        _ = self.bodies.slenderness

    @property
    def turned(self) -> EllipticFoundation:
        """The same bodies sheared along y."""
        bodies = CurvedBodies(self.bodies.lateral_curvature_radius, self.bodies.longitudinal_curvature_radius)
        return EllipticFoundation(bodies, self.medium)

    @property
    def profile(self) -> Paraboloid:  # type: ignore[override]
        """The ball with the same force-depth curve."""
        return Paraboloid(self.bodies.equivalent_radius)

    @property
    def footprint(self) -> EllipticOutline | RoundOutline:
        """Hertz's ellipse; a disc under equal curvatures."""
        bodies = self.bodies
        equal = bodies.longitudinal_curvature_radius == bodies.lateral_curvature_radius
        return DISC if equal else EllipticOutline(bodies.slenderness)

    @property
    def size(self) -> float:
        """Radius [m] of the disc with the stiffness of an ellipse as long as a curvature radius."""
        return 1.0 / float(self.slope(np.ones(1))[0])

    @property
    def notes(self) -> tuple[Note, ...]:
        """A note on the contact that the springs represent."""
        return (
            *self.medium.notes,
            Note(
                Assumption.SHAPE,
                Standing.EXACT,
                f"The springs represent an ellipse with b/a = {self.bodies.slenderness:.4g}. Force, depth and "
                "stiffness are those of Hertz; the radius is that of the disc of equal stiffness.",
                JOHNSON,
            ),
        )

    def slope(self, r: Array) -> Array:
        """Maximum slope of the bodies [-] at the edge of the ellipse whose stiffness is that of a disc of radius r."""
        along, across = EllipticOutline(self.bodies.slenderness).semi_axes(np.asarray(r, dtype=float))
        return np.asarray(
            np.maximum(along / self.bodies.longitudinal_curvature_radius, across / self.bodies.lateral_curvature_radius)
        )

    def tangential_stiffness(self, x: Array) -> Array:
        """Tangential stiffness of the springs per length c_T(x) [Pa], for shear along x.

        Raises
        ------
        OutsideValidity
            If the medium is not isotropic.
        """
        if not isinstance(self.medium, HalfSpace | ViscoelasticHalfSpace):
            raise OutsideValidity(
                f"EllipticFoundation: the deformation of a {type(self.medium).__name__} along an ellipse is not "
                "implemented; give HalfSpace."
            )
        normal, disc = self.medium.normal_stiffness(x), self.medium.tangential_stiffness(x)
        return np.asarray(1.0 / (1.0 / normal + 2.0 * self.footprint.shear_share * (1.0 / disc - 1.0 / normal)))
