r"""Viscoelastic solids: isotropic, linear, with a Poisson's ratio that does not change in time.

A solid is known by its shear relaxation :math:`G(t)`; its creep :math:`J(t)`, storage and loss follow, and so does
Young's relaxation :math:`E(t)=2(1+\nu)G(t)`.  Gels, tissue and rubber are incompressible as good as always, so that
nu is 1/2 unless given.
"""

from __future__ import annotations

import math
from typing import Annotated

import numpy as np

from winkler.numerics.springs.exponential_sums import CreepSeries, RelaxationSeries, merged, of_creep, of_relaxation
from winkler.numerics.types import Array, ArrayLike
from winkler.values.checks.contract import offered
from winkler.values.checks.number_checks import POSITIVE, NonNegative, Numbers, PoissonRatio, checked
from winkler.values.errors import InvalidInput
from winkler.values.limits import MOST_NUMBERS, MOST_TERMS
from winkler.values.value import value

POSITIVE_TIMES = Numbers(POSITIVE, most=MOST_NUMBERS, any_shape=True)


@offered("a viscoelastic solid such as StandardSolid(...) or Prony(...)")
class ViscoelasticSolid:
    """What every viscoelastic solid can compute, once the series of its shear relaxation is known."""

    @property
    def poisson(self) -> float:
        """Poisson's ratio nu [-], the same at all times."""
        raise NotImplementedError

    @property
    def series(self) -> RelaxationSeries:
        """G(t) as a sum of exponentials [Pa]."""
        raise NotImplementedError

    @property
    def span(self) -> tuple[float, float]:
        """Range of times [s] in which the series represents the solid; all times unless it was fitted."""
        return 0.0, math.inf

    def relaxation(self, time: ArrayLike) -> Array:
        """Return G(t), the stress after a unit step of shear.

        Parameters
        ----------
        time : array_like
            Since the step [s], positive.

        Returns
        -------
        ndarray
            [Pa], the shape of `time`.

        Raises
        ------
        InvalidInput
            If a time is not positive and finite.
        """
        return self.series.at(checked(POSITIVE_TIMES, "relaxation", "time", time, "s"))

    def creep(self, time: ArrayLike) -> Array:
        """Return J(t), the shear after a unit step of stress.

        Parameters
        ----------
        time : array_like
            Since the step [s], positive.

        Returns
        -------
        ndarray
            [1/Pa], the shape of `time`.

        Raises
        ------
        InvalidInput
            If a time is not positive and finite.
        """
        return of_relaxation(self.series).at(checked(POSITIVE_TIMES, "creep", "time", time, "s"))

    def storage(self, angular_frequency: ArrayLike) -> Array:
        """Return G', what is in phase with a harmonic shear.

        Parameters
        ----------
        angular_frequency : array_like
            omega [rad/s], positive.

        Returns
        -------
        ndarray
            [Pa], the shape of `angular_frequency`.

        Raises
        ------
        InvalidInput
            If a frequency is not positive and finite.
        """
        return np.real(
            self.series.dynamic(checked(POSITIVE_TIMES, "storage", "angular_frequency", angular_frequency, "rad/s"))
        )

    def loss(self, angular_frequency: ArrayLike) -> Array:
        """Return G'', what is a quarter of a turn ahead of a harmonic shear.

        Parameters
        ----------
        angular_frequency : array_like
            omega [rad/s], positive.

        Returns
        -------
        ndarray
            [Pa], the shape of `angular_frequency`.

        Raises
        ------
        InvalidInput
            If a frequency is not positive and finite.
        """
        return np.imag(
            self.series.dynamic(checked(POSITIVE_TIMES, "loss", "angular_frequency", angular_frequency, "rad/s"))
        )

    def slowed(self, factor: float) -> Prony:
        """Return the solid with all its times multiplied: the same one, colder, or older.

        Parameters
        ----------
        factor : float
            a_T [-], positive: of a `winkler.materials.temperature.WilliamsLandelFerry` or `Arrhenius`.

        Returns
        -------
        Prony

        Raises
        ------
        InvalidInput
            If the factor is not positive and finite.
        """
        checked(POSITIVE, "slowed", "factor", factor)
        series = self.series.scaled(1.0, factor)
        return Prony(series.relaxed, series.moduli, series.times, series.viscosity, self.poisson)


