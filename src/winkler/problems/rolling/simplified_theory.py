r"""Simplified theory of rolling: an elliptic contact on springs along the surface, with creepage and spin.

Every point of the ellipse is a spring of its own, :math:`u_x=L\,p_x`: again a Winkler foundation, but of the
surface instead of the line.  Kalker chose the flexibilities so that creep forces begin as those of the exact theory,

.. math:: L_1=\frac{8a}{3c_{11}G},\qquad L_2=\frac{8a}{3c_{22}G},\qquad L_3=\frac{\pi a\sqrt{a/b}}{4c_{23}G},

and the bound is a parabola, :math:`\mu\,\frac{2F_N}{\pi ab}(1-x^2/a^2-y^2/b^2)`.  His FASTSIM steps through the contact
strip by strip; here the steps are those of `winkler.numerics.springs.fastsim`, of second order.
"""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.checks.field_checks import Condition
from winkler.checks.number_checks import Advice, Whole
from winkler.errors import InvalidInput
from winkler.laws.friction import Sliding
from winkler.loading import Force
from winkler.media.halfspace import HalfSpace
from winkler.numerics.springs.fastsim import mapped, rolled
from winkler.numerics.types import Array, Quantity, shaped
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.declared import ROLLING
from winkler.problems.normal.yield_of_pressure import ellipse_yield_notes
from winkler.problems.rolling.creepage import Creepage, CreepageSolution
from winkler.problems.rolling.kalker import CreepCoefficients, creep_coefficients, rolling_pair
from winkler.profiles.ellipse import ContactEllipse, CurvedBodies
from winkler.validity import Assumption, Note, Standing
from winkler.values import value, words

__all__ = ["RollingTraction", "SimplifiedRolling", "SimplifiedRollingSolution"]

JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 4.2, doi:10.1017/CBO9781139171731"
HALF_BOUND_INTEGRAL = 0.25 * math.pi
"""Half the integral of the bound over the unit disc: sums over it become forces over mu F_N."""


ISOTROPIC = Advice("Kalker's coefficients are those of homogeneous, isotropic bodies")
ONE_FORCE = Condition(
    lambda load: np.ndim(load.force) == 0 and float(load.force) > 0.0, "give Force(F) with one positive number"
)


