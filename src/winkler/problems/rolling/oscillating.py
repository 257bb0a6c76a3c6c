r"""A contact that is rocked to and fro under a shear force: it comes to rest, or creeps on with every cycle.

A ball under :math:`F_N` and a constant :math:`F_x` rolls by :math:`\pm W`.  Springs at the edges enter and leave; what
they bore is lost, and the others take it over.  Only those that stay in contact all the time, and there only what the
least of their bounds allows, can bear anything without end:

.. math:: F_{\lim} = 2\int_0^{a-W} \mu\,q_z(x+W)\,\mathrm dx ,\qquad
          \frac{F_{\lim}}{\mu F_N} = 1-\tfrac32 w+\tfrac12 w^3\quad(w=W/a,\text{ sphere}).

Below it the shift stops growing (shakedown), above it every cycle adds its step (ratcheting).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.friction import Sliding
from winkler.loading.path import OneLoad
from winkler.numerics.springs.rolling_kernels import push
from winkler.numerics.types import Array
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import ROLLING
from winkler.problems.normal.indentation import IndentationSolution
from winkler.problems.rolling.calibration import Kalker, Uncalibrated
from winkler.problems.rolling.creepage import Creepage
from winkler.problems.rolling.line import RollingLine
from winkler.problems.rolling.springs import springs
from winkler.problems.rolling.steady import check_rolling, rolling_notes, touching
from winkler.values.checks.number_checks import NonNegative, Positive, Whole
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

DEFAULT_CALIBRATION = Kalker()
WETTER = (
    "R. Wetter, V. L. Popov, Influence of the alignment of load and oscillation on the frictional shakedown of an "
    "elastic rolling contact with Coulomb friction, Physical Mesomechanics 17 (2014)"
)
FORCE_ROUNDING = 1e-9
"""Part of the sliding force by which a march may miss it."""


@value
class OscillatingRolling:
    """A contact under steady normal and shear force that rolls back and forth.

    Parameters
    ----------
    bed : Bed
        The foundation: Foundation(profile, medium); on layers, graded bodies and power laws with `Kalker`.
    friction : Coulomb
        Friction; its coefficient must be positive and finite.
    amplitude : float
        Amplitude W of the rolling motion [m], positive.
    shear_force : float
        F_x [N] along the direction of rolling, zero or more; applied at rest, before the first cycle.
    load : Force, Depth or Radius
        The steady normal load, one number.
    calibration : Kalker or Uncalibrated, optional
        Tangential stiffness of the springs.
    cycles : int, optional
        How many.
    count : int, optional
        Minimum number of springs on half of the contact.

    Raises
    ------
    InvalidInput
        If a number is outside its range, friction not Coulomb's, or the response of the medium not known.

    References
    ----------
    R. Wetter, V. L. Popov, Influence of the alignment of load and oscillation on the frictional shakedown of an elastic
    rolling contact with Coulomb friction, Physical Mesomechanics 17 (2014)

    Examples
    --------
    Rocked by a fifth of its contact radius, a ball bears 0.704 of what friction bears at rest.

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading.loads import Radius
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> steel = Elastic(young=208e9, poisson=0.25)
    >>> bed = Foundation(Paraboloid(10e-3), HalfSpace.between(steel, steel))
    >>> rocked = OscillatingRolling(bed, Coulomb(0.3), amplitude=20e-6, shear_force=1.0, load=Radius(100e-6)).solve()
    >>> round(rocked.shakedown_force / (0.3 * rocked.contact.force), 6), rocked.ratchets
    (0.704, False)
    """

    __words__ = words(
        amplitude=("W", "m", "how far the contact rolls to each side"),
        count=("n", "", "springs on half of the contact, at least"),
    )

    bed: Bed
    friction: Sliding
    amplitude: Positive
    shear_force: NonNegative
    load: OneLoad
    calibration: Kalker | Uncalibrated = DEFAULT_CALIBRATION
    cycles: Annotated[int, Whole(1, 100_000)] = 30
    count: Annotated[int, Whole(20, 100_000)] = 200

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "wetter_popov_2014")
    assumptions: ClassVar[frozenset[Assumption]] = ROLLING
    needs_round: ClassVar[str] = "rolling along the line"

    def __post_init__(self) -> None:
        check_rolling("OscillatingRolling", self.bed, Creepage(), self.calibration)

    @property
    def shakedown_force(self) -> float:
        """The maximum shear force with shakedown [N]; zero if the amplitude of rolling exceeds the contact radius."""
        line = self._line
        inner = min(self.amplitude, line.radius)
        return 2.0 * float(line.bearing(np.array([inner]), np.array([line.radius]))[0])

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: the state at rest, and one after every cycle."""
        return self.cycles + 1

    def steps(self) -> Iterator[RockingState]:
        """Yield the state in the middle position, before the first and after every cycle.

        Raises
        ------
        OutsideValidity
            If the bodies do not touch, or the shear force exceeds the friction limit.
        """
        line = self._line
        if self.shear_force > line.most * (1.0 - FORCE_ROUNDING):
            raise OutsideValidity(
                f"OscillatingRolling: friction carries {line.most:.6g} N, no more than the shear force of "
                f"{self.shear_force:.6g} N; give less."
            )
        sampled, count = springs("OscillatingRolling", line, self.amplitude, 1, self.count)
        stiffness = self.calibration.stiffness(self.bed, line.radius)[0]
        load, shift = np.zeros(sampled.x.size), 0.0
        strokes = (((0, 1),), ((1, count), (-1, 2 * count), (1, count)))
        for cycle in range(self.cycles + 1):
            for direction, steps in strokes[min(cycle, 1)]:
                gained, borne = push(
                    load, sampled.bound, sampled.weight, sampled.part, direction, self.shear_force, steps
                )
                if not borne:
                    raise OutsideValidity(
                        f"OscillatingRolling: {load.size} springs do not carry {self.shear_force:.6g} N, so close to "
                        f"the sliding force of {line.most:.6g} N; give less, or a greater count."
                    )
                shift += gained / stiffness
            yield RockingState(cycle=cycle, shift=shift, x=sampled.x, shear_load=load)

    def gathered(self, states: Iterable[RockingState]) -> OscillatingRollingSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        contact = touching("OscillatingRolling", self.bed, self.load)
        return gather(OscillatingRollingSolution, self, states, contact=contact, shakedown_force=self.shakedown_force)

    def solve(self) -> OscillatingRollingSolution:
        """Return the tangential displacement after every cycle.

        Returns
        -------
        OscillatingRollingSolution

        Raises
        ------
        OutsideValidity
            As `steps`.
        """
        return self.gathered(self.steps())

    @property
    def _line(self) -> RollingLine:
        return RollingLine(self.friction.coefficient, touching("OscillatingRolling", self.bed, self.load))


