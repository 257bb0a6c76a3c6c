r"""A body pressed into a viscoelastic one, along any path: loading, holding, unloading, losing touch, touching again.

Every spring relaxes,

.. math:: q(x,t) = \int E^*(t-t')\,\frac{\partial u(x,t')}{\partial t'}\,\mathrm dt' , \qquad u = d(t)-g(x) ,

lets go when it would pull, recovers freely, and is caught again.  While depths are prescribed every spring is carried
exactly from event to event, for any step and any relaxation time; under prescribed forces the depth is straight within
steps that are chosen by their error.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.springs import Springs
from winkler.loading.loads import Depth, Force, Shift
from winkler.loading.path import Path
from winkler.media.offers import offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.numerics.springs.coupled_cells import CoupledCells
from winkler.numerics.types import Array
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import BALANCED, RELAXING
from winkler.problems.assumptions.energy import energy_note
from winkler.problems.assumptions.times import path_notes
from winkler.problems.last_cycle import Looped, PathLoop
from winkler.problems.normal.solve_contact import at_depth, at_force
from winkler.problems.round_march import RoundPress
from winkler.problems.viscoelastic.layered_march import MarchedPoint
from winkler.problems.viscoelastic.layered_notes import layered_notes
from winkler.problems.viscoelastic.layered_path import is_layered, marched
from winkler.problems.viscoelastic.march import SpringRow, elastic_like, refuse_rings, relaxation_of
from winkler.problems.viscoelastic.states import ViscoelasticState
from winkler.problems.viscoelastic.validity import relaxing_notes
from winkler.values.checks.number_checks import Whole, between
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.limits import RELAXING_SPRINGS
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

ROW_MARGIN = 1.001
"""The row reaches a little farther than the contact that is expected under forces."""
BLOCK = 4096
"""Points of the path in one go."""
BLOCK_UNDER_FORCES = 256
"""The same under forces, where one may take many steps, and a march can be interrupted between blocks alone."""


@value
class ViscoelasticIndentation:
    """A body pressed into a viscoelastic one along a path of loads.

    The load history begins with the first point of the path. A first depth or force that is not zero is applied in one
    step.

    Parameters
    ----------
    bed : Bed
        Foundation(profile, medium) with a ViscoelasticHalfSpace or a ViscoelasticCoatedHalfSpace.
    path : Path
        Depths or forces over time; equal times are a sudden step, which a dashpot alongside (Kelvin-Voigt) forbids for
        depths.  At zero force the body rests on the surface.
    count : int, optional
        Number of springs, or cells on layers with separate relaxation functions; the error falls with its square.
    tolerance : float, optional
        Error of the depth in one step under prescribed forces, over the maximum depth.  For layers with separate
        relaxation functions it is also the error of the force at prescribed depths; the effective tolerance is at
        least 0.1 / count^2.

    Raises
    ------
    InvalidInput
        If the medium is not viscoelastic, the path moves along the surface, a force is tensile, or a number is out of
        range.

    References
    ----------
    E. H. Lee, J. R. M. Radok, J. Appl. Mech. 27 (1960) 438-444, doi:10.1115/1.3644020; T. C. T. Ting, J. Appl. Mech. 33
    (1966) 845-854, doi:10.1115/1.3625192; I. I. Argatov, V. L. Popov, ZAMM 96 (2016) 956-967,
    doi:10.1002/zamm.201500144

    Examples
    --------
    A ball pressed into a Maxwell solid with E* = 1 and tau = 0.3 to d = 1 and back at the same speed.

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.spring_and_dashpot import Maxwell
    >>> from winkler.profiles.power import Paraboloid
    >>> from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
    >>> medium = ViscoelasticHalfSpace(Maxwell(shear=0.25, relaxation_time=0.3))
    >>> path = Path([0.0, 1.0, 1.1], Depth([0.0, 1.0, 0.9]))
    >>> contact = ViscoelasticIndentation(Foundation(Paraboloid(1.0), medium), path).solve()
    >>> contact.force.round(4), contact.radius.round(3)
    (array([0.    , 0.4881, 0.1857]), array([0.   , 1.   , 0.921]))
    """

    __words__ = words(count=("n", "", "how many springs"))

    bed: Bed
    path: Path
    count: Annotated[int, Whole(2, RELAXING_SPRINGS)] = 500
    tolerance: Annotated[float, between(1e-12, 0.1)] = 3e-7

    references: ClassVar[tuple[str, ...]] = (
        "popov_hess_2015",
        "popov_willert_hess_2018",
        "lee_radok_1960",
        "ting_1966",
        "argatov_popov_2016",
    )
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING | BALANCED
    needs_round: ClassVar[str] = ""

    def __post_init__(self) -> None:
        if not is_layered("ViscoelasticIndentation", self.bed, self.count):
            relaxation_of("ViscoelasticIndentation", self.bed)
        if not isinstance(self.path.lateral, Shift) or np.any(self.path.along != 0.0):
            raise InvalidInput(
                "ViscoelasticIndentation: the path moves along the surface; use Tangential, or leave "
                "the lateral load out."
            )
        if isinstance(self.path.normal, Force) and np.min(self.path.across) < 0.0:
            raise InvalidInput(
                f"ViscoelasticIndentation: the force {np.min(self.path.across):.6g} N is tensile; without adhesion "
                "bodies can only be pressed together."
            )

    @property
    def _deepest(self) -> float:
        """How deep the body can come [m]: under forces, as deep as the greatest one would press it if it stayed."""
        most = float(np.max(self.path.across))
        if isinstance(self.path.normal, Depth) or most <= 0.0:
            return max(most, 0.0)
        medium = self.bed.medium
        assert offers(medium, RelaxingMedium)
        spent = float(self.path.time[-1] - self.path.time[0])
        most *= ROW_MARGIN * float(medium.creep.at(np.array(spent)))
        if most == 0.0:  # a dashpot, and no time
            return 0.0
        depth, _ = at_force(elastic_like(self.bed), np.array([most]))
        return float(depth[0])

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one for every point of the path."""
        return self.path.time.size

    def steps(self) -> Iterator[ViscoelasticState]:
        """Yield the state at every point of the path, just before a sudden step at this point.

        Raises
        ------
        OutsideValidity
            If the depth exceeds the known range of the profile, or a dashpot is loaded by a step. If the contact is not
            a disc. The error is raised at that step, after all earlier states.
        NotConverged
            If the depth under a force is not found.
        """
        if is_layered("ViscoelasticIndentation", self.bed):
            for cells, point in self._layered():
                state, places = point.state, cells.displacement(point.state)
                yield ViscoelasticState(*point.numbers(), self.bed, cells.middle, state.load, places)
            return
        stiffness: Array = np.empty(0)
        for row, numbers in self._stretches(1):
            springs = row.springs
            stiffness = stiffness if stiffness.size else springs.density(row.bed)
            time, depth, force, radius, work, stored, lost = numbers[0].tolist()
            loads = stiffness * row.loads()
            yield ViscoelasticState(
                time, depth, force, radius, work, stored, lost, self.bed, springs.position, loads, row.place
            )

    def _layered(self) -> Iterator[tuple[CoupledCells, MarchedPoint]]:
        path = self.path
        assert isinstance(path.normal, Depth | Force)
        owner = "ViscoelasticIndentation"
        return marched(owner, self.bed, path.time, path.normal, path.across, self.count, self.tolerance)

    def _stretches(self, length: int) -> Iterator[tuple[SpringRow, Array]]:
        """Yield the row after every so many points of the path, and what a solution holds of them, a line each."""
        deepest = self._deepest
        if deepest == 0.0:
            raise OutsideValidity("ViscoelasticIndentation: the bodies never touch along this path; press them.")
        elastic = elastic_like(self.bed)
        _, reach = at_depth(elastic, np.array([deepest]))
        row = SpringRow(elastic, Springs.of(elastic, float(reach[0]), self.count), relaxation_of("", self.bed))
        if isinstance(self.path.normal, Depth):
            yield from self._by_depth(row, length)
        else:
            yield from self._by_force(row, deepest, min(length, BLOCK_UNDER_FORCES))

    def _by_depth(self, row: SpringRow, length: int) -> Iterator[tuple[SpringRow, Array]]:
        times, depths = self.path.time, self.path.across
        row.motion[0] = min(float(depths[0]), 0.0)
        before = np.append(row.depth, depths[:-1])
        changes, spans = depths - before, np.diff(times, prepend=times[0])
        if row.series.viscosity > 0.0:
            (sudden,) = np.nonzero((spans == 0.0) & (changes > 0.0) & (depths > 0.0))
        else:
            sudden = np.empty(0, dtype=int)
        end, work, lost = int(sudden[0]) if sudden.size else times.size, 0.0, 0.0
        for start in range(0, end, length):
            part = slice(start, min(start + length, end))
            done = row.march(changes[part], spans[part])
            refuse_rings("ViscoelasticIndentation", times[part], done.ring)
            worked, wasted = (np.cumsum(np.append(*each))[1:] for each in ((work, done.work), (lost, done.lost)))
            work, lost = float(worked[-1]), float(wasted[-1])
            columns = (times[part], depths[part], done.force, done.radius, worked, done.stored, wasted)
            yield row, np.stack(columns, axis=1)
        if end < times.size:
            raise OutsideValidity(
                f"ViscoelasticIndentation: at {times[end]:.6g} s the depth rises suddenly to {depths[end]:.6g} m, "
                "to which a dashpot alongside responds with an infinite force; give the step some time."
            )

    def _by_force(self, row: SpringRow, deepest: float, length: int) -> Iterator[tuple[SpringRow, Array]]:
        times, forces = self.path.time, self.path.across
        spans, before = np.diff(times, prepend=times[0]), np.append(0.0, forces)
        limits, course = np.array([self.tolerance * deepest, np.max(forces)]), np.zeros(5)
        work = lost = 0.0
        for start in range(0, times.size, length):
            part = slice(start, min(start + length, times.size))
            done, why = row.march_under(before[part.start : part.stop + 1], spans[part], limits, course)
            part = slice(start, start + len(done))
            depth, radius, worked, stored, wasted, ring = done.T
            far = np.nonzero(depth > deepest)[0] if math.isinf(row.bed.rim) else np.empty(0, dtype=int)
            refuse_rings("ViscoelasticIndentation", times[part][: far[0] if far.size else None], ring > 0.0)
            if far.size:
                raise NotConverged(
                    f"ViscoelasticIndentation: at {times[part][far[0]]:.6g} s the body has come deeper than the "
                    "maximum force would have pressed it; allow a smaller tolerance."
                )
            if why:
                raise NotConverged(f"ViscoelasticIndentation: at {times[part.stop]:.6g} s {why}")
            worked, wasted = (np.cumsum(np.append(*each))[1:] for each in ((work, worked), (lost, wasted)))
            work, lost = float(worked[-1]), float(wasted[-1])
            yield row, np.stack([times[part], depth, forces[part], radius, worked, stored, wasted], axis=1)

    def gathered(self, states: Iterable[ViscoelasticState]) -> ViscoelasticSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        return gather(ViscoelasticSolution, self, states)

    def solve(self) -> ViscoelasticSolution:
        """Return the whole path.

        Returns
        -------
        ViscoelasticSolution

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        if is_layered("ViscoelasticIndentation", self.bed):
            rows = np.array([point.numbers() for _, point in self._layered()])
        else:
            rows = np.concatenate([numbers for _, numbers in self._stretches(BLOCK)])
        time, depth, force, radius, work, stored, lost = rows.T
        return ViscoelasticSolution(time, depth, force, radius, work, stored, lost, self)


@value
class ViscoelasticSolution(RoundPress[Array], Looped):
    """The solution of a `ViscoelasticIndentation`, point by point; its numbers are those of `RoundPress`.

    Parameters
    ----------
    problem : ViscoelasticIndentation
        The problem that was solved.
    """

    problem: ViscoelasticIndentation

    @property
    def _loop(self) -> PathLoop:
        return PathLoop((self.problem.path.across,), self.depth, self.force, self.dissipation)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: assumptions, slopes and size of the body at its deepest."""
        bed = self.problem.bed
        balance = energy_note(self.work, self.stored_energy, self.dissipation)
        own = (*path_notes(bed.medium, self.time), balance, *self._cycle_notes)
        if is_layered("validity", bed):
            return layered_notes(self.problem, self, own)
        return relaxing_notes(bed, self.depth, self.radius, own)
