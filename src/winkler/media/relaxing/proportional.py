r"""Graded and layered bodies all of whose parts relax in proportion: an elastic medium times a function of time.

If every modulus of a body follows the same course, :math:`E(\mathbf x,t)=E(\mathbf x)\,\varphi(t)`, and no Poisson's
ratio changes, then g does not change in time, and every spring of the elastic medium relaxes by :math:`\varphi`:

.. math:: q(x,t) = c_N(x)\int\varphi(t-t')\,\frac{\partial u(x,t')}{\partial t'}\,\mathrm dt' .

One viscoelastic layer on a rigid base is such a body.  A viscoelastic layer on a body that does not relax, or relaxes
otherwise, is none: the ratio of the moduli, and with it g, would change in time.
"""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, cast

import numpy as np

from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.halfspace import HalfSpace
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.media.layered.pair_response import Mode
from winkler.media.layered.wave_constants import Wave, half_space_compliance
from winkler.media.medium import Displacement, exact_response
from winkler.media.offers import PlaneMedium, PowerOfDepth, offers
from winkler.media.punch_field import BodyField
from winkler.media.relaxing.at_rate import both, solid_at
from winkler.media.relaxing.relaxing_medium import LEE, RelaxingLayers
from winkler.media.transverse import TransverselyIsotropicHalfSpace
from winkler.numerics.springs.exponential_sums import CreepSeries, RelaxationSeries, of_relaxation
from winkler.numerics.types import Array, ComplexArray
from winkler.values.checks.number_checks import Advice, Positive
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Note
from winkler.values.value import value

ElasticMedium = (
    HalfSpace | TransverselyIsotropicHalfSpace | GradedHalfSpace | CoatedHalfSpace | DepthGradedHalfSpace
)  # fmt: skip


@value
class RelaxingInProportion(RelaxingLayers):
    """An elastic medium in which all moduli have one relaxation function, phi(t) = G(t) / shear.

    All deformable parts relax: the layers, their base, and the other body.

    Parameters
    ----------
    medium : GradedHalfSpace, CoatedHalfSpace, DepthGradedHalfSpace, TransverselyIsotropicHalfSpace or HalfSpace
        The bodies, with the moduli that correspond to the shear modulus `shear` of the solid.
    solid : ViscoelasticSolid
        A solid of which only the shear modulus G(t) is used; Poisson's ratios are those of the medium.
    shear : float
        Shear modulus [Pa] of the solid that corresponds to the moduli of the medium: the relaxed one, the glassy one,
        or any other.

    Raises
    ------
    InvalidInput
        If the medium or the solid is of another kind, or the shear modulus is not positive.

    References
    ----------
    E. H. Lee, J. R. M. Radok, J. Appl. Mech. 27 (1960) 438-444, doi:10.1115/1.3644020

    Examples
    --------
    A film of rubber on a rigid base; 1 MPa is its modulus after all time, five times as much that of a sudden step.

    >>> from winkler.materials.elastic import Elastic, Rigid
    >>> from winkler.materials.layered import Layer
    >>> from winkler.materials.spring_and_dashpot import StandardSolid
    >>> film = CoatedHalfSpace([Layer(Elastic(young=1e6, poisson=0.49), thickness=1e-3)], on=Rigid())
    >>> rubber = StandardSolid(relaxed_shear=0.3e6, shear=1.2e6, relaxation_time=0.1)
    >>> relaxing = RelaxingInProportion(film, rubber, shear=0.3e6)
    >>> relaxing.relaxation.relaxed, relaxing.relaxation.glassy
    (1.0, 5.0)
    """

    described: ClassVar[str] = "Layers, or bodies graded with depth, that relax in proportion,"

    medium: ElasticMedium
    solid: ViscoelasticSolid
    shear: Annotated[Positive, Advice("the shear modulus of the solid to which the moduli of the medium belong")]

    @property
    def elastic(self) -> ElasticMedium:
        """The elastic medium with the given moduli."""
        return self.medium

    bodies = elastic
    """The medium that contains the solids."""

    @property
    def thickness(self) -> float:
        """Depth below which the body is homogeneous [m], for layers and graded bodies."""
        return float(cast(PlaneMedium, self.medium).thickness)

    @property
    def second(self) -> Any:
        """The other body with the given moduli."""
        return self.medium.second

    @property
    def relaxation(self) -> RelaxationSeries:
        """phi(t) [-]."""
        return self.solid.series.scaled(1.0 / self.shear)

    @property
    def creep(self) -> CreepSeries:
        """Creep function: the compliance after a step of load, normalised [-]."""
        return of_relaxation(self.relaxation)

    def waves(self, part: Wave, xi: Array, s: ComplexArray) -> ComplexArray:
        """Response of both surfaces to harmonic pressures, as in `RelaxingMedium.waves`; the medium is no power law."""
        medium: Any = self.medium
        if offers(medium, PowerOfDepth):
            raise OutsideValidity(
                "RelaxingInProportion: for a power law of depth no half-space represents the surface under short "
                "waves; give layers, or a DepthGradedHalfSpace."
            )
        xi, s = np.broadcast_arrays(xi, s)
        layered = not isinstance(medium, HalfSpace | TransverselyIsotropicHalfSpace)
        first = medium.response.first.top if layered else medium.first
        whole = np.full(xi.shape, both(part, half_space_compliance(first, part), medium.second))
        if layered:
            response = medium.responding(Mode[part.name])
            finite = np.isfinite(xi)
            whole[finite] += response.excess(xi[finite]) / response.modulus
        return np.asarray(whole / solid_at(self.solid, s).shear * self.shear)

    @property
    def span(self) -> tuple[float, float]:
        """Range of times [s] in which the series represents the solid."""
        return self.solid.span

    @property
    def notes(self) -> tuple[Note, ...]:
        """What is assumed: that of the elastic medium, and that all relaxes in proportion."""
        alike = exact_response(
            "All deformable parts have one common relaxation function and constant Poisson's ratios, so g does "
            "not change with time. While the contact is one disc, elastic results apply with displacements "
            "replaced by their hereditary integrals.",
            LEE,
        )
        return (*self.medium.notes, *alike)

    def interior(self, displacement: Displacement, r: Array, z: Array, *, below: bool) -> BodyField:
        """Stresses and displacements inside the first body (`below`) or the second, at depths z >= 0 into it.

        Both are linear in the state of the springs: stresses in their forces, displacements in their deflections.
        """
        borne = self.elastic_parts(displacement)
        moved = np.array(self.medium.interior(displacement, r, z, below=below))
        loaded = np.array(self.medium.interior(borne[0], r, z, below=below)) if borne else np.zeros(moved.shape)
        return BodyField(*loaded[:4], *moved[4:])
