r"""Damping by friction: what a contact loses when it is pushed to and fro under a steady normal load.

Every spring is elastic up to its friction bound :math:`b(x)=\mu c_N(d-g)/c_T` and slides beyond it.  Pushed to and fro
by
:math:`\pm U` it runs round a parallelogram, and the contact loses

.. math:: W = 8\int_{b<U} c_T\,b\,(U-b)\,\mathrm dx ,\qquad F_x(U) = 2\int_0^a c_T\min(b,U)\,\mathrm dx

per cycle: the loop of Mindlin and Deresiewicz for every profile.  Of small amplitudes it is the cube,
:math:`W\to\tfrac43 G^{*2}U^3/(\mu E^*g'(a))`; beyond gross slip each further :math:`\mathrm dU` costs
:math:`4\mu F_N\mathrm dU`.  A static shift or shear force about which the contact oscillates changes nothing, as long
as the whole does not slide away: the loop depends on the amplitude alone.

Bodies that relax lose energy inside, too, and as much as the frequency has it.  There the shift or the shear force is
harmonic, and springs that relax are followed until their cycles repeat (`winkler.problems.viscoelastic.steady_cycle`).
"""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.friction import Sliding
from winkler.loading.loads import ShearForce, Shift
from winkler.loading.path import SWING, OneNormal, numbers_of
from winkler.media.relaxing.relaxing_medium import relaxes
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import RELAXING, SHEARED
from winkler.problems.friction.damping_springs import SlippingSprings
from winkler.problems.friction.damping_validity import damping_notes
from winkler.problems.last_cycle import loss_factor, per_unit
from winkler.problems.method import Method
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.normal.yield_statement import SurfaceFriction, slid_depth
from winkler.problems.ring_slip.push_bound import exact_ratio, pushed_body
from winkler.problems.ring_slip.pushed_rings import PushedRings, pushed_rings
from winkler.problems.viscoelastic.states import ViscoelasticState
from winkler.problems.viscoelastic.steady_cycle import (
    SteadyCycle,
    Swing,
    check_cycles,
    depth_at_rest,
    steady_cycle,
    swing_notes,
)
from winkler.values.checks.number_checks import NonNegative, Whole, between
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.limits import RELAXING_SPRINGS
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

FORCE_ROUNDING = 1e-12
"""Part of the sliding force by which rounding may exceed it."""


