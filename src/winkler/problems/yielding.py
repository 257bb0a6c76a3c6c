"""Onset of yield: the load at which the largest von Mises stress below the contact reaches a body's strength."""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from winkler.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.foundation.bed import Bed, Pressed
from winkler.media.halfspace import HalfSpace
from winkler.media.peak import Place, greatest
from winkler.media.stress import von_mises
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.closure import at_end, flat_radius
from winkler.problems.disc import refuse_unless_disc
from winkler.validity import Assumption, Note, Standing
from winkler.values import value

__all__ = ["YieldOnset", "YieldOnsetSolution", "can_yield"]

STEPS = 40


def can_yield(bed: Bed) -> bool:
    """Return whether the question can be asked: isotropic bodies with a strength, and a smooth apex and edge."""
    return isinstance(bed.medium, HalfSpace) and min(bed.medium.strengths) < math.inf and not _singular(bed)


def _singular(bed: Bed) -> str:
    """Return why the stress is infinite from the first touch on, or nothing."""
    if any(strength != 0.0 for _, strength in bed.kinks):
        return "the slope of the profile jumps"
    if bed.rim < math.inf and float(bed.gap(np.array([bed.rim]))[0]) == 0.0:
        return "the rim is sharp"
    scale = min([b for b, _ in bed.kinks] + [x for x in (bed.reach, bed.size) if x < math.inf], default=1e-3)
    near, far = np.abs(bed.gap_slope(scale * np.array([1e-8, 1e-6])))
    return "the apex is pointed" if near > 0.95 * far > 0.0 else ""


@value
class YieldOnset:
    """At which load does the first of the bodies begin to yield?

    Parameters
    ----------
    bed : Bed
        Springs over a `HalfSpace` of which at least one body was given a strength.

    Raises
    ------
    InvalidInput
        If no body has a strength, or the medium is not isotropic.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, section 6.1, doi:10.1017/CBO9781139171731
    """

    bed: Bed

    references: ClassVar[tuple[str, ...]] = ("johnson_1985", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED
    needs_round: ClassVar[str] = "the stress below the surface"

    def __post_init__(self) -> None:
        if not isinstance(self.bed.medium, HalfSpace):
            raise InvalidInput(
                f"YieldOnset: the medium is a {type(self.bed.medium).__name__}; the onset of yield is looked for in "
                "homogeneous, isotropic bodies only: give a HalfSpace."
            )
        if min(self.bed.medium.strengths) == math.inf:
            raise InvalidInput("YieldOnset: no body has a strength; give Elastic(young, poisson, strength=...).")

    def solve(self) -> YieldOnsetSolution:
        """Return the load, and where yielding begins.

        Raises
        ------
        OutsideValidity
            If the body yields at the first touch (sharp apex, kink or rim), not within the profile's reach, or where
            the contact is no disc.
        NotConverged
            If the contact radius at the onset is not found.
        """
        why = _singular(self.bed)
        if why:
            raise OutsideValidity(
                f"YieldOnset: {why}, so the stress is infinite there and yielding begins at the first touch; give a "
                "rounded profile."
            )
        medium = self.bed.medium
        assert isinstance(medium, HalfSpace)
        onsets = [
            (*_onset(self.bed, below, strength), below)
            for below, strength in zip((True, False), medium.strengths, strict=True)
            if strength < math.inf
        ]
        radius, place, below = min(onsets, key=lambda onset: onset[0])
        at = np.array([radius])
        depth = float(self.bed.gap(at)[0])
        force = float((self.bed.stiffness(at) * depth - self.bed.gap_load(at))[0])
        if not self.bed.certain:
            refuse_unless_disc(self.bed, depth, radius, min(self.bed.reach, self.bed.rim))
        return YieldOnsetSolution(self, depth, force, radius, r=place.r, z=place.z if below else -place.z)


@value
class YieldOnsetSolution:
    """The answer to `YieldOnset`.

    Parameters
    ----------
    problem : YieldOnset
        What was asked.
    depth, force, radius : float
        [m], [N], [m] when yielding begins.
    r, z : float
        Where it begins [m]; z > 0 in the first body, z < 0 in the second.
    """

    problem: YieldOnset
    depth: float
    force: float
    radius: float
    r: float
    z: float

    @property
    def validity(self) -> tuple[Note, ...]:
        """What is assumed."""
        return (
            *self.problem.bed.notes,
            Note(
                Assumption.ELASTIC,
                Standing.EXACT,
                "Yielding begins where the von Mises stress of the elastic field first reaches the strength.",
                "R. von Mises, Nachr. Ges. Wiss. Goettingen (1913) 582",
            ),
        )


def _onset(bed: Bed, below: bool, strength: float) -> tuple[float, Place]:
    """Return the contact radius at which one body yields, and where."""
    end = min(bed.reach, bed.rim)

    def stress(a: float) -> Place:
        pressed = Pressed(bed, float(bed.gap(np.array([a]))[0]), a)

        def field(r: Array, z: Array) -> Array:
            state = bed.medium.interior(pressed, r, z, below=below)
            return von_mises(state.radial_stress, state.hoop_stress, state.axial_stress, state.shear_stress)

        return greatest(field, a)

    if math.isfinite(at_end(bed)[0]):
        place = stress(end)
        if place.value < strength:
            if bed.rim <= bed.reach:  # the rim is reached first, and there the stress is infinite
                return end, Place(math.inf, end, 0.0)
            raise OutsideValidity(
                f"YieldOnset: within the profile's reach ({end:.6g} m) the largest von Mises stress stays below "
                f"{strength:.6g} Pa; the body does not yield before the profile ends."
            )
    flat = flat_radius(bed)
    low, high = flat, end
    a = 0.5 * end if math.isfinite(end) else (2.0 * flat or 1e-3 * min(bed.size, 1.0))
    last: tuple[float, float] | None = None
    for _ in range(STEPS):
        place = stress(a)
        miss = math.log(place.value / strength)
        if abs(miss) < 1e-10:
            return a, place
        low, high = (a, high) if miss < 0.0 else (low, a)
        # secant in logarithms: exact for power laws, whose stress is a power of the radius
        power = 1.0 if last is None else (miss - last[1]) / (math.log(a - flat) - last[0])
        last = (math.log(a - flat), miss)
        new = flat + (a - flat) * math.exp(max(-20.0, min(20.0, -miss / power))) if power > 0.0 else math.nan
        if not low < new < high:
            new = 0.5 * (low + high) if math.isfinite(high) else 2.0 * a
        if abs(new - a) <= 1e-14 * a:
            return a, place
        a = new
    raise NotConverged(f"YieldOnset: the radius at which yielding begins was not found in {STEPS} steps.")
