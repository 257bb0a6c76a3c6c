r"""A current through a contact: voltage, heat, and how hot the contact becomes.

Current lines and heat lines coincide, so temperature follows from voltage alone (Kohlrausch), whatever the shape of the
contact: :math:`T_{max}^2=T_0^2+V^2/(4L)` between ends of the temperature T_0, without a film.
"""

from __future__ import annotations

from typing import Annotated, ClassVar

import numpy as np

from winkler.laws.current import Current, Drive, Voltage, WiedemannFranz
from winkler.materials.conducting_body import ConductingBody, Rod, parts_of
from winkler.materials.conductor import ElectricalConductor
from winkler.media.conduction.conductors import ElectricalConductors
from winkler.media.conduction.disc_resistance import Resistances
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import CONDUCTING
from winkler.problems.conduction.disc import conducting_disc
from winkler.problems.conduction.heated_contact import (
    ColdContact,
    HotContact,
    hot_at_current,
    hot_at_voltage,
    temperatures,
)
from winkler.problems.conduction.solution import ConductingSolution
from winkler.problems.normal.indentation import Indentation
from winkler.values.checks.number_checks import Advice, Positive
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

DEFAULT_LAW = WiedemannFranz()
ROOM_TEMPERATURE = 293.15
KOHLRAUSCH = "R. Holm, Electric Contacts, 4th edition, Springer 1967, section 13, doi:10.1007/978-3-662-06688-1"


@value
class JouleHeating(PerLoad[Q]):
    """Heating of a contact by an electric current.

    Parameters
    ----------
    contact : Indentation
        The mechanical contact, on a Foundation, PlaneFoundation, EllipticFoundation, or MeasuredBed (a contact of any
        shape). For an array of loads the results have its shape.
    conductors : ElectricalConductors
        Conductors of the bodies, and the film between them.
    drive : Current or Voltage
        Prescribed current or voltage; if several voltages give the same current, the lowest is returned.
    law : WiedemannFranz, optional
        Relation between thermal and electrical conductivity; by default with Sommerfeld's Lorenz number.
    temperature : float, optional
        T_0 of both bodies far from the contact [K], positive; 293.15 K by default.

    Raises
    ------
    InvalidInput
        If an argument has the wrong type.

    References
    ----------
    F. Kohlrausch, Annalen der Physik 306 (1900) 132-158
    R. Holm, Electric Contacts, 4th edition, Springer 1967, doi:10.1007/978-3-662-06688-1

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.loading.loads import Radius
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(2e-3), HalfSpace.between(Elastic(83e9, 0.37)))
    >>> pair = ElectricalConductors(ElectricalConductor(15.9e-9), ElectricalConductor(15.9e-9))
    >>> hot = JouleHeating(Indentation(bed, Radius(20e-6)), pair, Voltage(0.1)).solve()
    >>> round(hot.max_temperature, 2)  # sqrt(T0^2 + V^2/(4L))
    434.05
    """

    __words__ = words(
        contact=("", None, "how the bodies are pressed together"),
        temperature=("T_0", "K", "temperature of both bodies far from the contact"),
        law=("", None, "how heat and current conduction go together"),
    )

    contact: Indentation[Q]
    conductors: ElectricalConductors
    drive: Drive
    law: WiedemannFranz = DEFAULT_LAW
    temperature: Annotated[Positive, Advice("an absolute temperature")] = ROOM_TEMPERATURE

    references: ClassVar[tuple[str, ...]] = ("kohlrausch_1900", "holm_1967", "barber_2003")
    assumptions: ClassVar[frozenset[Assumption]] = CONDUCTING | {Assumption.TEMPERATURE}
    needs_round: ClassVar[str] = ""

    def solve(self) -> JouleHeatingSolution[Q]:
        """Return voltage, current, heat and temperatures in the steady state.

        Returns
        -------
        JouleHeatingSolution

        Raises
        ------
        OutsideValidity
            As for `winkler.problems.conduction.constriction.Constriction.solve`. If the contact cannot carry the
            current at any voltage, because its resistance rises with temperature. If the resistivities of plating and
            substrate have different temperature coefficients.
        InvalidInput
            If a current is sent through bodies that do not touch.
        """
        contact, parts = conducting_disc(self.contact, self.conductors)
        hot = self._driven(parts)
        flowing = hot.current > 0.0
        resistance = np.where(flowing, hot.voltage / np.where(flowing, hot.current, 1.0), parts.whole)
        touch, most = temperatures(self.law, self.temperature, hot)
        middle, edge = (self._touched(parts, share, hot, touch) for share in (parts.middle, parts.edge))

        shape = np.shape(contact.radius)
        return JouleHeatingSolution(
            self,
            contact,
            resistance=shaped(resistance, shape),
            cold_resistance=shaped(parts.whole, shape),
            current=shaped(hot.current, shape),
            voltage=shaped(hot.voltage, shape),
            film_voltage=shaped(hot.film, shape),
            heat_rate=shaped(hot.current * hot.voltage, shape),
            contact_temperature=shaped(touch, shape),
            middle_temperature=shaped(middle, shape),
            edge_temperature=shaped(edge, shape),
            max_temperature=shaped(most, shape),
        )

    def _driven(self, parts: Resistances) -> HotContact:
        touching = np.isfinite(parts.first)
        none = np.zeros(touching.shape)
        hot = HotContact(none.copy(), none.copy(), none.copy(), none.copy())
        if isinstance(self.drive, Current) and self.drive.current > 0.0 and not touching.all():
            raise InvalidInput(
                f"JouleHeating: {self.drive.current:g} A cannot flow where the bodies do not touch; give a load that "
                "presses them together, or a voltage."
            )
        if touching.any():
            cold = cold_contact(self, parts, parts.first / (parts.first + parts.second), touching)
            drive = np.ones(int(touching.sum()))
            if isinstance(self.drive, Current):
                coefficients = hot_at_current(cold, self.drive.current * drive)
            else:
                coefficients = hot_at_voltage(cold, self.drive.voltage * drive)
            for whole, part in zip(hot, coefficients, strict=True):
                whole[touching] = part
        if isinstance(self.drive, Voltage):
            # apart, all the voltage stands between the surfaces
            hot.film[~touching] = self.drive.voltage
        return hot

    def _touched(self, parts: Resistances, share: Array, hot: HotContact, mean: Array) -> Array:
        """Return T_c [K] at a place of the spot from the first body's share there, `mean` if it is that of the mean."""
        touching = np.isfinite(parts.first)
        touching[touching] = share[touching] != parts.first[touching] / (parts.first + parts.second)[touching]
        found = mean.copy()
        if touching.any():
            there = hot_at_voltage(cold_contact(self, parts, share, touching), hot.voltage[touching])
            found[touching] = temperatures(self.law, self.temperature, there)[0]
        return found


