r"""Simplified theory of rolling: an elliptic contact on springs along the surface, with creepage and spin.

Every point of the ellipse is a spring of its own, :math:`u_x=L\,p_x`: again a Winkler foundation, but of the
surface instead of the line.  Kalker chose the flexibilities so that creep forces begin as those of the exact theory,

.. math:: L_1=\frac{8a}{3c_{11}G},\qquad L_2=\frac{8a}{3c_{22}G},\qquad L_3=\frac{\pi a\sqrt{a/b}}{4c_{23}G},

and the bound is a parabola, :math:`\mu\,\frac{2F_N}{\pi ab}(1-x^2/a^2-y^2/b^2)`.  His FASTSIM steps through the contact
strip by strip; here the steps are those of `winkler.numerics.springs.fastsim`, of second order.

Friction that falls with the velocity of slip takes that of the rigid bodies, as Polach's law does.  What the springs
unload is left out: a spring that begins to slide slowly would at once bear less, slide faster, and jump.  Steps that
include it alternate between stick and slip the more, the finer they are.
"""

from __future__ import annotations

import math
from typing import Annotated, ClassVar, cast

import numpy as np

from winkler.laws.varying_friction import FallingFriction, Rolled, greatest_coefficient
from winkler.loading.loads import Force
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.medium import Medium
from winkler.numerics.springs.fastsim import mapped, rolled
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.declared import ROLLING
from winkler.problems.normal.yield_of_pressure import ellipse_yield_notes
from winkler.problems.rolling.creepage import Creepage, CreepageSolution
from winkler.problems.rolling.distances import MEASURED_BY, ellipse_distances
from winkler.problems.rolling.kalker import CreepCoefficients, creep_coefficients, rolling_pair
from winkler.problems.rolling.speed import idle_speed_notes, refuse_rest
from winkler.profiles.curved_pair import CurvedPair
from winkler.profiles.ellipse import ContactEllipse, CurvedBodies
from winkler.values.checks.field_checks import Condition
from winkler.values.checks.number_checks import Advice, NonNegative, Whole
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

HALF_BOUND_INTEGRAL = 0.25 * math.pi
"""Half the integral of the bound over the unit disc: sums over it become forces over mu F_N."""


HERTZIAN = Advice("on layers and graded bodies the contact is not Hertz' ellipse; use ProfilePairRolling for them")
ONE_FORCE = Condition(
    lambda load: np.ndim(load.force) == 0 and float(load.force) > 0.0, "give Force(F) with one positive number"
)


