r"""The electric contact of a height map: resistance of its spots through platings and films, heating by the current.

The current that goes through each pixel of the contact follows from its voltage, which is the same for all
(`winkler.media.conduction.spot_resistances`); temperature follows from voltage, whatever the spots look like
(Kohlrausch), :math:`T_{max}^2=T_0^2+V^2/(4L)` without a film.  So a metal softens and melts at a voltage of its own.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.laws.current import Current, Drive, WiedemannFranz
from winkler.loading.path import numbers_of
from winkler.media.conduction.conductors import ElectricalConductors
from winkler.media.conduction.spot_resistances import SpotResistances, spot_resistances
from winkler.numerics.films.joined import islands
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import MAPPED
from winkler.problems.conduction.heated_contact import (
    ColdContact,
    HotContact,
    hot_at_current,
    hot_at_voltage,
    temperatures,
)
from winkler.problems.rough.map_conductors import refuse_bodies
from winkler.problems.rough.surface_contact import SurfaceContact, SurfaceContactSolution
from winkler.problems.rough.surface_states import SurfaceState
from winkler.problems.surface_current.notes import current_notes
from winkler.problems.surface_current.softening import coefficient_of, voltage_to_reach
from winkler.values.checks.number_checks import Advice, NonNegative, Positive, PositiveOrInfinite
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

DEFAULT_LAW = WiedemannFranz()
ROOM_TEMPERATURE = 293.15
SAME_SHARE = 1e-6
"""Difference of a pixel's share of the voltage from the mean up to which it counts as the same: rounding."""


