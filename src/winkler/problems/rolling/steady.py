r"""Steady rolling with friction: the creep force of a round contact, longitudinal and lateral.

Springs enter at the leading edge without strain and are stretched by the creepage while they stick.  Of a sphere

.. math:: q_x = \min\Bigl[\kappa s\,(a-x),\ \mu E^*\frac{a^2-x^2}{R}\Bigr],\qquad
          \frac{F_x}{\mu F_N} = 1-(1-\tfrac13\tau)^3,\qquad \tau = \frac{2\kappa a^2 s}{\mu F_N}\le 3 :

the zone of stick begins at the leading edge, and the curve is the cubic law of Vermeulen and Johnson.  Both creepages
together stretch the springs along one direction, :math:`(\kappa_x\xi,\ \kappa_y\eta)`, and the resultant follows the
same curve.  How stiff the springs are is a value of its own: `winkler.problems.rolling.calibration`.
"""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.friction import Coulomb, Sliding
from winkler.loading.path import OneLoad
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.offers import PowerOfDepth, PushedWaves, offers
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.declared import ROLLING
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.normal.yield_statement import SurfaceFriction
from winkler.problems.rolling.calibration import Kalker, Uncalibrated
from winkler.problems.rolling.creepage import Creepage, CreepageSolution
from winkler.problems.rolling.line import RollingLine
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value

VERMEULEN = "P. J. Vermeulen, K. L. Johnson, J. Appl. Mech. 31 (1964) 338-340"
DEFAULT_CALIBRATION = Kalker()


@value
class Rolling(PerLoad[Q]):
    """Steady rolling of a body with creepage, under a steady normal load.

    Parameters
    ----------
    bed : Bed
        The foundation: Foundation(profile, medium); on layers, graded bodies and power laws with `Kalker`.
    friction : Coulomb
        Friction; its coefficient must be positive and finite.
    creepage : Creepage
        Longitudinal and lateral, also arrays; no spin.
    load : Force, Depth or Radius
        The steady normal load, one number.
    calibration : Kalker or Uncalibrated, optional
        Tangential stiffness of the springs.

    Raises
    ------
    InvalidInput
        If friction is not Coulomb's with a positive, finite coefficient, the load an array, or the response of the
        medium to tractions not known.
    OutsideValidity
        If there is spin, which a one-dimensional foundation cannot represent, or a layer slides on its base.

    References
    ----------
    P. J. Vermeulen, K. L. Johnson, J. Appl. Mech. 31 (1964) 338-340;
    J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, doi:10.1007/978-94-015-7889-9

    Examples
    --------
    A steel ball that pulls at two thirds of the creepage from which it slides: 1 - (1/3)^3 of what friction bears.

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> steel = Elastic(young=208e9, poisson=0.25)
    >>> bed = Foundation(Paraboloid(10e-3), HalfSpace.between(steel, steel))
    >>> radius = Indentation(bed, Force(100.0)).solve().radius
    >>> creepage = Creepage(longitudinal=2.0 * 0.3 * 100.0 / (4.12 * steel.shear * radius**2))
    >>> pulled = Rolling(bed, Coulomb(0.3), creepage, Force(100.0)).solve()
    >>> round(pulled.longitudinal_force / (0.3 * 100.0), 9)
    0.962962963
    """

    bed: Bed
    friction: Sliding
    creepage: Creepage[Q]
    load: OneLoad
    calibration: Kalker | Uncalibrated = DEFAULT_CALIBRATION

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "vermeulen_johnson_1964", "kalker_1990")
    assumptions: ClassVar[frozenset[Assumption]] = ROLLING
    needs_round: ClassVar[str] = "rolling along the line"

    def __post_init__(self) -> None:
        check_rolling("Rolling", self.bed, self.creepage, self.calibration)

    def solve(self) -> RollingSolution[Q]:
        """Return the creep forces.

        Returns
        -------
        RollingSolution

        Raises
        ------
        OutsideValidity
            If the bodies do not touch, or Poisson's ratio lies outside Kalker's table.
        """
        contact = touching("Rolling", self.bed, self.load)
        along, across, _ = self.creepage.broadcast()
        stiffness = self.calibration.stiffness(self.bed, float(contact.radius))
        drive = np.stack([along, across]) * np.array(stiffness)[:, None]
        rate = np.hypot(*drive)
        line = RollingLine(self.friction.coefficient, contact)
        pieces = line.sticking(rate)
        force = line.force(rate, pieces)
        direction = drive / np.where(rate > 0.0, rate, 1.0)
        results = (*(direction * force), line.stick_share(rate, pieces))
        columns: list[Q] = [shaped(result, self.creepage.shape) for result in results]
        longitudinal, lateral, share = columns
        return RollingSolution(self, longitudinal, lateral, share, contact)


