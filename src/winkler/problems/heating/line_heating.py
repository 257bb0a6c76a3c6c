r"""Flash temperature of a line contact: the band of heat under a roller, a gear tooth, a cam.

The flux is :math:`\mu\,p(x)\,v` with the pressure of the line contact and the speed of sliding
:math:`v=|V_1-V_2|`; the surfaces move past the contact at V1 and V2.  The body that moves at V warms up by

.. math:: T(x) = \frac{1}{\pi\lambda}\int_{-a}^a q(s)\,\mathrm e^{z} K_0(|z|)\,\mathrm ds , \qquad
          z = \frac{V}{2\kappa}(x-s) ,

(`winkler.numerics.fields.band_source`), and the bodies share the heat.  A body that rests against an endless band has
no steady temperature: it becomes warmer and warmer with the logarithm of time.
"""

from __future__ import annotations

import dataclasses
from typing import Annotated, ClassVar

import numpy as np

from winkler.laws.friction import Overcome
from winkler.laws.heat import EqualMaximum, HeatPartition
from winkler.media.conduction.conductors import HeatConductors
from winkler.numerics.types import Q, shaped
from winkler.problems.assumptions.coupling import sliding_note
from winkler.problems.assumptions.declared import HEATED
from winkler.problems.heating.one_result import contact_at, one_problem, one_result
from winkler.problems.heating.strip_heating import StripHeating, StripTemperatures
from winkler.problems.line.indentation import LineIndentation, LineSolution
from winkler.values.checks.number_checks import FINITE_QUANTITY
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words


@value
class LineFrictionHeating(StripHeating[Q]):
    """Frictional heating of two bodies in line contact that slide, or roll and slide.

    Parameters
    ----------
    contact : LineIndentation
        The mechanical contact. For an array of loads the results have its shape.
    law : Coulomb
        Friction, with a finite coefficient.
    conductors : HeatConductors
        Thermal conductors of the bodies: two thick bodies of ThermalConductor, or Plated made of it, in perfect
        thermal contact.
    first_speed, second_speed : float or ndarray
        Velocities [m/s] along x at which each surface passes the contact, not zero; the sliding velocity is their
        difference.  Zero is allowed for a body that receives no heat, FixedShare(1.0) or FixedShare(0.0).  Arrays
        broadcast with each other and with the load.
    partition : EqualMaximum, EqualMean or FixedShare, optional
        Rule for the heat partition; by default Blok's rule, EqualMaximum().

    Raises
    ------
    OutsideValidity
        If a layer slides on the material below, because friction would displace it without limit.
    InvalidInput
        If a body that receives heat is at rest relative to the contact. If a conductor has the wrong type, a speed is
        not finite, or speeds and load do not broadcast.

    References
    ----------
    J. C. Jaeger, Proc. R. Soc. New South Wales 76 (1942) 203-224; H. Blok, Wear 6 (1963) 483-494,
    doi:10.1016/0043-1648(63)90283-7

    Examples
    --------
    Two steel discs that roll at 6 m/s and 4 m/s:

    >>> from winkler.foundation.line import LineFoundation
    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading.loads import LineForce
    >>> from winkler.materials.conductor import ThermalConductor
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> elastic, steel = Elastic(210e9, 0.3), ThermalConductor(45.0, 12e-6)
    >>> bed = LineFoundation(Paraboloid(10e-3), HalfSpace.between(elastic, elastic))
    >>> pressed, pair = LineIndentation(bed, LineForce(400e3)), HeatConductors(steel, steel)
    >>> discs = LineFrictionHeating(pressed, Coulomb(0.05), pair, first_speed=6.0, second_speed=4.0).solve()
    >>> round(discs.first_peclet, 1), round(discs.first_share, 4), round(discs.flash_temperature, 2)
    (52.5, 0.5505, 37.52)
    """

    __words__ = words(contact=("", None, "how the bodies are pressed together"))

    contact: LineIndentation[Q]
    law: Overcome
    conductors: HeatConductors
    first_speed: Annotated[Q | float, FINITE_QUANTITY]
    second_speed: Annotated[Q | float, FINITE_QUANTITY]
    partition: HeatPartition = EqualMaximum()

    references: ClassVar[tuple[str, ...]] = ("jaeger_1942", "blok_1963", "johnson_1985")
    assumptions: ClassVar[frozenset[Assumption]] = HEATED

    def __post_init__(self) -> None:
        super().__post_init__()
        self.contact.bed.refuse_dragged(self.law.coefficient)
        self._check_speeds(load=dataclasses.astuple(self.contact.load)[0])

    def solve(self) -> LineFrictionHeatingSolution[Q]:
        """Return the temperatures of the bodies.

        Returns
        -------
        LineFrictionHeatingSolution

        Raises
        ------
        OutsideValidity
            If `LineIndentation` does not support the load, or a Peclet number is above 1e8 or below 1e-8.
        """
        contact = self.contact.solve()
        shape = np.broadcast_shapes(np.shape(contact.half_width), *map(np.shape, self._speeds))
        first, second = self._speeds
        heat = self.law.coefficient * np.broadcast_to(contact.force_per_length, shape) * np.abs(first - second)
        return LineFrictionHeatingSolution(self, contact, *self._columns(contact, heat))


@value
class LineFrictionHeatingSolution(StripTemperatures[Q]):
    """The solution of a `LineFrictionHeating`; each quantity has the common shape of load and speeds.

    Temperatures are rises above the temperature of the bodies far away.

    Parameters
    ----------
    problem : LineFrictionHeating
        The problem that was solved.
    contact : LineSolution
        The contact, of the shape of the load.
    heat_per_length : float or ndarray
        Q = mu P v, the heat of friction per time and length [W/m].
    first_share : float or ndarray
        Heat partition: part of the heat that enters the first body [-]. Without contact it is the prescribed
        partition, or that of bodies at rest (ratio of conductivities).
    first_peclet, second_peclet : float or ndarray
        Pe = V a / (2 kappa) of each body [-]; for a plated body with the smallest diffusivity.
    first_max_temperature, second_max_temperature : float or ndarray
        Maximum temperature of either surface [K].
    first_mean_temperature, second_mean_temperature : float or ndarray
        Mean temperature of either surface over the strip [K].
    """

    problem: LineFrictionHeating[Q]
    contact: LineSolution[Q]
    heat_per_length: Q
    first_share: Q
    first_peclet: Q
    second_peclet: Q
    first_max_temperature: Q
    second_max_temperature: Q
    first_mean_temperature: Q
    second_mean_temperature: Q

    @property
    def half_width(self) -> Q:
        """Half-width of the strip a [m]."""
        return shaped(np.broadcast_to(self.contact.half_width, np.shape(self.heat_per_length)))

    @property
    def _heated(self) -> LineSolution[Q]:
        return self.contact

    def at(self, index: int | tuple[int, ...]) -> LineFrictionHeatingSolution[float]:
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
        shape = np.shape(self.heat_per_length)
        place, columns = one_result(self, index)
        contact = contact_at(self.contact, np.shape(self.contact.half_width), shape, place)
        problem = one_problem(self.problem, shape, place, contact=contact.problem)
        return LineFrictionHeatingSolution(problem, contact, **columns)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        friction = self.problem.law.coefficient
        return (
            *self.contact.dragged_notes(friction),
            sliding_note(self.problem.contact.bed.medium, friction),  # type: ignore[arg-type]
            *self._notes(),
        )
