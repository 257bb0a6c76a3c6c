r"""Shakedown of a strip that rolls over a body again and again: Melan's bound on the force per length.

Each passage leaves residual stresses :math:`\rho_x(z),\ \rho_y(z)`, which can take up differences of normal stresses
but not the shear :math:`\tau_{xz}` in planes along the surface.  The body can shake down only while

.. math:: \max_{x,z}\left|\tau_{xz}\right| \le k = \frac{\sigma_Y}{\sqrt3} ,

for a cylinder :math:`p_0 = 4k` without friction, where there are residual stresses with which it does, and from a
coefficient of 0.367 on, where the shear is greatest at the surface, :math:`p_0 = k/\mu`.

Whether it is reached is examined at each depth by itself: with :math:`u=\sigma_x-\sigma_z,\;v=\sigma_y-\sigma_z` the
square of von Mises' stress is :math:`u^2-uv+v^2+3\tau_{xz}^2`, and residual stresses shift (u, v) of all places alike.
The least of the greatest is the smallest ball about the points
:math:`(u-\tfrac v2,\tfrac{\sqrt3}2v,\pm\sqrt3\tau_{xz})`, the body at rest among them.  :math:`p_0=k/\mu` is not
reached: von Mises' stress of :math:`\sigma_x=\pm2\mu p_0` at both edges meets the strength first.
"""

from __future__ import annotations

import itertools
import math
from typing import ClassVar

import numpy as np

from winkler.errors import NotConverged
from winkler.foundation.line import LineFoundation
from winkler.laws.friction import Overcome
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import sliding_note
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.line.at_strength import first_at_strength, refuse_without_strength
from winkler.problems.line.greatest_stress import Placed
from winkler.problems.line.stress import LineContact, LineFields, stresses
from winkler.problems.line.validity import line_notes
from winkler.problems.line.yielding import FRICTIONLESS
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.validity import Assumption, Note, Standing
from winkler.values import value, words

__all__ = ["LineShakedown", "LineShakedownSolution"]

MELAN = "E. Melan, Ing.-Arch. 9 (1938) 116-126, doi:10.1007/BF02084409; K. L. Johnson (1985) sec. 9.2"
PLACES, DEPTHS, WIDTHS, FINEST = 81, 25, 6.0, 1e-4
"""Places beside the middle and depths of the first grid, how far it reaches over the width of the load, and its first
depth over the half-width."""
CLOSER, FINE = 4.0, 5
"""How much narrower each finer grid of depths is, and the places about the greatest ones and depths of it."""
EXAMINED, REACHED = 4, 1e-4
"""How often grids are refined while a bound is examined, and by how much of the strength it may be exceeded."""
EXCHANGES, SETTLED = 400, 1e-12


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
        mu = self.friction.coefficient
        a, place = first_at_strength(bed, mu, _shear_along, "LineShakedown")
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
        bed = self.problem.bed
        slid = sliding_note(bed.medium, self.problem.friction.coefficient)  # type: ignore[arg-type]
        mu = self.problem.friction.coefficient
        shares = [
            _least_of_part(bed, self.half_width, part, mu, EXAMINED).value / part.solid.strength
            for part in strong_parts(bed.medium)
        ]
        most = max(shares)
        reached = "residual stresses exist with which the body shakes down at this load"
        bound = (
            f"it bounds the limit from above, as von Mises' stress is {most:.4g} strengths with the best residual ones"
        )
        note = Note(
            Assumption.ELASTIC,
            Standing.EXACT if most <= 1.0 + REACHED else Standing.APPROXIMATE,
            "An elastic, perfectly plastic body; the limit is that of the shear in planes along the surface: "
            f"{reached if most <= 1.0 + REACHED else bound}.",
            MELAN,
        )
        return (*line_notes(bed, self.half_width), slid, note)


def _shear_along(fields: LineFields) -> Array:
    """Return what reaches the tensile strength where the shear in planes along the surface reaches k [Pa]."""
    return np.asarray(math.sqrt(3.0) * np.abs(fields.xz_stress))


