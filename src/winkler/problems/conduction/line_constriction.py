r"""Contact resistance of a line contact, per length, against points that are stated.

Current converges on the strip from -a to a.  Between the strip and a point at the depth d below its middle it costs

.. math:: R' = \frac\rho\pi\,\mathrm{arsinh}\frac da ,

in each body: for :math:`d\gg a` it is :math:`(\rho/\pi)\ln(2d/a)`, which has no limit, as the depth of a line contact
has none.  A film of the resistance :math:`\sigma_f` of a unit of area adds :math:`\sigma_f/2a`.  It also spreads the
current, from that of a strip of one voltage towards an even one, which costs at most
:math:`(\rho_1+\rho_2)(3/2-2\ln2)/\pi` more.
"""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from winkler.materials.conductor import ElectricalConductor
from winkler.media.conduction.conductors import ElectricalConductors
from winkler.media.conduction.disc_resistance import HOLM
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import CONDUCTING
from winkler.problems.line.indentation import LineIndentation, LineSolution
from winkler.values.checks.number_checks import Positive
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

MOST_SPREADING = (1.5 - 2.0 * math.log(2.0)) / math.pi
"""What an even current costs more than that of a strip of one voltage, over rho_1 + rho_2."""


@value
class LineConstriction(PerLoad[Q]):
    """Contact resistance per length of two conductors in line contact, between given reference points.

    Parameters
    ----------
    contact : LineIndentation
        The mechanical contact. For an array of loads the results have its shape.
    conductors : ElectricalConductors
        Two bodies of ElectricalConductor, and the film between them.
    first_depth, second_depth : float
        Depths [m] of the two reference points below the middle of each surface; the resistance is that between these
        points.

    Raises
    ------
    InvalidInput
        If a body is plated or a rod, or an argument has the wrong type.

    References
    ----------
    R. Holm, Electric Contacts, 4th edition, Springer 1967, doi:10.1007/978-3-662-06688-1

    Examples
    --------
    >>> from winkler.foundation.line import LineFoundation
    >>> from winkler.loading.loads import LineForce
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> steel, wire = Elastic(210e9, 0.3), ElectricalConductor(0.2e-6)
    >>> roller = LineFoundation(Paraboloid(10e-3), HalfSpace.between(steel, steel))
    >>> pair = ElectricalConductors(wire, wire)
    >>> pressed = LineIndentation(roller, LineForce(100e3))
    >>> contact = LineConstriction(pressed, pair, first_depth=5e-3, second_depth=5e-3).solve()
    >>> round(contact.resistance_per_length * 1e6, 4)  # micro-ohm times metre
    0.5801
    """

    __words__ = words(
        contact=("", None, "how the bodies are pressed together"),
        first_depth=("d_1", "m", "depth in the first body from which the resistance is counted"),
        second_depth=("d_2", "m", "depth in the second body up to which the resistance is counted"),
    )

    contact: LineIndentation[Q]
    conductors: ElectricalConductors
    first_depth: Positive
    second_depth: Positive

    references: ClassVar[tuple[str, ...]] = ("holm_1967", "johnson_1985")
    assumptions: ClassVar[frozenset[Assumption]] = CONDUCTING

    def __post_init__(self) -> None:
        _ = self._resistivities

    @property
    def _resistivities(self) -> tuple[float, float]:
        first, second = self.conductors.first, self.conductors.second
        if not isinstance(first, ElectricalConductor) or not isinstance(second, ElectricalConductor):
            raise InvalidInput(
                f"LineConstriction: the bodies are {type(first).__name__} and {type(second).__name__}; how a current "
                "converges on a strip is known for two thick bodies: give ElectricalConductor(resistivity) for both."
            )
        return first.resistivity, second.resistivity

    def solve(self) -> LineConstrictionSolution[Q]:
        """Return the resistance and its parts.

        Raises
        ------
        OutsideValidity
            If `LineIndentation` does not support the load.
        """
        contact = self.contact.solve()
        half_width = np.asarray(contact.half_width, dtype=float)
        touches = half_width > 0.0
        a = np.where(touches, half_width, 1.0)
        first, second = (
            np.where(touches, rho / math.pi * np.arcsinh(depth / a), math.inf)
            for rho, depth in zip(self._resistivities, (self.first_depth, self.second_depth), strict=True)
        )
        film = np.where(touches, 0.5 * self.conductors.film.area_resistance / a, math.inf)
        parts: tuple[Array, ...] = (first + second + film, first, second, film)
        return LineConstrictionSolution(self, contact, *(shaped(part, half_width.shape) for part in parts))


