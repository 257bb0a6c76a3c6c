r"""The electric load of a contact, current or voltage, and the temperature from the voltage (Wiedemann and Franz).

In metals the thermal conductivity times the resistivity is :math:`L\,T` (Wiedemann, Franz, Lorenz).  Voltage and
temperature then go together, whatever the shape of the contact (Kohlrausch): between ends of the temperature T_0

.. math:: T_{max}^2 = T_0^2 + \frac{V^2}{4L} .
"""

from __future__ import annotations

import math
from typing import Annotated

import numpy as np

from winkler.numerics.types import Array, Quantity
from winkler.values.checks.number_checks import Advice, NonNegative, Positive
from winkler.values.errors import InvalidInput
from winkler.values.value import value


@value
class Current:
    """A prescribed current.

    Parameters
    ----------
    current : float
        I [A], not negative.

    Raises
    ------
    InvalidInput
        If it is negative or not finite.
    """

    current: NonNegative


@value
class Voltage:
    """A prescribed voltage between the ends of both bodies.

    Parameters
    ----------
    voltage : float
        V [V], not negative.

    Raises
    ------
    InvalidInput
        If it is negative or not finite.
    """

    voltage: NonNegative


Drive = Current | Voltage
"""What may be prescribed."""


@value
class WiedemannFranz:
    """Metals: thermal conductivity times resistivity is the Lorenz number times the absolute temperature.

    Parameters
    ----------
    lorenz_number : float, optional
        L [V^2/K^2], positive; 2.44e-8, Sommerfeld's value, by default.

    Raises
    ------
    InvalidInput
        If it is not positive.

    Examples
    --------
    >>> round(WiedemannFranz().voltage_at(1235.0), 3)  # the melting voltage of silver
    0.375
    """

    lorenz_number: Annotated[Positive, Advice("2.44e-8 for most metals")] = 2.44e-8

    def temperature(self, ambient: float, work: Array) -> Array:
        """Return T [K] at the place where the integral of heat current per electric current has the value `work`.

        Parameters
        ----------
        ambient : float
            T_0 [K] at the end of the body.
        work : ndarray
            Integral over the voltage of the ratio of heat current to electric current, from that end [V^2].
        """
        return np.sqrt(ambient**2 + 2.0 * np.asarray(work) / self.lorenz_number)

    def voltage_at(self, temperature: Quantity, ambient: float = 293.15) -> Quantity:
        """Return the voltage [V] over a contact without film at which its hottest place has this temperature [K].

        With the temperature of softening or melting it is the softening or melting voltage of the metal.

        Parameters
        ----------
        temperature : float or ndarray
            [K], not below that of the bodies.
        ambient : float, optional
            T_0 of the bodies [K], 20 degrees Celsius by default.

        Raises
        ------
        InvalidInput
            If it is below that of the bodies, or that is not positive.
        """
        if not 0.0 < ambient < math.inf:
            raise InvalidInput(f"voltage_at: ambient is {ambient!r}; give a positive absolute temperature in K.")
        hot = np.asarray(temperature, dtype=float)
        if not np.all(hot >= ambient):
            raise InvalidInput(
                f"voltage_at: the temperature {float(np.min(hot)):g} K is below that of the bodies, {ambient:g} K; "
                "current only heats: give a higher one."
            )
        voltage_drop = 2.0 * np.sqrt(self.lorenz_number * (hot**2 - ambient**2))
        return float(voltage_drop) if np.ndim(temperature) == 0 else voltage_drop
