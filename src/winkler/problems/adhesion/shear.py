r"""An adhesive contact that is sheared while it sticks all over: the edge recedes under pull and shear together.

All springs move sideways by the same shift :math:`u_x`; the last ones are stretched by :math:`S_z = g(a)-d` and
:math:`S_x = u_x`.  If the energy that is released by normal and tangential springs alike pays for the surface,

.. math:: c_N(a)\,S_z^2 + c_T(a)\,S_x^2 = 2\pi a\,w, \qquad F_x = k_x(a)\,u_x, \quad
          k_x(a) = 2\int_0^a c_T\,\mathrm dx ,

the contact shrinks as it is sheared, until at some shift (or shear force) no radius holds any more.  **Approximate**:
in a sheared contact the share of the modes changes around the edge and a real contact becomes oval; the balance holds
on the average of the edge only, and parting in shear often costs more than in tension.
"""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.adhesion import ShortRange
from winkler.loading.loads import Depth, Force, ShearForce, Shift
from winkler.loading.path import numbers_of
from winkler.numerics.equations.bracketing import between
from winkler.numerics.panels.chebyshev import fit_panels, stationary
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.adhesion import griffith
from winkler.problems.adhesion.edge import DeadLoad, LoadingMachine
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.problems.adhesion.validity import adhesive_notes
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.declared import ADHESIVE
from winkler.problems.normal.solve_contact import indices_of
from winkler.problems.normal.yield_statement import SurfaceFriction
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

OCTAVES_SEARCHED = 60
PANEL_TOLERANCE, LEVEL_NOISE = 1e-12, 1e-11
SAVKOOR = "A. R. Savkoor, G. A. D. Briggs, Proc. R. Soc. Lond. A 356 (1977) 103-114, doi:10.1098/rspa.1977.0123"


@value
class ShearLimit:
    """Where a sheared contact loses its hold.

    Parameters
    ----------
    depth, force : float
        d [m] and F_N [N].
    radius : float
        a [m], the least that is stable.
    shift, shear_force : float
        u_x [m] and F_x [N], the greatest that is borne.
    """

    __words__ = words(radius=("a", "m", "least stable radius of the contact"))

    depth: float
    force: float
    radius: float
    shift: float
    shear_force: float


