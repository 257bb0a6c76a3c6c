r"""A contact that is pressed and moved along the surface: stick, partial slip and sliding, with memory of what was.

Springs stick until the friction they bear is used up, slide on that bound, and let go when nothing presses them any
more.  In one direction the springs are not needed one by one: distinguished by their gap they follow straight pieces
(`winkler.problems.friction.slip_memory`), so that every history of straight steps in depth and shift is solved exactly,

.. math:: F_x = \frac{G^*}{E^*}\int u_t\,\mathrm dK, \qquad U_t = \frac{G^*}{2E^*}\int u_t^2\,\mathrm dK .

Where a prescribed force bends the step between two points it is refined.  Layers and gradings answer to shear otherwise
than to pressure; there rings slide with their own kernels (`winkler.problems.friction.pushed`).  In the plane and under
other laws of friction the springs march one by one (`winkler.problems.friction.spring_run`).
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Iterator, Sequence
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import Bed, slipping_depth, slipping_springs
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Depth, Force, ShearForce, Shift
from winkler.loading.path import Path
from winkler.media.relaxing.relaxing_medium import relaxes
from winkler.numerics.types import Array
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import BALANCED, RELAXING, SHEARED
from winkler.problems.assumptions.energy import energy_note
from winkler.problems.friction.pushed import PushedState, pushed_notes, pushed_states
from winkler.problems.friction.spring_run import SingleSprings
from winkler.problems.friction.spring_states import SpringLaw, SpringState
from winkler.problems.friction.tangential_march import SlipRow
from winkler.problems.friction.tangential_states import TangentialState, friction_notes, stick_radii
from winkler.problems.last_cycle import Looped, PathLoop
from winkler.problems.method import Method
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.normal.stiffness_ratio import alike, refuse_plane, stiffness_ratios
from winkler.problems.one_load import OfPath, RestoredStates
from winkler.problems.ring_slip.push_bound import exact_ratio, layers_of_rings, pushed_body
from winkler.problems.round_march import RoundSlip
from winkler.problems.row import follow
from winkler.problems.viscoelastic.tangential import (
    DraggedState,
    Relaxed,
    dragged_notes,
    dragged_states,
    pressed_alone,
)
from winkler.values.checks.number_checks import Whole, between
from winkler.values.errors import InvalidInput
from winkler.values.limits import RELAXING_SPRINGS
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

State = TangentialState | SpringState | PushedState | DraggedState
"""The contact at one point of a path, by whichever method it was followed."""


@value
class Tangential:
    """A body pressed and moved tangentially along a path of loads, with friction.

    Parameters
    ----------
    bed : Bed
        The springs: Foundation(profile, medium).
    law : Coulomb, StaticKinetic or OwnLaw
        How the surfaces rub; a user-defined law has a method ``shear_bound(line_load)``.
    path : Path
        Depth or normal force, and shift or shear force, over time.
    method : Method, optional
        Method for stick and slip. The default on bonded layers and graded bodies is annular elements (RINGS). The
        default on homogeneous and power-law media is EXACT: all springs of equal gap together. Single springs
        (SPRINGS) are used for planar motion, for other laws than Coulomb's, and for viscoelastic bodies.
    count : int, optional
        Number of springs, if single springs are followed. The error is of second order; on viscoelastic bodies of first
        order if the load does not vanish at the edge.
    tolerance : float, optional
        Error of a step on viscoelastic bodies: of the shear force over the friction limit, of the frictional loss over
        this force times the maximum displacement, and of depth and displacement under forces over their maximum. With a
        dashpot alongside, under a normal force and a shift, the work counts in place of the shear force.

    Raises
    ------
    InvalidInput
        If the path twists the bodies (use Torsion), or the law is not a law of friction. If the method supports neither
        this law nor planar paths.  If the law of bodies that relax is not Coulomb's, or their path leaves its
        line.
    OutsideValidity
        If RINGS are requested on another medium, or for a contact that is not a disc.  If a liquid leaves a film.

    References
    ----------
    J. Jaeger, Arch. Appl. Mech. 65 (1995) 478-487, doi:10.1007/BF00835661;
    M. Ciavarella, Int. J. Solids Struct. 35 (1998) 2349-2362, doi:10.1016/S0020-7683(97)00154-6

    Examples
    --------
    Half of the shift at which all slides (Cattaneo, Mindlin):

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(10e-3), HalfSpace.between(Elastic(210e9, 0.3)))
    >>> most = 0.3 * 1e-6 * bed.medium.modulus / bed.medium.shear_modulus
    >>> pushed = Tangential(bed, Coulomb(0.3), Path([0.0, 1.0], Depth(1e-6), Shift([0.0, 0.5 * most]))).solve()
    >>> round(float(pushed.shear_force[-1] / (0.3 * pushed.force[-1])), 6)  # 1 - 2^(-3/2)
    0.646447
    """

    __words__ = words(
        by_rings=("", None, "whether rings are followed, not springs"),
        relaxes=("", None, "whether the bodies relax"),
        count=("n", "", "how many springs"),
    )

    bed: Bed
    law: SpringLaw
    path: Path
    method: Method = Method.AUTO
    count: Annotated[int, Whole(2, RELAXING_SPRINGS)] = 400
    tolerance: Annotated[float, between(1e-12, 0.1)] = 1e-5

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "cattaneo_1938", "mindlin_1949", "jaeger_1995")
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING | SHEARED | BALANCED
    needs_round: ClassVar[str] = ""

    def __post_init__(self) -> None:
        if not isinstance(self.path.lateral, Shift | ShearForce):
            raise InvalidInput(
                f"Tangential: the path prescribes a {type(self.path.lateral).__name__}; give Shift or ShearForce, or "
                "use Torsion."
            )
        refuse_plane("Tangential", self.bed, self.path)
        if self.method in (Method.EXACT, Method.RINGS) and not self._coulomb_line:
            raise InvalidInput(
                f"Tangential: the method {self.method} follows Coulomb's law on a path along one line; give the method "
                f"{Method.SPRINGS}, which follows each law and paths in the plane."
            )
        if self.relaxes:
            if not self._coulomb_line or self.method in (Method.EXACT, Method.RINGS):
                raise InvalidInput(
                    "Tangential: viscoelastic bodies require Coulomb's law, motion along one line and the method "
                    f"{Method.SPRINGS}; the law is a {type(self.law).__name__}, the method {self.method}, and the "
                    f"path {'leaves' if self.path.in_plane else 'keeps to'} its line."
                )
            pressed_alone("Tangential", self.bed, self.path, self.count, self.tolerance)
        elif self.by_rings:
            pushed_body(self.bed)

    @property
    def relaxes(self) -> bool:
        """Whether the bodies are viscoelastic, so that each spring depends on its load history."""
        return relaxes(self.bed.medium)

    @property
    def _coulomb_line(self) -> bool:
        """Whether the path keeps to one line, under the law of Coulomb."""
        return isinstance(self.law, Coulomb) and not self.path.in_plane

    @property
    def by_rings(self) -> bool:
        """Whether annular elements are used: for layers and graded bodies, unless another method is given."""
        if self.method is Method.AUTO:
            return self._coulomb_line and not self.relaxes and layers_of_rings(self.bed) is not None
        return self.method is Method.RINGS

    @property
    def normal(self) -> IndentationSolution:
        """The frictionless contact at every point of the path."""
        across = self.path.across
        return Indentation(self.bed, Depth(across) if isinstance(self.path.normal, Depth) else Force(across)).solve()

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one for every point of the path."""
        return self.path.time.size

    def steps(self) -> Iterator[State]:
        """Yield the contact at every point of the path.

        Raises
        ------
        OutsideValidity
            If a prescribed shear force exceeds the friction limit. The error is raised at that step, after all earlier
            states. If the method is EXACT, but the springs have different stiffness ratios. If a contact on layers is
            too wide compared with the uppermost layer.
        NotConverged
            If a step under prescribed forces is too long for the iteration; give more points.
        """
        if self.relaxes:
            assert isinstance(self.law, Coulomb)
            yield from dragged_states(self.bed, self.law, self.path, self.count, self.tolerance)
            return
        if self.by_rings:
            assert isinstance(self.law, Coulomb)
            yield from pushed_states(self.bed, self.law.coefficient, self.path)
            return
        if self.method is not Method.SPRINGS and self._coulomb_line:
            contact, bed = self.normal, slipping_springs(self.bed)
            widest = float(np.max(contact.radius, initial=0.0))
            ratios = stiffness_ratios(bed, widest) if widest > 0.0 else (1.0, 1.0)
            if alike(ratios):
                yield from self._by_gap(contact, ratios[1])
                return
            if self.method is Method.EXACT:
                exact_ratio("Tangential", bed, widest)
        yield from self._row.states()

    @property
    def _row(self) -> SingleSprings:
        return SingleSprings("Tangential", self.bed, self.law, self.path, self.count)

    def _by_gap(self, contact: IndentationSolution, ratio: float) -> Iterator[TangentialState]:
        """Yield the contact at every point of the path, springs of one gap taken together."""
        assert isinstance(self.law, Coulomb)
        moved = dataclasses.replace(
            contact, depth=slipping_depth(self.bed, np.asarray(contact.depth), np.asarray(contact.radius))
        )
        row = SlipRow(slipping_springs(self.bed), self.law.coefficient, ratio, self.path, moved)
        pressed = (np.asarray(quantity).tolist() for quantity in (contact.depth, contact.force, contact.radius))
        points = zip(self.path.time.tolist(), *pressed, strict=True)
        for (time, depth, force, radius), (state, work, lost) in zip(points, follow(row, row.goals), strict=True):
            memory = row.memory(state)
            along = state.shift, row.shear_force(memory), work, row.stored(memory), lost
            yield TangentialState(time, depth, force, radius, *along, self.bed, self.law, ratio, memory)

    def gathered(self, states: Iterable[State]) -> TangentialSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        reached = list(states)
        return gather(TangentialSolution, self, reached, stick_radius=stick_radii(self.bed, reached))

    def solve(self) -> TangentialSolution:
        """Return the contact along the whole path.

        Returns
        -------
        TangentialSolution

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        if not (self.relaxes or self.by_rings) and (self.method is Method.SPRINGS or not self._coulomb_line):
            row = self._row
            if row.straight():
                numbers, last = row.history()
                return TangentialSolution(problem=self, states=RestoredStates(self, last), **numbers)
        return self.gathered(self.steps())


@value
class TangentialSolution(RoundSlip[Array], Looped, Relaxed, OfPath[State]):
    """The solution of a `Tangential` problem, point by point; its numbers are those of `RoundSlip`.

    Parameters
    ----------
    problem : Tangential
        The problem that was solved.
    stick_radius : ndarray, (steps,)
        Radius c of the stick zone [m]: a if all springs stick, zero if the bodies slide or do not touch.
    states : sequence
        The states, from which surface and subsurface fields are computed.
    """

    problem: Tangential
    stick_radius: Array
    states: Sequence[State]

    @property
    def nested(self) -> Array:
        """Whether the slip zone of each step was one outer annulus with one slip direction, ``(steps,)`` of bool.

        Raises
        ------
        OutsideValidity
            If springs were used instead of annular elements.
        """
        return self._known("nested")

    @property
    def _loop(self) -> PathLoop:
        path = self.problem.path
        return PathLoop((path.across, path.along), self.shift, self.shear_force, self.dissipation)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        problem = self.problem
        notes = energy_note(self.work, self.stored_energy, self.dissipation), *self._cycle_notes
        if problem.relaxes:
            assert isinstance(problem.law, Coulomb)
            return (*dragged_notes(problem.bed, problem.law, self.time, self.depth, self.radius), *notes)
        if problem.by_rings:
            assert isinstance(problem.law, Coulomb)
            by_force = isinstance(problem.path.lateral, ShearForce)
            rings = [state for state in self.states if isinstance(state, PushedState)]
            return (*pushed_notes(problem.bed, problem.law, rings, by_force), *notes)
        last = self.states[-1]
        assert isinstance(last, TangentialState | SpringState)
        kept = self.depth, self.force, self.shear_force, self.radius
        return (*friction_notes(problem.bed, problem.law, *kept, last), *notes)