def cold_contact(problem: JouleHeating, parts: Resistances, share: Array, touching: Array) -> ColdContact:
    """Return what is known of contacts before they are heated, at a place of the spot.

    Parameters
    ----------
    problem : JouleHeating
    parts : Resistances
    share : ndarray, (m,)
        Of the first body in the voltage over both constrictions, at that place or on average over the current [-].
    touching : ndarray of bool, (m,)
        Which of them to return.

    Raises
    ------
    OutsideValidity
        If a plating and what carries it resist differently as they are heated.
    """
    share, spread = share[touching], (parts.first + parts.second)[touching]
    first, second = problem.conductors.first, problem.conductors.second
    return ColdContact(
        share * spread + parts.bulk_first,
        (1.0 - share) * spread + parts.bulk_second,
        parts.film[touching],
        (_coefficient(first), _coefficient(second)),
        problem.temperature,
        problem.law,
    )


def _coefficient(body: ConductingBody) -> float:
    """Return the coefficient of temperature of a body."""
    coefficients = {part.temperature_coefficient for part in parts_of(body) if isinstance(part, ElectricalConductor)}
    if len(coefficients) > 1:
        raise OutsideValidity(
            "JouleHeating: plating and substrate have different temperature coefficients, so the current "
            "distribution would change with heating; give equal coefficients, or zero."
        )
    return coefficients.pop()


