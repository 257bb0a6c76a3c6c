r"""How a current heats a contact whose resistance rises with the temperature.

Voltages take the place of lengths.  At the voltage :math:`\varphi` from the far end of a body, over which :math:`V_1`
falls, heat flows towards that end at the rate :math:`I\,(q_1+V_1-\varphi)`, where :math:`I\,q_1` is what comes through
the contact, from the film or from the other body.  With :math:`\lambda\varrho=LT`

.. math:: \tfrac L2\,(T^2-T_0^2) = (q_1+V_1)\,\varphi - \tfrac12\varphi^2, \qquad
          I\,\frac{R_1}{\varrho_1(T_0)} = \int_0^{V_1}\frac{\mathrm d\varphi}{\varrho_1(T(\varphi))},

R_1 the cold resistance.  Both temperatures of the contact agree, :math:`q_1+q_2=V_f`; so

.. math:: T_c^2 = T_0^2 + \frac{2V_1V_2}{L}\Bigl(\frac12+\frac{V_f}{V_1+V_2}\Bigr) .
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.laws.current import WiedemannFranz
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged, OutsideValidity

NODES = 40
MOST_STEPS = 300
VOLTAGE_FACTOR = 1.2
"""Factor from one voltage to the next, in search of a current."""
HIGHEST_TEMPERATURE = 2e4
"""No metal is solid or liquid at such temperatures [K]: beyond, no current is sought."""


class ColdContact(NamedTuple):
    """The contact at the temperature of the bodies."""

    first: Array
    """Resistance of the first body, `(m,)` [ohm]."""
    second: Array
    film: Array
    coefficients: tuple[float, float]
    """Of temperature, of both bodies [1/K]."""
    ambient: float
    """T_0 [K]."""
    law: WiedemannFranz


class HotContact(NamedTuple):
    """A heated contact; each `(m,)`."""

    current: Array
    first: Array
    """Voltage over the first body [V]."""
    second: Array
    film: Array

    @property
    def voltage(self) -> Array:
        """Between the ends [V]."""
        return self.first + self.second + self.film

    def inflow(self) -> tuple[Array, Array]:
        """q_1 and q_2 [V]: heat that comes through the contact into either body, over the current."""
        both = self.first + self.second
        some = np.where(both > 0.0, both, 1.0)
        into = (self.film * self.second + 0.5 * (self.second**2 - self.first**2)) / some
        return into, self.film - into


def profile(cold: ColdContact, inflow: Array, fall: Array, phi: Array) -> Array:
    """Return T [K] at the voltage phi from the end of a body over which `fall` falls."""
    return cold.law.temperature(cold.ambient, (inflow + fall) * phi - 0.5 * phi**2)


def temperatures(law: WiedemannFranz, ambient: float, hot: HotContact) -> tuple[Array, Array]:
    """Return the temperature of the contact and the greatest one [K], of bodies of the temperature `ambient` [K]."""
    both = hot.first + hot.second
    share = hot.film / np.where(both > 0.0, both, 1.0)
    touch = law.temperature(ambient, hot.first * hot.second * (0.5 + share))
    greatest = touch
    for fall, inflow in zip((hot.first, hot.second), hot.inflow(), strict=True):
        # heat flows out of the contact into both bodies, or the hottest place lies within one of them
        inside = law.temperature(ambient, 0.5 * (fall + inflow) ** 2)
        greatest = np.where((inflow < 0.0) & (both > 0.0), inside, greatest)
    return touch, greatest


def _growth(cold: ColdContact, hot: HotContact) -> tuple[Array, Array]:
    """Return by which factor either body's resistance has grown: one over the mean of rho(T_0) / rho(T)."""
    nodes, weights = gauss_legendre(NODES)
    factors = []
    for fall, inflow, alpha in zip((hot.first, hot.second), hot.inflow(), cold.coefficients, strict=True):
        if alpha == 0.0:
            factors.append(np.ones(fall.shape))
            continue
        # near its end a body is cold: there the nodes crowd
        phi = fall[:, None] * nodes**2
        temperature = profile(cold, inflow[:, None], fall[:, None], phi)
        mean = (1.0 / (1.0 + alpha * (temperature - cold.ambient))) @ (2.0 * weights * nodes)
        factors.append(1.0 / mean)
    return factors[0], factors[1]