@value
class SimplifiedRolling(PerLoad[Q]):
    """Rolling of bodies on an elliptic contact with creepage and spin, by Kalker's simplified theory.

    Parameters
    ----------
    footprint : ContactEllipse, CurvedBodies or CurvedPair
        The contact ellipse, or the curvatures of the bodies.
    medium : HalfSpace or TransverselyIsotropicHalfSpace
        The pair of bodies.
    friction : Coulomb or FallingFriction
        A positive, finite coefficient, or one that falls with the slip velocity of rigid bodies.
    creepage : Creepage
        Longitudinal, lateral and spin, also arrays.
    load : Force
        The normal force, one positive number.
    count : int, optional
        Number of strips across the contact, and of steps along each strip.
    speed : float, optional
        Rolling speed [m/s], for friction that falls with the slip velocity (creepage times speed). Under Coulomb's law
        forces do not depend on it.

    Raises
    ------
    InvalidInput
        If the load is no positive number, the medium not homogeneous, or friction falls and no speed is given.

    References
    ----------
    J. J. Kalker, Vehicle System Dynamics 11 (1982) 1-13, doi:10.1080/00423118208968684;
    E. A. H. Vollebregt, P. Wilders, Comput. Mech. 47 (2011) 105-116;
    O. Polach, Wear 258 (2005) 992-1000, doi:10.1016/j.wear.2004.03.046

    Examples
    --------
    Spin alone pushes sideways:

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> steel = Elastic(young=208e9, poisson=0.25)
    >>> contact = ContactEllipse(longitudinal_semi_axis=6e-3, lateral_semi_axis=6e-3)
    >>> spun = SimplifiedRolling(
    ...     contact, HalfSpace.between(steel, steel), Coulomb(0.3), Creepage(spin=0.2), Force(80e3)
    ... ).solve()
    >>> round(spun.lateral_force / (0.3 * 80e3), 3), round(abs(spun.longitudinal_force), 6)
    (0.216, 0.0)
    """

    __words__ = words(
        count=("n", "", "strips across the contact, and steps along each"), speed=("V", "m/s", "speed of rolling")
    )

    footprint: ContactEllipse | CurvedBodies | CurvedPair
    medium: Annotated[HomogeneousMedium, HERTZIAN]
    friction: Rolled
    creepage: Creepage[Q]
    load: Annotated[Force[Q], ONE_FORCE]
    count: Annotated[int, Whole(4, 4096, "strips")] = 32
    speed: NonNegative = 0.0

    references: ClassVar[tuple[str, ...]] = ("kalker_1982", "kalker_1990", "vollebregt_wilders_2011")
    assumptions: ClassVar[frozenset[Assumption]] = ROLLING

    def __post_init__(self) -> None:
        refuse_rest("SimplifiedRolling", self.friction, self.speed)

    def solve(self) -> SimplifiedRollingSolution[Q]:
        """Return the creep forces.

        Returns
        -------
        SimplifiedRollingSolution

        Raises
        ------
        OutsideValidity
            If the ellipse or Poisson's ratio lies outside Kalker's table.
        """
        a, b = self.footprint.semi_axes(self.medium.modulus, float(self.load.force))
        coefficients = creep_coefficients(a / b, rolling_pair(self.medium).poisson)
        sums = np.empty((self.creepage.broadcast()[0].size, 4))
        rolled(self.drives(a, b, coefficients), self.falls(a, b), self.count, sums)
        most = greatest_coefficient(self.friction) * float(self.load.force)
        forces = most * sums.T / (2.0 * HALF_BOUND_INTEGRAL)
        results = (forces[0], forces[1], a * forces[2] - b * forces[3])
        columns: list[Q] = [shaped(result, self.creepage.shape) for result in results]
        along, across, moment = columns
        return SimplifiedRollingSolution(self, along, across, moment, a, b, coefficients)

    def drives(self, a: float, b: float, coefficients: CreepCoefficients) -> Array:
        """Return the growth rates of tractions in the stick zone, in normalised units, ``(m, 4)``."""
        xi, eta, spin = self.creepage.broadcast()
        shear = rolling_pair(self.medium).shear
        first = 8.0 * a / (3.0 * coefficients.longitudinal * shear)
        second = 8.0 * a / (3.0 * coefficients.lateral * shear)
        third = math.pi * a * math.sqrt(a / b) / (4.0 * coefficients.spin * shear)
        bound = 2.0 * greatest_coefficient(self.friction) * float(self.load.force) / (math.pi * a * b)
        unit = a / bound
        return np.stack([xi / first, eta / second, spin * b / third, spin * a / third], axis=1) * unit

    def falls(self, a: float, b: float) -> Array:
        """Return the rigid slip over v_0 in normalised units, and mu_k over mu_s, ``(m, 5)``."""
        xi, eta, spin = self.creepage.broadcast()
        law, pace, kept = self.friction, 0.0, np.ones(xi.size)
        if isinstance(law, FallingFriction):
            pace, kept = self.speed / law.velocity, kept * (law.kinetic_coefficient / law.static_coefficient)
        return np.stack([xi * pace, eta * pace, spin * b * pace, spin * a * pace, kept], axis=1)


