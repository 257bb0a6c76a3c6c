r"""A cylinder that begins to roll: its tractions over the distance rolled, until they are Carter's.

On a grid that moves with the contact by one spacing per step, boundary elements of both half-planes are exact for
tractions that are linear between nodes (Kalker's approach): a particle now at x was at x + h a step before, and slips

.. math:: S = W - u(x) + u_0(x+h) - \frac{2\beta}{E^*}\int_x^{x+h} p\,\mathrm ds , \qquad \xi = \frac Wh .

The last term is what the pressure drags dissimilar surfaces along each other, with Dundurs' constant beta (Bentall and
Johnson); that tractions change the pressure of such bodies is left out.  On layers both displacements are those of the
bed (`LineBed.hat_compliance`, `LineBed.drawn`), which drags layers along a body like the uppermost one, too.

Under a force per length that is held, the contact begins as it sticks and slips at rest (Cattaneo), and the creepage
follows.  A prescribed creepage determines the force only against points at a stated distance d, because the surfaces
of half-planes move without bound under a growing force per length.

References
----------
J. J. Kalker, Transient phenomena in two elastic cylinders rolling over each other with dry friction, J. Appl. Mech. 37
(1970) 677-688; R. H. Bentall, K. L. Johnson, Int. J. Mech. Sci. 9 (1967) 389-404
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.line_bed import SIMILAR
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.laws.friction import Sliding
from winkler.loading.loads import LineShearForce
from winkler.numerics.surfaces.strip_grid import StripStep, StuckStrip, strip_step
from winkler.numerics.types import Array
from winkler.problems.answer import gather
from winkler.problems.assumptions.coupling import sliding_note
from winkler.problems.assumptions.declared import SHEARED
from winkler.problems.line.indentation import LineSolution
from winkler.problems.line_friction.validity import slid_yield_notes
from winkler.problems.line_rolling.pressed import (
    OneLineLoad,
    refuse_unless_along,
    refuse_unless_round,
    rolling_yield_notes,
    touching_strip,
)
from winkler.problems.line_rolling.start_states import (
    DRAGGED,
    ELEMENTS,
    ELEMENTS_ON_LAYERS,
    LineRollingState,
    rolled_state,
)
from winkler.problems.line_rolling.steady import LineRolling, LineRollingSolution
from winkler.problems.rolling.creepage import Creepage
from winkler.values.checks.field_checks import Condition
from winkler.values.checks.number_checks import Advice, Positive, PositiveOrInfinite, Whole
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

MOST_STEPS = 200_000
"""Steps of a march; more would take hours."""
NEAREST_REFERENCE = 2.0
"""Least distance to the reference, in half-widths."""
ONE_DRIVE = Condition(
    lambda drive: np.ndim(getattr(drive, "shear_force_per_length", 0.0)) == 0 and getattr(drive, "shape", ()) == (),
    "give LineShearForce(Q) or Creepage(longitudinal=xi) with one number, and sweep over several",
)


@value
class LineRollingStart:
    """A cylinder that begins to roll from rest, at constant force per length or with a prescribed creepage.

    Parameters
    ----------
    bed : LineFoundation, LayeredLineFoundation or PowerLawLineFoundation
        A foundation with a Paraboloid of the relative radius of both bodies; on layers that transmit shear to the base,
        or on a body graded with depth.
    friction : Coulomb
        Friction; its coefficient must be positive and finite.
    drive : LineShearForce or Creepage
        One number: the constant force per length at rest and during rolling, below the friction limit. Or the
        longitudinal creepage; the contact at rest then has no shear force.
    load : LineForce, HalfWidth or MeanPressure
        The steady normal load, one number.
    distance : float
        Rolling distance [m], positive; it is rounded up to a whole element.
    reference : float, optional
        With a prescribed creepage: distance d [m] of the reference points on the surface, relative to which tangential
        displacements are measured; at least two half-widths.
    points : int, optional
        Number of states that are returned along the distance.
    count : int, optional
        Number of elements on half of the contact; the error is inversely proportional to it.

    Raises
    ------
    InvalidInput
        If the profile is not round, a number is out of range, a creepage has no reference, or a force has one.
    OutsideValidity
        If the creepage has a lateral or spin component, a layer slides on the material below, or the bodies are
        viscoelastic.

    References
    ----------
    J. J. Kalker, J. Appl. Mech. 37 (1970) 677-688

    Examples
    --------
    Pulled with 64 % of what friction bears: the creepage passes its steady value before it comes back to it.

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading.loads import HalfWidth
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = LineFoundation(Paraboloid(10.0), HalfSpace(Elastic(1.0, 0.5)))
    >>> pull = LineShearForce(0.64 * 0.3 * math.pi / 40.0 / 0.75)
    >>> begun = LineRollingStart(bed, Coulomb(0.3), pull, HalfWidth(1.0), distance=4.0, points=4).solve()
    >>> (begun.longitudinal_creepage / begun.steady.longitudinal_creepage).round(2)
    array([0.  , 1.18, 0.99, 1.  , 1.  ])
    """

    __words__ = words(
        bed=("", None, "profile and bodies of the line contact"),
        drive=("", None, "what is prescribed along the direction of rolling: a force per length or a creepage"),
        load=("", None, "the normal load: a force per length, a half-width or a mean pressure"),
        distance=("X", "m", "how far the contact rolls"),
        reference=("d", "m", "distance on the surface against which a prescribed creepage shifts the bodies"),
        count=("n", "", "elements on half of the contact"),
    )

    bed: LineFoundation | LayeredLineFoundation | PowerLawLineFoundation
    friction: Sliding
    drive: Annotated[LineShearForce[float] | Creepage[float], ONE_DRIVE]
    load: OneLineLoad
    distance: Annotated[Positive, Advice("how far it rolls")]
    reference: PositiveOrInfinite = math.inf
    points: Annotated[int, Whole(1, 100_000)] = 100
    count: Annotated[int, Whole(5, 500)] = 80

    references: ClassVar[tuple[str, ...]] = ("kalker_1970", "carter_1926", "bentall_johnson_1967")
    assumptions: ClassVar[frozenset[Assumption]] = SHEARED

    def __post_init__(self) -> None:
        refuse_unless_round("LineRollingStart", self.bed)
        refuse_unless_along("LineRollingStart", self.drive)
        _ = self.bed.along_share
        if isinstance(self.drive, Creepage) and not math.isfinite(self.reference):
            raise InvalidInput(
                "LineRollingStart: a creepage is prescribed, and the surface of a half-plane moves without bound "
                "under a force per length. Give the distance `reference` in m against which it is counted, or "
                "prescribe LineShearForce(Q)."
            )
        if not isinstance(self.drive, Creepage) and math.isfinite(self.reference):
            raise InvalidInput(
                f"LineRollingStart: against a reference of {self.reference:g} m only a prescribed creepage is counted, "
                "and a shear force is prescribed; leave the reference out."
            )

    @property
    def steady(self) -> LineRollingSolution[float]:
        """The steady state of uncoupled bodies (Carter)."""
        return LineRolling(self.bed, self.friction, self.drive, self.load).solve()

    @property
    def total(self) -> int:
        """Maximum number of states that `steps` yields: the state at rest, and one after every part of the distance."""
        return self.points + 1

    def steps(self) -> Iterator[LineRollingState]:
        """Yield the contact at rest, and then after every part of the distance.

        Raises
        ------
        OutsideValidity
            If the bodies do not touch, the force exceeds the friction limit, or the travel is too long.
        NotConverged
            If the zones of stick and slip are not found.
        """
        contact, drive = touching_strip("LineRollingStart", self.bed, self.load), self.drive
        a, modulus = float(contact.half_width), self.bed.medium.modulus
        apart, travel, reference = a / self.count, self._steps(a), self.reference
        x = apart * np.arange(1 - self.count, self.count)
        most = self.friction.coefficient * float(contact.force_per_length)
        bound = contact.pressure(x)
        bound *= most / (modulus * apart * float(np.sum(bound)))
        nothing = np.zeros(x.size)
        step = StripStep(nothing, nothing, 0.0, nothing)
        total: float | None = None
        shift = 0.0
        if isinstance(drive, LineShearForce):
            force = float(drive.shear_force_per_length)
            if abs(force) >= most:
                raise OutsideValidity(
                    f"LineRollingStart: a shear force of {force:.6g} N/m was given, but the friction limit at "
                    f"rest is {most:.6g} N/m: give less."
                )
            total, reference = force / (modulus * apart), a  # which falls out, as the sum stays
        else:
            shift = float(drive.longitudinal) * apart
        near = self.bed.hat_compliance(x.size, apart, reference)
        away = np.arange(x.size)
        grid, earlier = StuckStrip(near[np.abs(away[:, None] - away)]), near[np.abs(away[:, None] + 1 - away)]
        drawn = self.bed.drawn(np.append(x, x[-1] + apart), a)
        if total is not None or np.any(drawn):
            step = strip_step(grid, -drawn[:-1], bound, step.slips, total=total or 0.0)
        passed = np.diff(drawn)
        yield rolled_state(0.0, step._replace(shift=0.0), apart, modulus, x)
        after = {int(n) for n in np.unique(np.round(np.linspace(0.0, travel, self.points + 1)))}
        for number in range(1, travel + 1):
            step = strip_step(grid, earlier @ step.traction + passed, bound, step.slips, shift=shift, total=total)
            if number in after:
                yield rolled_state(number * apart, step, apart, modulus, x)

    def _steps(self, half_width: float) -> int:
        steps = self.distance * self.count / half_width * (1.0 - 1e-12)
        if not steps <= MOST_STEPS:
            raise OutsideValidity(
                f"LineRollingStart: a travel of {self.distance:.6g} m is so long beside the half-width of "
                f"{half_width:.6g} m that it needs more than {MOST_STEPS} steps; after a few widths it is steady: give "
                "a shorter one, or use LineRolling."
            )
        if math.isfinite(self.reference) and self.reference < NEAREST_REFERENCE * half_width:
            raise OutsideValidity(
                f"LineRollingStart: the reference at {self.reference:.6g} m is nearer than {NEAREST_REFERENCE:g} "
                f"half-widths of {half_width:.6g} m; give a longer distance."
            )
        return max(math.ceil(steps), 1)

    def gathered(self, states: Iterable[LineRollingState]) -> LineRollingStartSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        contact = touching_strip("LineRollingStart", self.bed, self.load)
        return gather(LineRollingStartSolution, self, states, contact=contact)

    def solve(self) -> LineRollingStartSolution:
        """Return creepage and force over the whole distance.

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class LineRollingStartSolution:
    """The solution of a `LineRollingStart`, from rest on.

    Parameters
    ----------
    problem : LineRollingStart
        The problem that was solved.
    contact : LineSolution
        The contact under its normal load.
    distance : ndarray, (steps,)
        Distance rolled since rest [m].
    longitudinal_creepage : ndarray, (steps,)
        xi [-] over the last element rolled; zero at rest.
    shear_force_per_length : ndarray, (steps,)
        Q [N/m] on the first body along the rolling direction.
    stick_share : ndarray, (steps,)
        Width of the stick zone over that of the contact [-].
    states : tuple
        The states of all points.
    """

    __words__ = words(stick_share=("c/a", "", "part of the width that sticks"))

    problem: LineRollingStart
    contact: LineSolution[float]
    distance: Array
    longitudinal_creepage: Array
    shear_force_per_length: Array
    stick_share: Array
    states: tuple[LineRollingState, ...]

    @property
    def steady(self) -> LineRollingSolution[float]:
        """The steady state, which is the limit for elastically similar bodies."""
        return self.problem.steady

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        bed, mu = self.problem.bed, self.problem.friction.coefficient
        steady = self.steady
        sign = 1.0 if float(steady.shear_force_per_length) >= 0.0 else -1.0
        notes = [note for note in self.contact.validity if note.assumption is not Assumption.ELASTIC]
        notes += [sliding_note(bed.medium, mu), ELEMENTS if bed.hertzian else ELEMENTS_ON_LAYERS]  # type: ignore[arg-type]
        if abs(bed.mismatch) > SIMILAR:  # of gradings by a power it is no number, and left out
            notes.append(DRAGGED)
        if not bed.hertzian:
            return (*notes, *slid_yield_notes(self.contact, self.problem.friction, 0.0))
        return (*notes, *rolling_yield_notes(self.contact, sign * mu, float(steady.stick_share)))
