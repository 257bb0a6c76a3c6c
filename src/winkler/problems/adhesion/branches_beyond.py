r"""Stable branches of an adhesive contact up to a prescribed level, however far the radius has to go."""

from __future__ import annotations

import math
from typing import Protocol, runtime_checkable

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.foundation import Foundation
from winkler.media.offers import PressedWaves, offers
from winkler.numerics.types import Array
from winkler.problems.adhesion.edge_states import EdgeStates, ShortStates, margin, position
from winkler.problems.adhesion.stability import (
    OCTAVES_PER_BLOCK,
    OCTAVES_SEARCHED,
    SAMPLES_PER_OCTAVE,
    Branch,
    branches,
    least_radius,
    typical_radius,
)
from winkler.problems.normal.solve_contact import at_end
from winkler.values.errors import NotConverged, OutsideValidity

OCTAVES_ABOVE = 80
"""How many octaves above the first stable radius a load is sought."""


def branches_beyond(states: EdgeStates, machine_stiffness: float, level: float) -> tuple[Branch, ...]:
    """Return the stable stretches up to a radius at which the position exceeds a level for good.

    Parameters
    ----------
    states : EdgeStates
    machine_stiffness : float
        [N/m].
    level : float
        What has to be reached, d [m] of fixed grips, else F + k_m d [N].

    Returns
    -------
    tuple of Branch
        The last one ends beyond the level and is stable over its last two octaves, or ends with the profile.

    Raises
    ------
    OutsideValidity
        If the profile never settles into rising.
    """
    end = states.end()
    if math.isfinite(at_end(states.bed)[0]):
        return branches(states, machine_stiffness, end)
    low = least_radius(states) or 2.0**-6 * typical_radius(states)
    quiet = _quiet(states, low)
    for octave in range(4, OCTAVES_ABOVE + 1):
        high = low * 2.0**octave
        if high >= end:  # the profile ends in a wall that no depth reaches
            high = end * (1.0 - max(2.0 ** (math.log2(end / low) - octave - 4.0), 1e-14))
        if high < min(4.0 * quiet, 0.9 * end) or _level(states, machine_stiffness, high) <= level:
            continue
        stable = branches(states, machine_stiffness, high)
        last = stable[-1] if stable else Branch(high, 0.0)
        if last.stop == high and (last.start <= 0.25 * high or high >= 0.9 * end):
            return stable
    raise OutsideValidity(_WAVING)


_WAVING = (
    "The adhesive contact is stable up to no load in particular: the profile keeps falling or waving with the distance "
    "from the axis; give a profile that rises for good."
)


@runtime_checkable
class Outlined(Protocol):
    """Springs whose profile is known at less cost on another medium."""

    def outline(self) -> Bed:
        """Return the springs on that medium."""


def _quiet(states: EdgeStates, low: float) -> float:
    """Return a radius beyond which no dense sample is unstable [m]: waves may lie far outside the first stable contact.

    Raises
    ------
    OutsideValidity
        If they never end.
    """
    bed, end = states.bed, states.end()
    if bed.rising:
        return max([low] + [b for b, _ in bed.kinks if b < end])
    last = low
    for octave in range(0, OCTAVES_SEARCHED, OCTAVES_PER_BLOCK):
        start, stop = low * 2.0**octave, min(low * 2.0 ** (octave + OCTAVES_PER_BLOCK), 0.999 * end)
        if stop <= start:
            return last
        a = np.geomspace(start, stop, SAMPLES_PER_OCTAVE * OCTAVES_PER_BLOCK)
        try:
            unstable = _unstable(states, a)
        except NotConverged:  # so far out nothing is known of the profile
            return last
        if unstable.any():
            last = float(a[unstable][-1])
    if last > 0.25 * low * 2.0**OCTAVES_SEARCHED:
        raise OutsideValidity(_WAVING)
    return last


def _unstable(states: EdgeStates, radius: Array) -> Array:
    """Return where contacts are unstable, cheaply: of layers and rings by the profile's own transform."""
    bed = states.bed
    with np.errstate(all="ignore"):
        if offers(bed.medium, PressedWaves) and isinstance(bed, Foundation):
            return np.asarray(bed.profile.gap_slope(radius) < 0.0)
        if isinstance(bed, Outlined):
            bed = bed.outline()
        if isinstance(states, ShortStates):
            return np.asarray(margin(ShortStates(bed, states.work), 0.0, radius) < 0.0)
        return np.asarray(bed.gap_slope(radius) < 0.0)


def _level(states: EdgeStates, machine_stiffness: float, radius: float) -> float:
    with np.errstate(all="ignore"):
        stable = float(position(states, machine_stiffness, np.array([radius]))[0])
    return stable if not math.isnan(stable) else math.inf
