r"""A contact that is pressed and moved along the surface: stick, partial slip and sliding, with memory of what was.

Springs stick until the friction they bear is used up, slide on that bound, and let go when nothing presses them any
more.  In one direction the springs are not needed one by one: distinguished by their gap they follow straight pieces
(`winkler.problems.friction.slip_memory`), so that every history of straight steps in depth and shift is solved exactly,

.. math:: F_x = \frac{G^*}{E^*}\int u_t\,\mathrm dK, \qquad U_t = \frac{G^*}{2E^*}\int u_t^2\,\mathrm dK .

Where a prescribed force bends the step between two points it is refined.  In the plane, under other laws of friction
and on layered media the springs march one by one (`winkler.problems.friction.spring_run`).
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Iterator
from typing import ClassVar

import numpy as np

from winkler.errors import InvalidInput
from winkler.foundation.bed import Bed, slipping_depth, slipping_springs
from winkler.laws.friction import Coulomb
from winkler.loading import Depth, Force, ShearForce, Shift
from winkler.numerics.types import Array
from winkler.path import Path
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import BALANCED, SHEARED
from winkler.problems.assumptions.energy import energy_note
from winkler.problems.friction.spring_run import SingleSprings
from winkler.problems.friction.spring_states import SpringLaw, SpringState
from winkler.problems.friction.tangential_march import SlipRow
from winkler.problems.friction.tangential_states import TangentialState, friction_notes, stick_radii
from winkler.problems.last_cycle import LastCycle, Looped, cycle_of
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.normal.stiffness_ratio import alike, refuse_plane, stiffness_ratios
from winkler.problems.one_load import OfPath
from winkler.problems.row import follow
from winkler.validity import Assumption, Note
from winkler.values import value, words

__all__ = ["Tangential", "TangentialSolution"]

SPRINGS = 400
"""How many springs there are where they are followed one by one."""


@value
class Tangential:
    """A body pressed and moved along the surface on a path, with friction.

    Parameters
    ----------
    bed : Bed
        The springs: Foundation(profile, medium).
    law : Coulomb, StaticKinetic or OwnLaw
        How the surfaces rub; a law of one's own has a method ``shear_bound(line_load)``.
    path : Path
        Depth or normal force, and shift or shear force, over time.

    Raises
    ------
    InvalidInput
        If the path twists the bodies (use Torsion), or the law is none of friction.

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

    bed: Bed
    law: SpringLaw
    path: Path

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "cattaneo_1938", "mindlin_1949", "jaeger_1995")
    assumptions: ClassVar[frozenset[Assumption]] = SHEARED | BALANCED

    def __post_init__(self) -> None:
        if not isinstance(self.path.lateral, Shift | ShearForce):
            raise InvalidInput(
                f"Tangential: the path prescribes a {type(self.path.lateral).__name__}; give Shift or ShearForce, or "
                "use Torsion."
            )
        refuse_plane("Tangential", self.bed, self.path)

    @property
    def normal(self) -> IndentationSolution:
        """The frictionless contact at every point of the path."""
        across = self.path.across
        return Indentation(self.bed, Depth(across) if isinstance(self.path.normal, Depth) else Force(across)).solve()

    @property
    def total(self) -> int:
        """How many states `steps` yields: one for every point of the path."""
        return self.path.time.size

    def steps(self) -> Iterator[TangentialState | SpringState]:
        """Yield the contact at every point of the path.

        Raises
        ------
        OutsideValidity
            If friction does not bear a prescribed shear force, at that step: the states before it have been yielded.
        NotConverged
            If a step that is curved by prescribed forces is too long to be followed; give more points.
        """
        contact, bed = self.normal, slipping_springs(self.bed)
        widest = float(np.max(contact.radius, initial=0.0))
        ratios = stiffness_ratios(bed, widest) if widest > 0.0 else (1.0, 1.0)
        if not isinstance(self.law, Coulomb) or self.path.in_plane or not alike(ratios):
            yield from SingleSprings("Tangential", self.bed, self.law, self.path, SPRINGS).states()
            return
        moved = dataclasses.replace(
            contact, depth=slipping_depth(self.bed, np.asarray(contact.depth), np.asarray(contact.radius))
        )
        row = SlipRow(bed, self.law.coefficient, ratios[1], self.path, moved)
        pressed = (np.asarray(quantity).tolist() for quantity in (contact.depth, contact.force, contact.radius))
        points = zip(self.path.time.tolist(), *pressed, strict=True)
        for (time, depth, force, radius), (state, work, lost) in zip(points, follow(row, row.goals), strict=True):
            memory, shift = state
            yield TangentialState(
                self.bed, self.law, ratios[1], time, depth, force, radius, shift, row.shear_force(memory), work,
                row.stored(memory), lost, memory,
            )  # fmt: skip

    def gathered(self, states: Iterable[TangentialState | SpringState]) -> TangentialSolution:
        """Return the solution made of these states, of the whole path or of its beginning."""
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
        return self.gathered(self.steps())


@value
class TangentialSolution(Looped, OfPath[TangentialState | SpringState]):
    """The solution of a `Tangential` problem, point by point.

    Parameters
    ----------
    problem : Tangential
        The problem that was solved.
    time : ndarray, (steps,)
        t [s].
    depth, force, radius : ndarray, (steps,)
        d [m], F_N [N], a [m].
    shift, shear_force : ndarray, (steps,) or (steps, 2)
        u_x [m] and F_x [N]; what drags the upper body along, positive towards +x.
    stick_radius : ndarray, (steps,)
        c [m]: springs within stick; a where all do, zero where the bodies slide or are apart.
    stored_energy : ndarray, (steps,)
        In the springs' displacement along the surface [J].
    dissipation : ndarray, (steps,)
        Energy lost since the beginning [J].
    states : tuple
        The states themselves, from which fields are restored.
    """

    __words__ = words(work=("W", "J", "what the lateral motion has spent since the beginning"))

    problem: Tangential
    time: Array
    depth: Array
    force: Array
    radius: Array
    shift: Array
    shear_force: Array
    stick_radius: Array
    stored_energy: Array
    dissipation: Array
    states: tuple[TangentialState | SpringState, ...]

    @property
    def work(self) -> Array:
        """What the lateral motion has spent since the beginning [J], ``(steps,)``: stored or lost."""
        return np.array([state.work for state in self.states])

    @property
    def last_cycle(self) -> LastCycle:
        """Where the last cycle of the path runs, its loss and its amplitudes."""
        path = self.problem.path
        return cycle_of("Tangential", (path.across, path.along), self.dissipation, self.shift, self.shear_force)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        notes = friction_notes(
            self.problem.bed, self.problem.law, self.depth, self.force, self.shear_force, self.radius, self.states
        )
        return (*notes, energy_note(self.work, self.stored_energy, self.dissipation), *self._cycle_notes)
