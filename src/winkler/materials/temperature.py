r"""The effect of temperature on a viscoelastic solid: one factor :math:`a_T` on all its times."""

from __future__ import annotations

import math

from winkler.values.checks.number_checks import POSITIVE, Positive, checked
from winkler.values.errors import OutsideValidity
from winkler.values.value import value

GAS_CONSTANT = 8.31446261815324
"""Gas constant [J/(mol K)]."""


@value
class WilliamsLandelFerry:
    r"""Time-temperature shift of a polymer above its glass transition.

    :math:`\log_{10}a_T=-c_1(T-T_0)/(c_2+T-T_0)`.

    Parameters
    ----------
    reference_temperature : float
        T_0 [K] at which the solid is known, positive.
    first_constant : float, optional
        c_1 [-], positive; 17.44 if T_0 is the glass transition.
    second_constant : float, optional
        c_2 [K], positive; 51.6 there.

    Raises
    ------
    InvalidInput
        If a number is not positive.

    References
    ----------
    M. L. Williams, R. F. Landel, J. D. Ferry, J. Am. Chem. Soc. 77 (1955) 3701-3707, doi:10.1021/ja01619a008

    Examples
    --------
    >>> round(WilliamsLandelFerry(reference_temperature=200.0).factor(251.6), 12) == round(10**-8.72, 12)
    True
    """

    reference_temperature: Positive
    first_constant: Positive = 17.44
    second_constant: Positive = 51.6

    def factor(self, temperature: float) -> float:
        """Return a_T [-] at a temperature [K].

        Raises
        ------
        InvalidInput
            If the temperature is not positive.
        OutsideValidity
            If it is so low that the law gives no value.
        """
        checked(POSITIVE, "WilliamsLandelFerry", "temperature", temperature, "K")
        above = temperature - self.reference_temperature
        if self.second_constant + above <= 0.0:
            raise OutsideValidity(
                f"WilliamsLandelFerry: at {temperature:g} K the law gives no value; it holds well above "
                f"{self.reference_temperature - self.second_constant:g} K."
            )
        return float(10.0 ** (-self.first_constant * above / (self.second_constant + above)))


@value
class Arrhenius:
    r"""Time-temperature shift of a solid with thermally activated relaxation.

    :math:`\ln a_T=\frac{Q}{R}\bigl(\frac1T-\frac1{T_0}\bigr)`.

    Parameters
    ----------
    reference_temperature : float
        T_0 [K] at which the properties are given, positive.
    activation_energy : float
        Q [J/mol], positive.

    Raises
    ------
    InvalidInput
        If a number is not positive.

    Examples
    --------
    >>> round(Arrhenius(reference_temperature=300.0, activation_energy=80e3).factor(310.0), 6)
    0.355368
    """

    reference_temperature: Positive
    activation_energy: Positive

    def factor(self, temperature: float) -> float:
        """Return a_T [-] at a temperature [K].

        Raises
        ------
        InvalidInput
            If the temperature is not positive.
        """
        checked(POSITIVE, "Arrhenius", "temperature", temperature, "K")
        return math.exp(self.activation_energy / GAS_CONSTANT * (1.0 / temperature - 1.0 / self.reference_temperature))
