r"""What a measured surface conducts: by boundary elements, by the line of springs, and between which bounds.

Conductance and stiffness are in proportion, whatever the contact looks like (Barber),

.. math:: \frac{1}{R} = \frac{2}{E^*(\rho_1+\rho_2)}\,\frac{\mathrm dF_N}{\mathrm dd} ,

so k(F) determines the resistance between clean metals.  A film adds what the boundary elements of the current find,
each pixel with its own film in series (`winkler.media.conduction.spot_resistances`).  The map lies between a flat and
the same flat raised by its height s from the lowest valley to the highest peak.  With the stiffness :math:`k_\infty` of
the flat, which touches all over, the tangents to both force curves bound that of the rough surface by
:math:`F/(F/k_\infty+s)\le k\le k_\infty`.
"""

from __future__ import annotations

import dataclasses
import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.checks.number_checks import Seed, Whole
from winkler.errors import OutsideValidity
from winkler.laws.film import SurfaceFilm
from winkler.limits import MOST_SPRINGS
from winkler.loading import Depth, Force
from winkler.media.conduction.conductors import ElectricalConductors
from winkler.media.conduction.spot_resistances import spot_resistances
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.types import Array, Quantity, shaped
from winkler.problems.assumptions.declared import MAPPED
from winkler.problems.conduction.stiffness_analogy import conductance_of_stiffness
from winkler.problems.rough.line_contact import RoughContact, RoughContactSolution
from winkler.problems.rough.mapped_medium import homogeneous
from winkler.problems.rough.surface_contact import SurfaceContact, SurfaceContactSolution
from winkler.problems.rough.surface_states import SurfaceState
from winkler.profiles.rough.map_spectrum import spectrum_of
from winkler.profiles.rough.topography import Topography
from winkler.validity import Assumption, Note, Standing
from winkler.values import value, words

__all__ = ["SurfaceConduction", "SurfaceConductionSolution"]

LARGEST_CURVED_SHARE = 0.2
"""Part of the mean square height that a paraboloid may make up before lines of springs, rough alone, mislead."""
BARBER = "J. R. Barber, Proc. R. Soc. A 459 (2003) 53-66, doi:10.1098/rspa.2002.1038"


@value
class SurfaceConduction:
    """A height map on a flat half-space, and the current through both.

    Parameters
    ----------
    contact : SurfaceContact
        How they are pressed together.
    conductors : ElectricalConductors
        What the bodies conduct, and the film between them; thick ones without platings.
    realisations : int, optional
        How many random lines with the spectrum of the map are pressed beside it.
    seed : int, optional
        Of the first of them.

    Raises
    ------
    InvalidInput
        If an argument has the wrong type, or a number is out of range.
    OutsideValidity
        If there is a plating or a rod, or the bodies have layers, of which stiffness tells no conductance.

    References
    ----------
    J. R. Barber, Proc. R. Soc. A 459 (2003) 53-66, doi:10.1098/rspa.2002.1038
    """

    __words__ = words(contact=("", None, "how the surface is pressed"))

    contact: SurfaceContact
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
        medium = self._medium  # refuses layers
        try:
            conductance_of_stiffness("SurfaceConduction", medium, self._clean)
        except OutsideValidity as error:
            raise OutsideValidity(f"{error} A SurfaceConstriction follows platings on maps.") from None

    @property
    def _clean(self) -> ElectricalConductors:
        """The bodies without the film."""
        return dataclasses.replace(self.conductors, film=SurfaceFilm())

    @property
    def _medium(self) -> HomogeneousMedium:
        return homogeneous("SurfaceConduction", "the resistance", self.contact.medium)

    def solve(self) -> SurfaceConductionSolution:
        """Return the resistance under every load.

        Raises
        ------
        InvalidInput
            If the map has no spectrum: it is flat, or too small.
        NotConverged
            If a contact is not solved to its tolerance.
        """
        rough, medium = self.contact.topography, self._medium
        spectrum = spectrum_of(rough)  # first, since it may refuse
        states = list(self.contact.steps())
        contact_solution = self.contact.gathered(states)
        side = math.sqrt(rough.area)
        line = RoughContact(
            spectrum, medium, side, Force(contact_solution.force), realisations=self.realisations, seed=self.seed
        ).solve()
        flat = math.inf
        if not rough.periodic:
            smooth = Topography(np.zeros_like(rough.heights), rough.lengths)
            flat = float(SurfaceContact(smooth, medium, Depth(1.0)).solve().stiffness)
        force = np.asarray(contact_solution.force, dtype=float)
        least = force / (force / flat + float(np.ptp(rough.heights)))
        return SurfaceConductionSolution(
            self,
            contact_solution,
            line,
            *(contact_solution.depth, contact_solution.force, contact_solution.stiffness),
            *(np.asarray(line.stiffness), np.asarray(least), np.full_like(least, flat)),
            shaped(np.array([self._film_excess(state) for state in states]).reshape(force.shape)),
        )

    def _film_excess(self, state: SurfaceState) -> float:
        """Return what the film adds to the resistance of a contact [ohm]."""
        pair, rough = self.conductors, self.contact.topography
        if pair.film.area_resistance == 0.0:
            return 0.0
        found = spot_resistances(
            state.pressure > 0.0, rough.pixel, (pair.first, pair.second), pair.film.area_resistance,
            periodic=rough.periodic,
        )  # fmt: skip
        return found.first + found.second + found.film - found.bare