@value
class RollingSolution(CreepageSolution[Q]):
    """The solution of a `Rolling`; every quantity has the shape of the creepage.

    Parameters
    ----------
    problem : Rolling
        The problem that was solved.
    longitudinal_force, lateral_force : float or ndarray
        F_x and F_y [N] on the first body.
    stick_share : float or ndarray
        Fraction of the one-dimensional foundation in the stick zone [-].
    contact : IndentationSolution
        The contact under its normal load.
    """

    problem: Rolling[Q]
    stick_share: Q
    contact: IndentationSolution[float]

    @property
    def saturation(self) -> Q:
        """The resultant over the sliding force mu F_N [-]; one where the bodies slide."""
        return shaped(np.asarray(self.shear_force) / self._line.most)

    def shear_load(self, x: Array) -> Array:
        """Return the resultant line load of one creepage.

        Parameters
        ----------
        x : ndarray
            Positions along the one-dimensional foundation [m], the leading edge at +a.

        Returns
        -------
        ndarray
            q_x [N/m] along the direction of the force, zero outside the contact.

        Raises
        ------
        InvalidInput
            If the creepage is an array; give one creepage.
        """
        if self.problem.creepage.shape != ():
            raise InvalidInput("RollingSolution.shear_load: the creepage is an array; solve for one creepage.")
        along, across, _ = self.problem.creepage.broadcast()
        stiffness = self.problem.calibration.stiffness(self.problem.bed, float(self.contact.radius))
        rate = math.hypot(along[0] * stiffness[0], across[0] * stiffness[1])
        return self._line.shear_load(rate, np.asarray(x, dtype=float))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        problem = self.problem
        both = np.any(np.multiply(problem.creepage.longitudinal, problem.creepage.lateral) != 0.0)
        slides = bool(np.any(np.asarray(self.stick_share) == 0.0))
        notes = rolling_notes(self.contact, problem.calibration, problem.friction, slides=slides)
        return (*notes, TOGETHER) if both else notes

    @property
    def _line(self) -> RollingLine:
        return RollingLine(self.problem.friction.coefficient, self.contact)


TOGETHER = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "Longitudinal and lateral creepage act together. The computed force keeps the direction in which the "
    "sticking springs are stretched. At full sliding the exact force turns to the direction of the creepage.",
    VERMEULEN,
)
STRIPS = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "The one-dimensional foundation gives forces, not the distribution of traction over the surface. The true "
    "stick zone is not a strip with parallel edges. Use SurfaceRolling for a map of the tractions.",
    VERMEULEN,
)


def rolling_notes(
    contact: IndentationSolution, calibration: Kalker | Uncalibrated, friction: Coulomb, *, slides: bool = False
) -> tuple[Note, ...]:
    """Return what is assumed of springs that roll."""
    bed = contact.problem.bed
    notes = calibration.notes(bed, float(contact.radius))
    rubbing = SurfaceFriction(friction.coefficient, math.inf if slides else 0.0)
    return (*contact.notes_with(rubbing), sticking_note(bed.medium, friction.coefficient), *notes, STRIPS)


def check_rolling(owner: str, bed: Bed, creepage: Creepage, calibration: Kalker | Uncalibrated) -> None:
    """Refuse what does not roll on a line.

    Raises
    ------
    InvalidInput, OutsideValidity
    """
    medium = bed.medium
    if not isinstance(medium, HomogeneousMedium):
        name = type(medium).__name__
        if not (offers(medium, PushedWaves) or offers(medium, PowerOfDepth)):
            raise InvalidInput(
                f"{owner}: how tractions move the surface of a {name} is not known; give homogeneous bodies, layers, "
                "or a grading."
            )
        if isinstance(calibration, Uncalibrated):
            raise InvalidInput(
                f"{owner}: the springs of a {name} differ between middle and edge, and one that rolls through the "
                "contact keeps its stiffness; leave out Uncalibrated()."
            )
        _ = medium.shear_modulus  # refuses layers that slide, and Gibson's solid
    if np.any(np.asarray(creepage.spin) != 0.0):
        raise OutsideValidity(
            f"{owner}: spin turns the traction around the contact, and a line of springs has no counterpart of "
            "that; use SimplifiedRolling, on layers and graded bodies SurfaceRolling."
        )


def touching(owner: str, bed: Bed, load: OneLoad) -> IndentationSolution[float]:
    """Return the contact under its normal load; refuse one that does not touch.

    Raises
    ------
    OutsideValidity
    """
    contact = Indentation(bed, load).solve()
    if float(contact.radius) == 0.0 or float(contact.force) <= 0.0:
        raise OutsideValidity(f"{owner}: the bodies do not touch under this load; press them together.")
    return contact