def _least_of_part(
    bed: LineFoundation, half_width: float, part: StrongPart, friction: float, refinements: int
) -> Placed:
    """Return the greatest over all depths of a part of the least von Mises stress that residual stresses leave."""
    a = half_width
    wide = math.hypot(a, part.top)
    end = min(part.bottom, part.top + 4.0 * wide)
    first = part.top if part.top == 0.0 else float(np.nextafter(part.top, math.inf))
    z = first + (end - first) * np.geomspace(FINEST * a / wide, 1.0, DEPTHS)
    z = np.unique(np.append(np.minimum(z, end), [first, end if math.isfinite(part.bottom) else z[-1]]))
    away = np.concatenate(
        [a * np.linspace(0.0, 1.0, PLACES), a + WIDTHS * wide * np.linspace(0.0, 1.0, PLACES // 2)[1:] ** 2]
    )
    x = np.concatenate([-away[:0:-1], away])
    near, best = 2.0 * a / PLACES, Placed(-1.0, 0.0, 0.0)
    for _ in range(refinements + 1):
        signed = z if part.first else -z
        fields = stresses(LineContact(bed, a, 0.0, part.solid.poisson, friction), x[:, None], z[None, :])
        levels = [least_stress(_row(fields, j)) for j in range(z.size)]
        top = int(np.argmax([level for level, _ in levels]))
        touched = levels[top][1]
        place = max(touched, key=lambda i: abs(fields.xz_stress[i, top])) if touched else 0
        best = Placed(levels[top][0], float(x[place]), float(signed[top]))
        low, high = z[max(top - 1, 0)], z[min(top + 1, z.size - 1)]
        z = np.unique(np.append(np.linspace(low, high, FINE), z[top]))
        beside = near * np.linspace(-1.0, 1.0, 2 * FINE + 1)
        x = np.unique(np.concatenate([x, *(x[i] + beside for i in touched)]))
        near /= CLOSER
    return best


def _row(fields: LineFields, depth: int) -> LineFields:
    names = ("xx_stress", "yy_stress", "zz_stress", "xz_stress")
    return LineFields(
        fields.x[:, depth], fields.z[:, depth], *(np.asarray(getattr(fields, name))[:, depth] for name in names)
    )


def least_stress(fields: LineFields) -> tuple[float, list[int]]:
    """Return the least greatest von Mises stress of places at one depth that residual stresses leave, and where it is.

    Residual stresses along x and y, the same at all places; the body at rest counts as a place.
    """
    u, v = fields.xx_stress - fields.zz_stress, fields.yy_stress - fields.zz_stress
    points = np.vstack([np.stack([u - 0.5 * v, 0.5 * math.sqrt(3.0) * v], axis=1), np.zeros((1, 2))])
    raised = np.append(3.0 * fields.xz_stress**2, 0.0)
    basis = [int(np.argmax(raised))]
    centre, level = points[basis[0]], float(raised[basis[0]])
    for _ in range(EXCHANGES):
        squares = np.sum((points - centre) ** 2, axis=1) + raised
        worst = int(np.argmax(squares))
        if squares[worst] <= level + SETTLED * float(np.max(squares)):
            return math.sqrt(level), [i for i in basis if i < raised.size - 1]
        basis, centre, level = _smallest(points, raised, [*basis, worst])
    raise NotConverged("the residual stresses at one depth were not found; give a smoother profile.")


def _smallest(points: Array, raised: Array, among: list[int]) -> tuple[list[int], Array, float]:
    """Return which of a few points determine the smallest ball about all, its centre and the square of its radius."""
    found: tuple[list[int], Array, float] = ([], points[0], math.inf)
    for count in range(1, min(len(among), 3) + 1):
        for chosen in itertools.combinations(among, count):
            rows = list(chosen)
            q, w = points[rows], raised[rows]
            # equal squares of distances: 2 (q_i - q_0) . c = |q_i|^2 + w_i - |q_0|^2 - w_0, in the plane of the points
            apart, grown = 2.0 * (q[1:] - q[0]), np.sum(q[1:] ** 2, axis=1) + w[1:] - np.sum(q[0] ** 2) - w[0]
            centre = q[0] + np.linalg.lstsq(apart, grown - apart @ q[0], rcond=None)[0] if count > 1 else q[0]
            square = float(np.sum((q[0] - centre) ** 2) + w[0])
            within = np.sum((points[among] - centre) ** 2, axis=1) + raised[among] <= square * (1.0 + 1e-13)
            if np.all(within) and square < found[2]:
                found = rows, centre, square
    return found
