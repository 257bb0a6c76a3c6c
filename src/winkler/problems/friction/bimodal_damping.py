r"""Pressed and pushed at the same time: what a contact loses when its depth and its shift both oscillate.

.. math:: d = d_0 + A_z\cos n\theta ,\qquad U = A_x\cos(m\theta+\varphi)

Every spring runs through its own closed cycle, known without steps in time
(`winkler.problems.friction.spring_cycle`); the loss is their sum.  On layers and gradings rings are followed in steps
(`winkler.problems.ring_slip.steady_loss`).  Where nothing slides (infinite coefficient)
springs lose what they hold when they part,

.. math:: W = 4A_x^2\,S\int c_T(x)\,\sin^2\!\bigl(\tfrac mn\tau\bigr)\,\mathrm dx,\qquad
          \cos\tau = \frac{g(x)-d_0}{A_z},\qquad
          S = \begin{cases}\sin^2\varphi & n = 1\\ 2\sin^2\varphi & n = 2\ (m\text{ odd})\\ n/2 & n\ge3\end{cases}

which is relaxation damping: for m = n = 1 and small :math:`A_z` it is
:math:`\tfrac83(\mathrm dk_x/\mathrm dd)A_x^2|A_z|\sin^2\varphi`.
"""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Depth, Shift
from winkler.loading.path import Path
from winkler.media.relaxing.relaxing_medium import relaxes
from winkler.numerics.integrals.bisected_quadrature import along_springs, towards
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import RELAXING, SHEARED
from winkler.problems.friction.damping import DampingSolution
from winkler.problems.friction.damping_springs import oscillating_contact
from winkler.problems.friction.damping_validity import STEADY, damping_notes
from winkler.problems.friction.spring_cycle import SpringCycle
from winkler.problems.last_cycle import per_unit
from winkler.problems.method import Method, refuse_method
from winkler.problems.normal.yield_statement import SurfaceFriction
from winkler.problems.ring_slip.moving_notes import IN_CYCLES, moving_ring_notes
from winkler.problems.ring_slip.push_bound import pushed_body
from winkler.problems.ring_slip.ring_table import RingTable
from winkler.problems.ring_slip.sliding_springs import sliding_springs
from winkler.problems.ring_slip.steady_loss import STEPS_PER_CYCLE, cycle_steps, loss_of_cycle
from winkler.problems.viscoelastic.states import ViscoelasticState
from winkler.problems.viscoelastic.steady_cycle import SteadyCycle, Swing, check_cycles, steady_cycle, swing_notes
from winkler.values.checks.field_checks import Condition
from winkler.values.checks.number_checks import (
    FINITE_QUANTITY,
    NON_NEGATIVE_QUANTITY,
    Advice,
    Count,
    Finite,
    NonNegative,
    Whole,
    affordable,
    between,
)
from winkler.values.errors import InvalidInput
from winkler.values.limits import MOST_SPRINGS, RELAXING_SPRINGS
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

TOLERANCE = 1e-12
"""Of the integral over the springs."""
EDGE_HALVINGS = 30
"""How often the panels halve their distance from the edges of the widest and the narrowest contact."""

WITH_FRICTION = Condition(
    lambda law: law.coefficient > 0.0,
    "give Coulomb(coefficient) with a positive coefficient, infinite if nothing slides",
)
AMPLITUDE_ADVICE = Advice("how far to each side; turn the phase by pi instead of a negative one")


