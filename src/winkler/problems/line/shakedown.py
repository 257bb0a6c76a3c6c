r"""Shakedown of a strip that rolls over a body again and again: Melan's bound on the force per length.

Each passage leaves residual stresses :math:`\rho_x(z),\ \rho_y(z)`, which can take up differences of normal stresses
but not the shear :math:`\tau_{xz}` in planes along the surface.  The body can shake down only while

.. math:: \max_{x,z}\left|\tau_{xz}\right| \le k = \frac{\sigma_Y}{\sqrt3} ,

and for a cylinder there are residual stresses with which it does: :math:`p_0 = 4k` without friction, and from a
coefficient of 0.367 on, where the surface itself is the weakest place, :math:`p_0 = k/\mu`.
"""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from winkler.foundation.line import LineFoundation
from winkler.laws.friction import Overcome
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import sliding_note
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.line.at_strength import first_at_strength, refuse_without_strength
from winkler.problems.line.stress import LineFields
from winkler.problems.line.validity import line_notes
from winkler.problems.line.yielding import FRICTIONLESS
from winkler.validity import Assumption, Note, Standing
from winkler.values import value, words

__all__ = ["LineShakedown", "LineShakedownSolution"]

JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 9.2, doi:10.1017/CBO9781139171731"


@value
class LineShakedown:
    """Up to which force per length does a body stay elastic in the end that a strip rolls over again and again?

    Parameters
    ----------
    bed : LineFoundation
        Profile and bodies, on a `HalfSpace` of which at least one body was given a strength.
    friction : Coulomb, optional
        The rolling contact slides everywhere, and drags each body by mu p; none unless given.

    Raises
    ------
    InvalidInput
        If no body has a strength, or the medium is not isotropic.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 9.2, doi:10.1017/CBO9781139171731
    """

    __words__ = words(bed=("", None, "profile and bodies of the line contact"))

    bed: LineFoundation
    friction: Overcome = FRICTIONLESS

    references: ClassVar[tuple[str, ...]] = ("johnson_1985",)
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED | {Assumption.UNCOUPLED}

    def __post_init__(self) -> None:
        refuse_without_strength(self.bed, "LineShakedown")

    def solve(self) -> LineShakedownSolution:
        """Return the greatest load, and where the shear is at its limit then.

        Raises
        ------
        OutsideValidity
            If the profile has a sharp tip, kink or rim, or the limit is not met within its reach.
        """
        bed = self.bed
        a, place = first_at_strength(bed, self.friction.coefficient, _shear_along, "LineShakedown")
        force = bed.medium.modulus * float(bed.load_profile(np.array([a]))[0])
        return LineShakedownSolution(self, force, a, place.x, place.z)


@value
class LineShakedownSolution:
    """The solution of `LineShakedown`.

    Parameters
    ----------
    problem : LineShakedown
        The problem that was solved.
    force_per_length, half_width : float
        [N/m], [m] of the limit.
    x, z : float
        Where the shear reaches its limit [m], in the axes of the body, which is dragged along x; below zero (also
        -0.0) in the second.
    """

    __words__ = words(x=("x", "m", "place along the surface"))

    problem: LineShakedown
    force_per_length: float
    half_width: float
    x: float
    z: float

    @property
    def mean_pressure(self) -> float:
        """P / (2 a) [Pa]."""
        return 0.5 * self.force_per_length / self.half_width

    @property
    def validity(self) -> tuple[Note, ...]:
        """What is assumed; whether the limit is reached or only bounds what is."""
        cylinder = self.problem.bed.hertzian
        reached = "residual stresses exist with which the body shakes down at this load"
        bound = "it bounds the shakedown limit from above; that residual stresses exist which reach it was not shown"
        note = Note(
            Assumption.ELASTIC,
            Standing.EXACT if cylinder else Standing.APPROXIMATE,
            "An elastic, perfectly plastic body; the limit is that of the shear in planes along the surface: "
            f"{reached if cylinder else bound}.",
            JOHNSON,
        )
        slid = sliding_note(self.problem.bed.medium, self.problem.friction.coefficient)  # type: ignore[arg-type]
        return (*line_notes(self.problem.bed, self.half_width), slid, note)


def _shear_along(fields: LineFields) -> Array:
    """Return what reaches the tensile strength where the shear in planes along the surface reaches k [Pa]."""
    return np.asarray(math.sqrt(3.0) * np.abs(fields.xz_stress))
