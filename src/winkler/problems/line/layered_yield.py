"""The half-width of a strip on layers at which a stress in them, or in a body beside them, reaches a strength."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.numerics.equations.highest import MOST_ROUNDS
from winkler.numerics.equations.roots import between, rough_root
from winkler.numerics.types import Array
from winkler.problems.line.greatest_stress import Placed
from winkler.problems.line.layered_stress import greatest_in_part
from winkler.problems.line.strip import Strip
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.values.errors import OutsideValidity

__all__ = ["at_strength_on_layers", "full_on_layers"]

MOST_STEPS = 60
NEAREST_END = 1e-3
"""How near to the end of the profile the strength is sought, over its reach."""
WIDEST_START = 100.0
"""Widest strip with which the search begins, over half of the thickness of the uppermost layer."""
OVERSHOT, LEAST_STEP, LONGEST_STEP = 1.2, 0.02, 2.0
"""Steps of the logarithm of the half-width, over that of the stress, while the strength is bracketed."""
COARSE, COARSE_TOLERANCE = 3, 1e-4
"""Rounds of the search while the half-width is sought, and to which part; two full secant steps follow."""


Share = Callable[[float, int], Placed]
"""Takes a half-width [m] and how often its search closes in; returns the greatest of a stress over the strength."""


def at_strength_on_layers(
    bed: LayeredLineFoundation, part: StrongPart, friction: float, name: str
) -> tuple[float, Placed]:
    """Return the half-width [m] at which a part begins to yield, and where; z < 0 in the second body.

    Parameters
    ----------
    bed : LayeredLineFoundation
        Without a sharp tip, kink or rim.
    part : StrongPart
    friction : float
        Traction over pressure [-].
    name : str
        Of the problem, for its refusals.
    """

    def share(half_width: float, rounds: int) -> Placed:
        place = greatest_in_part(bed, Strip(half_width, 0.0), part, friction, rounds)
        return place._replace(value=place.value / part.solid.strength)

    return full_on_layers(bed, share, (COARSE, MOST_ROUNDS), COARSE_TOLERANCE, name)


def full_on_layers(
    bed: LayeredLineFoundation, share: Share, refinements: tuple[int, int], tolerance: float, name: str
) -> tuple[float, Placed]:
    """Return the half-width [m] at which a share of a strength is one, and where.

    Parameters
    ----------
    bed : LayeredLineFoundation
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


def _start(bed: LayeredLineFoundation) -> float:
    """Return where the search begins, beside what is flat [m]; the same for all parts."""
    flat, end = bed.flat, min(bed.reach, bed.rim)
    if math.isfinite(end):
        return 0.01 * (end - flat)

    def mean(beside: Array) -> Array:
        return np.asarray(0.5 * bed.half_plane.load_profile(flat + beside) / (flat + beside))

    weakest = min(part.solid.strength for part in strong_parts(bed.medium))
    return min(rough_root(mean, weakest / bed.medium.modulus), WIDEST_START * bed.trial)


def _bracket(
    bed: LayeredLineFoundation, excess: Callable[[float], float], start: float, name: str
) -> tuple[float, float, float]:
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
