r"""Frictional heating: how warm two bodies get where they rub.

The flux of heat is :math:`\mu\,p\,v`, with the pressure of the frictionless contact and the speed v of sliding.  A body
that rests against the contact warms up to

.. math:: T = \frac{\mu v E^*}{2\lambda}\,u_z(r) ,

the displacement of the surface times a constant; one that moves past it at the speed V, with the Peclet number
:math:`\mathrm{Pe}=Va/2\kappa`, stays cooler, and its warmest place lies behind the middle.  Both come from the same
springs: at rest, temperature is a mean of line loads over all directions, and motion changes each of these line loads
by itself (`winkler.numerics.fields.moving_source`).  The two bodies share the heat by a rule of their own.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.friction import Overcome
from winkler.laws.heat import EqualMaximum, HeatPartition
from winkler.loading.loads import Depth, Force, Radius
from winkler.loading.path import load_number
from winkler.media.conduction.conductors import HeatConductors
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import HEATED
from winkler.problems.heating.estimates import fast, stationary, tian_kennedy
from winkler.problems.heating.heat_source import HeatSource
from winkler.problems.heating.heated_body import HeatedBody
from winkler.problems.heating.input_checks import RubbingPlatedBodies, peclet_numbers
from winkler.problems.heating.moved_body import HeatBody
from winkler.problems.heating.one_result import contact_at, one_problem, one_result
from winkler.problems.heating.sharing import estimated, shared_temperatures
from winkler.problems.heating.validity import heating_notes, sliding_contact_notes
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.one_load import single
from winkler.values.checks.number_checks import FINITE_QUANTITY
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

__all__ = ["FrictionHeating", "FrictionHeatingSolution"]


@value
class FrictionHeating(RubbingPlatedBodies, PerLoad[Q]):
    """Two bodies that slide on each other and warm up.

    Parameters
    ----------
    bed : Bed
        The springs: Foundation(profile, medium) or another bed.
    law : Coulomb
        Friction, with a finite coefficient.
    load : Force, Depth or Radius
        The normal load, which may be an array.
    conductors : HeatConductors
        How the bodies conduct heat: two thick bodies of ThermalConductor, or Plated made
        of it, a perfect touch between them.
    first_speed, second_speed : float or ndarray, optional
        Velocities [m/s] along x at which the surface of either body moves past the contact; they slide with the
        difference.  A pin of the second body on a plate has `second_speed` 0, the default.  Arrays broadcast with each
        other and with the load.
    partition : EqualMaximum, EqualMean or FixedShare, optional
        How the bodies share the heat; Blok's rule, EqualMaximum(), unless given.

    Raises
    ------
    InvalidInput
        If the law is not Coulomb's with a finite coefficient, a conductor or partition is none, a speed is not finite,
        or speeds and load do not broadcast.

    References
    ----------
    J. C. Jaeger, Proc. R. Soc. New South Wales 76 (1942) 203-224; X. Tian, F. E. Kennedy, J. Tribol. 116 (1994)
    167-174, doi:10.1115/1.2927035; V. L. Popov, M. Hess, Method of Dimensionality Reduction, Springer 2015,
    doi:10.1007/978-3-642-53876-6

    Examples
    --------
    A ball on a plate, both of steel, at Pe = 1 of the plate:

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading.loads import Radius
    >>> from winkler.materials.conductor import ThermalConductor
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> elastic, steel = Elastic(210e9, 0.3), ThermalConductor(45.0, 12e-6)
    >>> bed = Foundation(Paraboloid(10e-3), HalfSpace.between(elastic, elastic))
    >>> pair = HeatConductors(steel, steel)
    >>> rubbing = FrictionHeating(bed, Coulomb(0.3), Radius(1e-4), pair, first_speed=0.24).solve()
    >>> round(rubbing.first_peclet, 12), round(rubbing.first_share, 5), round(rubbing.flash_temperature, 3)
    (1.0, 0.57328, 39.39)
    """

    bed: Bed
    law: Overcome
    load: Force[Q] | Depth[Q] | Radius[Q]
    conductors: HeatConductors
    first_speed: Annotated[Q | float, FINITE_QUANTITY]
    second_speed: Annotated[Q | float, FINITE_QUANTITY] = 0.0
    partition: HeatPartition = EqualMaximum()

    references: ClassVar[tuple[str, ...]] = ("jaeger_1942", "blok_1963", "tian_kennedy_1994", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = HEATED
    needs_round: ClassVar[str] = "the heat of friction, which follows the pressure from place to place,"

    def __post_init__(self) -> None:
        super().__post_init__()
        shapes = [np.shape(each) for each in (load_number(self.load), self.first_speed, self.second_speed)]
        try:
            np.broadcast_shapes(*shapes)
        except ValueError:
            raise InvalidInput(
                f"FrictionHeating: load, first_speed and second_speed have the shapes {shapes[0]}, {shapes[1]} and "
                f"{shapes[2]}, which do not broadcast; give arrays of one shape, or single numbers."
            ) from None

    def solve(self) -> FrictionHeatingSolution[Q]:
        """Return how warm the bodies get.

        Returns
        -------
        FrictionHeatingSolution

        Raises
        ------
        OutsideValidity
            If the load is refused by `Indentation`, the pressure is not known in the medium, or a Peclet number is
            above 1e8.
        NotConverged
            If the profile is too rough.
        """
        contact = Indentation(self.bed, self.load).solve()
        speeds = [np.asarray(each, dtype=float) for each in (self.first_speed, self.second_speed)]
        shape = np.broadcast_shapes(np.shape(contact.radius), *(each.shape for each in speeds))
        rates = [np.broadcast_to(each, shape) for each in speeds]
        peclets = peclet_numbers("FrictionHeating", contact.radius, rates, self._bodies)
        table = shared_temperatures(contact, self._bodies, self.partition, rates)
        heat = self.law.coefficient * np.broadcast_to(contact.force, shape) * np.abs(rates[0] - rates[1])
        columns = [heat, table[0], *peclets, *(table[1:] * heat)]
        return FrictionHeatingSolution(self, contact, *(shaped(each) for each in columns))


@value
class FrictionHeatingSolution(PerLoad[Q]):
    """The solution of a `FrictionHeating`; every quantity has the common shape of load and speeds.

    Temperatures are rises above that of the bodies far away.

    Parameters
    ----------
    problem : FrictionHeating
        The problem that was solved.
    contact : IndentationSolution
        The contact, of the shape of the load.
    heat_rate : float or ndarray
        Q = mu F v, the heat of friction per time [W].
    first_share : float or ndarray
        Part of it that goes into the first body [-]; without contact the fixed one, or that of bodies at rest, their
        conductivities against each other.
    first_peclet, second_peclet : float or ndarray
        Pe = V a / (2 kappa) of either body [-]; of a plated one with the least diffusivity.
    first_max_temperature, second_max_temperature : float or ndarray
        Greatest temperature of either surface within the contact [K].
    first_mean_temperature, second_mean_temperature : float or ndarray
        Mean temperature of either surface over the contact [K].
    """

    __words__ = words(
        first=("1", None, "the first body with its temperature"),
        second=("2", None, "the second body with its temperature"),
    )

    problem: FrictionHeating[Q]
    contact: IndentationSolution[Q]
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
        """Radius of the contact a [m]."""
        return shaped(np.broadcast_to(self.contact.radius, np.shape(self.heat_rate)))

    @property
    def flash_temperature(self) -> Q:
        """The greatest temperature of the contact, that of the warmer body [K]."""
        return shaped(np.maximum(self.first_max_temperature, self.second_max_temperature))

    @property
    def stationary_temperature(self) -> Q:
        """What the rule of slow sliding gives for the flash temperature [K]: both bodies as if at rest.

        mu v E* d / (2 (lambda_1 + lambda_2)) in homogeneous media, if the greatest displacement is d.
        """
        return self._estimate(stationary)

    @property
    def fast_temperature(self) -> Q:
        """What the flash temperature tends to when all that moves does so fast [K]; a body at rest stays at rest.

        Infinite under a rigid punch with a sharp edge.
        """
        return self._estimate(fast)

    @property
    def tian_kennedy_temperature(self) -> Q:
        """What the fit of Tian and Kennedy gives for a parabolic flux on the same disc [K]; platings are left out."""
        return self._estimate(tian_kennedy)

    def _estimate(self, per_watt: Callable[[HeatSource, HeatBody, Array], Array]) -> Q:
        problem, shape = self.problem, np.shape(self.heat_rate)
        first, second = (np.broadcast_to(each, shape) for each in (problem.first_speed, problem.second_speed))
        found = estimated(per_watt, self.contact, problem._bodies, problem.partition, (first, second))
        return shaped(found * self.heat_rate)

    @property
    def overestimate(self) -> Q:
        """By how much the rule of slow sliding exceeds the flash temperature, relative to that [-]."""
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
        heat = single(self.heat_rate, "temperature field")
        share = (self.first_share, 1.0 - self.first_share)[which]
        speed = (self.problem.first_speed, self.problem.second_speed)[which]
        return HeatedBody(self.problem._bodies[which], float(speed), float(share) * heat, self.contact.pressed)

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
        contact = contact_at(self.contact, np.shape(self.contact.radius), shape, place)
        problem = one_problem(self.problem, shape, place, load=contact.problem.load)
        return FrictionHeatingSolution(problem, contact, **columns)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        pairs = (
            (np.asarray(self.first_peclet), np.asarray(self.second_peclet)),
            (np.asarray(self.first_max_temperature), np.asarray(self.second_max_temperature)),
            (np.asarray(self.first_mean_temperature), np.asarray(self.second_mean_temperature)),
        )
        notes = heating_notes(*pairs, np.asarray(self.overestimate), self.problem.partition, self.problem._plated)
        return (*sliding_contact_notes(self.contact, self.problem.law.coefficient), *notes)
