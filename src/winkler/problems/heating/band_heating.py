r"""An even band of heat: a laser line, a strip that is ground or braked, a mean flux instead of a contact's.

As much heat per area enters everywhere on a strip of the half-width a, past which the bodies move.  One that moves at
V warms up by

.. math:: T(x) = \frac{q}{\pi\lambda}\int_{-a}^a \mathrm e^{z} K_0(|z|)\,\mathrm ds , \qquad
          z = \frac{V}{2\kappa}(x-s) ,

Jaeger's band source.  A body that rests against an endless band has no steady temperature.
"""

from __future__ import annotations

from typing import Annotated, ClassVar

import numpy as np

from winkler.laws.heat import EqualMaximum, HeatPartition
from winkler.media.conduction.conductors import HeatConductors
from winkler.numerics.types import Q, shaped
from winkler.problems.heating.band_flux import EvenBand
from winkler.problems.heating.one_result import SPEEDS, one_problem, one_result
from winkler.problems.heating.strip_heating import StripHeating, StripTemperatures
from winkler.problems.heating.validity import EVEN
from winkler.values.checks.number_checks import FINITE_QUANTITY, NON_NEGATIVE_QUANTITY, POSITIVE_QUANTITY
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words


@value
class BandHeating(StripHeating[Q]):
    """One or two bodies that move past a band of uniform heat flux.

    Parameters
    ----------
    half_width : float or ndarray
        Half-width a of the band [m].
    heat_flux : float or ndarray
        Heat per area and time that enters both bodies together [W/m^2].
    conductors : HeatConductors
        Thermal conductors of the bodies: two thick bodies of ThermalConductor, or Plated made of it, in perfect
        thermal contact.
    first_speed, second_speed : float or ndarray
        Velocities [m/s] along x at which the surface of either body moves past the band, not zero.  Zero is allowed for
        a body that receives no heat, FixedShare(1.0) or FixedShare(0.0).  Arrays broadcast with each other, with the
        half-width and with the flux.
    partition : EqualMaximum, EqualMean or FixedShare, optional
        Rule for the heat partition; by default Blok's rule, EqualMaximum().  For a single heated body give
        FixedShare(1.0).

    Raises
    ------
    InvalidInput
        If a body that receives heat is at rest relative to the band. If a conductor has the wrong type, a number is not
        finite, or the arguments do not broadcast.

    References
    ----------
    J. C. Jaeger, Proc. R. Soc. New South Wales 76 (1942) 203-224; H. Blok, Wear 6 (1963) 483-494,
    doi:10.1016/0043-1648(63)90283-7

    Examples
    --------
    A line of laser light, 0.2 mm wide, 100 W/mm^2 of which are absorbed by steel that passes at 0.5 m/s:

    >>> from winkler.laws.heat import FixedShare
    >>> from winkler.materials.conductor import ThermalConductor
    >>> steel = ThermalConductor(45.0, 12e-6)
    >>> pair = HeatConductors(steel, steel)
    >>> line = BandHeating(0.1e-3, 100e6, pair, first_speed=0.5, second_speed=0.0, partition=FixedShare(1.0)).solve()
    >>> round(line.first_peclet, 3), round(line.flash_temperature, 2), round(line.fast_temperature, 2)
    (2.083, 160.8, 173.73)
    """

    __words__ = words(half_width=("a", "m", "half-width of the band"))

    half_width: Annotated[Q, POSITIVE_QUANTITY]
    heat_flux: Annotated[Q, NON_NEGATIVE_QUANTITY]
    conductors: HeatConductors
    first_speed: Annotated[Q | float, FINITE_QUANTITY]
    second_speed: Annotated[Q | float, FINITE_QUANTITY]
    partition: HeatPartition = EqualMaximum()

    references: ClassVar[tuple[str, ...]] = ("jaeger_1942", "blok_1963")
    assumptions: ClassVar[frozenset[Assumption]] = frozenset((Assumption.CONDUCTION, Assumption.TEMPERATURE))

    def __post_init__(self) -> None:
        super().__post_init__()
        self._check_speeds(half_width=self.half_width, heat_flux=self.heat_flux)

    def solve(self) -> BandHeatingSolution[Q]:
        """Return the temperatures of the bodies.

        Returns
        -------
        BandHeatingSolution

        Raises
        ------
        OutsideValidity
            If a Peclet number is above 1e8 or below 1e-8.
        """
        half_width, flux, *_ = np.broadcast_arrays(self.half_width, self.heat_flux, *self._speeds)
        columns = self._columns(EvenBand(self.half_width), 2.0 * half_width * flux)
        return BandHeatingSolution(self, shaped(half_width), *columns)


@value
class BandHeatingSolution(StripTemperatures[Q]):
    """The solution of a `BandHeating`; each quantity has the common shape of half-width, flux and speeds.

    Temperatures are rises above the temperature of the bodies far away.

    Parameters
    ----------
    problem : BandHeating
        The problem that was solved.
    half_width : float or ndarray
        Half-width a of the band [m].
    heat_per_length : float or ndarray
        Q = 2 a q, the heat per time and length [W/m].
    first_share : float or ndarray
        Part of it that goes into the first body [-].
    first_peclet, second_peclet : float or ndarray
        Pe = V a / (2 kappa) of each body [-]; for a plated body with the smallest diffusivity.
    first_max_temperature, second_max_temperature : float or ndarray
        Maximum temperature of either surface [K].
    first_mean_temperature, second_mean_temperature : float or ndarray
        Mean temperature of either surface over the band [K].
    """

    __words__ = words(half_width=("a", "m", "half-width of the band"))

    problem: BandHeating[Q]
    half_width: Q
    heat_per_length: Q
    first_share: Q
    first_peclet: Q
    second_peclet: Q
    first_max_temperature: Q
    second_max_temperature: Q
    first_mean_temperature: Q
    second_mean_temperature: Q

    @property
    def _heated(self) -> EvenBand:
        return EvenBand(self.problem.half_width)

    def at(self, index: int | tuple[int, ...]) -> BandHeatingSolution[float]:
        """Return the solution of one half-width, flux and speed of an array.

        Parameters
        ----------
        index : int or tuple of int
            Which one.

        Raises
        ------
        InvalidInput
            If there is none.
        """
        place, columns = one_result(self, index)
        problem = one_problem(
            self.problem, np.shape(self.heat_per_length), place, many=("half_width", "heat_flux", *SPEEDS)
        )
        return BandHeatingSolution(problem, **columns)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        return self._notes(EVEN)
