"""Onset of yield: the load at which the largest von Mises stress below the contact reaches a body's strength."""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from winkler.errors import InvalidInput, OutsideValidity
from winkler.foundation.bed import Bed
from winkler.laws.friction import Coulomb, Overcome
from winkler.media.halfspace import HalfSpace
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.stacked.stacked import SlidingStack
from winkler.problems.assumptions.coupling import sliding_note
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.normal.greatest_stress import GreatestStress
from winkler.problems.normal.onset.search import greatest_in, onset_in, weakest_first
from winkler.problems.normal.single_contact import refuse_unless_disc
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.validity import Assumption, Note, Standing
from winkler.values import value, words

__all__ = ["YieldOnset", "YieldOnsetSolution", "part_that_yields"]

FRICTIONLESS = Coulomb(0.0)


@value
class YieldOnset:
    r"""At which load does the first of the bodies begin to yield, pressed or while it slides?

    A contact that slides carries the traction :math:`\mu p` of Coulomb's law; the pressure is taken to be that without
    friction, as usual: what the traction adds to it is left out (`validity` says of which order that is).

    Parameters
    ----------
    bed : Bed
        Springs over a `HalfSpace`, a `CoatedHalfSpace`, a `SlidingFilm` or a `StackedHalfSpace` of which at least one
        isotropic body, layer or base was given a strength.
    friction : Coulomb, optional
        The contact slides everywhere, and drags each body by mu p; none unless given.

    Raises
    ------
    InvalidInput
        If no part has a strength, or the medium is another one.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, section 6.1, doi:10.1017/CBO9781139171731;
    G. M. Hamilton, Proc. Inst. Mech. Eng. C 197 (1983) 53-59, doi:10.1243/PIME_PROC_1983_197_076_02 (sliding).
    """

    __words__ = words(friction=("", None, "law of friction of a contact that slides everywhere"))

    bed: Bed
    friction: Overcome = FRICTIONLESS

    references: ClassVar[tuple[str, ...]] = ("johnson_1985", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED | {Assumption.UNCOUPLED}

    def __post_init__(self) -> None:
        if not isinstance(self.bed.medium, HalfSpace | CoatedHalfSpace | SlidingStack):
            raise InvalidInput(
                f"YieldOnset: the medium is a {type(self.bed.medium).__name__}; the onset of yield is sought in "
                "isotropic bodies and layers only (a transversely isotropic body has no single strength, the strength "
                "of a graded one is a profile that no single number states): give a HalfSpace, or a CoatedHalfSpace "
                "whose layers have a strength each."
            )
        if not strong_parts(self.bed.medium):
            raise InvalidInput("YieldOnset: no body has a strength; give Elastic(young, poisson, strength=...).")

    def solve(self) -> YieldOnsetSolution:
        """Return the load, and where yielding begins.

        Raises
        ------
        OutsideValidity
            If the body yields at the first touch (a sharp apex, edge or rim), never, not within the profile's reach,
            or where the contact is no disc; under the edge of an incompressible truncated body; on layers, if the
            contact would be ten times as wide as the uppermost layer is thick.
        NotConverged
            If the contact radius at the onset is not found.
        """
        mu = self.friction.coefficient
        onsets: list[tuple[float, GreatestStress, StrongPart]] = []
        missed = []
        for part in weakest_first(self.bed, mu):
            if onsets:
                narrowest = min(onsets, key=_radius)[0]
                if greatest_in(self.bed, part, narrowest, True, mu).value < part.solid.strength:
                    continue  # still elastic where another part yields
            onset = onset_in(self.bed, part, mu)
            if isinstance(onset, str):
                missed.append(onset)
            else:
                onsets.append((*onset, part))
        if not onsets:
            raise OutsideValidity(missed[0])
        radius, place, part = min(onsets, key=_radius)
        at = np.array([radius])
        depth = float(self.bed.gap(at)[0])
        force = float((self.bed.stiffness(at) * depth - self.bed.gap_load(at))[0])
        if not self.bed.certain:
            refuse_unless_disc(self.bed, depth, radius, min(self.bed.reach, self.bed.rim))
        z = place.z if part.first else -place.z
        return YieldOnsetSolution(self, depth, force, radius, r=abs(place.x), z=z, x=place.x)


@value
class YieldOnsetSolution:
    """The solution of `YieldOnset`.

    Parameters
    ----------
    problem : YieldOnset
        The problem that was solved.
    depth, force, radius : float
        [m], [N], [m] when yielding begins.
    r, z : float
        Distance from the axis and depth [m] where it begins; z > 0 in the first body, z < 0 in the second, on whose
        surface it is -0.0.
    x : float
        The same distance in the direction in which the surface of that body is dragged [m]: negative behind the middle.
        Without friction it is `r`.
    """

    __words__ = words(x=("x", "m", "place in the direction in which the surface is dragged"))

    problem: YieldOnset
    depth: float
    force: float
    radius: float
    r: float
    z: float
    x: float

    @property
    def validity(self) -> tuple[Note, ...]:
        """What is assumed."""
        return (
            *self.problem.bed.notes,
            sliding_note(self.problem.bed.medium, self.problem.friction.coefficient),
            Note(
                Assumption.ELASTIC,
                Standing.EXACT,
                f"Yielding begins in the {part_that_yields(self).name}, where the von Mises stress of the elastic "
                "field first reaches its strength.",
                "R. von Mises, Nachr. Ges. Wiss. Goettingen (1913) 582",
            ),
        )


def _radius(onset: tuple[float, GreatestStress, StrongPart]) -> float:
    return onset[0]


def part_that_yields(solution: YieldOnsetSolution) -> StrongPart:
    """Return the body, layer or base that yields first."""
    first = math.copysign(1.0, solution.z) > 0.0  # on the surface of the second body z is -0.0
    parts = [part for part in strong_parts(solution.problem.bed.medium) if part.first == first]
    depth = abs(solution.z)
    return min(parts, key=lambda part: max(part.top - depth, depth - part.bottom, 0.0))
