r"""Torsion with friction: two bodies pressed together and twisted about the axis of their contact, along any path.

Torsion of a round contact is exact in springs.  A spring at x is displaced by :math:`\varphi x`, it carries

.. math:: q(x) = 8G_t\,\varphi\,x ,\qquad |q(x)| \le 4\mu x\int_x^a\frac{p(r)\,\mathrm dr}{\sqrt{r^2-x^2}} ,\qquad
          M_z = 2\int_0^a x\,q\,\mathrm dx ,\qquad \frac1{G_t} = \frac1{G_1}+\frac1{G_2} ,

its bound depends on the pressure of all rings farther out.  What sticks is the inner part of the contact: towards the
axis the bound grows without limit against the displacement, so that no finite angle makes all of it slide, and the
greatest torque is only approached.  On layers other springs are as exact (`winkler.media.twisting.kernels`), since
a twist and a pressure do not act on each other there either; on bodies graded in depth tables err by 2e-5 to 2e-4.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar

from winkler.foundation.bed import Bed
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Angle, Torque
from winkler.loading.path import Path
from winkler.media.relaxing.relaxing_medium import relaxes
from winkler.media.twisting.kernels import twisted_medium
from winkler.numerics.types import Array
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import BALANCED, PRESSED, RELAXING
from winkler.problems.assumptions.energy import energy_note
from winkler.problems.friction.torsion_states import TorsionState
from winkler.problems.friction.torsion_validity import torsion_notes, torsion_yield_notes
from winkler.problems.last_cycle import Looped, PathLoop
from winkler.problems.normal.validity import contact_notes
from winkler.problems.one_load import OfPath
from winkler.problems.ring_slip.ring_path import ring_points
from winkler.problems.ring_slip.ring_states import TwistedSprings
from winkler.problems.round_march import RoundTwist
from winkler.problems.viscoelastic.tangential import Relaxed, pressed_alone
from winkler.problems.viscoelastic.torsion import DraggedTwist, dragged_twist_notes, dragged_twists
from winkler.values.checks.number_checks import Whole, between
from winkler.values.errors import InvalidInput
from winkler.values.limits import RELAXING_SPRINGS
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

TwistState = TorsionState | DraggedTwist
"""The contact at one point of a path, of bodies that are elastic, or relax."""


@value
class Torsion:
    """Two bodies pressed together and twisted against each other about the contact axis.

    Parameters
    ----------
    bed : Bed
        Foundation(profile, medium) or PlaneFoundation(plane_profile, medium), elastic or viscoelastic. The
        medium is a homogeneous half-space, layers (bonded or sliding), or a body graded in depth.  Viscoelastic bodies
        have one common relaxation function, or are layers with separate ones.
    law : Coulomb
        Law of friction.
    path : Path
        Its normal load a Depth or Force, its lateral load an Angle or Torque.
    count : int, optional
        Number of springs, where bodies relax; the error falls with its square.
    tolerance : float, optional
        Error of a step on viscoelastic bodies: of the torque over the friction limit, of the frictional loss over this
        torque times the maximum angle, and of depth and angle under forces over their maximum.

    Raises
    ------
    InvalidInput
        If the law is not Coulomb's, the path prescribes a shift.
    OutsideValidity
        If the foundation is a `MeasuredBed`, for which the friction limit of the springs is not known.

    References
    ----------
    J. L. Lubkin, J. Appl. Mech. 18 (1951) 183-187; H. Deresiewicz, J. Appl. Mech. 21 (1954) 52-56; J. Jaeger, Arch.
    Appl. Mech. 65 (1995) 478-487, doi:10.1007/BF00835661

    Examples
    --------
    The greatest torque that a ball bears is (3 pi/16) mu F a; under a fifth of it little slides.

    >>> import math
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1.0), HalfSpace(Elastic(young=1.0, poisson=0.3)))
    >>> path = Path([0.0, 1.0], Force(1e-3), Torque([0.0, 5e-6]))
    >>> twist = Torsion(bed, Coulomb(0.5), path).solve()
    >>> round(float(twist.torque_limit[1] / (0.5 * 1e-3 * twist.radius[1]) / math.pi), 12)  # 3/16
    0.1875
    >>> round(float(twist.stick_radius[1] / twist.radius[1]), 6)
    0.938664
    """

    __words__ = words(
        relaxes=("", None, "whether the bodies relax"),
        count=("n", "", "how many springs"),
    )

    bed: Bed
    law: Coulomb
    path: Path
    count: Annotated[int, Whole(2, RELAXING_SPRINGS)] = 400
    tolerance: Annotated[float, between(1e-12, 0.1)] = 1e-5

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "lubkin_1951", "deresiewicz_1954", "jaeger_1995")
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING | PRESSED | BALANCED | {Assumption.SLIP}
    needs_round: ClassVar[str] = "torsion"

    def __post_init__(self) -> None:
        if not isinstance(self.path.lateral, Angle | Torque):
            raise InvalidInput(
                f"Torsion: the path prescribes a {type(self.path.lateral).__name__}; give Path(time, normal, lateral) "
                "with the lateral load Angle([...]) or Torque([...])."
            )
        if self.relaxes:
            pressed_alone("Torsion", self.bed, self.path, self.count, self.tolerance)
        else:
            twisted_medium(self.bed.medium)

    @property
    def relaxes(self) -> bool:
        """Whether the bodies are viscoelastic, so that each spring depends on its load history."""
        return relaxes(self.bed.medium)

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one for every point of the path."""
        return self.path.time.size

    def steps(self) -> Iterator[TwistState]:
        """Yield the state at every point of the path.

        Raises
        ------
        OutsideValidity
            If a torque exceeds the friction limit: at that step, the states before it have been yielded.  If the
            contact grows beyond the known range of the profile, or is not a disc.
        NotConverged
            If the profile is too rough, or a step too long for the angle or the loss to settle.
        """
        if self.relaxes:
            yield from dragged_twists(self.bed, self.law, self.path, self.count, self.tolerance)
            return
        unit = 8.0 * twisted_medium(self.bed.medium).torsional_modulus
        for normal, at, limit, springs in ring_points(self.bed, self.law.coefficient, self.path, unit, TwistedSprings):
            energies = at.work, at.stored, at.lost
            yield TorsionState(*normal, at.motion, at.load, limit, at.stick_radius, *energies, at.nested, springs)

    def gathered(self, states: Iterable[TwistState]) -> TorsionSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        return gather(TorsionSolution, self, states)

    def solve(self) -> TorsionSolution:
        """Return the whole path.

        Returns
        -------
        TorsionSolution

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class TorsionSolution(RoundTwist[Array], Looped, Relaxed, OfPath[TwistState]):
    """The solution of a `Torsion`, point by point; its numbers are those of `RoundTwist`.

    Parameters
    ----------
    problem : Torsion
        The problem that was solved.
    nested : ndarray of bool, (steps,)
        Whether the slip zone of the step was one outer annulus with one slip direction; then the step is exact.
    states : tuple of TorsionState or DraggedTwist
        The states one by one, with the springs from which fields are computed.
    """

    __words__ = words(secant_stiffness=("k_s", "N m/rad", "amplitude of the torque over that of the angle"))

    problem: Torsion
    nested: Array
    states: tuple[TwistState, ...]

    @property
    def _loop(self) -> PathLoop:
        path = self.problem.path
        return PathLoop((path.across, path.along), self.angle, self.torque, self.dissipation)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        problem = self.problem
        bed = problem.bed
        balance = energy_note(self.work, self.stored_energy, self.dissipation), *self._cycle_notes
        dragged = [state for state in self.states if isinstance(state, DraggedTwist)]
        if dragged:
            return (*dragged_twist_notes(bed, dragged), *balance)
        states = [state for state in self.states if isinstance(state, TorsionState)]
        contact = (*bed.notes, *contact_notes(bed, self.depth, self.radius), *torsion_yield_notes(bed, states))
        by_torque = isinstance(problem.path.lateral, Torque)
        return (*contact, *torsion_notes(bed, problem.law, states, by_torque), *balance)