@value
class FrictionDamping(PerLoad[Q]):
    """A contact under a steady normal load and oscillating tangential displacement.

    Parameters
    ----------
    bed : Bed
        The springs: Foundation(profile, medium) or another bed.
    law : Coulomb
        Friction; its coefficient must be positive and finite.
    normal : Depth or Force
        The steady normal load, one number.
    amplitude : Shift or ShearForce
        Amplitude to each side, half of the stroke. For an array the results have its shape.  Zero or more.
    method : Method, optional
        Method for stick and slip. By default annular elements (RINGS) on bonded layers and graded bodies if slip
        begins at the edge, otherwise springs.
    frequency : float, optional
        Frequency of the oscillation [Hz] for viscoelastic bodies; not allowed for elastic ones.
    count : int, optional
        Number of springs of viscoelastic bodies; the error falls with its square, without slip linearly.
    tolerance : float, optional
        On viscoelastic bodies the error of a step, as in `Tangential`.

    Raises
    ------
    InvalidInput
        If the law is not Coulomb's, its coefficient not positive and finite, the normal load an array, or an amplitude
        negative.  If viscoelastic bodies have no frequency, are liquids at long times, or have a dashpot in
        parallel. If elastic bodies have a frequency.
    OutsideValidity
        If RINGS are requested on another medium, or for a contact that is not a disc.

    References
    ----------
    R. D. Mindlin, H. Deresiewicz, J. Appl. Mech. 20 (1953) 327-344, doi:10.1115/1.4010702; V. L. Popov, M. Hess, Method
    of Dimensionality Reduction, Springer 2015, doi:10.1007/978-3-642-53876-6

    Examples
    --------
    The loss of a ball at six tenths of the sliding force, in units of (mu F)^2 / (a G*).

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> medium = HalfSpace(Elastic(young=1.0, poisson=0.3))
    >>> bed = Foundation(Paraboloid(1.0), medium)
    >>> swing = FrictionDamping(bed, Coulomb(0.5), Force(1e-3), ShearForce(3e-4)).solve()
    >>> round(swing.loss_per_cycle * swing.contact.radius * medium.shear_modulus / 0.5e-3**2, 9)
    0.041057384
    """

    __words__ = words(
        amplitude=("", None, "amplitude of the shift or of the shear force"),
        relaxes=("", None, "whether the bodies relax"),
        count=("n", "", "how many springs"),
    )

    bed: Bed
    law: Sliding
    normal: OneNormal
    amplitude: Annotated[Shift[Q] | ShearForce[Q], SWING]
    method: Method = Method.AUTO
    frequency: NonNegative = 0.0
    count: Annotated[int, Whole(2, RELAXING_SPRINGS)] = 400
    tolerance: Annotated[float, between(1e-12, 0.1)] = 1e-5

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "mindlin_deresiewicz_1953", "ciavarella_1998")
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING | SHEARED | {Assumption.INERTIA, Assumption.STEADY}
    needs_round: ClassVar[str] = ""

    def __post_init__(self) -> None:
        check_cycles("FrictionDamping", self.bed, self.frequency, self.method)
        if self.method is Method.RINGS:
            pushed_body(self.bed, "FrictionDamping")

    @property
    def relaxes(self) -> bool:
        """Whether the bodies are viscoelastic, so that results depend on the frequency."""
        return relaxes(self.bed.medium)

    def solve(self) -> FrictionDampingSolution[Q]:
        """Return dissipated energy per cycle, stiffness and loss factor.

        Returns
        -------
        FrictionDampingSolution

        Raises
        ------
        OutsideValidity
            If a shear force exceeds the friction limit (coefficient times normal force).  If the bodies do not touch.
            If the method is exact, and the springs have different stiffness ratios. If the method is RINGS, and no
            annulus slips before full sliding.
        NotConverged
            If the profile is too rough, or cycles of viscoelastic bodies do not repeat.
        """
        if self.relaxes:
            return self._relaxing()
        contact = Indentation(self.bed, self.normal).solve()
        if float(contact.radius) == 0.0:
            raise OutsideValidity(
                "FrictionDamping: the bodies do not touch under this normal load; press them together."
            )
        prescribed = numbers_of(self.amplitude)
        springs = _springs(self, contact)
        flat = prescribed.ravel()
        if isinstance(self.amplitude, ShearForce):
            force = np.minimum(flat, self._bearable(flat, float(contact.force)))
            moved = springs.shift(force)
        else:
            moved, force = flat, springs.force(flat)
        loss = springs.loss(moved)
        columns: list[Q] = [shaped(each, prescribed.shape) for each in (loss, loss, np.zeros(loss.size), moved, force)]
        return FrictionDampingSolution(self, contact, 0.0, *columns)

    def cycle(self, amplitude: float) -> SteadyCycle:
        """Return the cycle of viscoelastic bodies at one amplitude [m] or [N]."""
        depth, lateral = depth_at_rest(self.bed, self.normal), type(self.amplitude)
        swing = Swing(1.0 / self.frequency, depth, 0.0, lateral, amplitude, -0.5 * math.pi)
        return steady_cycle("FrictionDamping", self.bed, self.law, swing, self.count, self.tolerance)

    def _relaxing(self) -> FrictionDampingSolution[Q]:
        """Return the loss per cycle of bodies that relax."""
        prescribed = numbers_of(self.amplitude)
        flat, rest = prescribed.ravel(), self.cycle(0.0)
        if isinstance(self.amplitude, ShearForce):
            flat = np.minimum(flat, self._bearable(flat, rest.contact.force))
        cycles = [self.cycle(each) if each > 0.0 else rest for each in flat.tolist()]
        numbers = [
            (cycle.loss, cycle.friction, cycle.bulk, 0.5 * np.ptp(cycle.shift), 0.5 * np.ptp(cycle.shear_force))
            for cycle in cycles
        ]
        columns: list[Q] = [shaped(each, prescribed.shape) for each in np.reshape(numbers, (flat.size, 5)).T]
        change = max((cycle.change for cycle in cycles), default=0.0)
        return FrictionDampingSolution(self, rest.contact, change, *columns)

    def _bearable(self, targets: Array, force: float) -> float:
        """Return the sliding force [N]; refuse what exceeds it."""
        most = self.law.coefficient * force
        bad = np.flatnonzero(targets > most * (1.0 + FORCE_ROUNDING))
        if bad.size:
            where = "" if targets.size == 1 else f" at index {', '.join(map(str, bad[:5]))}"
            raise OutsideValidity(
                f"FrictionDamping: a shear force of {targets[bad[0]]:.6g} N{where} exceeds the coefficient of "
                f"friction times the normal force, {most:.6g} N: the bodies would slide away; give less, or "
                "prescribe a Shift."
            )
        return most


