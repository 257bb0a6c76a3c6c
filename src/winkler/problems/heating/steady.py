r"""Frictional heating: how warm two bodies get where they rub.

The flux of heat is :math:`\mu\,p\,v`, with the pressure of the frictionless contact and the speed v of sliding.  A body
that rests against a round contact warms up to

.. math:: T = \frac{\mu v E^*}{2\lambda}\,u_z(r) ,

the displacement of the surface times a constant; one that moves past it at the speed V, with the Peclet number
:math:`\mathrm{Pe}=Va/2\kappa`, stays cooler, and its warmest place lies behind the middle.  Both come from the same
springs: at rest, temperature is a mean of line loads over all directions, and motion changes each of these line loads
by itself (`winkler.numerics.fields.moving_source`; of ellipses in closed form,
`winkler.numerics.fields.elliptic_source`).  The two bodies share the heat by a rule of their own.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Annotated, ClassVar

import numpy as np

from winkler.laws.friction import Overcome
from winkler.laws.heat import EqualMaximum, HeatPartition
from winkler.loading.path import load_number
from winkler.media.conduction.conductors import HeatConductors
from winkler.numerics.types import PerLoad, Q, shaped
from winkler.problems.assumptions.declared import HEATED
from winkler.problems.heating.estimates import fast, stationary, tian_kennedy
from winkler.problems.heating.heat_source import PointSource, half_lengths, heat_sources
from winkler.problems.heating.heated_body import HeatedBody, Turn, sliding_line
from winkler.problems.heating.input_checks import RubbingPlatedBodies, peclet_numbers, refuse_contact
from winkler.problems.heating.moved_body import HeatBody, warmed
from winkler.problems.heating.one_result import contact_at, one_problem, one_result
from winkler.problems.heating.sharing import SharedHeat
from winkler.problems.heating.validity import heating_notes, sliding_contact_notes
from winkler.problems.normal.elliptic import EllipticIndentation, EllipticSolution
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.one_load import single
from winkler.values.checks.number_checks import FINITE_QUANTITY
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words


@value
class FrictionHeating(RubbingPlatedBodies, PerLoad[Q]):
    """Frictional heating of two bodies that slide, or roll and slide.

    Parameters
    ----------
    contact : Indentation or EllipticIndentation
        The mechanical contact: a round contact on any medium, or bodies with two curvatures each. For an array of loads
        the results have its shape.
    law : Coulomb
        Friction, with a finite coefficient.
    conductors : HeatConductors
        Thermal conductors of the bodies: two thick bodies of ThermalConductor, or Plated made of it, in perfect
        thermal contact.  Elastic layers have the conductivity of the material below.
    first_speed, second_speed : float or ndarray, optional
        Speeds [m/s] at which the surface of either body moves past the contact.  A pin of the second body on a plate
        has `second_speed` 0, the default.  Arrays broadcast with each other and with the load.
    first_direction, second_direction : float, optional
        Angles of the velocities to x [rad], at most one turn; 0, along x, by default.  The bodies slide with the
        difference of the velocities.
    partition : EqualMaximum, EqualMean or FixedShare, optional
        Rule for the heat partition; by default Blok's rule, EqualMaximum().

    Raises
    ------
    InvalidInput
        If the law is not Coulomb's with a finite coefficient, or a conductor or partition has the wrong type. If a
        number is not finite, or speeds and load do not broadcast. If a second body at rest has a direction.
    OutsideValidity
        If the foundation represents a contact that may not be round.

    References
    ----------
    J. C. Jaeger, Proc. R. Soc. New South Wales 76 (1942) 203-224; H. Blok, Wear 6 (1963) 483-494,
    doi:10.1016/0043-1648(63)90283-7; X. Tian, F. E. Kennedy, J. Tribol. 116 (1994) 167-174, doi:10.1115/1.2927035;
    V. L. Popov, M. Hess, Method of Dimensionality Reduction, Springer 2015, doi:10.1007/978-3-642-53876-6

    Examples
    --------
    A ball on a plate, both of steel, at Pe = 1 of the plate:

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading.loads import Force, Radius
    >>> from winkler.materials.conductor import ThermalConductor
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.ellipse import CurvedBodies
    >>> from winkler.profiles.power import Paraboloid
    >>> elastic, steel = Elastic(210e9, 0.3), ThermalConductor(45.0, 12e-6)
    >>> medium, pair = HalfSpace.between(elastic, elastic), HeatConductors(steel, steel)
    >>> ball = Indentation(Foundation(Paraboloid(10e-3), medium), Radius(1e-4))
    >>> rubbing = FrictionHeating(ball, Coulomb(0.3), pair, first_speed=0.24).solve()
    >>> round(rubbing.first_peclet, 12), round(rubbing.first_share, 5), round(rubbing.flash_temperature, 3)
    (1.0, 0.57328, 39.39)

    An ellipse slides along its short and along its long axis:

    >>> slender = EllipticIndentation(CurvedBodies(5e-3, 40e-3), medium, Force(200.0))
    >>> for direction in (0.0, math.pi / 2):
    ...     slides = FrictionHeating(slender, Coulomb(0.1), pair, first_speed=2.0, first_direction=direction).solve()
    ...     print(round(slides.first_peclet, 2), round(slides.flash_temperature, 1))
    10.54 192.8
    41.18 295.6
    """

    __words__ = words(
        contact=("", None, "how the bodies are pressed together"),
        first_direction=(r"\psi_1", "rad", "angle of the first body's velocity to x"),
        second_direction=(r"\psi_2", "rad", "angle of the second body's velocity to x"),
    )

    contact: Indentation[Q] | EllipticIndentation[Q]
    law: Overcome
    conductors: HeatConductors
    first_speed: Annotated[Q | float, FINITE_QUANTITY]
    second_speed: Annotated[Q | float, FINITE_QUANTITY] = 0.0
    first_direction: Turn = 0.0
    second_direction: Turn = 0.0
    partition: HeatPartition = EqualMaximum()

    references: ClassVar[tuple[str, ...]] = ("jaeger_1942", "blok_1963", "tian_kennedy_1994", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = HEATED

    def __post_init__(self) -> None:
        super().__post_init__()
        refuse_contact(self, self.contact)
        shapes = [np.shape(each) for each in (load_number(self.contact.load), self.first_speed, self.second_speed)]
        try:
            np.broadcast_shapes(*shapes)
        except ValueError:
            raise InvalidInput(
                f"FrictionHeating: load, first_speed and second_speed have the shapes {shapes[0]}, {shapes[1]} and "
                f"{shapes[2]}, which do not broadcast; give arrays of one shape, or single numbers."
            ) from None
        if self.second_direction and not np.any(self.second_speed):
            raise InvalidInput(
                f"FrictionHeating: second_direction is {self.second_direction:g} rad and second_speed is zero: a body "
                "at rest has no direction; give second_speed, or leave second_direction out."
            )

    @property
    def _directions(self) -> tuple[float, float]:
        """Angles of both velocities to x [rad]."""
        return self.first_direction, self.second_direction

    def _shared(self, contact: IndentationSolution[Q] | EllipticSolution[Q]) -> SharedHeat:
        speeds = [np.asarray(each, dtype=float) for each in (self.first_speed, self.second_speed)]
        shape = np.broadcast_shapes(np.shape(contact.depth), *(each.shape for each in speeds))
        rates = [np.broadcast_to(each, shape) for each in speeds]
        loads, sources = np.shape(contact.depth), heat_sources(contact)
        return SharedHeat(sources, loads, self._bodies, self.partition, rates, self._directions)

    def solve(self) -> FrictionHeatingSolution[Q]:
        """Return the temperatures of the bodies.

        Returns
        -------
        FrictionHeatingSolution

        Raises
        ------
        OutsideValidity
            If the contact does not support the load, or the pressure is not known in the medium. If a Peclet number is
            above 1e8. If bodies with two curvatures each on layers or graded bodies are plated.
        NotConverged
            If the profile is too rough, or the pressures of pixels are not found.
        """
        contact = self.contact.solve()
        heat = self._shared(contact)
        first, second = heat.speeds
        lengths = [half_lengths(contact, direction) for direction in self._directions]
        peclets = peclet_numbers("FrictionHeating", lengths, (first, second), self._bodies)
        between = self.first_direction - self.second_direction
        sliding = np.hypot(first * math.cos(between) - second, first * math.sin(between))
        released = self.law.coefficient * np.broadcast_to(contact.force, np.shape(first)) * sliding
        table = heat.temperatures(warmed)
        columns: list[Q] = [shaped(each) for each in (released, table[0], *peclets, *(table[1:] * released))]
        return FrictionHeatingSolution(self, contact, *columns)


@value
class FrictionHeatingSolution(PerLoad[Q]):
    """The solution of a `FrictionHeating`; every quantity has the common shape of load and speeds.

    Temperatures are rises above the temperature of the bodies far away.

    Parameters
    ----------
    problem : FrictionHeating
        The problem that was solved.
    contact : IndentationSolution or EllipticSolution
        The contact, of the shape of the load.
    heat_rate : float or ndarray
        Q = mu F v, the heat of friction per time [W].
    first_share : float or ndarray
        Heat partition: part of the heat that enters the first body [-]. Without contact it is the prescribed
        partition, or that of bodies at rest (ratio of conductivities).
    first_peclet, second_peclet : float or ndarray
        Pe = V l / (2 kappa) of each body, where l is half the contact length along its motion [-]; for a plated body
        with the smallest diffusivity.
    first_max_temperature, second_max_temperature : float or ndarray
        Maximum temperature of either surface within the contact [K].
    first_mean_temperature, second_mean_temperature : float or ndarray
        Mean temperature of either surface over the contact [K].
    """

    __words__ = words(
        first=("1", None, "the first body with its temperature"),
        second=("2", None, "the second body with its temperature"),
    )

    problem: FrictionHeating[Q]
    contact: IndentationSolution[Q] | EllipticSolution[Q]
    heat_rate: Q
    first_share: Q
    first_peclet: Q
    second_peclet: Q
    first_max_temperature: Q
    second_max_temperature: Q
    first_mean_temperature: Q
    second_mean_temperature: Q

    per_load: ClassVar[str] = "heat_rate"

    @property
    def radius(self) -> Q:
        """Radius of the contact a [m]; of an ellipse that of the circle of its area."""
        contact = self.contact
        found = contact.radius if isinstance(contact, IndentationSolution) else np.sqrt(contact.area / math.pi)
        return shaped(np.broadcast_to(found, np.shape(self.heat_rate)))

    @property
    def flash_temperature(self) -> Q:
        """The maximum temperature of the contact, that of the warmer body [K]."""
        return shaped(np.maximum(self.first_max_temperature, self.second_max_temperature))

    @property
    def stationary_temperature(self) -> Q:
        """Flash temperature by the rule for slow sliding [K], which treats both bodies as at rest.

        In homogeneous media it is mu v E* d / (2 (lambda_1 + lambda_2)), with the maximum displacement d.
        """
        return self._estimate(stationary)

    @property
    def fast_temperature(self) -> Q:
        """Limit of the flash temperature for high speed of the moving bodies [K]; a body at rest stays at rest.

        Infinite under a rigid punch with a sharp edge.
        """
        return self._estimate(fast)

    @property
    def tian_kennedy_temperature(self) -> Q:
        """Temperature by the fit of Tian and Kennedy for a parabolic flux on the same disc [K], without platings.

        Raises
        ------
        OutsideValidity
            If the contact is an ellipse.
        """
        if not isinstance(self.contact, IndentationSolution):
            raise OutsideValidity(
                "FrictionHeating: the fit of Tian and Kennedy is one of round contacts; for an ellipse compare with "
                "stationary_temperature and fast_temperature."
            )
        return self._estimate(tian_kennedy)

    def _estimate(self, per_watt: Callable[[PointSource, HeatBody, float, float], float]) -> Q:
        return shaped(self.problem._shared(self.contact).estimated(per_watt) * self.heat_rate)

    @property
    def overestimate(self) -> Q:
        """Relative error of the rule for slow sliding [-]: its excess over the flash temperature."""
        flash = np.asarray(self.flash_temperature)
        warm = flash > 0.0
        return shaped(np.where(warm, self.stationary_temperature / np.where(warm, flash, 1.0) - 1.0, 0.0))

    @property
    def first(self) -> HeatedBody:
        """The first body with its temperature field; of one load and speed, not of an array."""
        return self._body(0)

    @property
    def second(self) -> HeatedBody:
        """The second body with its temperature field; of one load and speed, not of an array."""
        return self._body(1)

    def _body(self, which: int) -> HeatedBody:
        heat, problem = single(self.heat_rate, "temperature field"), self.problem
        share = (self.first_share, 1.0 - self.first_share)[which]
        speed = (problem.first_speed, problem.second_speed)[which]
        (source,) = heat_sources(self.contact)
        body, direction = problem._bodies[which], problem._directions[which]
        return HeatedBody(body, float(speed), direction, float(share) * heat, source)

    def at(self, index: int | tuple[int, ...]) -> FrictionHeatingSolution[float]:
        """Return the solution of one load and speed of an array.

        Parameters
        ----------
        index : int or tuple of int
            Which one.

        Raises
        ------
        InvalidInput
            If there is none.
        """
        shape = np.shape(self.heat_rate)
        place, columns = one_result(self, index)
        contact = contact_at(self.contact, np.shape(self.contact.depth), shape, place)
        problem = one_problem(self.problem, shape, place, contact=contact.problem)
        return FrictionHeatingSolution(problem, contact, **columns)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        pairs = (
            (np.asarray(self.first_peclet), np.asarray(self.second_peclet)),
            (np.asarray(self.first_max_temperature), np.asarray(self.second_max_temperature)),
            (np.asarray(self.first_mean_temperature), np.asarray(self.second_mean_temperature)),
        )
        problem = self.problem
        angle = sliding_line((problem.first_speed, problem.second_speed), problem._directions)
        notes = heating_notes(*pairs, np.asarray(self.overestimate), problem.partition, problem._plated)
        return (*sliding_contact_notes(self.contact, problem.law.coefficient, angle), *notes)
