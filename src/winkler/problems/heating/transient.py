r"""How a contact that begins to rub warms up.

Both bodies are taken at rest under a flux :math:`\mu\,p\,v` that is switched on: it moves too slowly, or to and fro by
too little, to matter.  Waves of temperature of the wave number k have then grown by the time t to the part
:math:`\mathrm{erf}(k\sqrt{\kappa t})` of their last value, whatever their direction; so each line load of the flux
grows by itself (`winkler.numerics.fields.line_source`), and the surface follows by T3.  At first the temperature
grows as
:math:`2\,\mu p v\sqrt{\kappa t/\pi}/\lambda`, point by point; it settles as slowly as :math:`a/\sqrt{\pi\kappa t}`.
"""

from __future__ import annotations

import math
from typing import ClassVar, cast

import numpy as np

from winkler.laws.friction import Overcome
from winkler.laws.heat import EqualMaximum, FixedShare, HeatPartition
from winkler.loading.path import load_number
from winkler.materials.conductor import ThermalConductor
from winkler.media.conduction.conductors import HeatConductors
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.fields.elliptic_source import EllipticSource
from winkler.numerics.fields.line_source import LineSource
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.assumptions.declared import HEATED
from winkler.problems.assumptions.temperature import temperature_note
from winkler.problems.heating.estimates import first_share, idle_share, shared
from winkler.problems.heating.heat_source import HeatedContact, heat_sources
from winkler.problems.heating.input_checks import RubbingBodies, refuse_contact
from winkler.problems.heating.pressed_source import PressedSource
from winkler.problems.heating.validity import STEADY_SOURCE, sliding_contact_notes
from winkler.problems.normal.elliptic import EllipticIndentation, EllipticSolution
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.values.checks.number_checks import NonNegative, PositiveRow
from winkler.values.checks.place_checks import common_places
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words