@value
class JouleHeatingSolution(ConductingSolution["JouleHeatingSolution[float]", Q]):
    """The solution of a `JouleHeating`; every quantity has the shape of the load.

    Parameters
    ----------
    problem : JouleHeating
        The problem that was solved.
    contact : IndentationSolution
        The contact, of the shape of the load.
    resistance, cold_resistance : float or ndarray
        Voltage over current [ohm], and the value without heating; infinite without contact.
    current, voltage : float or ndarray
        I [A]; V [V] between the ends.
    film_voltage : float or ndarray
        Over the film [V].
    heat_rate : float or ndarray
        Joule heat I V [W].
    contact_temperature : float or ndarray
        T_c [K] of the contact; if its voltage varies, the temperature at the mean voltage of the current.
    middle_temperature, edge_temperature : float or ndarray
        T_c [K] on the axis and at the edge of the spot, which differ for different platings.
    max_temperature : float or ndarray
        T_max [K]; inside the body that resists more, if they differ.
    """

    __words__ = words(
        heat_rate=("Q", "W", "Joule heat"),
        middle_temperature=("T_{c,0}", "K", "temperature of the contact on its axis"),
        edge_temperature=("T_{c,a}", "K", "temperature of the contact at its edge"),
    )

    problem: JouleHeating[Q]
    cold_resistance: Q
    current: Q
    voltage: Q
    film_voltage: Q
    heat_rate: Q
    contact_temperature: Q
    middle_temperature: Q
    edge_temperature: Q
    max_temperature: Q

    @property
    def rise(self) -> Q:
        """Supertemperature: temperature rise of the hottest point above that of the bodies [K]."""
        return shaped(self.max_temperature - self.problem.temperature)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        problem = self.problem
        notes = [
            *self._disc_notes,
            Note(
                Assumption.CONDUCTION,
                Standing.EXACT,
                "Steady state. Temperature follows from voltage for a contact of any shape, if the metals obey "
                "the Wiedemann-Franz law with one Lorenz number. The ends have the temperature of the bodies, "
                "and no heat leaves through other surfaces. Thermoelectric effects are neglected.",
                KOHLRAUSCH,
            ),
        ]
        bodies = (problem.conductors.first, problem.conductors.second)
        middle, edge, mean = (
            np.ravel(part) for part in (self.middle_temperature, self.edge_temperature, self.contact_temperature)
        )
        if np.any(middle != mean):
            worst = int(np.argmax(np.abs(middle - edge)))
            alike = len({_coefficient(body) for body in bodies}) == 1
            notes.append(
                Note(
                    Assumption.CONDUCTION,
                    Standing.EXACT if alike else Standing.APPROXIMATE,
                    f"Between different platings the spot has no single temperature: {middle[worst]:.5g} K on its "
                    f"axis, {edge[worst]:.5g} K at its edge, {mean[worst]:.5g} K at the mean voltage of the "
                    "current" + ("." if alike else ("; the current distribution is that of the cold contact.")),
                    "own solution: with heat flowing as the current, L (T^2 - T_0^2) is the product of both voltages",
                )
            )
        if any(isinstance(body, Rod) for body in bodies) and bodies[0] != bodies[1]:
            notes.append(
                Note(
                    Assumption.CONDUCTION,
                    Standing.ASYMPTOTIC,
                    "The contact is assumed to have one voltage and one temperature, which is accurate while it "
                    "is narrow compared with the rods.",
                    KOHLRAUSCH,
                )
            )
        if problem.conductors.film.area_resistance:
            notes.append(
                Note(
                    Assumption.CONDUCTION,
                    Standing.APPROXIMATE,
                    "The heat of the film is assumed to be distributed as the current, and the contact to "
                    "have one temperature.",
                    KOHLRAUSCH,
                )
            )
        if float(np.max(self.max_temperature)) > 2.0 * problem.temperature:
            notes.append(
                Note(
                    Assumption.TEMPERATURE,
                    Standing.OUTSIDE,
                    f"The maximum temperature is {float(np.max(self.max_temperature)):.4g} K. Metals soften "
                    "there, and the elastic contact, its radius and its resistance change. Compare the softening "
                    "voltage, WiedemannFranz().voltage_at(temperature).",
                    KOHLRAUSCH,
                )
            )
        return tuple(notes)
