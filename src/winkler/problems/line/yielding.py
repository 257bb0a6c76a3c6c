r"""Onset of yield below a line contact, at rest or sliding: the force per length that brings a body to its strength.

For a cylinder all stresses grow with :math:`\sqrt P`; for other profiles the half-width is sought at which the greatest
stress of `winkler.problems.line.stress` is the strength of a body.
"""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from winkler.errors import InvalidInput, OutsideValidity
from winkler.foundation.line import LineFoundation
from winkler.laws.friction import Coulomb, Overcome
from winkler.media.halfspace import HalfSpace
from winkler.numerics.equations.roots import between
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.line.half_width import refuse_unless_strips
from winkler.problems.line.stress import LineContact, Placed, greatest
from winkler.problems.line.validity import line_notes
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.profiles.power import Paraboloid
from winkler.validity import Assumption, Note, Standing
from winkler.values import value, words

__all__ = ["LineYieldOnset", "LineYieldOnsetSolution"]

MOST_DOUBLINGS = 60
FRICTIONLESS = Coulomb(0.0)


@value
class LineYieldOnset:
    """Under which force per length does a line contact begin to yield, at rest or while it slides?

    Parameters
    ----------
    bed : LineFoundation
        Profile and bodies, on a `HalfSpace` of which at least one body was given a strength.
    friction : Coulomb, optional
        The contact slides everywhere, and drags each body by mu p; none unless given.

    Raises
    ------
    InvalidInput
        If no body has a strength, or the medium is not isotropic.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 6.1 and 7.1, doi:10.1017/CBO9781139171731
    """

    __words__ = words(bed=("", None, "profile and bodies of the line contact"))

    bed: LineFoundation
    friction: Overcome = FRICTIONLESS

    references: ClassVar[tuple[str, ...]] = ("johnson_1985",)
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED

    def __post_init__(self) -> None:
        if not isinstance(self.bed.medium, HalfSpace):
            raise InvalidInput(
                f"LineYieldOnset: the medium is a {type(self.bed.medium).__name__}; the onset of yield is sought in "
                "homogeneous, isotropic bodies only: give a HalfSpace."
            )
        if min(self.bed.medium.strengths) == math.inf:
            raise InvalidInput("LineYieldOnset: no body has a strength; give Elastic(young, poisson, strength=...).")

    def solve(self) -> LineYieldOnsetSolution:
        """Return the load, and where yielding begins.

        Raises
        ------
        OutsideValidity
            If the body yields at the first touch (a sharp tip, kink or rim), or not within the reach of the profile.
        """
        bed = self.bed
        sharp = float(bed.slope(np.zeros(1))[0]) != 0.0 or any(strength > 0.0 for _, strength in bed.kinks)
        if sharp or (math.isfinite(bed.rim) and bed.flat >= bed.rim):
            raise OutsideValidity(
                "LineYieldOnset: the stress at a sharp tip, kink or rim is infinite under every load, so that yielding "
                "begins at the first touch; round it off."
            )
        found = [(*self._onset(part), part.first) for part in strong_parts(bed.medium)]
        a, place, first = min(found, key=lambda onset: onset[0])
        refuse_unless_strips(bed, np.array([a]))
        force = bed.medium.modulus * float(bed.load_profile(np.array([a]))[0])
        return LineYieldOnsetSolution(self, force, a, place.x, place.z if first else -place.z)

    def _onset(self, part: StrongPart) -> tuple[float, Placed]:
        """Return the half-width at which one body yields, and where."""
        bed, strength = self.bed, part.solid.strength
        flat, end = bed.flat, min(bed.reach, bed.rim)

        def peak(beside: float) -> Placed:
            contact = LineContact(bed, flat + beside, 0.0, part.solid.poisson, self.friction.coefficient)
            return greatest(contact, lambda fields: fields.von_mises)

        low = high = 0.01 * (end - flat if math.isfinite(end) else flat or bed.size if bed.size < math.inf else 1.0)
        if isinstance(bed.profile, Paraboloid):  # all stresses grow in proportion to a
            low *= strength / peak(low).value
            return low, peak(low)
        for _ in range(MOST_DOUBLINGS):
            if peak(low).value < strength:
                break
            low *= 0.25
        for _ in range(MOST_DOUBLINGS):
            if peak(high).value >= strength:
                break
            if flat + high >= end:
                raise OutsideValidity(
                    f"LineYieldOnset: within the reach of the profile ({end:.6g} m) the body does not yield; give a "
                    "lower strength or a profile that is known farther."
                )
            high = min(4.0 * high, end - flat)
        beside = math.exp(
            between(lambda t: math.log(peak(math.exp(t)).value / strength), math.log(low), math.log(high))
        )
        return flat + beside, peak(beside)


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
        Where it begins [m], in the axes of the body, which is dragged along x; z < 0 in the second one.
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
        return (*line_notes(self.problem.bed, self.half_width), criterion)