@value
class LineConstrictionSolution(PerLoad[Q]):
    """The solution of a `LineConstriction`; every quantity has the shape of the load.

    Parameters
    ----------
    problem : LineConstriction
        The problem that was solved.
    contact : LineSolution
        The contact.
    resistance_per_length : float or ndarray
        R' [ohm m], all parts in series: over the length of the contact it is the resistance; infinite without contact.
    first_constriction_per_length, second_constriction_per_length : float or ndarray
        Constriction resistance of each body, up to its reference point [ohm m].
    film_resistance_per_length : float or ndarray
        Area resistance of the film over the width of the strip [ohm m].
    """

    __words__ = words(
        first_constriction_per_length=("R'_1", "ohm m", "constriction in the first body, times length"),
        second_constriction_per_length=("R'_2", "ohm m", "constriction in the second body, times length"),
        film_resistance_per_length=("R'_f", "ohm m", "resistance of the film, times length"),
    )

    problem: LineConstriction[Q]
    contact: LineSolution[Q]
    resistance_per_length: Q
    first_constriction_per_length: Q
    second_constriction_per_length: Q
    film_resistance_per_length: Q

    per_load: ClassVar[str] = "resistance_per_length"

    @property
    def force_per_length(self) -> Q:
        """P [N/m]."""
        return self.contact.force_per_length

    @property
    def half_width(self) -> Q:
        """Half-width of the strip a [m]."""
        return self.contact.half_width

    def at(self, index: int | tuple[int, ...]) -> LineConstrictionSolution[float]:
        """Return the solution of one load of an array.

        Parameters
        ----------
        index : int or tuple of int
            Which one.

        Raises
        ------
        InvalidInput
            If there is no such load.
        """
        given, contact = self.problem, self.contact.at(index).problem
        return LineConstriction(contact, given.conductors, given.first_depth, given.second_depth).solve()

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the resistance can be trusted."""
        widest = float(np.max(self.half_width, initial=0.0))
        reference = Note(
            Assumption.CONDUCTION,
            Standing.EXACT,
            "Half-planes of constant resistivity with a contact strip of uniform voltage. The resistance applies "
            f"between points {self.problem.first_depth:.4g} m and {self.problem.second_depth:.4g} m below the "
            "middle of the surfaces. Twice the depth adds rho ln(2)/pi; without a stated depth the resistance is "
            "not defined.",
            HOLM,
        )
        notes = [*self.contact.validity, reference]
        nearest = min(self.problem.first_depth, self.problem.second_depth)
        if widest > nearest:
            near = (
                f"The half-width of the strip is {widest:.3g} m, more than the depth of the nearer point, "
                f"{nearest:.3g} m."
            )
            notes.append(Note(Assumption.CONDUCTION, Standing.APPROXIMATE, near, HOLM))
        if self.problem.conductors.film.area_resistance > 0.0:
            most = MOST_SPREADING * sum(self.problem._resistivities)
            share = most / float(np.min(self.resistance_per_length))
            spread = (
                "The film is computed in series with a strip of uniform voltage, which is a lower bound. The "
                f"spreading of the current by the film adds at most {most:.3g} ohm m, {100.0 * share:.2g} % of "
                "the resistance."
            )
            notes.append(Note(Assumption.CONDUCTION, Standing.APPROXIMATE, spread, "two bounds, by Rayleigh's theorem"))
        return tuple(notes)