@value
class TransientHeating(RubbingBodies):
    """Frictional heating of two bodies after they begin to slide slowly.

    Parameters
    ----------
    contact : Indentation or EllipticIndentation
        The mechanical contact under one load: a round contact, or bodies with two curvatures each on a homogeneous
        medium.
    law : Coulomb
        Friction, with a finite coefficient.
    conductors : HeatConductors
        Thermal conductors of the bodies: two thick bodies of ThermalConductor, in perfect thermal contact.
    speed : float
        Speed of sliding [m/s], not negative.
    time : ndarray, (steps,)
        Since the sliding began [s], positive.
    partition : EqualMaximum, EqualMean or FixedShare, optional
        Rule for the heat partition, applied at every time; EqualMaximum() by default.

    Raises
    ------
    InvalidInput
        If the load is an array, a time is not positive, the speed negative, or as in `FrictionHeating`.
    OutsideValidity
        If the foundation represents a contact that may not be round, or bodies with two curvatures each are layered or
        graded.

    References
    ----------
    H. S. Carslaw, J. C. Jaeger, Conduction of Heat in Solids, 2nd edition, Oxford 1959, sect. 10.5

    Examples
    --------
    Under a ball the middle has reached three quarters of its last temperature at the time a^2/kappa.

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading.loads import Radius
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> elastic, steel = Elastic(210e9, 0.3), ThermalConductor(45.0, 12e-6)
    >>> ball = Indentation(Foundation(Paraboloid(10e-3), HalfSpace.between(elastic, elastic)), Radius(1e-4))
    >>> pair, settling = HeatConductors(steel, steel), 1e-8 / 12e-6
    >>> start = TransientHeating(ball, Coulomb(0.3), pair, speed=1e-3, time=[settling]).solve()
    >>> round(float(start.flash_temperature[0] / start.stationary_temperature), 4)
    0.7682
    """

    __words__ = words(
        contact=("", None, "how the bodies are pressed together"),
        speed=("v", "m/s", "speed of sliding"),
    )

    contact: Indentation | EllipticIndentation
    law: Overcome
    conductors: HeatConductors
    speed: NonNegative
    time: PositiveRow
    partition: HeatPartition = EqualMaximum()

    references: ClassVar[tuple[str, ...]] = ("carslaw_jaeger_1959", "jaeger_1942", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = HEATED

    def __post_init__(self) -> None:
        super().__post_init__()
        refuse_contact(self, self.contact)
        loads = np.shape(load_number(self.contact.load))
        if loads:
            raise InvalidInput(
                f"TransientHeating: the load of the contact has the shape {loads}; give Force, Depth or "
                "Radius with one number, and sweep over several."
            )
        if isinstance(self.contact, EllipticIndentation) and not isinstance(self.contact.medium, HomogeneousMedium):
            raise OutsideValidity(
                "TransientHeating: an ellipse on layers or graded bodies is not implemented; give a homogeneous "
                "medium, or use FrictionHeating for the steady state."
            )

    def solve(self) -> TransientHeatingSolution:
        """Return the temperatures in the course of time.

        Returns
        -------
        TransientHeatingSolution

        Raises
        ------
        OutsideValidity
            If `Indentation` does not support the load, or the pressure is not known in the medium.
        NotConverged
            If the profile is too rough.
        """
        contact = cast("IndentationSolution[float] | EllipticSolution[float]", self.contact.solve())  # of one load
        heat = self.law.coefficient * float(contact.force) * self.speed
        share = np.full(self.time.shape, idle_share(self.partition, self._bodies))
        parts = [np.zeros(self.time.shape)] * 4
        source = _source(contact)
        if source is not None:
            # two bodies of one diffusivity warm up alike
            rises = {
                rate: [
                    np.array([grown(math.sqrt(rate * time)) for time in self.time])
                    for grown in (source.risen_peak, source.risen_mean)
                ]
                for rate in {body.diffusivity for body in self._bodies}
            }
            first, first_mean, second, second_mean = (
                rise * heat / body.conductivity for body in self._bodies for rise in rises[body.diffusivity]
            )
            if heat > 0.0:
                share[:] = first_share(self.partition, (first, second), (first_mean, second_mean))
            parts = [share * first, (1.0 - share) * second, share * first_mean, (1.0 - share) * second_mean]
        return TransientHeatingSolution(self, contact, heat, self.time, share, *parts)


def _source(contact: HeatedContact) -> LineSource | EllipticSource | None:
    (source,) = heat_sources(contact)
    assert not isinstance(source, PressedSource)  # ellipses on layers are refused
    return source


@value
class TransientHeatingSolution:
    """The solution of a `TransientHeating`; temperatures are rises above that far away.

    Parameters
    ----------
    problem : TransientHeating
        The problem that was solved.
    contact : IndentationSolution or EllipticSolution
        The contact.
    heat_rate : float
        Q = mu F v, the heat of friction per time [W].
    time : ndarray, (steps,)
        Since the sliding began [s].
    first_share : ndarray, (steps,)
        Part of the heat that goes into the first body [-].
    first_max_temperature, second_max_temperature : ndarray, (steps,)
        Maximum temperature of either surface [K].
    first_mean_temperature, second_mean_temperature : ndarray, (steps,)
        Mean temperature of either surface over the contact [K].
    """

    problem: TransientHeating
    contact: IndentationSolution[float] | EllipticSolution[float]
    heat_rate: float
    time: Array
    first_share: Array
    first_max_temperature: Array
    second_max_temperature: Array
    first_mean_temperature: Array
    second_mean_temperature: Array

    @property
    def flash_temperature(self) -> Array:
        """The maximum temperature of the contact, that of the warmer body [K], (steps,)."""
        return np.maximum(self.first_max_temperature, self.second_max_temperature)

    @property
    def stationary_temperature(self) -> float:
        """Limit of the flash temperature at long times [K]."""
        source = _source(self.contact)
        if self.heat_rate == 0.0 or source is None:
            return 0.0
        last = np.array(source.peak(0.0).height)
        first, second = (last / body.conductivity for body in self.problem._bodies)
        return self.heat_rate * float(shared(first, second, self.problem.partition))

    def first_temperature(self, x: ArrayLike, y: ArrayLike = 0.0) -> Array:
        """Return the temperature of the first body's surface [K], (steps, ...), at places x, y [m] from the middle."""
        return self._field(self.problem._bodies[0], self.first_share, x, y)

    def second_temperature(self, x: ArrayLike, y: ArrayLike = 0.0) -> Array:
        """Return the temperature of the second body's surface [K], (steps, ...), at places x, y [m] from the middle."""
        return self._field(self.problem._bodies[1], 1.0 - self.first_share, x, y)

    def _field(self, body: ThermalConductor, share: Array, x: ArrayLike, y: ArrayLike) -> Array:
        along, across = common_places("TransientHeatingSolution", x=x, y=y)
        source = _source(self.contact)
        if source is None:
            return np.zeros((self.time.size, *along.shape))
        rows = [source.risen(math.sqrt(body.diffusivity * time), along, across) for time in self.time]
        scale = share * self.heat_rate / body.conductivity
        return np.asarray(scale.reshape(-1, *(1 for _ in along.shape)) * np.array(rows))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        hottest = temperature_note(float(np.max(self.flash_temperature, initial=0.0)))
        contact = sliding_contact_notes(self.contact, self.problem.law.coefficient)
        return (*contact, STEADY_SOURCE, self._rest, self._sharing, hottest)

    @property
    def _rest(self) -> Note:
        source, speed = _source(self.contact), self.problem.speed
        if source is None or speed == 0.0:
            return Note(Assumption.CONDUCTION, Standing.EXACT, "Nothing rubs.", "the problem")
        waves = [speed / body.diffusivity for body in self.problem._bodies]
        excess = 100.0 * (source.peak(0.0).height / source.peak(max(waves)).height - 1.0)
        return Note(
            Assumption.CONDUCTION,
            Standing.APPROXIMATE if excess > 1.0 else Standing.ASYMPTOTIC,
            "Both bodies are assumed at rest relative to the contact. One body may move at the full sliding "
            f"speed (Pe = {0.5 * max(waves) * source.half_length(0.0):.3g}). The maximum temperature of this body is "
            f"then overestimated by up to {excess:.2g} % at long times.",
            "own quadrature of the moving source",
        )

    @property
    def _sharing(self) -> Note:
        first, second = self.problem._bodies
        if isinstance(self.problem.partition, FixedShare) or first.diffusivity == second.diffusivity:
            return Note(
                Assumption.CONDUCTION,
                Standing.EXACT,
                "The surface temperatures of both bodies rise in proportion, with one constant heat partition.",
                CARSLAW,
            )
        spread = float(np.ptp(self.first_share))
        return Note(
            Assumption.CONDUCTION,
            Standing.APPROXIMATE,
            "The diffusivities of the bodies differ. The heat partition that gives equal temperatures therefore "
            "changes with time, from the ratio of effusivities to that of conductivities. At every time its "
            f"current value is applied to the whole history; it changes by {spread:.2g} over the times given.",
            CARSLAW,
        )


CARSLAW = "H. S. Carslaw, J. C. Jaeger, Conduction of Heat in Solids, 2nd edition, Oxford 1959"
