"""The range of contact radii over which the response of a contact to its machine is tabulated."""

from __future__ import annotations

import math

import numpy as np

from winkler.fitting.elastic.panels import Pair
from winkler.foundation.bed import Bed
from winkler.media.body_of import thickness_of
from winkler.numerics.equations.roots import rough_root
from winkler.numerics.types import Array
from winkler.problems.adhesion.edge_states import EdgeStates, force_under
from winkler.problems.adhesion.stability import least_radius
from winkler.problems.normal.length_scale import own_length
from winkler.problems.normal.solve_contact import end_of, flat_radius
from winkler.values.errors import NotConverged, OutsideValidity

MOST_DOUBLINGS = 400
MOST_BISECTIONS = 50
FEWEST_BISECTIONS = 2
"""Fewest bisections of the range beyond the requested position."""
SINGLE_RADIUS, GROWING_RADII, SHRINKING_RADII = np.ones(1), 2.0 ** np.arange(8), 0.5 ** np.arange(8)


def machine_curves(states: EdgeStates, compliance: float) -> Pair:
    """Return D [m] and F [N] as functions of the contact radius."""

    def curves(radius: Array) -> tuple[Array, Array]:
        depth = states.depth(radius)
        force = force_under(states, depth, radius)
        return depth + compliance * force, force

    return curves


def radius_range(states: EdgeStates, compliance: float, highest: float) -> tuple[float, float]:
    """Return the least radius of stable states, and one not far above that at which D passes `highest` [m]."""
    low = max(least_radius(states), flat_radius(states.bed) if states.from_nothing() else 0.0)
    return low, _last_radius(states, compliance, highest, low)


def kinks_between(bed: Bed, low: float, high: float) -> Array:
    """Return the radii between two others at which the bed is not smooth [m]."""
    return np.array([b for b, _ in bed.kinks if low <= b < high])


def _last_radius(states: EdgeStates, compliance: float, highest: float, low: float) -> float:
    """Return a radius not far above the one at which D passes `highest`, or the end of the profile."""
    bed = states.bed
    end = end_of(bed)
    if low >= end:
        return end

    curves = machine_curves(states, compliance)
    levels_by_radius: dict[float, float] = {}

    def level(radius: float, ahead: Array) -> float:
        """Return D at a radius; values that may be needed next are computed with it."""
        if radius not in levels_by_radius:
            places = np.minimum(radius * ahead, end)
            levels_by_radius.update(zip(places.tolist(), _levels(curves, places).tolist(), strict=True))
        return levels_by_radius[radius]

    length = own_length(bed)
    high = max(length if math.isfinite(length) else rough_root(bed.gap, highest), 2.0 * low)
    # on layers contacts far wider than needed are expensive
    upwards = GROWING_RADII if math.isinf(thickness_of(bed.medium)) else SINGLE_RADIUS
    below, narrowest = low, 2.0**-100 * high
    if high < end and not level(high, upwards) <= highest:
        while high > 4.0 * low and high > narrowest and not level(0.5 * high, SHRINKING_RADII) <= highest:
            high *= 0.5
        below = 0.5 * high
    else:
        for _ in range(MOST_DOUBLINGS):
            below, high = min(high, end), min(2.0 * high, end)
            if high == end or not level(high, upwards) <= highest:
                break
        else:
            raise OutsideValidity(
                f"The contact closes without end before the position {highest:.4g} m is reached; give a profile that "
                "rises."
            )
    if level(high, SINGLE_RADIUS) <= highest:
        return high
    for sweep in range(MOST_BISECTIONS):
        if sweep >= FEWEST_BISECTIONS and np.isfinite(level(high, SINGLE_RADIUS)):
            break
        middle = 0.5 * (below + high)
        below, high = (middle, high) if level(middle, SINGLE_RADIUS) <= highest else (below, middle)
    with np.errstate(divide="ignore"):
        walled = high == end and np.isinf(bed.gap(np.array([end]))[0])
    return below if walled else high  # no float below a vertical wall is as deep: the contact is pinned there


def _levels(curves: Pair, radii: Array) -> Array:
    """Return D [m], nan where the theory does not reach."""
    try:
        with np.errstate(all="ignore"):
            return curves(radii)[0]
    except (NotConverged, OutsideValidity):  # a cohesive zone beyond the profile, or its end on layers
        if radii.size == 1:
            return np.array([np.nan])
        return np.concatenate([_levels(curves, radii[i : i + 1]) for i in range(radii.size)])
