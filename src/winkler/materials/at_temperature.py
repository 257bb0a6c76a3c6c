"""A viscoelastic solid at another temperature than that at which it was measured."""

from __future__ import annotations

from winkler.materials.temperature import Arrhenius, WilliamsLandelFerry
from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.numerics.springs.exponential_sums import RelaxationSeries
from winkler.values.checks.number_checks import Positive
from winkler.values.value import value, words


@value
class AtTemperature(ViscoelasticSolid):
    r"""A thermorheologically simple solid: temperature multiplies all relaxation times by one factor.

    Moduli do not change: :math:`G(t;T)=G(t/a_T)`, with :math:`a_T=1` at the reference temperature.

    Parameters
    ----------
    solid : ViscoelasticSolid
        The solid at the reference temperature of the law.
    law : WilliamsLandelFerry or Arrhenius
        Law for the factor as a function of temperature.
    temperature : float
        T [K], positive.

    Raises
    ------
    InvalidInput
        If the solid is not viscoelastic, the law has the wrong type, or the temperature is not positive.
    OutsideValidity
        If the temperature is so low that the law gives no value.

    References
    ----------
    J. D. Ferry, Viscoelastic Properties of Polymers, 3rd edition, Wiley 1980

    Examples
    --------
    >>> from winkler.materials.spring_and_dashpot import Maxwell
    >>> law = WilliamsLandelFerry(reference_temperature=300.0, first_constant=8.86, second_constant=101.6)
    >>> warm = AtTemperature(Maxwell(shear=1e6, relaxation_time=1.0), law, temperature=320.0)
    >>> round(float(warm.series.times[0]), 6) == round(law.factor(320.0), 6)
    True
    """

    __words__ = words(
        solid=("", None, "the solid at the temperature at which it is known"),
        law=("", None, "how temperature changes its times"),
    )

    solid: ViscoelasticSolid
    law: WilliamsLandelFerry | Arrhenius
    temperature: Positive

    def __post_init__(self) -> None:
        _ = self.factor  # refuses a temperature at which there is none

    @property
    def factor(self) -> float:
        """a_T [-]."""
        return self.law.factor(self.temperature)

    @property
    def poisson(self) -> float:
        """Poisson's ratio nu [-], the same at all times and temperatures."""
        return self.solid.poisson

    @property
    def series(self) -> RelaxationSeries:
        """G(t) at this temperature [Pa]."""
        return self.solid.series.scaled(1.0, self.factor)

    @property
    def span(self) -> tuple[float, float]:
        """Range of times [s] in which the series represents the solid, at this temperature."""
        shortest, longest = self.solid.span
        return shortest * self.factor, longest * self.factor
