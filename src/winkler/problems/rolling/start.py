r"""From rest to rolling: the creep force over the distance rolled, until it is steady.

A contact at rest may bear a shear force, with the stick and slip of Cattaneo.  Then it rolls with creepage: springs
enter unstrained at the leading edge, all gain :math:`\kappa s` per distance while they stick, and after one width of
the contact, 2a, the last spring of the beginning has left.  Without slip and from no force

.. math:: F_x = \kappa s\,(2aX - \tfrac12X^2),\qquad X\le 2a .
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.friction import Sliding
from winkler.loading.loads import ShearForce
from winkler.loading.path import OneLoad
from winkler.numerics.springs.rolling_kernels import push, roll
from winkler.numerics.types import Array
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import ROLLING
from winkler.problems.normal.indentation import IndentationSolution
from winkler.problems.rolling.calibration import Kalker, Uncalibrated
from winkler.problems.rolling.creepage import Creepage
from winkler.problems.rolling.line import RollingLine
from winkler.problems.rolling.springs import springs
from winkler.problems.rolling.steady import Rolling, RollingSolution, check_rolling, rolling_notes, touching
from winkler.values.checks.field_checks import Condition
from winkler.values.checks.number_checks import Advice, Positive, Whole
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

DEFAULT_CALIBRATION = Kalker()
NO_SHEAR_FORCE = ShearForce(0.0)
BOUND_ROUNDING = 1e-12
"""Part of its bound by which a spring that slides may miss it."""


ONE_FORCE = Condition(lambda load: np.ndim(load.shear_force) == 0, "give ShearForce(F) with one number")


@value
class RollingStart:
    """A contact that begins to roll from rest with creepage.

    Parameters
    ----------
    bed : Bed
        The foundation: Foundation(profile, medium); on layers, graded bodies and power laws with `Kalker`.
    friction : Coulomb
        Friction; its coefficient must be positive and finite.
    creepage : Creepage
        Longitudinal and lateral, one number each; no spin.
    load : Force, Depth or Radius
        The steady normal load, one number.
    distance : float
        Rolling distance [m], positive.
    start : ShearForce, optional
        Shear force at rest, along the direction of the creep force (negative: against it).
    calibration : Kalker or Uncalibrated, optional
        Tangential stiffness of the springs.
    points : int, optional
        Number of states that are returned along the distance, evenly spaced.
    count : int, optional
        Minimum number of springs on half of the contact.

    Raises
    ------
    InvalidInput, OutsideValidity
        As `Rolling`; if a creepage is an array, or a number is not positive.

    References
    ----------
    J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, doi:10.1007/978-94-015-7889-9

    Examples
    --------
    After one width of the contact the force is the steady one:

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> steel = Elastic(young=208e9, poisson=0.25)
    >>> bed = Foundation(Paraboloid(10e-3), HalfSpace.between(steel, steel))
    >>> begun = RollingStart(bed, Coulomb(0.3), Creepage(longitudinal=1e-3), Force(100.0), distance=400e-6).solve()
    >>> round(float(begun.shear_force[-1]), 4), round(begun.steady.longitudinal_force, 4)
    (10.6629, 10.6629)
    """

    __words__ = words(
        distance=("X", "m", "how far the contact rolls"),
        start=("F_0", None, "shear force that the contact carries at rest"),
        count=("n", "", "springs on half of the contact, at least"),
    )

    bed: Bed
    friction: Sliding
    creepage: Creepage[float]
    load: OneLoad
    distance: Annotated[Positive, Advice("how far it rolls")]
    start: Annotated[ShearForce, ONE_FORCE] = NO_SHEAR_FORCE
    calibration: Kalker | Uncalibrated = DEFAULT_CALIBRATION
    points: Annotated[int, Whole(1, 100_000)] = 100
    count: Annotated[int, Whole(20, 100_000)] = 400

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "kalker_1990", "cattaneo_1938")
    assumptions: ClassVar[frozenset[Assumption]] = ROLLING
    needs_round: ClassVar[str] = "rolling along the line"

    def __post_init__(self) -> None:
        check_rolling("RollingStart", self.bed, self.creepage, self.calibration)
        if self.creepage.shape != ():
            raise InvalidInput("RollingStart: the creepage is an array; give one number each, and sweep over several.")

    @property
    def steady(self) -> RollingSolution[float]:
        """The steady state."""
        return Rolling(self.bed, self.friction, self.creepage, self.load, self.calibration).solve()

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: the state at rest, and one after every part of the distance."""
        return self.points + 1

    def steps(self) -> Iterator[RollingState]:
        """Yield the contact at rest, and then after every part of the distance.

        Raises
        ------
        OutsideValidity
            If the bodies do not touch, or the shear force at rest exceeds the friction limit.
        """
        line = RollingLine(self.friction.coefficient, touching("RollingStart", self.bed, self.load))
        along, across = self.calibration.stiffness(self.bed, line.radius)
        drive = np.array([along * float(self.creepage.longitudinal), across * float(self.creepage.lateral)])
        rate = float(np.hypot(*drive))
        sampled, count = springs("RollingStart", line, self.distance, self.points, self.count)
        load = np.zeros(sampled.x.size)
        held = float(self.start.shear_force)
        borne = push(load, sampled.bound, sampled.weight, sampled.part, 0, held, 1)[1]
        if abs(held) > line.most or not borne:
            raise OutsideValidity(
                f"RollingStart: friction carries {line.most:.6g} N at rest, less than the shear force of {held:.6g} N; "
                "give less."
            )
        apart = self.distance / self.points / count
        for point in range(self.points + 1):
            if point > 0:
                roll(load, sampled.bound, sampled.part, rate * apart, count)
            sticking = np.abs(load) < sampled.bound * (1.0 - BOUND_ROUNDING)
            yield RollingState(
                distance=self.distance * point / self.points,
                shear_force=float(sampled.weight @ load),
                stick_share=float(sampled.weight @ sticking) / (2.0 * line.radius),
                x=sampled.x,
                shear_load=load,
            )

    def gathered(self, states: Iterable[RollingState]) -> RollingStartSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        contact = touching("RollingStart", self.bed, self.load)
        return gather(RollingStartSolution, self, states, contact=contact)

    def solve(self) -> RollingStartSolution:
        """Return the force over the whole distance.

        Returns
        -------
        RollingStartSolution

        Raises
        ------
        OutsideValidity
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class RollingState:
    """A contact that has rolled so far.

    Parameters
    ----------
    distance, shear_force, stick_share : float
        As in `RollingStartSolution`.
    x : ndarray, (n,)
        Places of the springs [m], the leading edge at +a.
    shear_load : ndarray, (n,)
        q_x [N/m].
    """

    distance: float
    shear_force: float
    stick_share: float
    x: Array
    shear_load: Array


@value
class RollingStartSolution:
    """The solution of a `RollingStart`, from rest on.

    Parameters
    ----------
    problem : RollingStart
        The problem that was solved.
    contact : IndentationSolution
        The contact under its normal load.
    distance : ndarray, (steps,)
        Distance rolled since rest [m].
    shear_force : ndarray, (steps,)
        Shear force along the direction of the creep force [N].
    stick_share : ndarray, (steps,)
        Fraction of the one-dimensional foundation in the stick zone [-].
    states : tuple
        The states of all points.
    """

    problem: RollingStart
    contact: IndentationSolution[float]
    distance: Array
    shear_force: Array
    stick_share: Array
    states: tuple[RollingState, ...]

    @property
    def steady(self) -> RollingSolution[float]:
        """The steady state, which is the limit of the solution."""
        return self.problem.steady

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        problem, slides = self.problem, bool(np.any(self.stick_share == 0.0))
        return (*rolling_notes(self.contact, problem.calibration, problem.friction, slides=slides), TRANSIENT)


TRANSIENT = Note(
    Assumption.CALIBRATION,
    Standing.APPROXIMATE,
    "The transition to the steady state takes one contact width; this is a property of the springs. They were "
    "calibrated for the steady force, not for the transition.",
    "the springs' rule; not compared with a theory in three dimensions",
)