@value
class DampingSolution(PerLoad[Q]):
    """What solutions of damping by friction have in common.

    Parameters
    ----------
    problem
        The problem that was solved.
    contact : IndentationSolution or ViscoelasticState
        The contact at its greatest depth; of bodies that relax in the cycle that repeats.
    cycle_change : float
        Part of loss or force by which the last two cycles of bodies that relax differ [-]; zero of elastic ones.
    loss_per_cycle : float or ndarray
        Energy lost in every closed cycle [J].
    friction_loss, bulk_loss : float or ndarray
        The parts of it that friction takes, and that bodies which relax lose inside [J].  Where nothing slides friction
        takes what springs hold when they part.
    """

    __words__ = words(
        cycle_change=("", "", "part of loss or force by which the last two cycles differ"),
        friction_loss=("W_f", "J", "energy lost to friction in a cycle"),
        bulk_loss=("W_b", "J", "energy lost in the bodies in a cycle"),
    )

    problem: Any
    contact: IndentationSolution[float] | ViscoelasticState
    cycle_change: float
    loss_per_cycle: Q
    friction_loss: Q
    bulk_loss: Q

    @property
    def loss_stiffness(self) -> Q:
        """Loss per cycle over pi times the square of the shift [N/m]."""
        raise NotImplementedError

    def damping(self, frequency: float) -> Q:
        """Return the viscous damper that loses as much.

        Parameters
        ----------
        frequency : float
            Of the oscillation along the surface [Hz]; of bodies that relax the prescribed one.

        Returns
        -------
        float or ndarray
            W / (2 pi^2 f U^2) [N s/m].

        Raises
        ------
        InvalidInput
            If the frequency is not positive, or not that at which bodies that relax oscillate.
        """
        problem, given = self.problem, positive_frequency(frequency)
        prescribed = problem.frequency * getattr(problem, "lateral_cycles", 1)
        if problem.relaxes and not math.isclose(given, prescribed, rel_tol=1e-9):
            raise InvalidInput(
                f"frequency: {given:.6g} Hz is given, but the bodies relax, and the loss is that at {prescribed:.6g} "
                "Hz; give this one, or solve the problem at the other."
            )
        return shaped(np.asarray(self.loss_stiffness) / (2.0 * np.pi * given))


@value
class FrictionDampingSolution(DampingSolution[Q]):
    """The solution of a `FrictionDamping`; every quantity has the shape of the amplitude.

    Parameters
    ----------
    problem : FrictionDamping
        The problem that was solved.
    shift : float or ndarray
        Amplitude of the shift [m].
    shear_force : float or ndarray
        Amplitude of the shear force [N].
    """

    problem: FrictionDamping[Q]
    shift: Q
    shear_force: Q

    @property
    def secant_stiffness(self) -> Q:
        """Amplitude of the shear force over that of the displacement [N/m]; at zero amplitude that without slip."""
        moving = np.asarray(self.shift) > 0.0
        stuck = 0.0
        if not np.all(moving):
            at_rest = self.contact
            if isinstance(at_rest, ViscoelasticState):
                stuck = self.problem.cycle(0.0).stuck
            else:
                stuck = _springs(self.problem, at_rest).stiffness
        return shaped(np.where(moving, self.shear_force / np.where(moving, self.shift, 1.0), stuck))

    @property
    def loss_stiffness(self) -> Q:
        """W / (pi U^2) [N/m], the imaginary part of the equivalent linear spring.

        Divided by the angular frequency it is the constant of the equivalent viscous damper.
        """
        return per_unit(self.loss_per_cycle, np.pi * np.asarray(self.shift) ** 2)

    @property
    def loss_factor(self) -> Q:
        """W / (pi F_x U) [-]: the loss per radian over the maximum energy of a spring with the secant stiffness.

        It is zero at zero amplitude, 4/pi for full sliding, and equals twice the damping ratio.  For viscoelastic
        bodies without slip it is the sine of the loss angle.
        """
        return loss_factor(self.loss_per_cycle, self.shift, self.shear_force)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        stated = self.problem
        if isinstance(self.contact, ViscoelasticState):
            return swing_notes(stated.bed, stated.law, 1.0 / stated.frequency, self.contact)
        mu, shape = self.problem.law.coefficient, np.shape(self.shear_force)
        depth, force = (np.broadcast_to(part, shape) for part in (self.contact.depth, self.contact.force))
        rubbing = SurfaceFriction(mu, slid_depth(mu, depth, force, np.asarray(self.shear_force)))
        rings = isinstance(_springs(self.problem, self.contact), PushedRings)
        return (
            *self.contact.notes_with(rubbing),
            *damping_notes(self.problem.bed, float(self.contact.radius), mu, rings),
        )


def _springs(problem: FrictionDamping, contact: IndentationSolution) -> SlippingSprings | PushedRings:
    """Return what slides by the method of a problem: rings of layers with their own kernels, or springs."""
    bed, coefficient, radius = problem.bed, problem.law.coefficient, float(contact.radius)
    if problem.method in (Method.AUTO, Method.RINGS):
        rings = pushed_rings(bed, coefficient, float(contact.depth), radius)
        if rings:
            return rings
        if problem.method is Method.RINGS:
            raise OutsideValidity(
                "FrictionDamping: no annulus slips before full sliding of this contact; give the method "
                f"{Method.SPRINGS}."
            )
    if problem.method is Method.EXACT:
        exact_ratio("FrictionDamping", bed, radius)
    return SlippingSprings(coefficient, contact)


def positive_frequency(frequency: float) -> float:
    """Return a frequency [Hz]; refuse one that is not positive and finite."""
    if isinstance(frequency, bool) or not isinstance(frequency, int | float) or not 0.0 < frequency < math.inf:
        raise InvalidInput(f"frequency: {frequency!r} is not positive and finite; give one number in Hz.")
    return float(frequency)
