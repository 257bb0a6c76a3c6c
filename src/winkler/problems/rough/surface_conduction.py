r"""What a measured surface conducts: by boundary elements, by the line of springs, and between which bounds.

Conductance and stiffness are in proportion, whatever the contact looks like (Barber),

.. math:: \frac{1}{R} = \frac{2}{E^*(\rho_1+\rho_2)}\,\frac{\mathrm dF_N}{\mathrm dd} ,

so k(F) determines the resistance between clean metals.  A film adds what the boundary elements of the current find,
each pixel with its own film in series (`winkler.media.conduction.spot_resistances`).  The map lies between a flat and
the same flat raised by its height s from the lowest valley to the highest peak.  With the stiffness :math:`k_\infty` of
the flat, which touches all over, the tangents to both force curves bound that of the rough surface by
:math:`F/(F/k_\infty+s)\le k\le k_\infty`.

Platings and elastic layers end the proportion; the boundary elements of the current then find all of the resistance.
Nothing conducts better than full contact, which is the bound that is left.
"""

from __future__ import annotations

import dataclasses
import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.laws.film import SurfaceFilm
from winkler.loading.loads import Force
from winkler.materials.conducting_body import Plated
from winkler.media.conduction.conductors import ElectricalConductors
from winkler.media.conduction.spot_resistances import SpotResistances, spot_resistances
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import layers_of
from winkler.numerics.surfaces.punched_grid import punch
from winkler.numerics.types import Array, PerLoad, Q, Quantity, shaped
from winkler.problems.assumptions.declared import MAPPED
from winkler.problems.conduction.stiffness_analogy import conductance_of_stiffness
from winkler.problems.rough.line_contact import NO_AREA, RoughContact, RoughContactSolution
from winkler.problems.rough.map_conductors import plating_notes, refuse_bodies
from winkler.problems.rough.surface_contact import SurfaceContact, SurfaceContactSolution
from winkler.problems.rough.surface_states import SurfaceState
from winkler.profiles.rough.map_spectrum import spectrum_of
from winkler.values.checks.number_checks import Seed, Whole
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.limits import MOST_SPRINGS
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

LARGEST_CURVED_SHARE = 0.2
"""Part of the mean square height that a paraboloid may make up before lines of springs, rough alone, mislead."""
BARBER = "J. R. Barber, Proc. R. Soc. A 459 (2003) 53-66, doi:10.1098/rspa.2002.1038"


