r"""From the contact back to the bodies: voltage, temperature, and the densities of current and heat.

The contact of two thick bodies is a disc of one voltage and one temperature, whatever the body that made it, so its
field is that of `winkler.numerics.fields.disc_field`.  The lines of current stay where they are if the resistivity
rises with the temperature; only the voltages along them move.
"""

from __future__ import annotations

from typing import overload

import numpy as np

from winkler.foundation.bed import Bed
from winkler.media.conduction.conductors import ElectricalConductors, HeatConductors
from winkler.numerics.fields.disc_field import disc_potential, disc_slopes
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.conduction.disc import resistances_of
from winkler.problems.conduction.heated_contact import ColdContact, hot_at_voltage, profile
from winkler.problems.conduction.joule_heating import JouleHeatingSolution, cold_contact
from winkler.problems.conduction.stiffness_analogy import plain
from winkler.problems.conduction.thermal_constriction import ThermalConstrictionSolution
from winkler.problems.one_load import single
from winkler.values.checks.outline import refuse_unless_round
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.value import value

NODES = 48
CLOSE = 1e-14
"""Of the voltage over a body, the last step of the search for the voltage at a place."""


@value
class CurrentFields:
    """A current through a contact, inside the bodies and on their surfaces.

    Parameters
    ----------
    r, z : ndarray
        Coordinates [m]; z positive in the first body, negative in the second.
    potential : ndarray
        Voltage against the far end of the first body [V].
    temperature : ndarray
        T [K].
    radial_current_density, axial_current_density : ndarray
        [A/m^2], outward and along z; infinite at the edge of the contact.
    """

    r: Array
    z: Array
    potential: Array
    temperature: Array
    radial_current_density: Array
    axial_current_density: Array


@value
class HeatFields:
    """Heat that flows through a contact, inside the bodies and on their surfaces.

    Parameters
    ----------
    r, z : ndarray
        Coordinates [m]; z positive in the first body, negative in the second.
    excess_temperature : ndarray
        Above that of the second body far away [K].
    radial_heat_flux, axial_heat_flux : ndarray
        [W/m^2], outward and along z; infinite at the edge of the contact.
    """

    r: Array
    z: Array
    excess_temperature: Array
    radial_heat_flux: Array
    axial_heat_flux: Array


@overload
def restore_conduction(solution: JouleHeatingSolution, r: ArrayLike, z: ArrayLike = 0.0) -> CurrentFields: ...
@overload
def restore_conduction(solution: ThermalConstrictionSolution, r: ArrayLike, z: ArrayLike = 0.0) -> HeatFields: ...
def restore_conduction(
    solution: JouleHeatingSolution | ThermalConstrictionSolution, r: ArrayLike, z: ArrayLike = 0.0
) -> CurrentFields | HeatFields:
    """Return the fields of current or heat in two bodies that touch.

    Parameters
    ----------
    solution : JouleHeatingSolution or ThermalConstrictionSolution
        For one load.
    r : array_like
        Distances from the axis [m], not negative.
    z : array_like, optional
        Depths [m], broadcast against r: positive in the first body, negative in the second; the surface of the first
        by default.

    Returns
    -------
    CurrentFields or HeatFields

    Raises
    ------
    InvalidInput
        If a place is not finite or r negative, the solution is of another kind, or holds many loads.
    OutsideValidity
        If there is a film, a plating or a rod, or the foundation defines only the stiffness: then the field is not that
        of a plain disc.
    """
    places = []
    for word, coordinate in (("r", r), ("z", z)):
        try:
            numbers = np.asarray(coordinate, dtype=float)
        except (TypeError, ValueError):
            raise InvalidInput(
                f"restore_conduction: {word} is {coordinate!r}; give a number or an array in m."
            ) from None
        if not np.all(np.isfinite(numbers)):
            raise InvalidInput(f"restore_conduction: {word} holds values that are not finite; give places in m.")
        places.append(numbers)
    if np.any(places[0] < 0.0):
        raise InvalidInput(f"restore_conduction: r = {np.min(places[0]):.6g} m is negative; give distances.")
    across, down = np.broadcast_arrays(*places)
    match solution:
        case JouleHeatingSolution():
            _refuse(solution.problem.contact.bed, solution.problem.conductors)
            return _current(solution, across, down)
        case ThermalConstrictionSolution():
            _refuse(solution.problem.contact.bed, solution.problem.conductors)
            return _heat(solution, across, down)
        case _:
            raise InvalidInput(
                f"restore_conduction: a {type(solution).__name__} drives nothing through the contact; give a solution "
                "of JouleHeating or ThermalConstriction."
            )


