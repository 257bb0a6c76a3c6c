r"""Impact of a body that sticks: snap-in, loss at pull-off, and the velocity below which it stays.

While the edge of the contact follows Griffith's balance under fixed grips (`winkler.problems.adhesion.cycle`), the body
moves by :math:`m\dot v=-F(d)`, with one curve of forces for the approach and another for the rebound.  Where the edge
loses its hold it runs on at once; what its potential falls by is lost, and so is what opening costs more than closing
has gained.  A ball leaves with

.. math:: e = \sqrt{1-(v_\mathrm{s}/v)^2}, \qquad
          \tfrac12 m v_\mathrm{s}^2 = 7.092\left(\frac{w^5R^4}{E^{*2}}\right)^{1/3},

and not at all if it arrives more slowly than that.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.adhesion import ShortRange
from winkler.loading.loads import Depth
from winkler.numerics.types import Array
from winkler.problems.adhesion.cycle import AdhesiveCycle
from winkler.problems.adhesion.cycle_states import AdhesiveJump
from winkler.problems.adhesion.edge_states import stored_energy
from winkler.problems.adhesion.validity import adhesive_notes
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import ADHESIVE, BALANCED
from winkler.problems.assumptions.energy import energy_note
from winkler.problems.assumptions.inertia import wave_loss, wave_note
from winkler.problems.impact.approach_and_rebound import impact_motion
from winkler.problems.impact.states import AdhesiveImpactHistory, AdhesiveImpactState
from winkler.problems.impact.validity import Moments, gravity_note
from winkler.values.checks.number_checks import Advice, Positive, PositiveNotTiny
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value

__all__ = ["AdhesiveImpact", "AdhesiveImpactSolution"]


RANGE_ADVICE = Advice("attraction from afar begins before the touch")


@value
class AdhesiveImpact:
    """A sticky body strikes a surface, straight.

    Parameters
    ----------
    bed : Bed
        The springs: Foundation(profile, medium).
    law : ShortRange
        ShortRange(work), or with hysteresis ShortRange(work_closing=..., work_opening=...).
    mass : float
        m [kg] of the body; of two free bodies, m1 m2 / (m1 + m2).
    velocity : float
        v [m/s] of approach at first touch, positive.
    count : int, optional
        At how many moments states are returned; the moment of greatest depth is added.

    Raises
    ------
    InvalidInput
        If a number is of the wrong sign or kind, or the law is another one.

    References
    ----------
    C. Thornton, Z. Ning, Powder Technol. 99 (1998) 154-162, doi:10.1016/S0032-5910(98)00099-0

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1.0), HalfSpace(Elastic(1.0, 0.0)))
    >>> sticking = (2.0 * 7.092195972e-5) ** 0.5  # at w = 1e-3 and m = 1
    >>> impact = AdhesiveImpact(bed, ShortRange(1e-3), mass=1.0, velocity=2.0 * sticking).solve()
    >>> round(impact.restitution, 6), round(0.75**0.5, 6)
    (0.866025, 0.866025)
    """

    bed: Bed
    law: Annotated[ShortRange, RANGE_ADVICE]
    mass: PositiveNotTiny
    velocity: Positive
    count: Moments = 201

    references: ClassVar[tuple[str, ...]] = (
        "popov_hess_2015",
        "johnson_kendall_roberts_1971",
        "thornton_ning_1998",
    )
    assumptions: ClassVar[frozenset[Assumption]] = ADHESIVE | BALANCED | {Assumption.INERTIA}
    needs_round: ClassVar[str] = "adhesion, whose edge runs round the contact,"

    @property
    def total(self) -> int:
        """How many states `steps` yields: `count`, and that at the greatest depth if it is none of them."""
        return self.count + 1

    def steps(self) -> Iterator[AdhesiveImpactState]:
        """Yield the state at `count` moments, evenly spaced, and at the greatest depth.

        Raises
        ------
        OutsideValidity
            If the body is pressed in beyond what is known of its profile, or a contact along the path is no disc.
        NotConverged
            If the profile is too rough, or the march comes to a halt.
        """
        moved = impact_motion(self.bed, self.law, self.mass, self.velocity)
        times = np.union1d(np.linspace(0.0, moved.duration, self.count), [moved.turn]).tolist()
        motion = [moved.at(time) for time in times]
        depths = np.array([depth for depth, _ in motion])
        depths[0], depths[times.index(moved.turn)] = 0.0, moved.deepest
        if not moved.captured:  # a little beyond where the edge loses its hold
            depths[-1] = moved.parting - SEPARATION_MARGIN * (moved.deepest - moved.parting)
        cycle = AdhesiveCycle(self.bed, self.law, Depth(depths))
        for time, (depth, velocity), state in zip(times, motion, cycle.steps(), strict=True):
            elastic = float(stored_energy(self.bed, np.array([state.depth]), np.array([state.radius]))[0])
            yield AdhesiveImpactState(
                time=time,
                depth=depth,
                velocity=velocity,
                force=state.force,
                radius=state.radius,
                energy=elastic - self.law.work_closing * np.pi * state.radius**2,
                dissipation=state.dissipation,
                jumps=state.jumps,
                duration=moved.duration,
                captured=moved.captured,
            )

    def gathered(self, states: Iterable[AdhesiveImpactState]) -> AdhesiveImpactSolution:
        """Return the solution made of these states, of the whole path or of its beginning."""
        every = list(states)
        return gather(
            AdhesiveImpactSolution,
            self,
            every,
            jumps=tuple(jump for state in every for jump in state.jumps),
            duration=every[-1].duration,
            captured=every[-1].captured,
        )

    def solve(self) -> AdhesiveImpactSolution:
        """Return the impact until the bodies part, or turn back in contact.

        Returns
        -------
        AdhesiveImpactSolution

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