@value
class SimplifiedRolling:
    """Bodies that roll over each other on an elliptic contact, with creepage and spin.

    Parameters
    ----------
    footprint : ContactEllipse or CurvedBodies
        The contact, or the curvatures it comes from.
    medium : HalfSpace
        The pair of bodies.
    friction : Coulomb
        Its coefficient positive and finite.
    creepage : Creepage
        Longitudinal, lateral and spin, also arrays.
    load : Force
        The normal force, one positive number.
    count : int, optional
        Strips across the contact, and steps along each.

    Raises
    ------
    InvalidInput
        If the load is no positive number, the medium no HalfSpace, or friction not Coulomb's.

    References
    ----------
    J. J. Kalker, Vehicle System Dynamics 11 (1982) 1-13, doi:10.1080/00423118208968684;
    E. A. H. Vollebregt, P. Wilders, Comput. Mech. 47 (2011) 105-116

    Examples
    --------
    Spin alone pushes sideways:

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.materials.elastic import Elastic
    >>> steel = Elastic(young=208e9, poisson=0.25)
    >>> contact = ContactEllipse(longitudinal_semi_axis=6e-3, lateral_semi_axis=6e-3)
    >>> spun = SimplifiedRolling(
    ...     contact, HalfSpace.between(steel, steel), Coulomb(0.3), Creepage(spin=0.2), Force(80e3)
    ... ).solve()
    >>> round(spun.lateral_force / (0.3 * 80e3), 3), round(abs(spun.longitudinal_force), 6)
    (0.216, 0.0)
    """

    __words__ = words(count=("n", "", "strips across the contact, and steps along each"))

    footprint: ContactEllipse | CurvedBodies
    medium: Annotated[HalfSpace, ISOTROPIC]
    friction: Sliding
    creepage: Creepage
    load: Annotated[Force, ONE_FORCE]
    count: Annotated[int, Whole(4, 4096, "strips")] = 32

    references: ClassVar[tuple[str, ...]] = ("kalker_1982", "kalker_1990", "vollebregt_wilders_2011")
    assumptions: ClassVar[frozenset[Assumption]] = ROLLING

    def solve(self) -> SimplifiedRollingSolution:
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
        creep_coefficients_ = creep_coefficients(a / b, rolling_pair(self.medium).poisson)
        sums = np.empty((self.creepage.broadcast()[0].size, 4))
        rolled(self.drives(a, b, creep_coefficients_), self.count, sums)
        most = self.friction.coefficient * float(self.load.force)
        forces = most * sums.T / (2.0 * HALF_BOUND_INTEGRAL)

        def shaped(result: Array) -> Quantity:
            return float(result[0]) if self.creepage.shape == () else result.reshape(self.creepage.shape)

        moment = a * forces[2] - b * forces[3]
        return SimplifiedRollingSolution(
            self, a, b, creep_coefficients_, *(shaped(q) for q in (forces[0], forces[1], moment))
        )

    def drives(self, a: float, b: float, creep_coefficients_: CreepCoefficients) -> Array:
        """Return how fast sticking tractions grow, in units of the disc and of the greatest bound, ``(m, 4)``."""
        xi, eta, spin = self.creepage.broadcast()
        shear = rolling_pair(self.medium).shear
        first, second = (
            8.0 * a / (3.0 * creep_coefficients_.longitudinal * shear),
            8.0 * a / (3.0 * creep_coefficients_.lateral * shear),
        )
        third = math.pi * a * math.sqrt(a / b) / (4.0 * creep_coefficients_.spin * shear)
        bound = 2.0 * self.friction.coefficient * float(self.load.force) / (math.pi * a * b)
        unit = a / bound
        return np.stack([xi / first, eta / second, spin * b / third, spin * a / third], axis=1) * unit