@value
class AdhesiveShear(PerLoad[Q]):
    """A contact with short-range adhesion under a normal load, sheared without slip (approximate).

    Parameters
    ----------
    bed : Bed
        The springs: Foundation(profile, medium).
    law : ShortRange
        Its work_opening is the energy that the edge needs per area.
    normal : Force or Depth
        One dead load [N] or one depth [m], constant during shearing. If several contact radii are possible, the
        largest is used.
    lateral : Shift or ShearForce
        Relative displacement of the bodies far away [m], or force [N]; its value may be an array.

    Raises
    ------
    InvalidInput
        If law or loads are of other kinds, or the normal load is an array.

    References
    ----------
    A. R. Savkoor, G. A. D. Briggs, Proc. R. Soc. Lond. A 356 (1977) 103-114, doi:10.1098/rspa.1977.0123

    Examples
    --------
    Without normal load a ball bears at most a shear force of 3 pi w R sqrt(G*/E*).

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1.0), HalfSpace(Elastic(1.0, 0.0)))
    >>> sheared = AdhesiveShear(bed, ShortRange(1e-3), Force(0.0), ShearForce(0.0)).solve()
    >>> round(sheared.limit.shear_force / (3e-3 * math.pi), 9)
    1.0
    """

    bed: Bed
    law: ShortRange
    normal: Force[float] | Depth[float]
    lateral: Shift[Q] | ShearForce[Q]

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "savkoor_briggs_1977")
    assumptions: ClassVar[frozenset[Assumption]] = ADHESIVE | {Assumption.UNCOUPLED}
    needs_round: ClassVar[str] = "adhesion, whose edge runs round the contact,"

    def __post_init__(self) -> None:
        level = numbers_of(self.normal)
        if level.ndim != 0:
            raise InvalidInput(
                f"AdhesiveShear: the normal load has the shape {level.shape}; give one number, and the array "
                "as the lateral load."
            )

    def solve(self) -> AdhesiveShearSolution[Q]:
        """Return contact radius, tangential displacement and shear force, and the limit at which the contact separates.

        Raises
        ------
        OutsideValidity
            If the normal load alone pulls the contact off, or the lateral load exceeds the limit. The message names the
            limit and the indices of an array.
        """
        level = float(numbers_of(self.normal))
        widest = float(AdhesiveIndentation(self.bed, self.law, self.normal).solve().radius)
        states = _ShearCapacity(self, level)
        place = np.array([widest])
        if float(states.depth_and_force(place)[0][0]) > float(self.bed.gap(place)[0]):
            raise OutsideValidity(
                f"AdhesiveShear: the edge of the contact is pinned at a rim ({widest:.6g} m) under compression. "
                "No energy balance at the edge limits the shear there; use a smaller load, or pull."
            )
        least = states.least_radius(widest)
        prescribed = numbers_of(self.lateral)
        signed = np.ravel(prescribed)
        targets = np.abs(signed)
        most = math.sqrt(float(states.borne(np.array([least]))[0]))
        beyond = targets > most * (1.0 + 1e-14)
        if beyond.any():
            what, unit = ("shift", "m") if isinstance(self.lateral, Shift) else ("shear force", "N")
            raise OutsideValidity(
                f"AdhesiveShear: the {what} of {targets[beyond][0]:.6g} {unit}{indices_of(beyond)} pulls the "
                f"contact off; the limit is {most:.6g} {unit}, at a contact radius of {least:.6g} m."
            )
        radius = states.radius(targets**2, least, widest)
        depth, force = states.depth_and_force(radius)
        stiffness = tangential_stiffness(self.bed, radius)
        shift, shear = (signed, stiffness * signed) if isinstance(self.lateral, Shift) else (signed / stiffness, signed)
        columns: list[Q] = [shaped(each, prescribed.shape) for each in (depth, force, radius, shift, shear)]
        d, f, a, u, q = columns
        return AdhesiveShearSolution(self, d, f, a, u, q, states.limit(least))


