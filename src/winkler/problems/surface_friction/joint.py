r"""The stiffness of a joint from the map of its surfaces: across, along, and in loops of friction.

Under every normal force the map is pressed by boundary elements, and its contact then moved as a whole, across and
along the surface, without slip: the forces per motion are :math:`K_z`, :math:`K_x` and :math:`K_y`.  Pushed to and fro
under the last normal force it slips in part; what a cycle loses follows from boundary elements with friction, and from
the stiffnesses alone (`winkler.problems.surface_friction.joint_loops`), and both are given side by side.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.laws.friction import Sliding
from winkler.loading.loads import Force, ShearForce
from winkler.loading.path import Path, numbers_of
from winkler.media.mapped import MappedMedium
from winkler.numerics.types import Array, N, PerLoad, Q, Quantity, shaped
from winkler.problems.assumptions.declared import MAPPED
from winkler.problems.last_cycle import loss_factor
from winkler.problems.rough.compliance import compliance_of
from winkler.problems.rough.surface_contact import SurfaceContact, SurfaceContactSolution
from winkler.problems.rough.surface_states import SurfaceState
from winkler.problems.surface_friction.joint_loops import loop_difference, loops_of_elements, loops_of_stiffness
from winkler.problems.surface_friction.joint_states import JointState, disc_ratio, joint_state
from winkler.problems.surface_friction.tangential import SurfaceTangential, SurfaceTangentialSolution
from winkler.profiles.rough.topography import Topography
from winkler.values.checks.number_checks import Advice, Number, Numbers
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

BARBER = "J. R. Barber, Proc. R. Soc. A 459 (2003) 53-66, doi:10.1098/rspa.2002.1038"
JAEGER = (
    "M. Ciavarella, Int. J. Solids Struct. 35 (1998) 2349-2362, doi:10.1016/S0020-7683(97)00154-6; G. Masing, "
    "Proc. 2nd Int. Congr. Appl. Mech., Zurich 1926, 332-335"
)
FORCES_BELOW = 8
"""Contacts under lesser forces than the last one, for the springs of the loops."""
LEAST_SHARE, GREATEST_SHARE = 0.01, 0.99


def _shares() -> Array:
    return np.array([0.2, 0.4, 0.6, 0.8, 0.95])


@value
class JointStiffness(PerLoad[Q]):
    """Normal and tangential stiffness of a pressed height map, and its dissipated energy per cycle of friction.

    Parameters
    ----------
    topography : Topography
        Sum of the heights of both surfaces, positive towards the other body.  A periodic map represents a wide joint,
        with the same stiffness and dissipated energy per area.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace or DepthGradedHalfSpace
        Both bodies.
    law : Coulomb
        Friction; its coefficient must be positive and finite.
    load : Force
        Normal force, compression positive, one or several; for a periodic map the force on one period.
    share : ndarray, (amplitudes,), optional
        Amplitudes of the shear force along x under the last normal force, increasing, over the friction limit; between
        0.01 and 0.99.

    Raises
    ------
    InvalidInput
        If a share is out of range; otherwise as `SurfaceContact` and `SurfaceTangential`.
    OutsideValidity
        If the tractions in this medium are not known.

    References
    ----------
    J. R. Barber, Proc. R. Soc. A 459 (2003) 53-66, doi:10.1098/rspa.2002.1038; M. Ciavarella, Int. J. Solids Struct. 35
    (1998) 2349-2362, doi:10.1016/S0020-7683(97)00154-6

    Examples
    --------
    A ball of Poisson's ratio 0.3 on one alike: along the surface it is 2 (1 - nu) / (2 - nu) = 0.82 as stiff as across.

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> x = (np.arange(63) - 31) / 63.0
    >>> ball = Topography(-0.5 * (x[:, None] ** 2 + x**2), [1.0, 1.0])
    >>> body = Elastic(1.0, 0.3)
    >>> joint = JointStiffness(ball, HalfSpace.between(body, body), Coulomb(0.3), Force(0.005)).solve()
    >>> round(joint.ratio_x, 2), round(joint.disc_ratio, 2)
    (0.82, 0.82)
    """

    __words__ = words(share=("F_x/(\\mu F_N)", "", "amplitude of the shear force over the friction limit"))

    topography: Topography
    medium: Annotated[MappedMedium, Advice("the boundary elements apply to no other")]
    law: Sliding
    load: Force[Q]
    share: Annotated[
        Array,
        Numbers(
            Number(
                f"give numbers between {LEAST_SHARE:g} and {GREATEST_SHARE:g}", LEAST_SHARE, GREATEST_SHARE,
                several=f"numbers between {LEAST_SHARE:g} and {GREATEST_SHARE:g}",
            ),
            order="rising",
        ),
    ] = dataclasses.field(default_factory=_shares)  # fmt: skip

    references: ClassVar[tuple[str, ...]] = (
        "barber_2003", "ciavarella_1998", "jaeger_1995", "mindlin_1949", "kalker_1990", "polonsky_keer_1999",
    )  # fmt: skip
    assumptions: ClassVar[frozenset[Assumption]] = MAPPED | {Assumption.UNCOUPLED, Assumption.SLIP}

    def __post_init__(self) -> None:
        _ = self._pressed(self.load)  # refuses what it would refuse later
        last = float(np.ravel(numbers_of(self.load))[-1])
        SurfaceTangential(self.topography, self.medium, self.law, Path.through(Force(last), ShearForce(np.zeros(2))))

    def _pressed(self, load: Force[N]) -> SurfaceContact[N]:
        return SurfaceContact(self.topography, self.medium, load)

    def solve(self) -> JointStiffnessSolution[Q]:
        """Return stiffnesses under every normal force, and friction loops under the last one.

        Raises
        ------
        NotConverged
            If a contact, or its stick zone, is not found.
        OutsideValidity
            If a periodic map touches everywhere under the last force, or the pixels are too coarse for the layers.
        """
        rough, medium, compliance = self.topography, self.medium, compliance_of(self.medium)
        asked, rows = self._pressed(self.load), list[JointState]()

        def watched() -> Iterator[SurfaceState]:
            for state in asked.steps():
                rows.append(joint_state(state, rough, medium, compliance))
                yield state

        contact = asked.gathered(watched())
        force, shape = contact.last.force, numbers_of(self.load).shape
        if not math.isfinite(rows[-1].normal):
            raise OutsideValidity(
                f"JointStiffness: under the force {force:.6g} N the periodic map touches everywhere, and its two sides "
                "are one body; press less."
            )
        elements, loop = loops_of_elements(rough, medium, self.law, force, self.share)
        forces, stiffnesses = self._below(force, rows[-1])
        springs = loops_of_stiffness(forces, stiffnesses, self.law.coefficient, self.share)

        def column(numbers: list[float]) -> Q:
            return shaped(np.array(numbers).reshape(shape))

        return JointStiffnessSolution(
            self, contact, contact.force, shaped(np.asarray(contact.force) / rough.area), contact.depth, contact.area,
            column([row.normal for row in rows]), column([row.along_x for row in rows]),
            column([row.along_y for row in rows]),
            column([row.normal * disc_ratio(row.normal, medium) for row in rows]),
            self.share, self.law.coefficient * force * self.share, elements.shift, elements.loss,
            springs.shift, springs.loss, forces, stiffnesses, loop,
        )  # fmt: skip

    def _below(self, force: float, last: JointState) -> tuple[Array, Array]:
        """Return lesser forces and K_x under them, up to those of the last contact."""
        rough, compliance = self.topography, compliance_of(self.medium)
        forces = np.geomspace((1.0 - float(self.share[-1])) * force, force, FORCES_BELOW + 1)
        contacts = self._pressed(Force(forces[:-1])).steps()
        below = [joint_state(state, rough, self.medium, compliance).along_x for state in contacts]
        return forces, np.array([*below, last.along_x])


@value
class JointStiffnessSolution(PerLoad[Q]):
    """The solution of a `JointStiffness`; what depends on the normal force has its shape.

    Parameters
    ----------
    problem : JointStiffness
        The problem that was solved.
    contact : SurfaceContactSolution
        The contacts under the normal forces, with the maps of the last one.
    force, nominal_pressure, depth, area : float or ndarray
        F_N [N], the force over the area of the map [Pa], d [m] and the contact area [m^2].
    stiffness, stiffness_x, stiffness_y : float or ndarray
        K_z, K_x, K_y [N/m]: stiffnesses for rigid displacements of the whole contact, without slip.
    disc_stiffness : float or ndarray
        Tangential stiffness of the disc with the same normal stiffness [N/m]: Mindlin's ratio times K_z.
    share, shear_amplitude : ndarray, (amplitudes,)
        Amplitudes of the shear force along x under the last normal force, over the friction limit and in N.
    shift_amplitude, loss_per_cycle : ndarray, (amplitudes,)
        Amplitude [m] and dissipated energy [J] of the loops by boundary elements with friction.
    spring_shift, spring_loss : ndarray, (amplitudes,)
        The same for the loops by springs, which follow from the stiffnesses alone [m], [J].
    spring_forces, spring_stiffnesses : ndarray, (contacts,)
        Normal forces F' [N] up to the last one and K_x [N/m] under them, which define the springs.
    loop : SurfaceTangentialSolution
        The path of all loops by boundary elements.
    """

    __words__ = words(
        contact=("", None, "the contacts under the normal forces"),
        stiffness=("K_z", "N/m", "stiffness across the surface"),
        share=("F_x/(\\mu F_N)", "", "amplitude of the shear force over the friction limit"),
        spring_forces=("F'", "N", "normal forces up to the last one"),
        spring_stiffnesses=("K_x(F')", "N/m", "stiffness along x under lesser normal forces"),
        shift_error=("", "", "greatest difference of a shift from boundary elements, over the greatest shift"),
        loss_error=("", "", "greatest difference of a loss from boundary elements, over the greatest loss"),
        loop=("", None, "the loops by boundary elements"),
    )

    problem: JointStiffness[Q]
    contact: SurfaceContactSolution[Q]
    force: Q
    nominal_pressure: Q
    depth: Q
    area: Q
    stiffness: Q
    stiffness_x: Q
    stiffness_y: Q
    disc_stiffness: Q
    share: Array
    shear_amplitude: Array
    shift_amplitude: Array
    loss_per_cycle: Array
    spring_shift: Array
    spring_loss: Array
    spring_forces: Array
    spring_stiffnesses: Array
    loop: SurfaceTangentialSolution

    def _over(self, numbers: Quantity, other: Quantity) -> Q:
        return shaped(np.asarray(numbers) / np.asarray(other))

    @property
    def ratio_x(self) -> Q:
        """K_x / K_z [-]."""
        return self._over(self.stiffness_x, self.stiffness)

    @property
    def ratio_y(self) -> Q:
        """K_y / K_z [-]."""
        return self._over(self.stiffness_y, self.stiffness)

    @property
    def disc_ratio(self) -> Q:
        """The same ratio of a disc [-]: 2 (1 - nu) / (2 - nu) of equal bodies."""
        return self._over(self.disc_stiffness, self.stiffness)

    @property
    def areal_stiffness(self) -> Q:
        """K_z over the area of the map [Pa/m]."""
        return self._over(self.stiffness, self.problem.topography.area)

    @property
    def areal_stiffness_x(self) -> Q:
        """K_x over the area of the map [Pa/m]."""
        return self._over(self.stiffness_x, self.problem.topography.area)

    @property
    def areal_stiffness_y(self) -> Q:
        """K_y over the area of the map [Pa/m]."""
        return self._over(self.stiffness_y, self.problem.topography.area)

    @property
    def secant_stiffness(self) -> Array:
        """Amplitude of the shear force over that of the shift [N/m], ``(amplitudes,)``."""
        return np.asarray(self.shear_amplitude / self.shift_amplitude)

    @property
    def loss_factor(self) -> Array:
        """Dissipated energy over pi times the amplitudes of displacement and force [-], ``(amplitudes,)``."""
        return np.asarray(loss_factor(self.loss_per_cycle, self.shift_amplitude, self.shear_amplitude))

    def slip_loop(self, amplitude: int = -1, count: int = 60) -> tuple[Array, Array]:
        """Return displacement [m] and shear force [N] of the loop by springs for one amplitude, ``(2 count,)``."""
        friction, most = self.problem.law.coefficient, float(self.share[amplitude])
        half = np.linspace(0.0, most, count)
        moved = loops_of_stiffness(self.spring_forces, self.spring_stiffnesses, friction, half[1:]).shift
        u = np.concatenate(([0.0], moved))
        force, shift = friction * float(self.spring_forces[-1]) * (most - 2.0 * half), u[-1] - 2.0 * u
        return np.concatenate((shift, -shift)), np.concatenate((force, -force))

    @property
    def shift_error(self) -> float:
        """Maximum difference of a shift by springs from boundary elements, over the maximum shift [-]."""
        return loop_difference(self.shift_amplitude, self.spring_shift)

    @property
    def loss_error(self) -> float:
        """Maximum difference of a loss by springs from boundary elements, over the maximum loss [-]."""
        return loop_difference(self.loss_per_cycle, self.spring_loss)

    @property
    def validity(self) -> tuple[Note, ...]:
        """The limits of stiffnesses and loops, the errors of springs and discs, and the notes of the loops."""
        finite = np.isfinite(np.asarray(self.stiffness))
        ratios = np.stack(
            [np.ravel(np.asarray(part)[finite]) for part in (self.ratio_x, self.ratio_y, self.disc_ratio)]
        )
        off = float(np.max(np.abs(ratios[:2] / ratios[2] - 1.0), initial=0.0))
        return (
            Note(
                Assumption.SLIP,
                Standing.ASYMPTOTIC,
                "The stiffnesses apply to small motions of the whole contact without slip or rotation. Coupling "
                "of pressure and traction is neglected. The tangential stiffnesses differ by up to "
                f"{_per_cent(off)} % from those of the disc with the same normal stiffness.",
                BARBER,
            ),
            Note(
                Assumption.SLIP,
                Standing.APPROXIMATE,
                "The springs assume that the stick zone equals the contact area under a smaller force (Ciavarella, "
                "Jaeger). Compared with boundary elements with friction, displacements differ by at most "
                f"{_per_cent(self.shift_error)} % of their maximum, the dissipated energy by "
                f"{_per_cent(self.loss_error)} % of its maximum.",
                JAEGER,
            ),
            *self.loop.validity,
        )


def _per_cent(error: float) -> str:
    return f"{100.0 * error:.2g}"
