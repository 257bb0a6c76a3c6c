"""Onset of yield: the load at which the largest von Mises stress below the contact reaches a body's strength."""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.friction import Coulomb, Overcome
from winkler.media.halfspace import HalfSpace
from winkler.media.layered.hankel_waves import blurred
from winkler.media.offers import LayerStack, PressedWaves, offers
from winkler.problems.assumptions.coupling import sliding_note
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.normal.onset.part_onset import PartOnset, onset_note
from winkler.problems.normal.onset.search import greatest_in, onset_in
from winkler.problems.normal.single_contact import refuse_unless_disc
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

FRICTIONLESS = Coulomb(0.0)


@value
class YieldOnset:
    r"""The load at which each body begins to yield, with or without sliding, and which body is the first.

    A sliding contact carries the traction :math:`\mu p` of Coulomb's law. The pressure is assumed to be that without
    friction. `validity` states the order of magnitude of this error.

    Parameters
    ----------
    bed : Bed
        Springs over a `HalfSpace`, a `CoatedHalfSpace`, a `SlidingFilm` or a `StackedHalfSpace`; at least one isotropic
        body, layer or base has a strength.
    friction : Coulomb, optional
        Coulomb's law of a contact that slides everywhere, with the traction mu p on each body; no friction by default.

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
    needs_round: ClassVar[str] = ""

    def __post_init__(self) -> None:
        if not (isinstance(self.bed.medium, HalfSpace) or offers(self.bed.medium, LayerStack)):
            raise InvalidInput(
                f"YieldOnset: the medium is a {type(self.bed.medium).__name__}; the onset of yield is implemented "
                "for isotropic bodies and layers only. A transversely isotropic body has no single strength, and "
                "the strength of a graded body varies with depth. Give a HalfSpace, or a CoatedHalfSpace in "
                "which each layer has a strength."
            )
        if not strong_parts(self.bed.medium):
            raise InvalidInput("YieldOnset: no body has a strength; give Elastic(young, poisson, strength=...).")

    def solve(self) -> YieldOnsetSolution:
        """Return the load at the onset of yield, and the position of the onset.

        Raises
        ------
        OutsideValidity
            If the body yields at first touch (a sharp apex, edge or rim), or not within the reach of the profile. If
            the contact is not a disc, or under the edge of an incompressible truncated body. On layers, if the contact
            would be thousands of times wider than the uppermost layer is thick.
        NotConverged
            If the contact radius at the onset is not found.
        """
        parts, rows = strong_parts(self.bed.medium), []
        failures: dict[StrongPart, OutsideValidity | NotConverged] = {}
        for number, part in enumerate(parts, 1):
            try:
                rows.append(onset_of_part(self, number, part))
            except (OutsideValidity, NotConverged) as error:
                failures[part] = error
                never, nowhere = math.inf, math.nan
                rows.append(PartOnset(number, part.name, never, never, never, nowhere, nowhere, str(error)))
        first = min(rows, key=lambda row: row.radius)
        if math.isinf(first.radius):
            raise failures[parts[0]]
        for part, failure in failures.items():  # is it elastic where another part yields?
            greatest = greatest_in(self.bed, part, first.radius, True, self.friction.coefficient)
            if greatest.sharp or greatest.value >= part.solid.strength:
                raise failure
        return YieldOnsetSolution(
            self, first.depth, first.force, first.radius, abs(first.x), first.z, first.x, tuple(rows)
        )


def onset_of_part(problem: YieldOnset, number: int, part: StrongPart) -> PartOnset:
    """Return the onset of one part of the bodies of a problem, the first of which has the number 1.

    Raises
    ------
    OutsideValidity, NotConverged
        As in `YieldOnset.solve`.
    """
    bed = problem.bed
    found = onset_in(bed, part, problem.friction.coefficient)
    if isinstance(found, str):
        raise OutsideValidity(found)
    radius, place = found
    at = np.array([radius])
    depth = float(bed.gap(at)[0])
    if not bed.certain:
        refuse_unless_disc(bed, depth, radius, min(bed.reach, bed.rim))
    force = float((bed.stiffness(at) * depth - bed.gap_load(at))[0])
    return PartOnset(number, part.name, force, radius, depth, place.x, place.z if part.first else -place.z)


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
        Distance from the axis and depth [m] of the onset; z > 0 in the first body, z < 0 in the second, whose surface
        is -0.0.
    x : float
        The same distance along the direction of the traction on that body [m], negative behind the middle. Without
        friction it is `r`.
    onsets : tuple of PartOnset
        The onset of yield of each part with a strength, in order from the uppermost layer of the first body down.
    """

    __words__ = words(
        x=("x", "m", "position along the direction of the traction"),
        onsets=("", None, "onset of yield of each body, layer and base"),
    )

    problem: YieldOnset
    depth: float
    force: float
    radius: float
    r: float
    z: float
    x: float
    onsets: tuple[PartOnset, ...]

    @property
    def validity(self) -> tuple[Note, ...]:
        """What is assumed."""
        medium = self.problem.bed.medium
        length = medium.response.length if offers(medium, PressedWaves) else math.inf
        fading = [
            one.name
            for one in self.onsets
            if math.isfinite(one.radius) and math.copysign(1.0, one.z) > 0.0 and blurred(length, one.radius)
        ]
        return (
            *self.problem.bed.notes,
            sliding_note(medium, self.problem.friction.coefficient),
            onset_note([(one.name, one.force) for one in self.onsets], "N", fading=fading),
        )


def part_that_yields(solution: YieldOnsetSolution) -> StrongPart:
    """Return the body, layer or base that yields first."""
    first = min(solution.onsets, key=lambda onset: onset.radius)
    return strong_parts(solution.problem.bed.medium)[first.part - 1]
