r"""A viscoelastic contact that is pressed and moved along the surface, with friction: springs relax in both directions.

Every spring relaxes across and along the surface,

.. math:: q_z = \int E^*(t-t')\,\mathrm du_z(t'), \qquad q_x = \int G^*(t-t')\,\mathrm du_x(t'), \qquad
          |q_x|\le\mu q_z ,

moves with the body while it sticks, slides on its bound, and recovers freely in both directions once it has let go.
All the work is stored, lost to friction, or lost in the bodies.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.checks.number_checks import Whole, between
from winkler.errors import InvalidInput, OutsideValidity
from winkler.foundation.bed import Bed
from winkler.foundation.springs import Springs
from winkler.laws.friction import Coulomb
from winkler.limits import RELAXING_SPRINGS
from winkler.loading import Depth, ShearForce, Shift
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.types import Array
from winkler.path import Path
from winkler.problems.answer import gather
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.declared import BALANCED, RELAXING, SHEARED
from winkler.problems.assumptions.direction import direction_notes
from winkler.problems.assumptions.energy import energy_note
from winkler.problems.assumptions.times import path_notes
from winkler.problems.last_cycle import LastCycle, Looped, cycle_of
from winkler.problems.normal.solve_contact import at_depth
from winkler.problems.normal.unknown_yield import relaxing_yield
from winkler.problems.normal.validity import contact_notes
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.march import SpringRow, elastic_like, refuse_rings, relaxation_of
from winkler.problems.viscoelastic.tangential_march import (
    ErrorScales,
    ShearedMarch,
    StepTarget,
    shear_relaxation,
    sudden_step,
    travel,
)
from winkler.problems.viscoelastic.tangential_states import ViscoelasticTangentialState, stick_radius
from winkler.validity import Assumption, Note, Standing
from winkler.values import value, words

__all__ = ["ViscoelasticTangential", "ViscoelasticTangentialSolution"]


@value
class ViscoelasticTangential:
    """A body pressed into a viscoelastic one and moved along the surface on a path, with friction.

    Before the first point of the path nothing has happened; what is not zero there comes suddenly, the normal load
    first.

    Parameters
    ----------
    bed : Bed
        Foundation(profile, ViscoelasticHalfSpace(solid)).
    law : Coulomb
        Friction; Coulomb(inf) where nothing slides.
    path : Path
        Depth or force, and shift or shear force in one direction, over time; equal times are a sudden step, which a
        dashpot alongside (Kelvin-Voigt) forbids for depths and shifts.
    count : int, optional
        How many springs; the error falls with its square, or with itself where the load does not vanish at the edge:
        where nothing slides, or with a dashpot alongside.
    tolerance : float, optional
        Error of a step: of the shear force over what friction can bear, of the energy lost to friction over that force
        times the greatest shift, and of depth and shift under prescribed forces over the greatest ones.

    Raises
    ------
    InvalidInput
        If the bed is no viscoelastic half-space, the law not Coulomb's, the path in the plane or twisted, a force
        tensile, or a number out of range.

    References
    ----------
    V. L. Popov, M. Hess, Method of Dimensionality Reduction, Springer 2015, doi:10.1007/978-3-642-53876-6

    Examples
    --------
    Pressed suddenly and dragged suddenly to half of the shift at which all slides, then held: everything relaxes in
    proportion (E* = 1 Pa at once, tau = 1 s).

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.spring_and_dashpot import Maxwell
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1.0), ViscoelasticHalfSpace(Maxwell(shear=0.25, relaxation_time=1.0)))
    >>> half = 0.5 * 0.3 * 0.01 * 1.5  # of mu d E*/G*
    >>> path = Path([0.0, 1.0], Depth(0.01), Shift(half))
    >>> held = ViscoelasticTangential(bed, Coulomb(0.3), path).solve()
    >>> (held.shear_force / (0.3 * held.force)).round(4)  # 1 - 2^(-3/2)
    array([0.6464, 0.6464])
    """

    __words__ = ViscoelasticIndentation.__words__

    bed: Bed
    law: Coulomb
    path: Path
    count: Annotated[int, Whole(2, RELAXING_SPRINGS)] = 500
    tolerance: Annotated[float, between(1e-12, 0.1)] = 1e-5

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "popov_willert_hess_2018", "mindlin_1949")
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING | SHEARED | BALANCED

    def __post_init__(self) -> None:
        if not isinstance(self.bed.medium, ViscoelasticHalfSpace):
            raise InvalidInput(
                f"ViscoelasticTangential: the bed stands on a {type(self.bed.medium).__name__}, and slip "
                "is followed by one ratio of tangential to normal stiffness and one relaxation, which homogeneous "
                "bodies have; give Foundation(profile, ViscoelasticHalfSpace(solid))."
            )
        if not isinstance(self.path.lateral, Shift | ShearForce) or self.path.in_plane:
            raise InvalidInput(
                "ViscoelasticTangential: the path turns or leaves its line; give Shift or ShearForce in one direction."
            )
        _ = self._normal

    @property
    def _normal(self) -> ViscoelasticIndentation:
        """The contact without friction, which refuses what it cannot press."""
        return ViscoelasticIndentation(self.bed, Path(self.path.time, self.path.normal), self.count, self.tolerance)

    @property
    def total(self) -> int:
        """How many states `steps` yields: one for every point of the path."""
        return self.path.time.size

    def steps(self) -> Iterator[ViscoelasticTangentialState]:
        """Yield the state at every point of the path.

        Raises
        ------
        OutsideValidity
            If the body is pressed beyond what is known of its profile, is moved suddenly against a dashpot, friction
            does not bear a prescribed shear force, or the contact is no disc: at that step, the states before it have
            been yielded.
        NotConverged
            If no step is short enough.
        """
        row, scales = self._start()
        density = row.row.springs.density(row.row.bed)
        times = self.path.time.tolist()
        goals = [StepTarget(*each) for each in zip(self.path.across.tolist(), self.path.along.tolist(), strict=True)]
        pace = math.inf
        for i, (time, goal) in enumerate(zip(times, goals, strict=True)):
            if i and time > times[i - 1]:
                row, pace = travel(row, goals[i - 1], goal, time - times[i - 1], pace, scales)
            else:
                row = sudden_step(row, goal, time, scales)
            refuse_rings("ViscoelasticTangential", np.array([time]), np.array([row.turn.ring]))
            turn, springs = row.turn, row.row
            place = springs.springs.position
            slack = row.bounds - np.abs(row.loads)
            yield ViscoelasticTangentialState(
                time, springs.depth, turn.force, turn.radius, row.shift, turn.shear_force,
                stick_radius(place, row.stuck, slack, turn.radius), turn.work, turn.stored, turn.friction, turn.bulk,
                turn.friction + turn.bulk, place, density * springs.loads(), density * row.loads, springs.place.copy(),
                row.displaced.copy(), row.stuck,
            )  # fmt: skip

    def _start(self) -> tuple[ShearedMarch, ErrorScales]:
        """Return the row before anything has happened, and what counts as little on this path."""
        deepest = self._normal._deepest
        if deepest == 0.0:
            raise OutsideValidity("ViscoelasticTangential: the bodies never touch along this path; press them.")
        elastic, medium = elastic_like(self.bed), self.bed.medium
        assert isinstance(medium, ViscoelasticHalfSpace)
        _, reach = at_depth(elastic, np.array([deepest]))
        springs = Springs.of(elastic, float(reach[0]), self.count)
        normal, shear = relaxation_of("", self.bed), shear_relaxation(medium, self.bed.footprint.shear_share)
        by_depth, by_shift = isinstance(self.path.normal, Depth), isinstance(self.path.lateral, Shift)
        row = ShearedMarch(SpringRow(elastic, springs, normal), shear, self.law.coefficient, by_depth, by_shift)
        row.row.motion[0] = min(float(self.path.across[0]), 0.0) if by_depth else row.row.depth
        # the greatest stiffness of the springs: glassy, or as they are within the time that the path takes
        quick = 1.0 / max(float(self.path.time[-1] - self.path.time[0]), 1e-300)
        hard, stiff = (
            series.glassy if math.isfinite(series.glassy) else float(abs(series.dynamic(np.array(quick))))
            for series in (normal, shear)
        )
        force = hard * springs.force(deepest) if by_depth else float(np.max(self.path.across))
        along = float(np.max(np.abs(self.path.along), initial=0.0))
        whole = stiff * float(np.sum(springs.stiffness))
        slide_ = along if by_shift else along / whole
        borne = min(self.law.coefficient * force, whole * slide_) if self.law.coefficient > 0.0 else 0.0
        borne = borne if borne > 0.0 else force
        slide_ = slide_ if slide_ > 0.0 else deepest
        little = self.tolerance
        return row, ErrorScales(little * deepest, little * slide_, little * borne, little * borne * slide_, force)

    def gathered(self, states: Iterable[ViscoelasticTangentialState]) -> ViscoelasticTangentialSolution:
        """Return the solution made of these states, of the whole path or of its beginning."""
        return gather(ViscoelasticTangentialSolution, self, states)

    def solve(self) -> ViscoelasticTangentialSolution:
        """Return the whole path.

        Returns
        -------
        ViscoelasticTangentialSolution

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class ViscoelasticTangentialSolution(Looped):
    """The solution of a `ViscoelasticTangential`, point by point of its path.

    Parameters
    ----------
    problem : ViscoelasticTangential
        The problem that was solved.
    time : ndarray, (steps,)
        [s].
    depth, force, radius : ndarray, (steps,)
        d [m], F_N [N], a [m].
    shift, shear_force : ndarray, (steps,)
        u_x [m] and F_x [N]; what drags the upper body along, positive towards +x.
    stick_radius : ndarray, (steps,)
        Up to which all springs stick [m].
    work, stored_energy : ndarray, (steps,)
        What the machine has spent since the beginning, and what all springs store, in both directions [J].
    friction_loss, bulk_loss, dissipation : ndarray, (steps,)
        Lost since the beginning to friction, in the dashpots of the bodies, and both together [J].
    states : tuple of ViscoelasticTangentialState
        The states themselves.
    """

    __words__ = words(
        work=("W", "J", "what the machine has spent since the beginning"),
        stored_energy=("U", "J", "energy stored in all springs, both directions"),
    )

    problem: ViscoelasticTangential
    time: Array
    depth: Array
    force: Array
    radius: Array
    shift: Array
    shear_force: Array
    stick_radius: Array
    work: Array
    stored_energy: Array
    friction_loss: Array
    bulk_loss: Array
    dissipation: Array
    states: tuple[ViscoelasticTangentialState, ...]

    @property
    def last_cycle(self) -> LastCycle:
        """Where the last cycle of the path runs, its loss to friction and in the bodies, and its amplitudes."""
        path = self.problem.path
        given = path.across, path.along
        return cycle_of("ViscoelasticTangential", given, self.dissipation, self.shift, self.shear_force)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        bed = self.problem.bed
        return (
            *bed.notes,
            CATTANEO,
            sticking_note(bed.medium, self.problem.law.coefficient),
            *direction_notes(bed),
            *path_notes(bed, self.time),
            energy_note(self.work, self.stored_energy, self.dissipation),
            *contact_notes(elastic_like(bed), self.depth, self.radius),
            *relaxing_yield(bed.medium),
            *self._cycle_notes,
        )


CATTANEO = Note(
    Assumption.SLIP,
    Standing.ASYMPTOTIC,
    "Tractions are taken parallel to the motion and the directions as independent (Cattaneo-Mindlin); "
    "sliding is decided spring by spring at the end of every step.",
    "R. D. Mindlin, J. Appl. Mech. 16 (1949) 259-268, doi:10.1115/1.4009973",
)