@value
class BimodalDamping(PerLoad[Q]):
    """A contact with harmonic normal and tangential motion, d_0 + A_z cos(.) and A_x cos(. + phase).

    Parameters
    ----------
    bed : Bed
        The foundation, on a homogeneous or power-law medium, bonded layers or a body graded in depth. Without slip, on
        any medium with known k_x.
    law : Coulomb
        Law of friction. An infinite coefficient excludes slip (relaxation damping); zero is not supported.
    depth : float
        Mean depth d_0 [m].
    depth_amplitude : float
        A_z [m], zero or more; beyond the mean depth the bodies separate in every cycle.
    shift_amplitude : float or ndarray
        A_x [m], zero or more.
    phase : float or ndarray
        Phase by which the tangential displacement is ahead of the depth [rad], within its own cycle.
    normal_cycles, lateral_cycles : int, optional
        Numbers of normal and tangential oscillations in a closed cycle, without a common divisor.  A frequency ratio
        of 3/2 is three lateral cycles to two normal ones.
    method : Method, optional
        Method for stick and slip: AUTO, EXACT (all springs of equal gap together) or RINGS (annular elements). By
        default springs if all have one stiffness ratio, otherwise annular elements.
    frequency : float, optional
        Frequency of the closed cycle [Hz] for viscoelastic bodies; not allowed for elastic ones.
    count : int, optional
        Number of springs of viscoelastic bodies; the error falls with its square, without slip linearly.
    tolerance : float, optional
        On viscoelastic bodies the error of a step, as in `Tangential`.

    Raises
    ------
    InvalidInput
        If one of them is out of bounds, the shapes do not go together, or the method is another one.  If viscoelastic
        bodies have no frequency, are liquids at long times, or have a dashpot in parallel. If elastic bodies
        have a frequency.
    OutsideValidity
        If rings are requested on a medium that does not support them, or for a contact that is not a disc.

    References
    ----------
    M. Popov, V. L. Popov, R. Pohrt, Sci. Rep. 5 (2015) 16189, doi:10.1038/srep16189

    Examples
    --------
    In phase a cone that does not slide loses nothing; a quarter of a cycle apart it loses most.

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.conical import Cone
    >>> bed = Foundation(Cone(half_angle=1.4), HalfSpace(Elastic(1.0, 0.0)))
    >>> swing = BimodalDamping(bed, Coulomb(math.inf), depth=0.1, depth_amplitude=0.02, shift_amplitude=0.01,
    ...                        phase=np.array([0.0, math.pi / 2])).solve()
    >>> swing.loss_per_cycle / (16 / 3 * bed.medium.shear_modulus * 0.01**2 * 0.02 / bed.gap_slope(np.ones(1)))
    array([0., 1.])
    """

    __words__ = words(relaxes=("", None, "whether the bodies relax"), count=("n", "", "how many springs"))

    bed: Bed
    law: Annotated[Coulomb, WITH_FRICTION]
    depth: Finite
    depth_amplitude: Annotated[NonNegative, AMPLITUDE_ADVICE]
    shift_amplitude: Annotated[Q, NON_NEGATIVE_QUANTITY, AMPLITUDE_ADVICE]
    phase: Annotated[Q | float, FINITE_QUANTITY] = 0.0
    normal_cycles: Count = 1
    lateral_cycles: Count = 1
    method: Method = Method.AUTO
    frequency: NonNegative = 0.0
    count: Annotated[int, Whole(2, RELAXING_SPRINGS)] = 400
    tolerance: Annotated[float, between(1e-12, 0.1)] = 1e-5

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "popov_popov_pohrt_2015", "jaeger_1995")
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING | SHEARED | {Assumption.INERTIA, Assumption.STEADY}
    needs_round: ClassVar[str] = ""

    def __post_init__(self) -> None:
        check_cycles("BimodalDamping", self.bed, self.frequency, self.method)
        if not self.relaxes:
            refuse_method("BimodalDamping", self.method, (Method.AUTO, Method.EXACT, Method.RINGS))
        if self.method is Method.RINGS:
            pushed_body(self.bed, "BimodalDamping", "")
        affordable("BimodalDamping", "pairs of cycles", self.normal_cycles * self.lateral_cycles, MOST_SPRINGS)
        common = math.gcd(self.normal_cycles, self.lateral_cycles)
        if common > 1:
            raise InvalidInput(
                f"BimodalDamping: {self.normal_cycles} normal and {self.lateral_cycles} lateral cycles close "
                f"{common} times; give {self.normal_cycles // common} and {self.lateral_cycles // common}."
            )
        try:
            np.broadcast_shapes(np.shape(self.shift_amplitude), np.shape(self.phase))
        except ValueError:
            raise InvalidInput(
                f"BimodalDamping: shift_amplitude has the shape {np.shape(self.shift_amplitude)}, phase "
                f"{np.shape(self.phase)}; give shapes that go together."
            ) from None

    @property
    def relaxes(self) -> bool:
        """Whether the bodies are viscoelastic, so that results depend on the frequency."""
        return relaxes(self.bed.medium)

    def solve(self) -> BimodalDampingSolution[Q]:
        """Return the dissipated energy of every closed cycle, in the steady state.

        Returns
        -------
        BimodalDampingSolution

        Raises
        ------
        OutsideValidity
            If the bodies never touch, or the profile ends before the maximum depth. If the springs have different
            stiffness ratios, and the medium is not a coating or the method is exact. If a closed cycle on a coating has
            more than 50 oscillations.
        NotConverged
            If the profile is too rough, or cycles of viscoelastic bodies do not repeat.
        """
        if self.relaxes:
            return self._relaxing()
        deepest, lowest = oscillating_contact("BimodalDamping", self.bed, self.depth, self.depth_amplitude)
        radius = float(deepest.radius)
        ratio, table = 1.0, None
        if not math.isinf(self.law.coefficient):
            ratio, table = sliding_springs("BimodalDamping", self.bed, self.law.coefficient, radius, self.method)
        shape, pairs = self._pairs
        if table is None:
            edges = self._edges(lowest, radius)
            loss = np.array([self._lost(ratio, edges, a, p) for a, p in pairs])
        else:
            loss = self._worn(table, pairs)
        lost: Q = shaped(loss, shape)
        return BimodalDampingSolution(self, deepest, 0.0, lost, lost, shaped(np.zeros(shape)), 0.0)

    @property
    def _pairs(self) -> tuple[tuple[int, ...], list[tuple[float, float]]]:
        """The shape of what is asked for, and each amplitude [m] with its phase [rad]."""
        amplitude, phase = np.broadcast_arrays(self.shift_amplitude, self.phase)
        return amplitude.shape, list(zip(amplitude.ravel().tolist(), phase.ravel().tolist(), strict=True))

    def _relaxing(self) -> BimodalDampingSolution[Q]:
        """Return the loss of every closed cycle of bodies that relax."""
        shape, pairs = self._pairs

        def cycle(amplitude: float, phase: float) -> SteadyCycle:
            swing = Swing(
                1.0 / self.frequency, self.depth, self.depth_amplitude, Shift, amplitude, phase, self.normal_cycles,
                self.lateral_cycles,
            )  # fmt: skip
            return steady_cycle("BimodalDamping", self.bed, self.law, swing, self.count, self.tolerance)

        cycles = [cycle(*pair) for pair in pairs]
        any_cycle = cycles[0] if cycles else cycle(0.0, 0.0)
        numbers = np.reshape([(each.loss, each.friction, each.bulk) for each in cycles], (len(pairs), 3))
        columns: list[Q] = [shaped(each, shape) for each in numbers.T]
        whole, rubbed, inside = columns
        change = max((each.change for each in cycles), default=0.0)
        return BimodalDampingSolution(self, any_cycle.contact, change, whole, rubbed, inside, any_cycle.pressing)

    def path(self, phase: float, shift_amplitude: float, cycles: int = 2, count: int = 200) -> Path:
        """Return the motion as a path of straight pieces, for `Tangential`; its time counts closed cycles.

        Parameters
        ----------
        phase : float
            [rad].
        shift_amplitude : float
            [m].
        cycles : int, optional
            Number of closed cycles.
        count : int, optional
            Points per cycle, evenly spaced, in addition to the reversals of depth and displacement.  The path between
            points is straight, so dissipated energies have an error of second order in the point spacing.
        """
        n, m = self.normal_cycles, self.lateral_cycles
        aside = np.mod(np.arange(2 * m) / 2 - phase / (2.0 * np.pi), m) / m
        points = np.unique(np.concatenate([np.arange(count) / count, np.arange(2 * n) / (2 * n), aside]))
        time = np.append((np.arange(cycles)[:, None] + points).ravel(), float(cycles))
        cycle = self._cycle(1.0, shift_amplitude, phase)
        angle = 2.0 * np.pi * np.mod(time, 1.0)
        return Path(time, Depth(self.depth + cycle.sunk(angle)), Shift(cycle.moved(angle)))

    def _cycle(self, bound: float, pushed: float, ahead: float) -> SpringCycle:
        return SpringCycle(self.depth_amplitude, pushed, ahead, self.normal_cycles, self.lateral_cycles, bound)

    def _lost(self, ratio: float, edges: Array, pushed: float, ahead: float) -> float:
        """Return the loss per closed cycle [J] of one amplitude [m] and phase [rad]."""
        if pushed == 0.0 and not math.isinf(self.law.coefficient):
            # pressing alone moves nothing along the surface
            return 0.0
        bound = self.law.coefficient / ratio
        cycle = self._cycle(bound, pushed, ahead)

        def density(x: Array, _: Array) -> Array:
            gap = self.bed.gap(x) - self.depth
            lost = cycle.released(gap) if math.isinf(bound) else cycle.loss(gap)
            return np.asarray(2.0 * self.bed.tangential_stiffness(x) * lost)

        return float(along_springs(density, edges, np.array([self._tolerance(cycle)]), "loss of the springs")[0])

    def _worn(self, table: RingTable, pairs: list[tuple[float, float]]) -> Array:
        """Return the losses per closed cycle [J] of rings, by amplitude [m] and phase [rad]."""
        n, m = self.normal_cycles, self.lateral_cycles
        angle = np.linspace(0.0, 2.0 * np.pi, STEPS_PER_CYCLE * max(n, m) + 1)
        cycles = [self._cycle(1.0, pushed, ahead) for pushed, ahead in pairs]
        if not cycles:
            return np.zeros(0)
        steps = cycle_steps("BimodalDamping", table, n, m, self.depth + cycles[0].sunk(angle))
        return np.array([loss_of_cycle(table, steps, cycle.moved(angle)) for cycle in cycles])

    def _tolerance(self, cycle: SpringCycle) -> float:
        """Return what rounding spoils: small differences of depths, and of displacements below a high bound."""
        stiff, pushed = not math.isinf(cycle.bound), cycle.shift_amplitude
        span = self.depth_amplitude + (pushed / cycle.bound if stiff else 0.0)
        if span == 0.0:
            return TOLERANCE
        lost = (abs(self.depth) + self.depth_amplitude) / span
        if stiff:
            lost *= 1.0 + cycle.bound * self.depth_amplitude / pushed
        return max(TOLERANCE, 16.0 * np.finfo(float).eps * lost)

    def _edges(self, lowest: float, radius: float) -> Array:
        """Return ends of panels, finest at the edges of the narrowest and the widest contact [m]."""
        kinks = [b for b, _ in self.bed.kinks]
        parts = [towards(radius, kinks, EDGE_HALVINGS)]
        if 0.0 < lowest < radius:
            outside = lowest + (radius - lowest) * 0.5 ** np.arange(1, EDGE_HALVINGS)
            parts += [towards(lowest, [], EDGE_HALVINGS), outside]
        return np.unique(np.concatenate(parts))


