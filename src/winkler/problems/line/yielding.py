r"""Onset of yield below a line contact, at rest or sliding: the force per length that brings a body to its strength.

For a cylinder all stresses grow with :math:`\sqrt P`; for other profiles the half-width is sought at which the greatest
stress of `winkler.problems.line.stress` is the strength of a body.
"""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.laws.friction import Coulomb, Overcome
from winkler.problems.assumptions.coupling import sliding_note
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.line.at_strength import first_at_strength, refuse_sharp, refuse_without_strength
from winkler.problems.line.greatest_stress import von_mises
from winkler.problems.line.layered_notes import strip_notes
from winkler.problems.line.layered_stress import refuse_friction
from winkler.problems.line.layered_yield import first_on_layers
from winkler.problems.line.validity import line_notes
from winkler.validity import Assumption, Note, Standing
from winkler.values import value, words

__all__ = ["FRICTIONLESS", "LineYieldOnset", "LineYieldOnsetSolution"]

FRICTIONLESS = Coulomb(0.0)


@value
class LineYieldOnset:
    """Under which force per length does a line contact begin to yield, at rest or while it slides?

    Parameters
    ----------
    bed : LineFoundation or LayeredLineFoundation
        Profile and bodies, on a `HalfSpace` or on bonded layers, of which at least one part was given a strength.
    friction : Coulomb, optional
        The contact slides everywhere, and drags each body by mu p; none unless given, and none on layers.

    Raises
    ------
    InvalidInput
        If no body has a strength, or the medium is not isotropic.
    OutsideValidity
        If there is friction on layers.

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
        if isinstance(self.bed, LayeredLineFoundation):
            refuse_friction(self.friction.coefficient)

    def solve(self) -> LineYieldOnsetSolution:
        """Return the load, and where yielding begins.

        Raises
        ------
        OutsideValidity
            If the body yields at the first touch (a sharp tip, kink or rim), or not within the reach of the profile.
        """
        bed = self.bed
        if isinstance(bed, LayeredLineFoundation):
            refuse_sharp(bed, "LineYieldOnset")
            a, place = first_on_layers(bed, "LineYieldOnset")
        else:
            a, place = first_at_strength(bed, self.friction.coefficient, von_mises, "LineYieldOnset")
        force = bed.medium.modulus * float(bed.load_profile(np.array([a]))[0])
        return LineYieldOnsetSolution(self, force, a, place.x, place.z)


@value
class LineYieldOnsetSolution:
    """The solution of `LineYieldOnset`.

    Parameters
    ----------
    problem : LineYieldOnset
        The problem that was solved.
    force_per_length, half_width : float
        [N/m], [m] when yielding begins.
    x, z : float
        Where it begins [m], in the axes of the body, which is dragged along x; below zero (also -0.0) in the second
        one.
    """

    __words__ = words(x=("x", "m", "place along the surface"))

    problem: LineYieldOnset
    force_per_length: float
    half_width: float
    x: float
    z: float

    @property
    def mean_pressure(self) -> float:
        """P / (2 a) [Pa]."""
        return 0.5 * self.force_per_length / self.half_width

    @property
    def validity(self) -> tuple[Note, ...]:
        """What is assumed."""
        criterion = Note(
            Assumption.ELASTIC,
            Standing.EXACT,
            "Yielding begins where the von Mises stress of the elastic field in plane strain reaches the strength.",
            "R. von Mises, Nachr. Ges. Wiss. Goettingen (1913) 582",
        )
        bed = self.problem.bed
        if isinstance(bed, LayeredLineFoundation):
            return (*strip_notes(bed, self.half_width, 0.0), criterion)
        slid = sliding_note(bed.medium, self.problem.friction.coefficient)  # type: ignore[arg-type]
        return (*line_notes(bed, self.half_width), slid, criterion)
