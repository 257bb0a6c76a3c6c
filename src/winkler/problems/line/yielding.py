r"""Onset of yield below a line contact, at rest or sliding: the force per length that brings a body to its strength.

For a cylinder all stresses grow with :math:`\sqrt P`; for other profiles the half-width is sought at which the greatest
stress of `winkler.problems.line.stress` is the strength of a body.
"""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.laws.friction import Coulomb, Overcome
from winkler.media.layered.hankel_waves import blurred
from winkler.problems.assumptions.coupling import sliding_note
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.line.at_strength import at_strength, refuse_sharp, refuse_without_strength
from winkler.problems.line.half_width import refuse_unless_strips
from winkler.problems.line.pressing_load import OfWidth
from winkler.problems.line.validity import line_notes
from winkler.problems.normal.onset.part_onset import NAME, PART, onset_note
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

FRICTIONLESS = Coulomb(0.0)


@value
class LinePartOnset:
    """The onset of yield of one body, layer or base below a line contact, as if the others stayed elastic.

    Parameters
    ----------
    part : int
        Number of the part among those with a strength, counted from the uppermost layer of the first body down, from
        1.
    name : str
        Name of the part.
    force_per_length, half_width : float
        Load and half-width at the onset of yield [N/m], [m]; infinite if no yield was found in the examined range.
    x, z : float
        Coordinates [m], as in `LineYieldOnsetSolution`; nan where it does not yield.
    why : str
        Reason why no onset was found; empty if one was found.
    """

    __words__ = words(
        part=PART,
        name=NAME,
        x=("x", "m", "place along the surface"),
        why=("", None, "why no onset was found"),
    )

    part: int
    name: str
    force_per_length: float
    half_width: float
    x: float
    z: float
    why: str = ""


@value
class LineYieldOnset:
    """The force per length at which each body in a line contact begins to yield, with or without sliding.

    Parameters
    ----------
    bed : LineFoundation or LayeredLineFoundation
        Profile and bodies, on a `HalfSpace` or on layers; at least one part has a strength.
    friction : Coulomb, optional
        Coulomb's law of a contact that slides everywhere, with the traction mu p on each body; no friction by default.

    Raises
    ------
    InvalidInput
        If no body has a strength, or the medium is not isotropic.
    OutsideValidity
        If there is friction on a layer that slides on the material below.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 6.1 and 7.1, doi:10.1017/CBO9781139171731
    """

    __words__ = words(bed=("", None, "profile and bodies of the line contact"))

    bed: LineFoundation | LayeredLineFoundation
    friction: Overcome = FRICTIONLESS

    references: ClassVar[tuple[str, ...]] = ("johnson_1985",)
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED | {Assumption.UNCOUPLED}

    def __post_init__(self) -> None:
        refuse_without_strength(self.bed, "LineYieldOnset")
        self.bed.refuse_dragged(self.friction.coefficient)

    def solve(self) -> LineYieldOnsetSolution:
        """Return the load at the onset of yield, and the position of the onset.

        Raises
        ------
        OutsideValidity
            If the body yields at the first touch (a sharp tip, kink or rim), or not within the reach of the profile.
        """
        refuse_sharp(self.bed, "LineYieldOnset")
        failures: list[OutsideValidity | NotConverged] = []
        rows = [self._onset(number, part, failures) for number, part in enumerate(strong_parts(self.bed.medium), 1)]
        first = min(rows, key=lambda row: row.half_width)
        if math.isinf(first.half_width):
            raise failures[0]
        return LineYieldOnsetSolution(self, first.force_per_length, first.half_width, first.x, first.z, tuple(rows))

    def _onset(self, number: int, part: StrongPart, failures: list[OutsideValidity | NotConverged]) -> LinePartOnset:
        """Return the onset of one part; why there is none is added to the failures."""
        bed, mu = self.bed, self.friction.coefficient
        try:
            a, place = at_strength(bed, part, mu, "LineYieldOnset")
            refuse_unless_strips(bed, np.array([a]))
        except (OutsideValidity, NotConverged) as error:
            failures.append(error)
            return LinePartOnset(number, part.name, math.inf, math.inf, math.nan, math.nan, str(error))
        force = bed.medium.modulus * float(bed.load_profile(np.array([a]))[0])
        return LinePartOnset(number, part.name, force, a, place.x, place.z)


@value
class LineYieldOnsetSolution(OfWidth[float]):
    """The solution of `LineYieldOnset`.

    Parameters
    ----------
    problem : LineYieldOnset
        The problem that was solved.
    force_per_length, half_width : float
        [N/m], [m] when yielding begins.
    x, z : float
        Place of the onset [m] in the axes of the body, with the traction along x; negative z (also -0.0) in the second
        body.
    onsets : tuple of LinePartOnset
        The onset of yield of each part with a strength, in order from the uppermost layer of the first body down.
    """

    __words__ = words(
        x=("x", "m", "place along the surface"),
        onsets=("", None, "onset of yield of each body, layer and base"),
    )

    problem: LineYieldOnset
    force_per_length: float
    half_width: float
    x: float
    z: float
    onsets: tuple[LinePartOnset, ...]

    @property
    def validity(self) -> tuple[Note, ...]:
        """What is assumed."""
        rows = [(one.name, one.force_per_length) for one in self.onsets]
        bed = self.problem.bed
        slid = sliding_note(bed.medium, self.problem.friction.coefficient)  # type: ignore[arg-type]
        fading: list[str] = []
        if isinstance(bed, LayeredLineFoundation):
            length = bed.medium.response.length
            fading = [
                one.name
                for one in self.onsets
                if math.isfinite(one.half_width) and math.copysign(1.0, one.z) > 0.0 and blurred(length, one.half_width)
            ]
        return (*line_notes(bed, self.half_width), slid, onset_note(rows, "N/m", fading=fading))