@value
class SurfaceConstriction(PerLoad[Q]):
    """Electrical resistance of a height map pressed onto another conductor, with or without platings.

    Parameters
    ----------
    contact : SurfaceContact
        The mechanical contact; with a `hardness` it is partly plastic.
    conductors : ElectricalConductors
        Conductors of the bodies, thick and plated or not, and the film between them.
    drive : Current or Voltage
        Prescribed current or voltage; if several voltages give the same current, the lowest is returned.
    law : WiedemannFranz, optional
        Relation between thermal and electrical conductivity; by default with Sommerfeld's Lorenz number.
    temperature : float, optional
        T_0 of both bodies far from the contact [K], positive; 293.15 K by default.
    softening_temperature, melting_temperature : float, optional
        Temperatures of the metal that softens or melts first [K], above `temperature`; infinite (the default) if not
        required.  Holm states about 373 K and 1336 K for gold, 453 K and 1233 K for silver, 463 K and 1356 K for
        copper.
    mean_free_path : float, optional
        Mean free path of the electrons [m]; a note states the resulting error of the resistance.

    Raises
    ------
    InvalidInput
        If a number is out of range, or a temperature is not above that of the bodies.
    OutsideValidity
        If a body is a rod (a map needs thick bodies), or a plating is thinner than 1e-7 of the map.

    References
    ----------
    R. Holm, Electric Contacts, 4th edition, Springer 1967, doi:10.1007/978-3-662-06688-1
    F. Kohlrausch, Annalen der Physik 306 (1900) 132-158

    Examples
    --------
    A gold-plated ball, partly plastic: its resistance, and the voltage at which gold softens.

    >>> import numpy as np
    >>> from winkler.laws.current import Voltage
    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.conducting_body import Plated
    >>> from winkler.materials.conductor import ElectricalConductor
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> from winkler.profiles.rough.sampled_profile import SampledProfile
    >>> ball = SampledProfile([60e-6, 60e-6], Paraboloid(2e-3), (49, 49))
    >>> metal = HalfSpace.between(Elastic(80e9, 0.42), Elastic(120e9, 0.34))
    >>> gold, bronze = ElectricalConductor(22e-9), ElectricalConductor(110e-9)
    >>> pair = ElectricalConductors(Plated(gold, 1e-6, bronze), Plated(gold, 1e-6, bronze))
    >>> contact = SurfaceContact(ball, metal, Force(0.5), hardness=0.4e9)
    >>> plated = SurfaceConstriction(contact, pair, Voltage(0.02), softening_temperature=373.0).solve()
    >>> round(plated.resistance * 1e3, 1), round(plated.plating_factor, 2), round(plated.softening_voltage, 3)
    (1.9, 0.81, 0.072)
    """

    __words__ = words(
        contact=("", None, "how the surface is pressed"),
        temperature=("T_0", "K", "temperature of both bodies far from the contact"),
        law=("", None, "how heat and current conduction go together"),
    )

    contact: SurfaceContact[Q]
    conductors: ElectricalConductors
    drive: Drive
    law: WiedemannFranz = DEFAULT_LAW
    temperature: Annotated[Positive, Advice("an absolute temperature")] = ROOM_TEMPERATURE
    softening_temperature: PositiveOrInfinite = math.inf
    melting_temperature: PositiveOrInfinite = math.inf
    mean_free_path: NonNegative = 0.0

    references: ClassVar[tuple[str, ...]] = ("holm_1967", "kohlrausch_1900", "barber_2003", "polonsky_keer_1999")
    assumptions: ClassVar[frozenset[Assumption]] = MAPPED | {
        Assumption.CONDUCTION,
        Assumption.CONTINUUM,
        Assumption.TEMPERATURE,
    }

    def __post_init__(self) -> None:
        refuse_bodies("SurfaceConstriction", self.conductors, float(np.max(self.contact.topography.lengths)))
        for word, number in (("softening", self.softening_temperature), ("melting", self.melting_temperature)):
            if not number > self.temperature:
                raise InvalidInput(
                    f"SurfaceConstriction: {word}_temperature is {number:g} K, not above that of the bodies, "
                    f"{self.temperature:g} K; current only heats: give a higher one, in kelvin."
                )

    def solve(self) -> SurfaceConstrictionSolution[Q]:
        """Return resistance, voltage, current and temperatures under every load.

        Returns
        -------
        SurfaceConstrictionSolution

        Raises
        ------
        NotConverged
            If a contact is not solved to its tolerance, or its current not found.
        OutsideValidity
            If the contact cannot carry the current at any voltage, because its resistance rises with temperature, or
            the pixels are too coarse for the platings.
        """
        rough = self.contact.topography
        bodies, film = (self.conductors.first, self.conductors.second), self.conductors.film.area_resistance
        rows: list[SpotResistances] = []
        counts: list[float] = []

        def watched() -> Iterator[SurfaceState]:
            for state in self.contact.steps():
                touching = state.pressure > 0.0
                counts.append(float(islands(touching, (rough.periodic, rough.periodic), corners=True)[1]))
                try:
                    rows.append(spot_resistances(touching, rough.pixel, bodies, film, periodic=rough.periodic))
                except OutsideValidity as error:
                    raise OutsideValidity(f"SurfaceConstriction: of the platings, {error}") from None
                except NotConverged:
                    raise NotConverged(
                        "SurfaceConstriction: the current through the spots was not found; give platings whose "
                        "resistivities differ by a factor of less than 1e8, or smooth the heights."
                    ) from None
                yield state

        contact = self.contact.gathered(watched())
        first, second, lost, bare, least, greatest = (np.array(column) for column in zip(*rows, strict=True))
        cold = ColdContact(
            first, second, lost, (coefficient_of(bodies[0]), coefficient_of(bodies[1])), self.temperature, self.law
        )
        ones = np.ones(len(rows))
        if isinstance(self.drive, Current):
            hot = hot_at_current(cold, self.drive.current * ones)
        else:
            hot = hot_at_voltage(cold, self.drive.voltage * ones)
        touch, most = temperatures(self.law, self.temperature, hot)
        even = np.clip(0.5, least, greatest)  # the share at which both bodies are heated most
        spots = np.array([self._touched(cold, share, hot, touch) for share in (least, even, greatest)])
        whole = first + second + lost
        flowing = hot.current > 0.0
        softening, melting = (
            voltage_to_reach(cold, number) for number in (self.softening_temperature, self.melting_temperature)
        )
        shape = numbers_of(self.contact.load).shape

        def column(numbers: Array | list[float]) -> Q:
            return shaped(np.asarray(numbers).reshape(shape))

        return SurfaceConstrictionSolution(
            self, contact, contact.depth, contact.force, contact.area, column(counts),
            resistance=column(np.where(flowing, hot.voltage / np.where(flowing, hot.current, 1.0), whole)),
            cold_resistance=column(whole),
            first_constriction=column(first), second_constriction=column(second), film_resistance=column(lost),
            bare_constriction=column(bare),
            current=column(hot.current), voltage=column(hot.voltage), film_voltage=column(hot.film),
            contact_temperature=column(touch), max_temperature=column(most),
            coldest_contact_temperature=column(np.min(spots, axis=0)),
            hottest_contact_temperature=column(np.max(spots, axis=0)),
            softening_voltage=column(softening.voltage), softening_current=column(softening.current),
            melting_voltage=column(melting.voltage), melting_current=column(melting.current),
        )  # fmt: skip

    def _touched(self, cold: ColdContact, share: Array, hot: HotContact, mean: Array) -> Array:
        """Return T_c [K] at a pixel from the first body's share there, `mean` if it is that of the mean."""
        both = cold.first + cold.second
        unlike = np.abs(share * both - cold.first) > SAME_SHARE * both
        found = mean.copy()
        if unlike.any():
            here, spread = share[unlike], both[unlike]
            there = cold._replace(first=here * spread, second=(1.0 - here) * spread, film=cold.film[unlike])
            heated = hot_at_voltage(there, hot.voltage[unlike])
            found[unlike] = temperatures(self.law, self.temperature, heated)[0]
        return found