class FittedSolid(ViscoelasticSolid):
    """A solid that a series stands for, but for an error."""

    @property
    def _fitted(self) -> tuple[RelaxationSeries, float]:
        raise NotImplementedError

    @property
    def series(self) -> RelaxationSeries:
        """G(t) [Pa]."""
        return self._fitted[0]

    @property
    def series_error(self) -> float:
        """Greatest relative error of the series within the span, or misfit of the data [-]."""
        return self._fitted[1]


@value
class Prony(ViscoelasticSolid):
    r"""The generalised Maxwell solid: a spring, a dashpot and Maxwell elements in parallel.

    :math:`G(t)=G_\infty+\eta\delta(t)+\sum_i G_i e^{-t/\tau_i}`.

    Parameters
    ----------
    relaxed_shear : float
        G_inf [Pa], zero for a fluid.
    shears : ndarray, (m,)
        G_i [Pa], positive.
    relaxation_times : ndarray, (m,)
        tau_i [s], positive.
    viscosity : float, optional
        eta [Pa s] of a dashpot alongside.
    poisson : float, optional
        nu [-].

    Raises
    ------
    InvalidInput
        If a number is outside its range, the rows differ in length, or no elastic element remains.

    Examples
    --------
    >>> rubber = Prony(1e6, [2e6, 1e6], [0.01, 1.0])
    >>> rubber.relaxation([1e-9, 1e9]) / 1e6
    array([3.9999998, 1.       ])
    """

    relaxed_shear: NonNegative
    shears: Annotated[Array, Numbers(POSITIVE, fewest=0, most=MOST_TERMS)]
    relaxation_times: Annotated[Array, Numbers(POSITIVE, fewest=0, most=MOST_TERMS)]
    viscosity: NonNegative = 0.0
    poisson: PoissonRatio = 0.5

    def __post_init__(self) -> None:
        if self.shears.size != self.relaxation_times.size:
            raise InvalidInput(
                f"Prony: {self.shears.size} shears and {self.relaxation_times.size} relaxation_times; give one time "
                "for each modulus."
            )
        if not (self.relaxed_shear > 0.0 or self.viscosity > 0.0 or self.shears.size):
            raise InvalidInput("Prony: nothing resists; give a relaxed_shear, a viscosity, or shears with their times.")

    @property
    def series(self) -> RelaxationSeries:
        """G(t) [Pa]."""
        return RelaxationSeries(self.relaxed_shear, self.viscosity, *merged(self.shears, self.relaxation_times))


@value
class GeneralisedKelvin(ViscoelasticSolid):
    r"""The generalised Kelvin solid: a spring, a dashpot and Kelvin-Voigt elements in series.

    :math:`J(t)=J_0+\varphi t+\sum_k J_k(1-e^{-t/\lambda_k})`.

    Parameters
    ----------
    glassy_compliance : float
        J_0 [1/Pa], of the immediate response.
    compliances : ndarray, (n,)
        J_k [1/Pa], positive.
    retardation_times : ndarray, (n,)
        lambda_k [s], positive.
    fluidity : float, optional
        phi [1/(Pa s)], the reciprocal of its viscosity in steady flow.
    poisson : float, optional
        nu [-].

    Raises
    ------
    InvalidInput
        If a number is outside its range, the rows differ in length, or all compliances are zero.

    Examples
    --------
    >>> gel = GeneralisedKelvin(1e-3, [2e-3], [5.0])
    >>> gel.creep([1e-9, 1e9])
    array([0.001, 0.003])
    """

    glassy_compliance: NonNegative
    compliances: Annotated[Array, Numbers(POSITIVE, fewest=0, most=MOST_TERMS)]
    retardation_times: Annotated[Array, Numbers(POSITIVE, fewest=0, most=MOST_TERMS)]
    fluidity: NonNegative = 0.0
    poisson: PoissonRatio = 0.5

    def __post_init__(self) -> None:
        if self.compliances.size != self.retardation_times.size:
            raise InvalidInput(
                f"GeneralisedKelvin: {self.compliances.size} compliances and {self.retardation_times.size} "
                "retardation_times; give one time for each compliance."
            )
        if not (self.glassy_compliance > 0.0 or self.fluidity > 0.0 or self.compliances.size):
            raise InvalidInput("GeneralisedKelvin: all compliances are zero; give a compliance, or use Rigid().")

    @property
    def series(self) -> RelaxationSeries:
        """G(t) [Pa]."""
        strengths, times = merged(self.compliances, self.retardation_times)
        return of_creep(CreepSeries(self.glassy_compliance, self.fluidity, strengths, times))