@value
class RockingState:
    """A contact after so many cycles, in its middle position.

    Parameters
    ----------
    cycle : int
        How many are over.
    shift : float
        u_x [m] of the bodies against each other, since there was no shear force.
    x : ndarray, (n,)
        Places of the springs [m].
    shear_load : ndarray, (n,)
        q_x [N/m].
    """

    cycle: int
    shift: float
    x: Array
    shear_load: Array


@value
class OscillatingRollingSolution:
    """The solution of an `OscillatingRolling`.

    Parameters
    ----------
    problem : OscillatingRolling
        The problem that was solved.
    contact : IndentationSolution
        The contact under its normal load.
    shakedown_force : float
        F_lim [N], the maximum force with shakedown.
    cycle : ndarray, (steps,)
        Number of completed cycles: 0, 1, 2 ...
    shift : ndarray, (steps,)
        Tangential displacement u_x after these cycles [m].
    states : tuple
        The states of all points.
    """

    problem: OscillatingRolling
    contact: IndentationSolution[float]
    shakedown_force: float
    cycle: Array
    shift: Array
    states: tuple[RockingState, ...]

    @property
    def ratchets(self) -> bool:
        """Whether the displacement grows without end (ratcheting)."""
        return self.problem.shear_force > self.shakedown_force

    @property
    def shift_per_cycle(self) -> float:
        """Displacement in the last cycle [m]: the steady ratcheting rate, or the remainder of shakedown."""
        return float(self.shift[-1] - self.shift[-2]) if self.shift.size > 1 else float(self.shift[-1])

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        return (*rolling_notes(self.contact, self.problem.calibration, self.problem.friction), LIMIT)


LIMIT = Note(
    Assumption.CALIBRATION,
    Standing.APPROXIMATE,
    "The limit between shakedown and ratcheting does not depend on the spring stiffness. The springs do not "
    "distinguish rocking along the shear force from rocking across the shear force; the limits of these two cases "
    "differ little. Displacements depend on the calibration, which was made for steady rolling.",
    WETTER,
)