@value
class AdhesiveShearSolution(PerLoad[Q]):
    """The solution of an `AdhesiveShear`; every quantity has the shape of the lateral load.

    Parameters
    ----------
    problem : AdhesiveShear
        The problem that was solved.
    depth, force : float or ndarray
        d [m] and F_N [N].
    radius : float or ndarray
        a [m].
    shift, shear_force : float or ndarray
        u_x [m] and F_x [N], of the sign of the load.
    limit : ShearLimit
        Tangential displacement and shear force at which the contact separates.
    """

    problem: AdhesiveShear[Q]
    depth: Q
    force: Q
    radius: Q
    shift: Q
    shear_force: Q
    limit: ShearLimit

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: it is approximate."""
        problem = self.problem
        return (
            *adhesive_notes(
                problem.bed, problem.law, np.ravel(self.depth), np.ravel(self.radius), SurfaceFriction(math.inf)
            ),
            sticking_note(problem.bed.medium, math.inf),
            Note(
                Assumption.ADHESION,
                Standing.APPROXIMATE,
                "The normal and tangential parts of the energy release rate are added with equal weight and "
                "averaged around the edge. The effect of the mode mixture is neglected. A real contact becomes "
                "oval and slips near its edge. A real contact often separates at a greater shear force than computed.",
                SAVKOOR,
            ),
        )


class _ShearCapacity:
    """What a contact of a given radius bears sideways, under its normal load."""

    def __init__(self, problem: AdhesiveShear, level: float) -> None:
        self.bed, self.work, self.level = problem.bed, problem.law.work_opening, level
        self.control = DeadLoad() if isinstance(problem.normal, Force) else LoadingMachine(0.0)
        self.by_force = isinstance(problem.lateral, ShearForce)

    def depth_and_force(self, radius: Array) -> tuple[Array, Array]:
        """Return d [m] and F [N] at contact radii."""
        stiffness, load = self.bed.stiffness(radius), self.bed.gap_load(radius)
        depth = self.control.depth(stiffness, load, np.full(radius.shape, self.level))
        return depth, griffith.force_at(self.bed, depth, radius)

    def borne(self, radius: Array) -> Array:
        """Return the square of the shift [m^2] or shear force [N^2] at which the edge of radii a is in balance."""
        bed, (depth, _) = self.bed, self.depth_and_force(radius)
        pulled = bed.normal_stiffness(radius) * (bed.gap(radius) - depth) ** 2
        left = 2.0 * np.pi * radius * self.work - pulled
        squared = left / bed.tangential_stiffness(radius)
        return squared * tangential_stiffness(bed, radius) ** 2 if self.by_force else np.asarray(squared)

    def least_radius(self, widest: float) -> float:
        """Return the radius, from the widest down, at which `borne` is greatest for the first time."""
        places, high = np.array([widest]), widest
        for _ in range(OCTAVES_SEARCHED):
            low = 0.5 * high
            edges = np.unique([low, *(b for b, _ in self.bed.kinks if low < b < high), high])
            size = float(np.max(np.abs(self.borne(edges))))
            panels = fit_panels(lambda a: self.borne(a.ravel()).reshape(a.shape), edges, PANEL_TOLERANCE * size)
            places_ = np.concatenate([stationary(panels), panels.edges[:-1]])
            places = np.concatenate([places, np.sort(places_)[::-1]])
            levels = self.borne(places)
            falls = np.flatnonzero(np.diff(levels) < -LEVEL_NOISE * np.max(np.abs(levels)))
            if falls.size:
                return float(places[np.argmax(levels[: falls[0] + 1])])
            high = low
        raise OutsideValidity(
            f"AdhesiveShear: the contact of {widest:.6g} m carries more shear the smaller it gets; its profile is "
            "too pointed for attraction of vanishing range."
        )

    def radius(self, squared: Array, least: float, widest: float) -> Array:
        """Return the radii `(m,)` at which the edge is in balance."""
        held = squared <= self.borne(np.full(squared.shape, widest))  # a rim bears something without moving
        low, high = np.full(squared.shape, least), np.full(squared.shape, widest)
        places_ = between(lambda a, index: self.borne(a) - squared[index], low, high) if least < widest else high
        return np.where(held, widest, np.where(squared >= self.borne(low), least, places_))

    def limit(self, radius: float) -> ShearLimit:
        """Return the state at a radius."""
        place = np.array([radius])
        depth, force = self.depth_and_force(place)
        stiffness = float(tangential_stiffness(self.bed, place)[0])
        borne = math.sqrt(float(self.borne(place)[0]))
        shift, shear = (borne / stiffness, borne) if self.by_force else (borne, borne * stiffness)
        return ShearLimit(float(depth[0]), float(force[0]), radius, shift, shear)


def tangential_stiffness(bed: Bed, radius: Array) -> Array:
    """Return k_x(a) [N/m], twice the integral of c_T up to the radii."""
    places = float(np.max(radius)) * 2.0 ** -np.arange(0.0, 12.0)
    ratio = bed.tangential_stiffness(places) / bed.normal_stiffness(places)
    if np.ptp(ratio) <= 1e-12 * ratio[0]:  # one ratio all over, as in every homogeneous medium
        return np.asarray(ratio[0] * bed.stiffness(radius))
    return abel.integral(lambda x: 2.0 * bed.tangential_stiffness(x), [b for b, _ in bed.kinks], radius)
