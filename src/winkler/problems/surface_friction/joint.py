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

from winkler.checks.number_checks import Advice, Number, Numbers
from winkler.errors import OutsideValidity
from winkler.laws.friction import Sliding
from winkler.loading import Force, ShearForce
from winkler.media.mapped import MappedMedium
from winkler.numerics.types import Array, Quantity, shaped
from winkler.path import Path, numbers_of
from winkler.problems.assumptions.declared import MAPPED
from winkler.problems.rough.compliance import compliance_of
from winkler.problems.rough.surface_contact import SurfaceContact
from winkler.problems.rough.surface_states import SurfaceState
from winkler.problems.surface_friction.joint_loops import loops_of_elements, loops_of_stiffness
from winkler.problems.surface_friction.joint_solution import JointStiffnessSolution
from winkler.problems.surface_friction.joint_states import JointState, disc_ratio, joint_state
from winkler.problems.surface_friction.tangential import SurfaceTangential
from winkler.profiles.rough.topography import Topography
from winkler.validity import Assumption
from winkler.values import value, words

__all__ = ["JointStiffness"]

FORCES_BELOW = 8
"""Contacts under lesser forces than the last one, for the springs of the loops."""
LEAST_SHARE, GREATEST_SHARE = 0.01, 0.99


def _shares() -> Array:
    return np.array([0.2, 0.4, 0.6, 0.8, 0.95])


@value
class JointStiffness:
    """How stiff a pressed height map is, across and along the surface, and what it loses in a cycle of friction.

    Parameters
    ----------
    topography : Topography
        Heights of both surfaces together, up towards the other one.  A periodic map is a part of a wide joint: per
        area, stiffnesses and losses are those of the joint.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace or DepthGradedHalfSpace
        Both bodies.
    law : Coulomb
        Friction; its coefficient positive and finite.
    load : Force
        Normal force, compression positive, one or many; of a periodic map on one period.
    share : ndarray, (amplitudes,), optional
        Amplitudes of the shear force along x under the last normal force, rising, over what friction bears: between
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

    __words__ = words(share=("F_x/(\\mu F_N)", "", "amplitude of the shear force over what friction bears"))

    topography: Topography
    medium: Annotated[MappedMedium, Advice("the boundary elements apply to no other")]
    law: Sliding
    load: Force
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

    def _pressed(self, load: Force) -> SurfaceContact:
        return SurfaceContact(self.topography, self.medium, load)

    def solve(self) -> JointStiffnessSolution:
        """Return stiffnesses under every normal force, and the loops under the last one.

        Raises
        ------
        NotConverged
            If a contact, or what sticks and slips, is not found.
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

        def column(numbers: list[float]) -> Quantity:
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
