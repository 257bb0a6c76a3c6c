"""The half-width of a line contact at which a stress below it reaches a given strength."""

from __future__ import annotations

import math

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.line_bed import LineBed
from winkler.media.halfspace import HalfSpace
from winkler.numerics.equations.roots import between, rough_root
from winkler.numerics.types import Array
from winkler.problems.line.greatest_stress import Measure, Placed, greatest
from winkler.problems.line.half_width import refuse_unless_strips
from winkler.problems.line.stress import LineContact
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.values.errors import InvalidInput, OutsideValidity

__all__ = ["at_strength", "first_at_strength", "refuse_sharp", "refuse_without_strength"]

MOST_STEPS = 60
FACTOR = 4.0
NEAREST_END = 1e-3
"""How near to the end of the profile the strength is sought, over its reach."""


def refuse_without_strength(bed: LineFoundation | LayeredLineFoundation, name: str) -> None:
    """Refuse bodies that are not isotropic, or of which none has a strength."""
    if isinstance(bed, LayeredLineFoundation):
        if not strong_parts(bed.medium):
            raise InvalidInput(f"{name}: no layer or body has a strength; give Elastic(young, poisson, strength=...).")
        return
    if not isinstance(bed.medium, HalfSpace):
        raise InvalidInput(
            f"{name}: the medium is a {type(bed.medium).__name__}; stresses are compared with a strength in "
            "homogeneous, isotropic bodies only. Other bodies have no single strength. Give a HalfSpace."
        )
    if min(bed.medium.strengths) == math.inf:
        raise InvalidInput(f"{name}: no body has a strength; give Elastic(young, poisson, strength=...).")


def refuse_sharp(bed: LineBed, name: str) -> None:
    """Refuse profiles under which the stress is infinite."""
    sharp = float(bed.slope(np.zeros(1))[0]) != 0.0 or any(strength > 0.0 for _, strength in bed.kinks)
    if sharp or (math.isfinite(bed.rim) and bed.flat >= bed.rim):
        raise OutsideValidity(
            f"{name}: the stress at a sharp tip, kink or rim is infinite under every load, so that yielding begins at "
            "the first touch; round it off."
        )


def first_at_strength(bed: LineFoundation, friction: float, measure: Measure, name: str) -> tuple[float, Placed]:
    """Return the half-width [m] at which the first body reaches its strength, and where; z < 0 in the second body.

    Parameters
    ----------
    bed : LineFoundation
    friction : float
        Traction over pressure [-].
    measure
        Takes the fields, returns what is compared with the strength [Pa].
    name : str
        Of the problem, for its refusals.
    """
    refuse_sharp(bed, name)
    found = [at_strength(bed, part, friction, measure, name) for part in strong_parts(bed.medium)]
    first = min(found, key=lambda onset: onset[0])
    refuse_unless_strips(bed, np.array([first[0]]))
    return first


def at_strength(
    bed: LineFoundation, part: StrongPart, friction: float, measure: Measure, name: str
) -> tuple[float, Placed]:
    """Return the half-width [m] at which one body reaches its strength, as `first_at_strength`."""
    contact = LineContact(bed, 0.0, 0.0, part.solid.poisson, friction)
    a, place = _half_width(contact, measure, part.solid.strength, name)
    return a, place if part.first else place._replace(z=-place.z)


def _half_width(contact: LineContact, measure: Measure, strength: float, name: str) -> tuple[float, Placed]:
    bed = contact.bed
    flat, end = bed.flat, min(bed.reach, bed.rim)

    def peak(beside: float) -> Placed:
        return greatest(contact._replace(half_width=flat + beside), measure)

    def mean(beside: Array) -> Array:
        return np.asarray(0.5 * bed.load_profile(flat + beside) / (flat + beside))

    if bed.hertzian:  # all stresses grow in proportion to a
        start = bed.hertz_radius * strength / bed.medium.modulus
        a = start * strength / peak(start).value
        return a, peak(a)
    if math.isfinite(end):
        low = high = 0.01 * (end - flat)
    else:
        low = high = rough_root(mean, strength / bed.medium.modulus)
    for _ in range(MOST_STEPS):
        if peak(low).value < strength:
            break
        low /= FACTOR
    for _ in range(MOST_STEPS):
        if peak(high).value >= strength:
            break
        if flat + high >= (1.0 - NEAREST_END) * end:
            raise OutsideValidity(
                f"{name}: within the reach of the profile ({end:.6g} m) the strength is not reached; give a lower "
                "strength or a profile that is known farther."
            )
        high = min(FACTOR * high, 0.5 * (high + end - flat))  # at the end itself the profile may be upright

    def excess(logarithm: float) -> float:
        return math.log(peak(math.exp(logarithm)).value / strength)

    beside = math.exp(between(excess, math.log(low), math.log(high), relative=1e-13))
    return flat + beside, peak(beside)