@value
class SurfaceConstrictionSolution(PerLoad[Q]):
    """The solution of a `SurfaceConstriction`; quantities have the shape of the load.

    Parameters
    ----------
    problem : SurfaceConstriction
        The problem that was solved.
    contact : SurfaceContactSolution
        The contact, with its maps under the last load.
    depth, force, area : float or ndarray
        As in `SurfaceContactSolution` [m], [N], [m^2].
    patch_count : float or ndarray
        Number of spots of contact; pixels that touch at a corner belong to one spot.
    resistance, cold_resistance : float or ndarray
        Voltage over current [ohm], and the value without heating. For a periodic map: that of one period, in addition
        to the same bodies in full contact without film.
    first_constriction, second_constriction : float or ndarray
        Constriction resistance of each body without heating, platings included [ohm].
    film_resistance : float or ndarray
        Area resistance of the film over the area of the pixels in contact [ohm].
    bare_constriction : float or ndarray
        Constriction resistance of the same spots in both bodies, without platings and film [ohm].
    current, voltage, film_voltage : float or ndarray
        I [A]; V [V] between the ends, and over the film.
    contact_temperature, max_temperature : float or ndarray
        T_c [K] of the contact (for different platings at the mean voltage of the current), and maximum temperature
        T_max [K].
    coldest_contact_temperature, hottest_contact_temperature : float or ndarray
        Minimum and maximum T_c [K] of the pixels in contact, which differ for different platings.
    softening_voltage, softening_current, melting_voltage, melting_current : float or ndarray
        Voltage [V] and current [A] at which the hottest point has the given temperature; infinite without a given
        temperature.
    """

    __words__ = words(
        contact=("", None, "the contact by boundary elements"),
        patch_count=("n", "", "number of spots of contact"),
        heat_rate=("Q", "W", "Joule heat"),
        coldest_contact_temperature=("T_{c,min}", "K", "least temperature of a pixel in contact"),
        hottest_contact_temperature=("T_{c,max}", "K", "greatest temperature of a pixel in contact"),
    )

    problem: SurfaceConstriction[Q]
    contact: SurfaceContactSolution[Q]
    depth: Q
    force: Q
    area: Q
    patch_count: Q
    resistance: Q
    voltage: Q
    max_temperature: Q
    softening_voltage: Q
    softening_current: Q
    melting_voltage: Q
    melting_current: Q
    current: Q
    film_voltage: Q
    contact_temperature: Q
    coldest_contact_temperature: Q
    hottest_contact_temperature: Q
    cold_resistance: Q
    first_constriction: Q
    second_constriction: Q
    film_resistance: Q
    bare_constriction: Q

    @property
    def conductance(self) -> Q:
        """1 / R [S]; infinite for full contact of a periodic map without a film."""
        with np.errstate(divide="ignore"):
            return shaped(1.0 / np.asarray(self.resistance, dtype=float))

    @property
    def constriction(self) -> Q:
        """Constriction resistance of both bodies without heating [ohm]."""
        return shaped(np.asarray(self.first_constriction) + self.second_constriction)

    @property
    def plating_factor(self) -> Q:
        """Constriction resistance over that of the spots without platings and film [-]; nan without constriction."""
        bare = np.asarray(self.bare_constriction, dtype=float)
        some = bare > 0.0
        return shaped(np.where(some, np.asarray(self.constriction) / np.where(some, bare, 1.0), np.nan))

    @property
    def rise(self) -> Q:
        """Temperature rise of the hottest point above that of the bodies [K]."""
        return shaped(self.max_temperature - self.problem.temperature)

    @property
    def heat_rate(self) -> Q:
        """Joule heat I V [W]."""
        return shaped(np.asarray(self.current) * self.voltage)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: the contact, the bodies, the film, the temperature."""
        stated = self.problem
        return (
            *self.contact.validity,
            *current_notes(
                stated.conductors,
                rise=float(np.max(self.max_temperature)) - stated.temperature,
                narrowest=float(np.min(np.sqrt(np.asarray(self.area) / (np.pi * np.asarray(self.patch_count))))),
                mean_free_path=stated.mean_free_path,
                spots=(self.coldest_contact_temperature, self.hottest_contact_temperature, self.contact_temperature),
            ),
        )