@value
class BimodalDampingSolution(DampingSolution[Q]):
    """The solution of a `BimodalDamping`; arrays have the shape of amplitude and phase together.

    Parameters
    ----------
    problem : BimodalDamping
        The problem that was solved.
    pressing_loss : float
        Part of the dissipated energy that is due to the normal motion alone in viscoelastic bodies [J].
    """

    __words__ = words(pressing_loss=("W_d", "J", "energy per cycle that the depth alone would dissipate"))

    problem: BimodalDamping[Q]
    pressing_loss: float

    @property
    def loss_stiffness(self) -> Q:
        """Dissipated energy per tangential cycle over pi A_x^2 [N/m]; over omega the equivalent viscous damper.

        The dissipation due to the normal motion alone is not included.
        """
        moved = np.broadcast_to(self.problem.shift_amplitude, np.shape(self.loss_per_cycle))
        return per_unit(
            shaped(self.loss_per_cycle - self.pressing_loss), np.pi * moved**2 * self.problem.lateral_cycles
        )

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        stated = self.problem
        if isinstance(self.contact, ViscoelasticState):
            return swing_notes(stated.bed, stated.law, 1.0 / stated.frequency, self.contact)
        bed, coefficient, radius = self.problem.bed, self.problem.law.coefficient, float(self.contact.radius)
        by_rings = self.problem.method is Method.RINGS
        rings = () if math.isinf(coefficient) else moving_ring_notes(bed, coefficient, radius, IN_CYCLES, by_rings)
        return (
            *self.contact.notes_with(SurfaceFriction(coefficient)),
            STEADY,
            *rings[1:],
            *damping_notes(bed, radius, coefficient, rings=bool(rings)),
        )
