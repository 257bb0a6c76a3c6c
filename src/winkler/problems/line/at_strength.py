"""The half-width of a line contact at which a stress below it reaches a given strength."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.line_bed import LineBed
from winkler.media.halfspace import HalfSpace
from winkler.media.offers import PlaneMedium, offers
from winkler.numerics.equations.highest import MOST_ROUNDS
from winkler.numerics.equations.roots import between, rough_root
from winkler.numerics.types import Array
from winkler.problems.line.greatest_stress import Measure, Placed, von_mises
from winkler.problems.line.layered_stress import greatest_in_part
from winkler.problems.line.stress import Strip
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.values.errors import InvalidInput, OutsideValidity

MOST_STEPS = 60
NEAREST_END = 1e-3
"""How near to the end of the profile the strength is sought, over its reach."""
WIDEST_START = 100.0
"""Widest strip with which the search begins, over half of the thickness of the uppermost layer."""
OVERSHOT, LEAST_STEP, LONGEST_STEP = 1.2, 0.02, 2.0
"""Steps of the logarithm of the half-width, over that of the stress, while the strength is bracketed."""
COARSE, COARSE_TOLERANCE = 3, 1e-4
"""Rounds of the search while the half-width is sought, and to which part; two full secant steps follow."""
FINE_TOLERANCE = 1e-13
"""To which part it is sought on half-planes, where no search is coarse."""


Share = Callable[[float, int], Placed]
"""Takes a half-width [m] and how often its search closes in; returns the greatest of a stress over the strength."""


def refuse_without_strength(bed: LineFoundation | LayeredLineFoundation, name: str) -> None:
    """Refuse bodies that are not isotropic, or of which none has a strength."""
    layered = isinstance(bed, LayeredLineFoundation)
    if not layered and not isinstance(bed.medium, HalfSpace):
        raise InvalidInput(
            f"{name}: the medium is a {type(bed.medium).__name__}; stresses are compared with a strength in "
            "homogeneous, isotropic bodies only. Other bodies have no single strength. Give a HalfSpace."
        )
    if not strong_parts(bed.medium):
        which = "layer or body" if layered else "body"
        raise InvalidInput(f"{name}: no {which} has a strength; give Elastic(young, poisson, strength=...).")


def refuse_sharp(bed: LineBed, name: str) -> None:
    """Refuse profiles under which the stress is infinite."""
    sharp = float(bed.slope(np.zeros(1))[0]) != 0.0 or any(strength > 0.0 for _, strength in bed.kinks)
    if sharp or (math.isfinite(bed.rim) and bed.flat >= bed.rim):
        raise OutsideValidity(
            f"{name}: the stress at a sharp tip, kink or rim is infinite under every load, so that yielding begins at "
            "the first touch; round it off."
        )


def at_strength(
    bed: LineBed, part: StrongPart, friction: float, name: str, measure: Measure = von_mises
) -> tuple[float, Placed]:
    """Return the half-width [m] at which a part begins to yield, and where; z < 0 in the second body.

    Parameters
    ----------
    bed : LineBed
        Without a sharp tip, kink or rim.
    part : StrongPart
    friction : float
        Traction over pressure [-].
    name : str
        Of the problem, for its refusals.
    measure
        Takes the fields, returns what is compared with the strength [Pa].
    """

    def share(half_width: float, rounds: int = MOST_ROUNDS) -> Placed:
        place = greatest_in_part(bed, Strip(half_width, 0.0), part, friction, rounds, measure)
        return place._replace(value=place.value / part.solid.strength)

    if bed.hertzian:  # all stresses grow in proportion to a
        start = bed.hertz_radius * part.solid.strength / bed.medium.modulus
        a = start / share(start).value
        return a, share(a)
    if offers(bed.medium, PlaneMedium):
        return full_strength(bed, share, (COARSE, MOST_ROUNDS), COARSE_TOLERANCE, name)
    return full_strength(bed, share, (MOST_ROUNDS, MOST_ROUNDS), FINE_TOLERANCE, name)


def full_strength(
    bed: LineBed, share: Share, refinements: tuple[int, int], tolerance: float, name: str
) -> tuple[float, Placed]:
    """Return the half-width [m] at which a share of a strength is one, and where.

    Parameters
    ----------
    bed : LineBed
        Without a sharp tip, kink or rim.
    share
        See `Share`.
    refinements : tuple of int
        While the half-width is sought, and of the last steps.
    tolerance : float
        Of the half-width while it is sought, relative.
    name : str
        Of the problem, for its refusals.
    """
    few, many = refinements

    @functools.cache
    def excess(logarithm: float, count: int = few) -> float:
        return math.log(share(bed.flat + math.exp(logarithm), count).value)

    low, high, slope = _bracket(bed, excess, _start(bed), name)
    coarse = between(excess, low, high, absolute=tolerance)
    first = excess(coarse, many)
    near = coarse - first / slope
    second = excess(near, many)
    if second != first:
        near -= second * (near - coarse) / (second - first)
    a = bed.flat + math.exp(near)
    return a, share(a, many)


def _start(bed: LineBed) -> float:
    """Return where the search begins, beside what is flat [m]; the same for all parts."""
    flat, end = bed.flat, min(bed.reach, bed.rim)
    if math.isfinite(end):
        return 0.01 * (end - flat)

    def mean(beside: Array) -> Array:
        return np.asarray(0.5 * bed.half_plane.load_profile(flat + beside) / (flat + beside))

    weakest = min(part.solid.strength for part in strong_parts(bed.medium))
    return min(rough_root(mean, weakest / bed.medium.modulus), WIDEST_START * bed.trial)


def _bracket(bed: LineBed, excess: Callable[[float], float], start: float, name: str) -> tuple[float, float, float]:
    """Return logarithms of lengths [m] beside what is flat, between which the strength is reached, and the slope."""
    width = min(bed.reach, bed.rim) - bed.flat
    here, level = math.log(start), excess(math.log(start))
    for _ in range(MOST_STEPS):
        step = min(OVERSHOT * abs(level) + LEAST_STEP, LONGEST_STEP)
        there = here + (step if level < 0.0 else -step)
        if level < 0.0 and math.isfinite(width):
            if math.exp(here) >= (1.0 - NEAREST_END) * width:
                break
            there = min(there, math.log(0.5 * (math.exp(here) + width)))  # at the end itself it may be upright
        beyond = excess(there)
        if (beyond < 0.0) != (level < 0.0):
            return min(here, there), max(here, there), (beyond - level) / (there - here)
        here, level = there, beyond
    raise OutsideValidity(
        f"{name}: within the reach of the profile ({bed.flat + width:.6g} m) the strength is not reached; give a "
        "lower strength or a profile that is known farther."
    )
