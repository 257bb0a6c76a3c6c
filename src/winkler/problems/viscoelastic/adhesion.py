r"""Adhesion of rubber on separated scales of time: a relaxed body, whose edge opens at a speed that its pull decides.

The edge of the contact is a crack.  It recedes as fast as what is released there makes it,

.. math:: \mathcal G(a,d) = \frac{k'(a)\,(g(a)-d)^2}{4\pi a} = w(\dot a) , \qquad d + F/k_\mathrm{m} = D(t) ,

and closes without delay where that falls to the work of slow opening.  Between two points of the path the machine moves
steadily; of its work what is not stored is lost.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.on_medium import OnMedium
from winkler.laws.adhesion import ShortRange
from winkler.laws.crack import CrackLaw
from winkler.loading.loads import Depth, Shift
from winkler.loading.path import Path
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.media.offers import offers
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.media.relaxing.proportional import RelaxingInProportion
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.types import Array, PerLoad, Q
from winkler.problems.adhesion.edge import LoadingMachine, adhesive_edge
from winkler.problems.adhesion.validity import adhesive_notes
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import ADHESIVE, BALANCED, RELAXING
from winkler.problems.assumptions.energy import energy_note
from winkler.problems.last_cycle import Looped, PathLoop
from winkler.problems.normal.unknown_yield import relaxing_yield
from winkler.problems.viscoelastic.adhesion_crack import Crack
from winkler.values.checks.number_checks import POSITIVE_OR_INFINITE, Advice
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

__all__ = ["RubberCrack", "ViscoelasticAdhesion", "ViscoelasticAdhesionSolution", "ViscoelasticAdhesionState"]

RESTING_EXCESS = 1e-8
"""An edge that is driven by this part more than slow opening takes does not move."""


@value
class RubberCrack(PerLoad[Q]):
    """An adhesive contact of rubber at a moment, or at the points of its path.

    Parameters
    ----------
    time : float or ndarray, (steps,)
        [s].
    position : float or ndarray, (steps,)
        D [m], where the far end of the machine stands.
    depth, force, radius : float or ndarray, (steps,)
        d [m], F_N [N], a [m]; force and radius are zero apart.
    crack_speed : float or ndarray, (steps,)
        How fast the edge recedes [m/s]; zero where it rests or closes, infinite where nothing holds it.
    lowest_force : float or ndarray, (steps,)
        The lowest force since the beginning [N], negative if the bodies were pulled.
    work, energy : float or ndarray, (steps,)
        What the machine has spent since the beginning, and energy of bodies, machine and surfaces, less what closing
        has gained [J]; zero apart.
    dissipation : float or ndarray, (steps,)
        Energy lost since the beginning [J], in jumps and by opening.
    """

    __words__ = words(
        position=("D", "m", "where the far end of the machine stands"),
        work=("W", "J", "what the machine has spent since the beginning"),
    )

    time: Q
    position: Q
    depth: Q
    force: Q
    radius: Q
    crack_speed: Q
    lowest_force: Q
    work: Q
    energy: Q
    dissipation: Q


@value
class ViscoelasticAdhesionState(RubberCrack[float]):
    """An adhesive contact of rubber at one moment; its numbers are those of `RubberCrack`."""


MACHINE_STIFFNESS_RANGE = POSITIVE_OR_INFINITE._replace(demand="it must be positive{unit}, infinite for fixed grips")


@value
class ViscoelasticAdhesion:
    """A body that sticks to rubber, pressed on and pulled off along a path.

    The bodies are apart at the beginning and first approach slowly up to the first point of the path.

    Parameters
    ----------
    bed : Bed
        Foundation(profile, medium); a medium that relaxes counts as relaxed, and RelaxingInProportion must state the
        moduli of that state.
    law : RateDependentWork or SaturatingWork
        What opening takes at which speed.
    path : Path
        Positions of the far end of the machine over time, Path(time, Depth([...])).
    machine_stiffness : float, optional
        k_m [N/m] of the spring between far end and contact; infinite for fixed grips, a soft one is almost a dead load.

    Raises
    ------
    InvalidInput
        If the bed flows for ever, its moduli are not the relaxed ones, the law has no speed, the path prescribes
        forces or moves along the surface, or the stiffness is not positive.

    References
    ----------
    D. Maugis, M. Barquins, J. Phys. D: Appl. Phys. 11 (1978) 1989-2023, doi:10.1088/0022-3727/11/14/011;
    M. Ciavarella, J. Adhes. Sci. Technol. (2021), doi:10.1080/01694243.2021.1882766

    Examples
    --------
    A ball with w_0 = 50 mJ/m^2 is pulled off rubber, slowly with 3/2 pi w_0 R (JKR), and faster with more.

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.laws.crack import RateDependentWork
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1e-3), HalfSpace(Elastic(young=1e6, poisson=0.5)))
    >>> law = RateDependentWork(work=0.05, reference_speed=1e-6, exponent=0.6)
    >>> for speed in (1e-12, 1e-8, 1e-7):
    ...     pulled = ViscoelasticAdhesion(bed, law, Path([0.0, 5e-5 / speed], Depth([5e-6, -45e-6]))).solve()
    ...     print(round(-pulled.lowest_force[-1] / (np.pi * 0.05 * 1e-3), 2))
    1.5
    1.94
    3.03
    """

    bed: Bed
    law: Annotated[CrackLaw, Advice("laws without a speed are those of AdhesiveCycle")]
    path: Path
    machine_stiffness: Annotated[float, MACHINE_STIFFNESS_RANGE] = math.inf

    references: ClassVar[tuple[str, ...]] = (
        "popov_hess_2015",
        "maugis_barquins_1978",
        "johnson_kendall_roberts_1971",
        "ciavarella_2021",
    )
    assumptions: ClassVar[frozenset[Assumption]] = ADHESIVE | RELAXING | BALANCED
    needs_round: ClassVar[str] = "adhesion, whose edge runs round the contact,"

    def __post_init__(self) -> None:
        medium = self.bed.medium
        if isinstance(medium, ViscoelasticHalfSpace) and medium.relaxation.relaxed == 0.0:
            raise InvalidInput(
                "ViscoelasticAdhesion: the body flows for ever and has no relaxed state to be pulled off from; give a "
                "solid with a relaxed modulus."
            )
        if isinstance(medium, RelaxingInProportion) and not math.isclose(medium.relaxation.relaxed, 1.0):
            raise InvalidInput(
                f"ViscoelasticAdhesion: the moduli of the medium belong to the shear modulus {medium.shear:g} Pa, and "
                "the body is taken as relaxed; give RelaxingInProportion(medium, solid, shear) with the relaxed moduli "
                f"in the medium and the relaxed shear modulus {medium.solid.series.relaxed:g} Pa."
            )
        if not isinstance(self.path.normal, Depth):
            raise InvalidInput(
                f"ViscoelasticAdhesion: a {type(self.path.normal).__name__} is prescribed; give Path(time, "
                "Depth([...])): a dead load is almost a machine with little stiffness."
            )
        if not isinstance(self.path.lateral, Shift) or np.any(self.path.along != 0.0):
            raise InvalidInput("ViscoelasticAdhesion: the path moves along the surface; leave the lateral load out.")

    @property
    def _relaxed(self) -> Bed:
        """The bed when all has relaxed."""
        medium = self.bed.medium
        if not offers(medium, RelaxingMedium):
            return self.bed
        assert isinstance(self.bed, OnMedium)
        if offers(medium, RelaxingByWaves):
            return self.bed.with_medium(medium.relaxed)
        if isinstance(medium, RelaxingInProportion):
            return self.bed.with_medium(medium.elastic)
        return self.bed.with_medium(HalfSpace(Elastic(medium.relaxation.relaxed, 0.0)))

    @property
    def total(self) -> int:
        """How many states `steps` yields: one for every point of the path."""
        return self.path.time.size

    def steps(self) -> Iterator[ViscoelasticAdhesionState]:
        """Yield the state at every point of the path.

        Raises
        ------
        OutsideValidity
            If the contact grows beyond what is known of the profile or is no disc: at that step, the states before it
            have been yielded.
        NotConverged
            If the edge cannot be followed.
        """
        law, machine = self.law, LoadingMachine(1.0 / self.machine_stiffness)
        times, positions = self.path.time.tolist(), self.path.across.tolist()
        edge = adhesive_edge(self._relaxed, ShortRange(law.work), machine, max(positions))
        crack = Crack(edge, machine, law)
        crack.close(positions[0], positions[0])
        for i, (time, position) in enumerate(zip(times, positions, strict=True)):
            if i:
                crack.follow(positions[i - 1], position, time - times[i - 1])
            depth, force, release = crack.at(crack.radius, position)
            crack.lowest = min(crack.lowest, force)
            speed = float(law.speed(release)) if release > (1.0 + RESTING_EXCESS) * law.work else 0.0
            energy = crack.energy(crack.radius, position)
            yield ViscoelasticAdhesionState(
                time, position, depth, force, crack.radius, speed, crack.lowest, crack.work, energy, crack.lost
            )

    def gathered(self, states: Iterable[ViscoelasticAdhesionState]) -> ViscoelasticAdhesionSolution:
        """Return the solution made of these states, of the whole path or of its beginning."""
        return gather(ViscoelasticAdhesionSolution, self, states)

    def solve(self) -> ViscoelasticAdhesionSolution:
        """Return the whole path.

        Returns
        -------
        ViscoelasticAdhesionSolution

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class ViscoelasticAdhesionSolution(RubberCrack[Array], Looped):
    """The solution of a `ViscoelasticAdhesion`, point by point; its numbers are those of `RubberCrack`.

    Parameters
    ----------
    problem : ViscoelasticAdhesion
        The problem that was solved.
    """

    problem: ViscoelasticAdhesion

    @property
    def _loop(self) -> PathLoop:
        return PathLoop((self.problem.path.across,), self.position, self.force, self.dissipation)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        problem = self.problem
        law = ShortRange(problem.law.work)
        contact = adhesive_notes(problem._relaxed, law, self.depth, self.radius)
        balance = energy_note(self.work, self.energy, self.dissipation)
        return (SEPARATED, *contact, balance, *relaxing_yield(problem.bed.medium), *self._cycle_notes)


SEPARATED = Note(
    Assumption.ADHESION,
    Standing.APPROXIMATE,
    "What is viscous happens at the edge alone. The body is taken as relaxed, which holds if the contact's size over "
    "the speed of the edge is far longer than the relaxation times. The edge closes without delay, and the work of "
    "opening follows its law, whatever the speed.",
    "D. Maugis, M. Barquins, J. Phys. D: Appl. Phys. 11 (1978) 1989-2023, doi:10.1088/0022-3727/11/14/011",
)
