"""At which voltage a contact reaches a temperature, and how its bodies resist when heated."""

from __future__ import annotations

import math

import numpy as np

from winkler.materials.conducting_body import ConductingBody, parts_of
from winkler.materials.conductor import ElectricalConductor
from winkler.numerics.equations.bracketing import between
from winkler.numerics.types import Array
from winkler.problems.conduction.heated_contact import ColdContact, HotContact, hot_at_voltage, temperatures

MOST_DOUBLINGS = 60
"""Of the voltage, in search of one that heats enough: a film may take nearly all of it."""


def coefficients_of(body: ConductingBody) -> tuple[float, ...]:
    """Return the coefficients of temperature of what a body is made of [1/K]."""
    return tuple(part.temperature_coefficient for part in parts_of(body) if isinstance(part, ElectricalConductor))


def coefficient_of(body: ConductingBody) -> float:
    """Return the coefficient of temperature of a body [1/K], of a plated one the mean of both."""
    return float(np.mean(coefficients_of(body)))


def voltage_to_reach(cold: ColdContact, temperature: float) -> HotContact:
    """Return the contacts `(m,)` heated until their hottest place has a temperature [K].

    Parameters
    ----------
    cold
        The contacts.
    temperature
        Above that of the bodies.

    Returns
    -------
    HotContact
        All infinite where the temperature is, or nothing constricts.
    """
    never = np.full(cold.first.shape, math.inf)
    result = HotContact(never.copy(), never.copy(), 0.0 * cold.first, 0.0 * cold.first)
    heated = cold.first + cold.second > 0.0
    if math.isinf(temperature) or not heated.any():
        return result

    def part(which: Array) -> ColdContact:
        return cold._replace(first=cold.first[which], second=cold.second[which], film=cold.film[which])

    places = np.flatnonzero(heated)

    def excess(voltage: Array, index: Array) -> Array:
        hot = hot_at_voltage(part(places[index]), voltage)
        return temperatures(cold.law, cold.ambient, hot)[1] / temperature - 1.0

    high = np.full(places.size, float(cold.law.voltage_at(temperature, cold.ambient)))
    every = np.arange(places.size)
    for _ in range(MOST_DOUBLINGS):
        short = excess(high, every) < 0.0
        if not short.any():
            break
        high = np.where(short, 2.0 * high, high)
    hot = hot_at_voltage(part(places), between(excess, np.zeros(places.size), high))
    for whole, found in zip(result, hot, strict=True):
        whole[places] = found
    return result