@value
class SurfaceConductionSolution:
    """The solution of a `SurfaceConduction`; quantities have the shape of the load.

    Parameters
    ----------
    problem : SurfaceConduction
        The problem that was solved.
    contact : SurfaceContactSolution
        The contact by boundary elements.
    line : RoughContactSolution
        That of lines with the same spectrum under the same forces.
    depth, force, stiffness : float or ndarray
        Of the contact by boundary elements [m], [N], [N/m].
    line_stiffness : float or ndarray
        dF/dd of the lines [N/m], their median.
    least_stiffness, greatest_stiffness : float or ndarray
        Bounds of dF/dd [N/m]; the second is infinite of a periodic map.
    film_excess : float or ndarray
        What the film adds to the resistance [ohm]: its area resistance over the area of the pixels in contact, and what
        it spreads the current.
    """

    __words__ = words(
        contact=("", None, "the contact by boundary elements"),
        film_excess=("R_f", "ohm", "what a film adds to the resistance"),
    )

    problem: SurfaceConduction
    contact: SurfaceContactSolution
    line: RoughContactSolution
    depth: Quantity
    force: Quantity
    stiffness: Quantity
    line_stiffness: Quantity
    least_stiffness: Quantity
    greatest_stiffness: Quantity
    film_excess: Quantity

    def _resistance(self, stiffness: Quantity) -> Array:
        stated = self.problem
        share = conductance_of_stiffness("SurfaceConduction", stated._medium, stated._clean)
        return np.asarray(1.0 / (share * np.asarray(stiffness, dtype=float)) + np.asarray(self.film_excess))

    @property
    def conductance(self) -> Quantity:
        """1 / R [S] by boundary elements."""
        return shaped(1.0 / self._resistance(self.stiffness))

    @property
    def resistance(self) -> Quantity:
        """R [ohm] by boundary elements."""
        return shaped(self._resistance(self.stiffness))

    @property
    def line_resistance(self) -> Quantity:
        """R [ohm] by the lines."""
        return shaped(self._resistance(self.line_stiffness))

    @property
    def least_resistance(self) -> Quantity:
        """The lower bound of R [ohm]; of a periodic map what the film adds."""
        return shaped(self._resistance(self.greatest_stiffness))

    @property
    def greatest_resistance(self) -> Quantity:
        """The upper bound of R [ohm]."""
        return shaped(self._resistance(self.least_stiffness))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: the contact, the line, the bounds."""
        line = [note for note in self.line.validity if note.standing is Standing.APPROXIMATE]  # no area is given here
        film = self.problem.conductors.film.area_resistance
        spots = "All pixels in contact bear the same film" if film else "All spots are clean metal"
        bounds = Note(
            Assumption.CONDUCTION,
            Standing.EXACT,
            "Rigorous bounds for elastic contact without friction or adhesion: the map lies between a flat and the "
            f"same flat raised by its height; of a curved map they are wide. {spots}, wider than the free path of "
            "electrons.",
            BARBER,
        )
        rough = self.problem.contact.topography
        shape = 0.0 if rough.periodic else 1.0 - (rough.detrended(2).rms_height / rough.rms_height) ** 2
        curved = Note(
            Assumption.ROUGHNESS,
            Standing.OUTSIDE,
            f"A plane or paraboloid makes up {shape:.0%} of the mean square height: lines of springs hold the "
            "roughness on it alone, their stiffness and resistance are not those of this map. Take a tilt off with "
            "topography.detrended(1); a rough ball is a RoughIndentation.",
            "comparison with boundary elements",
        )
        return (
            *self.contact.validity,
            *(note for note in line if note not in self.contact.validity),
            *((curved,) if shape > LARGEST_CURVED_SHARE else ()),
            bounds,
        )