@value
class SurfaceConduction(PerLoad[Q]):
    """A height map on a flat half-space, and the current through both bodies.

    Parameters
    ----------
    contact : SurfaceContact
        The mechanical contact.
    conductors : ElectricalConductors
        Conductors of the bodies, thick and plated or not, and the film between them.
    realisations : int, optional
        Number of random profiles with the spectrum of the map that are pressed for comparison.
    seed : int, optional
        Seed of the first random profile.

    Raises
    ------
    InvalidInput
        If an argument has the wrong type, or a number is out of range.
    OutsideValidity
        If a body is a rod, or a plating is thinner than 1e-7 of the map.

    References
    ----------
    J. R. Barber, Proc. R. Soc. A 459 (2003) 53-66, doi:10.1098/rspa.2002.1038
    """

    __words__ = words(
        contact=("", None, "how the surface is pressed"),
        in_proportion=("", "", "whether conductance is in proportion to stiffness"),
    )

    contact: SurfaceContact[Q]
    conductors: ElectricalConductors
    realisations: Annotated[int, Whole(1, MOST_SPRINGS // 256)] = 20
    seed: Seed = 0

    references: ClassVar[tuple[str, ...]] = ("barber_2003", "pohrt_popov_2012")
    assumptions: ClassVar[frozenset[Assumption]] = MAPPED | {
        Assumption.CONDUCTION,
        Assumption.CONTINUUM,
        Assumption.ROUGHNESS,
    }

    def __post_init__(self) -> None:
        refuse_bodies("SurfaceConduction", self.conductors, float(np.max(self.contact.topography.lengths)))

    @property
    def in_proportion(self) -> bool:
        """Whether the conductance is proportional to the stiffness: no elastic layers and no platings."""
        plated = any(isinstance(body, Plated) for body in (self.conductors.first, self.conductors.second))
        return isinstance(self.contact.medium, HomogeneousMedium) and not plated

    def solve(self) -> SurfaceConductionSolution[Q]:
        """Return the resistance under every load.

        Raises
        ------
        InvalidInput
            If the map has no spectrum: it is flat, or too small.
        NotConverged
            If a contact is not solved to its tolerance, or its current not found.
        OutsideValidity
            If the pixels are too coarse for the platings.
        """
        rough, medium = self.contact.topography, self.contact.medium
        spectrum = spectrum_of(rough)  # first, since it may refuse
        states = list(self.contact.steps())
        contact_solution = self.contact.gathered(states)
        side = math.sqrt(rough.area)
        line = RoughContact(
            spectrum, medium, side, Force(contact_solution.force), realisations=self.realisations, seed=self.seed
        ).solve()
        flat = math.inf
        if not rough.periodic:
            everywhere = np.ones(rough.heights.shape, dtype=bool)
            pressures = punch(everywhere, rough.pixel, periodic=False, layers=layers_of(medium))
            flat = medium.modulus * rough.pixel[0] * rough.pixel[1] * float(np.sum(pressures))
        force = np.asarray(contact_solution.force, dtype=float)
        # in layers parts of a contact may open as it is pressed: the force curve need not bend upwards
        bent = isinstance(medium, HomogeneousMedium)
        least = force / (force / flat + float(np.ptp(rough.heights))) if bent else np.zeros(force.shape)
        resistances = self._in_proportion if self.in_proportion else self._of_current
        stiffnesses = (contact_solution.stiffness, np.asarray(line.stiffness), least, np.full_like(least, flat))
        return SurfaceConductionSolution(
            self, contact_solution, line, contact_solution.depth, contact_solution.force, *stiffnesses,
            *(shaped(part) for part in resistances(states, stiffnesses)),
        )  # fmt: skip

    def of_stiffness(self, stiffness: Quantity, film_excess: Quantity) -> Array:
        """Return the resistance [ohm] for a stiffness [N/m], film included; nan if they are not proportional."""
        if not self.in_proportion:
            return np.full(np.shape(stiffness), math.nan)
        assert isinstance(self.contact.medium, HomogeneousMedium)
        clean = dataclasses.replace(self.conductors, film=SurfaceFilm())
        share = conductance_of_stiffness("SurfaceConduction", self.contact.medium, clean)
        return np.asarray(1.0 / (share * np.asarray(stiffness, dtype=float)) + np.asarray(film_excess))

    def _in_proportion(self, states: list[SurfaceState], stiffnesses: tuple[Quantity, ...]) -> list[Array]:
        """Return what the film adds, and the resistance with its bounds [ohm], in the shape of the load."""
        film, shape = self.conductors.film.area_resistance, np.shape(stiffnesses[0])
        excess = np.zeros(shape)
        if film:
            found = [self._spots(state.pressure > 0.0, film) for state in states]
            excess = np.array([_whole(parts) - parts.bare for parts in found]).reshape(shape)
        by_elements, _, least, greatest = stiffnesses
        return [excess, *(self.of_stiffness(each, excess) for each in (by_elements, greatest, least))]

    def _of_current(self, states: list[SurfaceState], stiffnesses: tuple[Quantity, ...]) -> list[Array]:
        """Return the same by the current of every pixel, without an upper bound."""
        film, shape = self.conductors.film.area_resistance, np.shape(stiffnesses[0])
        touching = [state.pressure > 0.0 for state in states]
        whole = np.array([_whole(self._spots(each, film)) for each in touching]).reshape(shape)
        clean = np.array([_whole(self._spots(each, 0.0)) for each in touching]).reshape(shape) if film else whole
        full = _whole(self._spots(np.ones_like(touching[0]), film))
        return [whole - clean, whole, *(np.full(shape, each) for each in (full, math.inf))]

    def _spots(self, touching: Array, film: float) -> SpotResistances:
        """Return the resistance of pixels in contact, under a film of this area resistance [ohm m^2]."""
        rough, bodies = self.contact.topography, (self.conductors.first, self.conductors.second)
        try:
            return spot_resistances(touching, rough.pixel, bodies, film, periodic=rough.periodic)
        except OutsideValidity as error:
            raise OutsideValidity(f"SurfaceConduction: of the platings, {error}") from None
        except NotConverged:
            raise NotConverged(
                "SurfaceConduction: the current through the spots was not found; give platings whose resistivities "
                "differ by a factor of less than 1e8, or smooth the heights."
            ) from None


def _whole(parts: SpotResistances) -> float:
    """Return all of a resistance, film included [ohm]."""
    return parts.first + parts.second + parts.film


@value
class SurfaceConductionSolution(PerLoad[Q]):
    """The solution of a `SurfaceConduction`; quantities have the shape of the load.

    Parameters
    ----------
    problem : SurfaceConduction
        The problem that was solved.
    contact : SurfaceContactSolution
        The contact by boundary elements.
    line : RoughContactSolution
        The contact of random profiles with the same spectrum under the same forces.
    depth, force, stiffness : float or ndarray
        Results of boundary elements [m], [N], [N/m].
    line_stiffness : float or ndarray
        Median of dF/dd of the random profiles [N/m].
    least_stiffness, greatest_stiffness : float or ndarray
        Bounds of dF/dd [N/m]; the first is zero for elastic layers, the second is infinite for a periodic map.
    film_excess : float or ndarray
        Additional resistance of the film [ohm]: its area resistance over the area of the pixels in contact, and the
        effect of spreading the current.
    resistance : float or ndarray
        R [ohm] by boundary elements.
    least_resistance, greatest_resistance : float or ndarray
        Bounds of R [ohm].  The lower bound of a periodic map is the resistance of the film.  Through platings and
        between elastic layers it is the resistance in full contact, and the upper one infinite.
    """

    __words__ = words(
        contact=("", None, "the contact by boundary elements"),
        film_excess=("R_f", "ohm", "what a film adds to the resistance"),
    )

    problem: SurfaceConduction[Q]
    contact: SurfaceContactSolution[Q]
    line: RoughContactSolution[Q]
    depth: Q
    force: Q
    stiffness: Q
    line_stiffness: Q
    least_stiffness: Q
    greatest_stiffness: Q
    film_excess: Q
    resistance: Q
    least_resistance: Q
    greatest_resistance: Q

    @property
    def conductance(self) -> Q:
        """1 / R [S] by boundary elements; infinite for full contact of a periodic map without a film."""
        with np.errstate(divide="ignore"):
            return shaped(1.0 / np.asarray(self.resistance, dtype=float))

    @property
    def line_resistance(self) -> Q:
        """R [ohm] of the one-dimensional foundations; nan with platings or elastic layers, for which they yield no
        resistance.
        """
        return shaped(self.problem.of_stiffness(self.line_stiffness, self.film_excess))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: the contact, the line, the bounds."""
        stated = self.problem
        approximate = [note for note in self.line.validity if note.standing is Standing.APPROXIMATE]
        line = [
            note for note in approximate if note.statement != NO_AREA.statement
        ]  # no area of the line is given here
        spots = (
            "All pixels in contact have the same film"
            if stated.conductors.film.area_resistance
            else "All pixels in contact are clean metal"
        )
        between = (
            "Rigorous bounds for elastic contact without friction or adhesion. The map lies between a flat and "
            "the same flat raised by the height of the map. For a curved map the bounds are wide."
            if stated.in_proportion
            else "With platings or elastic layers conductance is not proportional to stiffness. The current is "
            "therefore computed on the pixels in contact; the springs give no resistance. The only bound of the "
            "conductance is that of full contact. For a round spot n pixels wide the resistance is too high by a "
            "fraction of about 0.5 / n of that of the equal disc."
        )
        bounds = Note(
            Assumption.CONDUCTION, Standing.EXACT if stated.in_proportion else Standing.APPROXIMATE,
            f"{between} {spots}. All spots are assumed wider than the mean free path of electrons.",
            BARBER,
        )  # fmt: skip
        rough = stated.contact.topography
        shape = 0.0 if rough.periodic else 1.0 - (rough.detrended(2).rms_height / rough.rms_height) ** 2
        curved = Note(
            Assumption.ROUGHNESS,
            Standing.OUTSIDE,
            f"A plane or paraboloid makes up {shape:.0%} of the mean square height. The one-dimensional "
            "foundation represents only the remaining roughness; its stiffness and resistance are not those of "
            "this map. Remove a tilt with topography.detrended(1), or use RoughIndentation for a rough ball.",
            "comparison with boundary elements",
        )
        return (
            *self.contact.validity,
            *(note for note in line if note not in self.contact.validity),
            *((curved,) if shape > LARGEST_CURVED_SHARE else ()),
            *plating_notes(stated.conductors, stated.contact.medium, rough),
            bounds,
        )