def hot_at_voltage(cold: ColdContact, voltage: Array) -> HotContact:
    """Return the heated contact at given voltages `(m,)`, of which none is negative.

    Raises
    ------
    NotConverged
        If the resistances do not settle.
    """
    first, second = cold.first, cold.second
    for _ in range(MOST_STEPS):
        current = voltage / (first + second + cold.film)
        hot = HotContact(current, current * first, current * second, current * cold.film)
        grown = _growth(cold, hot)
        change = np.max(np.abs(cold.first * grown[0] - first) + np.abs(cold.second * grown[1] - second))
        size = np.max(first + second)
        first, second = cold.first * grown[0], cold.second * grown[1]
        if change <= 4e-15 * size or max(cold.coefficients) == 0.0:
            return hot
    if change <= 1e-12 * size:
        return hot
    raise NotConverged(f"The heated resistances do not converge: they still change by {change / size:.1e}.")


def hot_at_current(cold: ColdContact, current: Array) -> HotContact:
    """Return the heated contact at given currents `(m,)`: the lowest voltage at which they flow.

    Where the resistivity rises faster than the temperature itself, the current has a maximum over the voltage; what
    lies beyond is not reached from the cold, and does not stay under a given current.

    Raises
    ------
    OutsideValidity
        If no voltage drives so much current: the contact resists the more, the hotter it is.
    NotConverged
        If the resistances do not settle.
    """
    low = current * (cold.first + cold.second + cold.film)
    if max(cold.coefficients) == 0.0:
        return hot_at_voltage(cold, low)
    high, end = low, float(cold.law.voltage_at(HIGHEST_TEMPERATURE, cold.ambient))
    best, most = low, hot_at_voltage(cold, low).current
    short = most < current
    while short.any():
        high = np.where(short, VOLTAGE_FACTOR * high, high)
        hot = hot_at_voltage(cold, high)
        best, most = np.where(hot.current > most, high, best), np.maximum(hot.current, most)
        low = np.where(short & (hot.current < current), high, low)
        short &= (hot.current < current) & (hot.first + hot.second < end)
    missed = most < current
    if missed.any():
        high = np.where(missed, _peak(cold, best), high)
        low = np.where(missed, best / VOLTAGE_FACTOR, low)
        peak = hot_at_voltage(cold, high)
        if np.any(missed & (peak.current < current)):
            place = int(np.flatnonzero(missed & (peak.current < current))[0])
            raise OutsideValidity(
                f"No voltage drives {current[place]:.4g} A through this contact, because its resistance grows "
                f"with the temperature. The maximum current is {peak.current[place]:.4g} A, at {high[place]:.3g} "
                "V; give less."
            )
    return hot_at_voltage(cold, _met(cold, current, low, high))


def _peak(cold: ColdContact, near: Array) -> Array:
    """Return the voltages of the greatest currents, next to those given."""
    low, high = near / VOLTAGE_FACTOR, near * VOLTAGE_FACTOR
    for _ in range(60):
        left, right = low + (high - low) / 3.0, high - (high - low) / 3.0
        rises = hot_at_voltage(cold, left).current < hot_at_voltage(cold, right).current
        low, high = np.where(rises, left, low), np.where(rises, high, right)
    return 0.5 * (low + high)


def _met(cold: ColdContact, current: Array, low: Array, high: Array) -> Array:
    """Return the voltages between two bounds at which the currents flow: regula falsi, halving what hangs on."""
    below = hot_at_voltage(cold, low).current - current
    above = hot_at_voltage(cold, high).current - current
    middle = high
    for _ in range(200):
        steep = above - below
        middle = np.where(steep > 0.0, high - above * (high - low) / np.where(steep > 0.0, steep, 1.0), low)
        miss = hot_at_voltage(cold, middle).current - current
        if np.all((np.abs(miss) <= 4e-15 * current) | (high - low <= 4e-16 * high)):
            return middle
        less = miss < 0.0
        below, above = np.where(less, miss, 0.5 * below), np.where(less, 0.5 * above, miss)
        low, high = np.where(less, middle, low), np.where(less, high, middle)
    if np.all(np.abs(miss) <= 1e-12 * current):
        return middle
    raise NotConverged("No voltage was found that drives the current; give a smaller current, or a voltage.")