SEPARATION_MARGIN = 1e-9
"""Part of the whole depth by which bodies are drawn beyond the last hold."""


@value
class AdhesiveImpactSolution(AdhesiveImpactHistory[Array]):
    """The solution of an `AdhesiveImpact`, moment by moment; its numbers are those of `AdhesiveImpactHistory`.

    Parameters
    ----------
    problem : AdhesiveImpact
        The problem that was solved.
    jumps : tuple of AdhesiveJump
        Snap-in, pull-off and all between.
    duration : float
        How long the bodies touch, or until they stand still during the rebound [s], also of a solution that was stopped
        before.
    captured : bool
        Whether the body stays: it then swings on in contact.
    """

    problem: AdhesiveImpact
    jumps: tuple[AdhesiveJump, ...]
    duration: float
    captured: bool

    @property
    def kinetic_energy(self) -> Array:
        """m v^2 / 2 [J], ``(steps,)``."""
        return np.asarray(0.5 * self.problem.mass * self.velocity**2)

    @property
    def balance(self) -> Array:
        """Kinetic, elastic and lost energy together over what there was at first touch, ``(steps,)``; should be one."""
        total = self.kinetic_energy + self.energy + self.dissipation
        return np.asarray(total / (0.5 * self.problem.mass * self.problem.velocity**2))

    @property
    def restitution(self) -> float:
        """Velocity of parting over that of approach [-]; zero if the body stays, nan if the march was stopped."""
        if self.captured:
            return 0.0
        return -float(self.velocity[-1]) / self.problem.velocity if self.time[-1] == self.duration else math.nan

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: attraction, slopes, slowness, gravity, jumps."""
        problem = self.problem
        modulus = float(problem.bed.normal_stiffness(np.array([np.max(self.radius)]))[0])
        share = wave_loss(modulus=modulus, mass=problem.mass, size=problem.bed.size, velocity=problem.velocity)
        energy_at_start = np.full(self.time.size, 0.5 * problem.mass * problem.velocity**2)
        verdict = "it stays, and swings on in contact without end in this theory" if self.captured else "it leaves"
        return (
            *adhesive_notes(problem.bed, problem.law, self.depth, self.radius),
            energy_note(energy_at_start, self.kinetic_energy + self.energy, self.dissipation),
            wave_note(share),
            gravity_note(self.force),
            Note(
                Assumption.EQUILIBRIUM,
                Standing.ASYMPTOTIC,
                f"The edge runs on in {len(self.jumps)} jumps at once, while the body hardly moves; all that its "
                f"potential falls by is lost: {verdict}.",
                "Griffith's balance at every limit of stability, under fixed grips",
            ),
        )