@value
class SimplifiedRollingSolution(CreepageSolution):
    """The solution of a `SimplifiedRolling`; forces and moment have the shape of the creepage.

    Parameters
    ----------
    problem : SimplifiedRolling
        The problem that was solved.
    longitudinal_semi_axis, lateral_semi_axis : float
        a and b [m].
    coefficients : CreepCoefficients
        Kalker's, of this ellipse.
    longitudinal_force, lateral_force : float or ndarray
        F_x and F_y [N], with which the second body drags the first.
    moment : float or ndarray
        M_z [N m], with which it turns it: an approximation of its own, see `validity`.
    """

    __words__ = words(
        moment=("M_z", "N m", "moment about the normal of the contact"),
        coefficients=("c_{ij}", None, "Kalker's creep coefficients of the ellipse"),
        traction=("", None, "tractions over the contact"),
    )

    problem: SimplifiedRolling
    longitudinal_semi_axis: float
    lateral_semi_axis: float
    coefficients: CreepCoefficients
    longitudinal_force: Quantity
    lateral_force: Quantity
    moment: Quantity

    @property
    def spin_creepage(self) -> Quantity:
        """phi [1/m], in the shape of the results."""
        return shaped(np.broadcast_to(self.problem.creepage.spin, self.problem.creepage.shape))

    @property
    def shear_force(self) -> Quantity:
        """The resultant of both forces [N]."""
        return shaped(np.hypot(self.longitudinal_force, self.lateral_force))

    @property
    def saturation(self) -> Quantity:
        """The resultant over mu F_N [-]."""
        most = self.problem.friction.coefficient * float(self.problem.load.force)
        return shaped(np.asarray(self.shear_force) / most)

    @property
    def loss_per_distance(self) -> Quantity:
        """Energy lost per distance rolled [J/m]: creepage times force, and spin times moment."""
        creep = self.problem.creepage
        lost = np.asarray(creep.longitudinal) * self.longitudinal_force + np.asarray(creep.lateral) * self.lateral_force
        return shaped(lost + np.asarray(creep.spin) * self.moment)

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
        drive = problem.drives(a, b, self.coefficients)[0]
        across = np.sin(np.pi * ((np.arange(count) + 0.5) / count - 0.5))
        tractions, sliding = np.empty((count, 2, count + 1)), np.empty((count, count + 1))
        mapped(drive, across, tractions, sliding)
        along = np.sqrt(1.0 - across**2)[:, None] * np.linspace(1.0, -1.0, count + 1)
        peak = 2.0 * problem.friction.coefficient * float(problem.load.force) / (math.pi * a * b)
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
        stated, axes, creep = self.problem, (self.longitudinal_semi_axis, self.lateral_semi_axis), self.problem.creepage
        with_spin, aside = (bool(np.any(np.asarray(part) != 0.0)) for part in (creep.spin, creep.lateral))
        moments = (*((self._moment_note,) if aside else ()), *((SPIN,) if with_spin else ()))
        coupled = sticking_note(stated.medium, stated.friction.coefficient)
        yielding = ellipse_yield_notes(stated.medium, axes, stated.load.force, stated.friction.coefficient)
        return (*stated.medium.notes, self._size_note, coupled, CREEP, *moments, *yielding)

    @property
    def _moment_note(self) -> Note:
        """Return how much of the moment under lateral creepage the springs bear.

        Of the exact theory it begins as -G (ab)^1.5 c23 eta; of springs, whose p_y = (l - x) eta / L_2 grows from the
        leading edge l on, as -eta / L_2 times the integral of x^2 over the ellipse.
        """
        creep_coefficients_ = self.coefficients
        slender = math.sqrt(self.longitudinal_semi_axis / self.lateral_semi_axis)
        part = 3.0 * math.pi / 32.0 * creep_coefficients_.lateral / creep_coefficients_.spin * slender
        return Note(
            Assumption.CALIBRATION,
            Standing.APPROXIMATE,
            f"The moment under lateral creepage begins at {100.0 * part:.2g} per cent of that of the exact theory on "
            "this ellipse, and stays within 0.03 of mu F_N a of it for a circle.",
            "Kalker's coefficient c23, by reciprocity; compared with CONTACT's curves of a circle",
        )

    @property
    def _size_note(self) -> Note:
        """Return whether the bodies may be taken for half-spaces."""
        match self.problem.footprint:
            case CurvedBodies(along, across):
                ratio = max(self.longitudinal_semi_axis / along, self.lateral_semi_axis / across)
            case _:
                return PRESCRIBED_PRESSURE
        if ratio <= 0.1:
            standing, verdict = Standing.ASYMPTOTIC, "the bodies may be taken for half-spaces"
        elif ratio <= 0.5:
            standing, verdict = Standing.APPROXIMATE, "the bodies are hardly half-spaces any more"
        else:
            standing, verdict = Standing.OUTSIDE, "the bodies are no half-spaces"
        statement = f"The semi-axes are up to {ratio:.3g} of the relative radii of curvature: {verdict}."
        return Note(Assumption.HALF_SPACE, standing, statement, JOHNSON)


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


PRESCRIBED_PRESSURE = Note(
    Assumption.SHAPE,
    Standing.ASYMPTOTIC,
    "The ellipse was given: that these bodies touch on it under this load, and are large beside it, is not checked.",
    JOHNSON,
)
CREEP = Note(
    Assumption.CALIBRATION,
    Standing.APPROXIMATE,
    "Simplified theory: one spring for every point, its flexibility chosen by Kalker's coefficients, under a parabolic "
    "bound; creep forces of a circle stay within 0.04 of mu F_N of the exact theory.",
    "compared with CONTACT's curves of a circle",
)
SPIN = Note(
    Assumption.CALIBRATION,
    Standing.APPROXIMATE,
    "Under spin the lateral force stays within 0.11 of mu F_N of the exact theory for a circle; the moment about the "
    "normal, which has no coefficient of its own in the springs, begins up to 27 per cent too low on ellipses of 1 : 5 "
    "to 2 : 1 and stays within 0.1 of mu F_N a for a circle.",
    "compared with CONTACT's curves of a circle and its coefficients of ellipses",
)
