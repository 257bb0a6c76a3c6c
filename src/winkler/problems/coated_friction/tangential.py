r"""A layered or graded body that is pressed and pushed along the surface, with friction, by kernels that differ.

On a homogeneous half-space a stuck contact drags with the same distribution as a flat punch presses, so that the
difference of two normal contacts solves partial slip (Cattaneo, Mindlin, Jaeger, Ciavarella).  Layers answer to shear
otherwise than to pressure, and that rule fails.  What holds are springs of another weight and another bound
(`winkler.problems.ring_slip.push_bound`): a ring that slides bears :math:`\mu p(r)`, one that sticks follows the body.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import ClassVar

from winkler.errors import InvalidInput
from winkler.foundation.bed import Bed
from winkler.laws.friction import Coulomb
from winkler.loading import Depth, ShearForce, Shift
from winkler.numerics.types import Array
from winkler.path import Path
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import BALANCED, SHEARED
from winkler.problems.assumptions.energy import energy_note
from winkler.problems.coated_friction.notes import coated_notes
from winkler.problems.coated_friction.push import PushedSprings
from winkler.problems.coated_friction.state import CoatedTangentialState
from winkler.problems.last_cycle import LastCycle, Looped, cycle_of
from winkler.problems.one_load import OfPath
from winkler.problems.ring_slip.push_bound import push_bound, pushed_body
from winkler.problems.ring_slip.ring_path import ring_points
from winkler.validity import Assumption, Note
from winkler.values import value

__all__ = ["CoatedTangential", "CoatedTangentialSolution"]


@value
class CoatedTangential:
    """A body pressed on a layered or graded one and pushed along the surface to and fro, with friction.

    Parameters
    ----------
    bed : Bed
        Foundation(profile, medium), its contact a disc; the medium a CoatedHalfSpace, a StackedHalfSpace whose layers
        are bonded, or a DepthGradedHalfSpace.
    law : Coulomb
        Friction.
    path : Path
        Depth or normal force, and shift or shear force in one direction, over time.

    Raises
    ------
    InvalidInput
        If the path twists the bodies, leaves its line, or the law is not Coulomb's.
    OutsideValidity
        If the medium is none of these, or the contact no disc.

    References
    ----------
    C. Cattaneo, Rend. Accad. Naz. Lincei 27 (1938) 342-348; R. D. Mindlin, J. Appl. Mech. 16 (1949) 259-268,
    doi:10.1115/1.4009973

    Examples
    --------
    A coating of the same material as its base slips as a half-space does: half of the shift at which all slides.

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.materials.layered import Layer
    >>> from winkler.media.layered.coated import CoatedHalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> steel = Elastic(210e9, 0.3)
    >>> bed = Foundation(Paraboloid(10e-3), CoatedHalfSpace([Layer(steel, 1e-3)], on=steel))
    >>> most = 0.3 * 1e-6 * bed.medium.modulus / bed.medium.shear_modulus
    >>> pushed = CoatedTangential(bed, Coulomb(0.3), Path([0.0, 1.0], Depth(1e-6), Shift([0.0, 0.5 * most]))).solve()
    >>> round(float(pushed.shear_force[-1] / (0.3 * pushed.force[-1])), 6)  # 1 - 2^(-3/2)
    0.646447
    """

    bed: Bed
    law: Coulomb
    path: Path

    references: ClassVar[tuple[str, ...]] = ("cattaneo_1938", "mindlin_1949", "jaeger_1995")
    assumptions: ClassVar[frozenset[Assumption]] = SHEARED | BALANCED
    needs_round: ClassVar[str] = "slip on a coating, ring by ring"

    def __post_init__(self) -> None:
        if not isinstance(self.path.lateral, Shift | ShearForce) or self.path.in_plane:
            raise InvalidInput(
                "CoatedTangential: the path must move along one line; give Path(time, normal, lateral) with the "
                "lateral load Shift([...]) or ShearForce([...]), or use Tangential or Torsion."
            )
        pushed_body(self.bed)

    @property
    def total(self) -> int:
        """How many states `steps` yields: one for every point of the path."""
        return self.path.time.size

    def steps(self) -> Iterator[CoatedTangentialState]:
        """Yield the state at every point of the path.

        Raises
        ------
        OutsideValidity
            If friction does not bear a prescribed shear force, at that step: the states before it have been yielded.
            If the contact is too wide against the uppermost layer.
        NotConverged
            If a step is too long for the shift or the loss to settle.
        """
        forced = not isinstance(self.path.normal, Depth)
        unit = pushed_body(self.bed).shear_modulus
        for point in ring_points(self.bed, self.law.coefficient, self.path, unit, push_bound):
            yield CoatedTangentialState(
                time=point.time,
                depth=point.depth,
                force=point.force,
                radius=point.radius,
                shift=point.motion,
                shear_force=point.load,
                stick_radius=point.stick_radius,
                work=point.work,
                stored_energy=point.stored,
                dissipation=point.lost,
                nested=point.nested,
                springs=PushedSprings(self.bed, self.law.coefficient, point.bound.widest, forced, point.memory),
            )

    def gathered(self, states: Iterable[CoatedTangentialState]) -> CoatedTangentialSolution:
        """Return the solution made of these states, of the whole path or of its beginning."""
        return gather(CoatedTangentialSolution, self, states)

    def solve(self) -> CoatedTangentialSolution:
        """Return the contact along the whole path.

        Returns
        -------
        CoatedTangentialSolution

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class CoatedTangentialSolution(Looped, OfPath[CoatedTangentialState]):
    """The solution of a `CoatedTangential` problem, point by point.

    Parameters
    ----------
    problem : CoatedTangential
        The problem that was solved.
    time : ndarray, (steps,)
        t [s].
    depth, force, radius : ndarray, (steps,)
        d [m], F_N [N], a [m].
    shift, shear_force : ndarray, (steps,)
        u_x [m] and F_x [N], positive towards +x.
    stick_radius : ndarray, (steps,)
        Of the part that is not at its bound [m].
    work, stored_energy, dissipation : ndarray, (steps,)
        Spent by the lateral motion since the beginning, stored, and lost since the beginning [J].
    nested : ndarray of bool, (steps,)
        Whether all that slid in the step was one outer ring, and slid to one side.
    states : tuple of CoatedTangentialState
        One by one, with `traction(r)`.
    """

    __words__ = CoatedTangentialState.__words__

    problem: CoatedTangential
    time: Array
    depth: Array
    force: Array
    radius: Array
    shift: Array
    shear_force: Array
    stick_radius: Array
    work: Array
    stored_energy: Array
    dissipation: Array
    nested: Array
    states: tuple[CoatedTangentialState, ...]

    @property
    def last_cycle(self) -> LastCycle:
        """Where the last cycle of the path runs, its loss and its amplitudes."""
        path = self.problem.path
        return cycle_of("CoatedTangential", (path.across, path.along), self.dissipation, self.shift, self.shear_force)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        problem = self.problem
        by_force = isinstance(problem.path.lateral, ShearForce)
        return (
            *coated_notes(problem.bed, problem.law, self.states, by_force),
            energy_note(self.work, self.stored_energy, self.dissipation),
            *self._cycle_notes,
        )
