r"""Which contact radius meets a load, where g may turn: the radius jumps from crest to crest.

A disc of radius a needs every spring inside compressed, so g(a) must be a record: :math:`g(a)\ge g(x)` for
:math:`x<a`.  Beyond a crest of g the radius jumps to where g is back at the crest; forces in between belong to rings.
Many loads are met at once: where g turns is found once for all that have the same horizon.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.numerics.equations.bracketing import between
from winkler.numerics.types import Array
from winkler.problems.normal.overlap import SLOPE_SAMPLES
from winkler.problems.normal.single_contact import MOST_TURNING_POINTS, too_many
from winkler.values.errors import NotConverged, OutsideValidity


class RisingInterval(NamedTuple):
    """An interval of x on which g rises above everything before it."""

    start: float
    stop: float


def _turns(bed: Bed, end: float) -> Array:
    """Return the places up to `end` where g' changes sign."""
    x = np.linspace(0.0, end, SLOPE_SAMPLES + 1)[1:]
    slope = bed.gap_slope(x)
    changes = np.flatnonzero(np.sign(slope[1:]) * np.sign(slope[:-1]) < 0)
    if changes.size > MOST_TURNING_POINTS:
        raise OutsideValidity(too_many(end))
    low, high = x[changes], x[changes + 1]
    # a kink at which g' drops from above zero is a crest itself
    crests = np.array([b for b, strength in bed.kinks if strength < 0.0])
    next_crest = np.append(crests, np.inf)[np.searchsorted(crests, low)]
    crest = (slope[changes] > 0.0) & (next_crest < high)
    starts_ = np.where(crest, next_crest, low)
    starts_[~crest] = between(lambda t, _: bed.gap_slope(t), low[~crest], high[~crest])
    return starts_


def _rising_intervals(bed: Bed, end: float) -> list[RisingInterval]:
    bounds = np.concatenate([[0.0], _turns(bed, end), [end]])
    tops = bed.gap(bounds)
    # what was the highest before each: beyond a crest g is back at it only later
    record = np.maximum.accumulate(np.maximum(tops, 0.0))
    (climbing,) = np.nonzero(tops[1:] > record[:-1])
    start, stop, before = bounds[climbing], bounds[climbing + 1], record[climbing]
    (late,) = np.nonzero(tops[climbing] < before)
    start[late] = between(lambda t, i: bed.gap(t) - before[late][i], start[late], stop[late])
    return [RisingInterval(*ends) for ends in zip(start.tolist(), stop.tolist(), strict=True)]


class _Landscape:
    """Properties of one bed that many loads need, each computed once: where g rises, and g and the force at places."""

    def __init__(self, bed: Bed, end: float) -> None:
        self.bed, self.end = bed, end
        self.intervals = functools.cache(lambda horizon: _rising_intervals(bed, horizon))
        self.gap = functools.cache(lambda x: float(bed.gap(np.array([x]))[0]))
        self.force = functools.cache(lambda x: float(forces(bed, np.array([x]))[0]))

    def horizon(self, value: Callable[[float], float], target: float, guess: float) -> float:
        """Return a place at which a value is met, and not at half of it, by doubling or halving the guess."""
        place = guess
        for _ in range(400):
            if value(place) >= target:
                if not value(0.5 * place) >= target:
                    return place
                place *= 0.5
            elif place >= self.end:
                return self.end
            else:
                place = min(2.0 * place, self.end)
        raise NotConverged(
            "The load is not met at any contact radius that can be represented; check the profile's units."
        )

    def at_depth(self, depth: float, guess: float) -> RisingInterval:
        """Return the interval on which g meets a depth, or refuse."""
        for interval in self.intervals(self.horizon(self.gap, depth, guess)):
            if self.gap(interval.stop) >= depth:
                return interval
        _refuse_unless_pinned(self.bed, f"depth {depth:.6g} m", self.end)
        return RisingInterval(self.end, self.end)

    def at_force(self, force: float, guess: float) -> RisingInterval:
        """Return the interval on which a force is met, or refuse."""
        place = self.horizon(self.force, force, guess)
        # in a valley of g the force may be met below the crest before it
        for horizon in (place, min(2.0 * place, self.end)):
            for interval in self.intervals(horizon):
                if force < self.force(interval.start):
                    raise OutsideValidity(
                        f"At force {force:.6g} N the contact is not a disc. Its inner gap closes at "
                        f"{self.gap(interval.start):.6g} m depth; from {self.force(interval.start):.6g} N on it "
                        f"is a disc of {interval.start:.6g} m. Give a force outside."
                    )
                if force <= self.force(interval.stop):
                    return interval
        _refuse_unless_pinned(self.bed, f"force {force:.6g} N", self.end)
        return RisingInterval(self.end, self.end)


def forces(bed: Bed, a: Array) -> Array:
    """Return the forces [N] under which contacts have given radii."""
    return bed.stiffness(a) * bed.gap(a) - bed.gap_load(a)


def _met(value: Callable[[Array], Array], target: Array, intervals: list[RisingInterval]) -> Array:
    start, stop = np.array(intervals).T
    radius: Array = stop.copy()
    (free,) = np.nonzero(start < stop)
    radius[free] = between(lambda x, i: value(x) - target[free][i], start[free], stop[free])
    return radius


def radii_at_depth(bed: Bed, depth: Array, end: float, guess: Callable[[float], float]) -> Array:
    """Return the contact radii at depths ``(m,)``, zero where there is no contact, or refuse, naming the load."""
    landscape = _Landscape(bed, end)
    return _all_met(bed.gap, depth, lambda d: landscape.at_depth(d, guess(d)))


def radii_at_force(bed: Bed, force: Array, end: float, guess: Callable[[float], float]) -> Array:
    """Return the contact radii under forces ``(m,)``, zero without force, or refuse, naming the load."""
    landscape = _Landscape(bed, end)
    return _all_met(functools.partial(forces, bed), force, lambda load: landscape.at_force(load, guess(load)))


def _all_met(value: Callable[[Array], Array], target: Array, interval: Callable[[float], RisingInterval]) -> Array:
    radius = np.zeros(target.shape)
    (loaded,) = np.nonzero(target > 0.0)
    intervals = []
    for index in loaded:
        try:
            intervals.append(interval(float(target[index])))
        except OutsideValidity as error:
            raise OutsideValidity(f"{error} (load at index {index})" if target.size > 1 else str(error)) from None
    if intervals:
        radius[loaded] = _met(value, target[loaded], intervals)
    return radius


def _refuse_unless_pinned(bed: Bed, target: str, end: float) -> None:
    """Raise if a load that no free edge meets is not met by the rim either."""
    if not math.isfinite(end):
        raise OutsideValidity(
            f"{target} is not met by a round contact: the profile falls with the distance from the axis, so that it "
            "touches as a ring; give a profile that rises from its apex."
        )
    if bed.rim > bed.reach:
        raise OutsideValidity(
            f"{target} leads beyond the reach of the profile ({end:.6g} m), where nothing is known of it; give less."
        )
