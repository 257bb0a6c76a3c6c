r"""A line contact that is pressed and sheared: stick, partial slip and sliding, with memory of what was.

On similar bodies the traction of a contact that slips in part is that of a normal contact less that of an earlier,
narrower one (Cattaneo; for all profiles Ciavarella and Jaeger),

.. math:: q(x) = \mu\,[p(x;P) - p(x;\gamma)] , \qquad Q = \mu\,(P-\gamma) ,

and every history of straight steps in P and Q is a sum of such terms.  The memory is that of bodies of revolution
(`winkler.problems.friction.slip_memory`), with the load per length of a narrower contact in the place of the gap, and Q
in the place of the shift.  A bulk stress in one body, in phase with Q, tilts the profile of each term; the strips of a
cylinder are shifted by it (Nowell and Hills).  Beside any other bulk stress boundary elements are followed along the
path (`winkler.problems.line_friction.element_row`), and on layers, which answer traction and pressure in different
manners, so that no sum holds.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import ClassVar, cast

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.laws.friction import Sliding
from winkler.media.relaxing.relaxing_medium import relaxes
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import BALANCED, RELAXING, SHEARED
from winkler.problems.last_cycle import Cycled, PathLoop
from winkler.problems.line.half_width import grows, refuse_unless_strips, under_force
from winkler.problems.line_friction.bulk import has_closed_form, refuse_bulk
from winkler.problems.line_friction.element_row import ElementRow
from winkler.problems.line_friction.marched_states import LineDraggedState, LineMarchedState, marched_state
from winkler.problems.line_friction.path import LinePath
from winkler.problems.line_friction.relaxing_row import RelaxingElementRow, refuse_timeless
from winkler.problems.line_friction.sheared_strip import LineSlip
from winkler.problems.line_friction.slip_work import SummedRow
from winkler.problems.line_friction.states import LineTangentialState
from winkler.problems.line_friction.validity import dragged_line_notes, sheared_line_notes
from winkler.problems.method import Method, refuse_method
from winkler.problems.one_load import OfPath
from winkler.problems.row import follow
from winkler.values.checks.place_checks import finite_places
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

METHODS = Method.AUTO, Method.EXACT, Method.ELEMENTS


@value
class LineTangential:
    """A cylinder, a wedge or another two-dimensional body pressed and sheared on half-planes or layers, with friction.

    Parameters
    ----------
    bed : LineFoundation, LayeredLineFoundation or PowerLawLineFoundation
        Profile and bodies: half-planes, or layers that transmit shear to the base, elastic or viscoelastic, with one
        common relaxation function or separate ones.
    law : Coulomb
        Law of friction.
    path : LinePath
        Normal and shear force per length, and a bulk stress; with a time where the bodies relax.
    method : Method, optional
        Method for stick and slip: AUTO, EXACT (Ciavarella-Jaeger superposition) or ELEMENTS (boundary elements). By
        default EXACT where it applies.

    Raises
    ------
    InvalidInput
        If the method is another one.  If bodies relax along a path without time, or a liquid leaves a film.  If the
        body, or what carries its layers, is rigid and there is a bulk stress.
    OutsideValidity
        If a layer slides on the material below.

    References
    ----------
    M. Ciavarella, Int. J. Solids Struct. 35 (1998) 2349-2362, doi:10.1016/S0020-7683(97)00154-6;
    J. Jaeger, Arch. Appl. Mech. 65 (1995) 478-487, doi:10.1007/BF00835661;
    D. Nowell, D. A. Hills, Int. J. Mech. Sci. 29 (1987) 355-365, doi:10.1016/0020-7403(87)90117-2

    Examples
    --------
    A cylinder under 60 % of the shear force at which it slides: c/a is the root of the rest.

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> steel = Elastic(210e9, 0.3)
    >>> bed = LineFoundation(Paraboloid(10e-3), HalfSpace.between(steel, steel))
    >>> pushed = LineTangential(bed, Coulomb(0.5), LinePath(100e3, [0.0, 30e3])).solve()
    >>> round(float(pushed.stick_half_width[-1] / pushed.half_width[-1]), 12)  # sqrt(0.4)
    0.632455532034
    """

    __words__ = words(
        bed=("", None, "profile and bodies of the line contact"),
        relaxes=("", None, "whether the bodies relax"),
    )

    bed: LineFoundation | LayeredLineFoundation | PowerLawLineFoundation
    law: Sliding
    path: LinePath
    method: Method = Method.AUTO

    references: ClassVar[tuple[str, ...]] = (
        "johnson_1985",
        "cattaneo_1938",
        "jaeger_1995",
        "ciavarella_1998",
        "nowell_hills_1987",
    )
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING | SHEARED | BALANCED

    def __post_init__(self) -> None:
        refuse_method("LineTangential", self.method, METHODS)
        if self.relaxes:
            refuse_timeless(self._relaxing_bed, self.path, self.method)
            return
        _ = self.bed.along_share
        refuse_bulk(self.bed, self.path)

    @property
    def relaxes(self) -> bool:
        """Whether the bodies are viscoelastic, so that each element depends on its load history."""
        return relaxes(self.bed.medium)

    @property
    def _relaxing_bed(self) -> LineFoundation | LayeredLineFoundation:
        """The bed of bodies that relax; that of a power law takes none."""
        return cast(LineFoundation | LayeredLineFoundation, self.bed)

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one for every point of the path."""
        return self.path.across.size

    def steps(self) -> Iterator[LineTangentialState | LineMarchedState]:
        """Yield the contact at every point of the path.

        Raises
        ------
        OutsideValidity
            If the shear force exceeds the friction limit, or the bulk stress leaves hardly any stick zone. The error
            is raised at that point, after all earlier states.  If the method is EXACT, but the superposition does not
            apply.
        """
        bed, mu = self.bed, self.law.coefficient
        if self.relaxes:
            yield from RelaxingElementRow(self._relaxing_bed, mu, self.path).states(self.law)
            return
        modulus = bed.medium.modulus
        forces = self.path.across
        widths = under_force(bed, forces / modulus)
        refuse_unless_strips(bed, widths)
        widest, most = float(np.max(widths)), float(np.max(forces)) / modulus
        if not (bed.profile.rising or grows(bed, widest)):
            raise OutsideValidity(
                f"LineTangential: up to the half-width of {widest:.6g} m the profile lets the load fall again, so that "
                "the contact grows in jumps, of which slip keeps no memory; give a smoother profile or a smaller load."
            )
        sums = most == 0.0 or (self.method is not Method.ELEMENTS and has_closed_form(bed, self.path))
        if self.method is Method.EXACT and not sums:
            raise OutsideValidity(
                f"LineTangential: the method {Method.EXACT} adds up earlier contacts, which holds on similar bodies. "
                "Beside a bulk stress it holds under a steady force on a cylinder, while the stress is in phase with "
                f"the shear force and no edge slips back. Give the method {Method.ELEMENTS}."
            )
        columns = [row.tolist() for row in (forces, widths, self.path.along, self.path.bulk)]
        points = zip(*columns, strict=True)
        if sums:
            row = SummedRow(bed, mu, self.path)
            for (force, width, shear, bulk), (state, _, lost) in zip(points, follow(row, row.goals), strict=True):
                yield LineTangentialState(
                    force, width, shear, bulk, state.shift, lost, bed, self.law, row.lean, state.memory
                )
            return
        cells = ElementRow(bed, mu, self.path)
        for (force, width, shear, bulk), (reached, _, lost) in zip(points, follow(cells, cells.goals), strict=True):
            touching = cells.touching(reached)
            yield marched_state(bed, self.law, touching, force, width, shear, bulk, cells.lost_per_length(lost))

    def gathered(self, states: Iterable[LineTangentialState | LineMarchedState]) -> LineTangentialSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        given = tuple(states)
        reached = tuple(state for state in given if isinstance(state, LineTangentialState))
        if len(reached) < len(given):
            return gather(LineTangentialSolution, self, given)
        gaps = np.array([0.0 if state.sliding else state.memory.stick_gap for state in reached])
        widths = np.array([state.half_width for state in reached])
        distinct, where = np.unique(np.maximum(gaps, 0.0), return_inverse=True)
        stick = np.minimum(under_force(self.bed, distinct)[where], widths)
        return gather(LineTangentialSolution, self, reached, stick_half_width=stick)

    def solve(self) -> LineTangentialSolution:
        """Return the contact along the whole path.

        Raises
        ------
        OutsideValidity
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class LineTangentialSolution(LineSlip[Array], Cycled, OfPath["LineTangentialState | LineMarchedState"]):
    """The solution of a `LineTangential` problem, point by point; its numbers are those of `LineSlip`.

    Parameters
    ----------
    problem : LineTangential
        The problem that was solved.
    stick_half_width, stick_middle : ndarray, (points,)
        Half-width and middle of the strip that does not slip [m].
    states : tuple of LineTangentialState or LineMarchedState
        The states, with traction, slip and stresses. They are `LineMarchedState` if the path was computed step by
        step.
    """

    __words__ = words(
        loss_per_cycle_per_length=("W", "J/m", "energy per length lost in the last cycle of the path"),
    )

    problem: LineTangential
    stick_half_width: Array
    stick_middle: Array
    states: tuple[LineTangentialState | LineMarchedState, ...]

    def friction_work(self, x: ArrayLike) -> Array:
        """Return the frictional dissipation along the path per area [J/m^2], at positions on the surface.

        Divided by the coefficient of friction it is pressure times slip, the input of Archard's law.

        Parameters
        ----------
        x : array_like
            Positions on the surface [m]; the dissipation outside the contact is zero.

        Raises
        ------
        OutsideValidity
            If the normal force changes along a path that was not computed step by step: the local dissipation is then
            not available.
        """
        last = self.states[-1]
        if isinstance(last, LineMarchedState):
            return last.friction_work(x)
        if np.ptp(self.force_per_length) > 0.0:
            raise OutsideValidity(
                "LineTangentialSolution: the normal force changes along the path, and the loss is known by place under "
                "a steady one only; give one force per length, or use dissipation_per_length."
            )
        x = finite_places("LineTangentialSolution.friction_work", "x", x)
        inside = np.abs(x) < self.half_width[0]
        before, total = np.zeros((2, int(np.sum(inside))))
        for state in self.states if total.size else ():
            ahead = state.slip(x[inside])
            total += state.traction(x[inside]) * (ahead - before)
            before = ahead
        spread = np.zeros(x.shape)
        spread[inside] = total
        return spread

    @property
    def _loop(self) -> PathLoop:
        """Motions are those beyond what Q causes."""
        path, shear = self.problem.path, self.shear_force_per_length
        return PathLoop((path.across, path.along, path.bulk), self.slip_shift, shear, self.dissipation_per_length)

    @property
    def loss_per_cycle_per_length(self) -> float:
        """Energy lost in the last cycle of the path, per length [J/m].

        Raises
        ------
        OutsideValidity
            If the path closes no cycle.
        """
        return self.last_cycle.loss

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        widest = self.states[int(np.argmax(self.half_width))]
        if isinstance(widest, LineDraggedState):
            moments = self.problem.path.moments[: len(self.states)]
            return (
                *dragged_line_notes(self.problem._relaxing_bed, self.problem.law, widest, moments),
                *self._cycle_notes,
            )
        widest = self.states[int(np.argmax(self.force_per_length))]
        greatest = float(np.max(np.abs(self.bulk_stress)))
        return (*sheared_line_notes(self.problem.bed, self.problem.law, widest, greatest), *self._cycle_notes)