@value
class SimplifiedRollingSolution(CreepageSolution[Q]):
    """The solution of a `SimplifiedRolling`; forces and moment have the shape of the creepage.

    Parameters
    ----------
    problem : SimplifiedRolling
        The problem that was solved.
    longitudinal_force, lateral_force : float or ndarray
        F_x and F_y [N] on the first body.
    moment : float or ndarray
        Moment M_z [N m] on the first body; for its accuracy see `validity`.
    longitudinal_semi_axis, lateral_semi_axis : float
        a and b [m].
    coefficients : CreepCoefficients
        Kalker's, of this ellipse.
    """

    __words__ = words(
        moment=("M_z", "N m", "moment about the normal of the contact"),
        coefficients=("c_{ij}", None, "Kalker's creep coefficients of the ellipse"),
        traction=("", None, "tractions over the contact"),
    )

    problem: SimplifiedRolling[Q]
    moment: Q
    longitudinal_semi_axis: float
    lateral_semi_axis: float
    coefficients: CreepCoefficients

    @property
    def spin_creepage(self) -> Q:
        """phi [1/m], in the shape of the results."""
        return shaped(np.broadcast_to(self.problem.creepage.spin, self.problem.creepage.shape))

    @property
    def saturation(self) -> Q:
        """The resultant over mu F_N [-]; mu is that of slow slip if friction falls."""
        most = greatest_coefficient(self.problem.friction) * float(self.problem.load.force)
        return shaped(np.asarray(self.shear_force) / most)

    @property
    def loss_per_distance(self) -> Q:
        """Energy lost per distance rolled [J/m]: creepage times force, and spin times moment."""
        return shaped(np.asarray(super().loss_per_distance) + np.asarray(self.problem.creepage.spin) * self.moment)

    @property
    def traction(self) -> RollingTraction:
        """The tractions over the contact; of one creepage, not of an array.

        Raises
        ------
        InvalidInput
            If the creepage is an array.
        """
        problem = self.problem
        if problem.creepage.shape != ():
            raise InvalidInput("SimplifiedRollingSolution.traction: the creepage is an array; solve for one creepage.")
        a, b, count = self.longitudinal_semi_axis, self.lateral_semi_axis, problem.count
        drive, fall = problem.drives(a, b, self.coefficients)[0], problem.falls(a, b)[0]
        across = np.sin(np.pi * ((np.arange(count) + 0.5) / count - 0.5))
        tractions, sliding = np.empty((count, 2, count + 1)), np.empty((count, count + 1))
        mapped(drive, fall, across, tractions, sliding)
        along = np.sqrt(1.0 - across**2)[:, None] * np.linspace(1.0, -1.0, count + 1)
        peak = 2.0 * greatest_coefficient(problem.friction) * float(problem.load.force) / (math.pi * a * b)
        return RollingTraction(
            x=a * along,
            y=b * np.repeat(across[:, None], count + 1, axis=1),
            longitudinal=peak * tractions[:, 0],
            lateral=peak * tractions[:, 1],
            sliding=sliding > 0.5,
        )

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        problem, axes = self.problem, (self.longitudinal_semi_axis, self.lateral_semi_axis)
        creep = problem.creepage
        aside = bool(np.any(np.asarray(creep.lateral) != 0.0))
        moments = (moment_note(self.coefficients, *axes),) if aside else ()
        distances = distance_notes(creep, axes[0] / axes[1], rolling_pair(problem.medium).poisson)
        law, most = problem.friction, greatest_coefficient(problem.friction)
        coupled = sticking_note(cast(Medium, problem.medium), most)
        yielding = ellipse_yield_notes(problem.medium, axes, problem.load.force, most)
        falling = (self._falling_note(law),) if isinstance(law, FallingFriction) else ()
        idle = idle_speed_notes(law, problem.speed)
        sized = size_note(problem.footprint, *axes)
        return (*problem.medium.notes, sized, coupled, *distances, *moments, *falling, *idle, *yielding)

    def _falling_note(self, law: FallingFriction) -> Note:
        problem, a, b = self.problem, self.longitudinal_semi_axis, self.lateral_semi_axis
        xi, eta, spin = problem.creepage.broadcast()
        slowest = problem.speed * np.maximum(np.hypot(xi, eta) - np.abs(spin) * max(a, b), 0.0)
        peak = 2.0 * float(problem.load.force) / (math.pi * a * b)
        softest = min(self.coefficients.longitudinal, self.coefficients.lateral) * rolling_pair(problem.medium).shear
        unloading = 16.0 * problem.speed * peak / (3.0 * softest)
        return falling_note(float(np.max(law.fall(slowest))) * unloading)


@value
class RollingTraction:
    """Tractions over an elliptic contact that rolls along +x, strip by strip from the leading edge.

    Parameters
    ----------
    x, y : ndarray, (strips, places)
        [m].
    longitudinal, lateral : ndarray, (strips, places)
        Traction along and across the direction of rolling with which the second body drags the first [Pa].
    sliding : ndarray of bool, (strips, places)
        Where the surfaces slide.
    """

    __words__ = words(
        longitudinal=(r"\tau_x", "Pa", "traction along the direction of rolling"),
        lateral=(r"\tau_y", "Pa", "traction across the direction of rolling"),
        sliding=("", None, "where the surfaces slide"),
    )

    x: Array
    y: Array
    longitudinal: Array
    lateral: Array
    sliding: Array

    @property
    def traction(self) -> Array:
        """The resultant traction [Pa]."""
        return np.asarray(np.hypot(self.longitudinal, self.lateral))


JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 4.2, doi:10.1017/CBO9781139171731"
PRESCRIBED_ELLIPSE = Note(
    Assumption.SHAPE,
    Standing.ASYMPTOTIC,
    "The contact ellipse was given. It was not checked that the bodies touch on this ellipse under this "
    "load, or are large compared with it.",
    JOHNSON,
)
LARGEST_CHANGE = 1.0
"""Of friction by the unloading of the springs; beyond it friction falls faster than they unload, and they jump."""
POLACH = "O. Polach, Wear 258 (2005) 992-1000, doi:10.1016/j.wear.2004.03.046"
FIRST_DIGITS = Note(
    Assumption.CALIBRATION,
    Standing.APPROXIMATE,
    "The springs have no separate coefficient for the moment due to spin. For a/b from 1 : 5 to 2 : 1 its "
    "initial slope is up to 27 per cent too low.",
    "compared with CONTACT's coefficients of ellipses",
)
THEORY = (
    "The simplified theory uses independent springs, with flexibilities from Kalker's coefficients, and a parabolic "
    "traction bound. "
)


def distance_notes(creepage: Creepage, ratio: float, poisson: float) -> tuple[Note, ...]:
    """Return how far forces and moments are from the exact theory on an ellipse of a ratio a/b.

    Parameters
    ----------
    creepage : Creepage
    ratio : float
        a/b [-].
    poisson : float
        Of the pair of bodies [-].
    """
    known = ellipse_distances(ratio, poisson)
    spun = bool(np.any(np.asarray(creepage.spin) != 0.0))
    both = bool(np.any(np.multiply(creepage.longitudinal, creepage.lateral) != 0.0))
    if known is None:
        statement = (
            f"{THEORY}For an ellipse with a/b = {ratio:.3g} the creep forces were not compared with the exact theory."
        )
        return (Note(Assumption.CALIBRATION, Standing.APPROXIMATE, statement, MEASURED_BY),)
    under = "With spin" if spun else "Under both creepages" if both else "Under longitudinal or lateral creepage alone"
    distance = known.spun if spun else known.both if both else known.one
    turned = known.spun_moment if spun else known.moment
    statement = (
        f"{THEORY}The springs were compared with Kalker's exact theory for similar ellipses and Poisson's ratios. "
        f"{under} the force differs by at most {distance:.2g} mu F_N, the moment by at most {turned:.2g} mu F_N "
        "sqrt(a b)."
    )
    first = Note(Assumption.CALIBRATION, Standing.APPROXIMATE, statement, MEASURED_BY)
    return (first, FIRST_DIGITS) if spun else (first,)


def moment_note(coefficients: CreepCoefficients, longitudinal: float, lateral: float) -> Note:
    """Return how much of the moment under lateral creepage the springs bear, on an ellipse of these semi-axes [m].

    Of the exact theory it begins as -G (ab)^1.5 c23 eta; of springs, whose p_y = (l - x) eta / L_2 grows from the
    leading edge l on, as -eta / L_2 times the integral of x^2 over the ellipse.
    """
    slender = math.sqrt(longitudinal / lateral)
    part = 3.0 * math.pi / 32.0 * coefficients.lateral / coefficients.spin * slender
    return Note(
        Assumption.CALIBRATION,
        Standing.APPROXIMATE,
        f"The initial slope of the moment under lateral creepage is {100.0 * part:.2g} per cent of that of the "
        "exact theory on this ellipse.",
        "Kalker's coefficient c23, by reciprocity",
    )


def falling_note(change: float) -> Note:
    """Return what friction that falls with the velocity of slip leaves out.

    Parameters
    ----------
    change : float
        Greatest change of friction by the velocity at which springs that slide unload, over friction [-].
    """
    return Note(
        Assumption.SLIP,
        Standing.APPROXIMATE if change <= LARGEST_CHANGE else Standing.OUTSIDE,
        "Friction depends on the slip velocity of rigid bodies. The additional slip velocity of unloading "
        f"springs is neglected; it changes friction by at most about {100.0 * change:.2g} per cent.",
        POLACH,
        change,
    )


def size_note(footprint: ContactEllipse | CurvedBodies | CurvedPair, longitudinal: float, lateral: float) -> Note:
    """Return whether the bodies may be taken for half-spaces, with a contact of these semi-axes [m]."""
    if isinstance(footprint, ContactEllipse):
        return PRESCRIBED_ELLIPSE
    radii = footprint.longitudinal_curvature_radius, footprint.lateral_curvature_radius
    ratio = max(longitudinal / radii[0], lateral / radii[1])
    if ratio <= 0.1:
        standing, verdict = Standing.ASYMPTOTIC, "the bodies can be treated as half-spaces"
    elif ratio <= 0.5:
        standing, verdict = Standing.APPROXIMATE, "the bodies deviate notably from half-spaces"
    else:
        standing, verdict = Standing.OUTSIDE, "the bodies are no half-spaces"
    statement = f"The semi-axes are up to {ratio:.3g} of the relative radii of curvature: {verdict}."
    return Note(Assumption.HALF_SPACE, standing, statement, JOHNSON)