def _refuse(bed: Bed, conductors: ElectricalConductors | HeatConductors) -> None:
    if not plain(conductors):
        raise OutsideValidity(
            "restore_conduction: with a film, a plating or a rod the field is not that of a plain disc, and is not "
            "implemented; give thick bodies of one conductor that touch without a film."
        )
    refuse_unless_round(bed, "restore_conduction", "the field")


def _density(r: Array, z: Array, radius: float, flow: float) -> tuple[Array, Array]:
    """Return the density of a flow along z, through a disc, outward and along z."""
    outward, down = disc_slopes(r, np.abs(z), radius)
    factor = 0.0 if radius == 0.0 else flow / (4.0 * radius)
    if factor == 0.0:
        return np.zeros(r.shape), np.zeros(r.shape)
    # adding zero turns minus zero into zero
    return 0.0 - factor * np.where(z < 0.0, -1.0, 1.0) * outward, 0.0 - factor * down


def _current(solution: JouleHeatingSolution, r: Array, z: Array) -> CurrentFields:
    problem, radius = solution.problem, single(solution.radius, "fields")
    theta = disc_potential(r, np.abs(z), radius)
    if radius == 0.0:
        voltage = np.where(z < 0.0, float(solution.voltage), 0.0)
        ambient = np.full(r.shape, problem.temperature)
        return CurrentFields(r, z, voltage, ambient, np.zeros(r.shape), np.zeros(r.shape))
    parts = resistances_of(problem.contact.bed, problem.conductors, np.array([radius]))
    cold = cold_contact(problem, parts, parts.middle, np.array([True]))
    hot = hot_at_voltage(cold, np.array([float(solution.voltage)]))
    potential, temperature = np.zeros(r.shape), np.zeros(r.shape)
    sides = (z >= 0.0, z < 0.0)
    falls, inflows = (float(hot.first[0]), float(hot.second[0])), [float(part[0]) for part in hot.inflow()]
    for body, (here, fall, inflow) in enumerate(zip(sides, falls, inflows, strict=True)):
        own = _fallen(cold, cold.coefficients[body], np.array(inflow), np.array(fall), theta[here])
        temperature[here] = profile(cold, np.array(inflow), np.array(fall), own)
        potential[here] = own if body == 0 else float(solution.voltage) - own
    return CurrentFields(r, z, potential, temperature, *_density(r, z, radius, float(solution.current)))


def _fallen(cold: ColdContact, alpha: float, inflow: Array, fall: Array, theta: Array) -> Array:
    """Return the voltage against the end of a body where the cold body would have the part theta of its voltage.

    Theta is the integral of 1 / rho(T) over the voltage, over that of the whole body: a function that only rises.
    """
    if alpha == 0.0 or float(fall) == 0.0:
        return np.asarray(fall * theta)
    nodes, weights = gauss_legendre(NODES)

    def summed(phi: Array) -> Array:
        places = phi[..., None] * nodes**2
        temperature = profile(cold, inflow, fall, places)
        return np.asarray(phi * ((1.0 / (1.0 + alpha * (temperature - cold.ambient))) @ (2.0 * weights * nodes)))

    def inverse_slope(phi: Array) -> Array:
        return np.asarray(1.0 + alpha * (profile(cold, inflow, fall, phi) - cold.ambient))

    goal = float(summed(np.asarray(fall))) * theta
    low, high, middle = np.zeros(theta.shape), np.full(theta.shape, float(fall)), np.asarray(fall * theta)
    for _ in range(60):
        excess = summed(middle) - goal
        low, high = np.where(excess < 0.0, middle, low), np.where(excess < 0.0, high, middle)
        newton = middle - excess * inverse_slope(middle)
        before, middle = middle, np.where((newton >= low) & (newton <= high), newton, 0.5 * (low + high))
        if np.all(np.abs(middle - before) <= CLOSE * float(fall)):
            break
    return np.asarray(middle)


def _heat(solution: ThermalConstrictionSolution, r: Array, z: Array) -> HeatFields:
    radius = single(solution.radius, "fields")
    theta = disc_potential(r, np.abs(z), radius)
    first = solution.problem.temperature_drop - float(solution.first_drop) * theta
    second = float(solution.second_drop) * theta
    # heat flows from the first body, z > 0, to the second
    flux = _density(r, z, radius, -float(solution.heat_rate))
    return HeatFields(r, z, np.where(z >= 0.0, first, second), *flux)
