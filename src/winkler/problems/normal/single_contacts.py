r"""Are the contacts under many loads one disc each?  Where g rises, the check of one contact holds for many.

In the sums of `winkler.problems.normal.single_contact` a wider contact has more punches; between the radii of two
contacts, if g does not fall there, they add

.. math:: \int_{a_1}^{a_2} p_1(r;x)\,g'(x)\,\mathrm dx \ge 0 \quad\text{to the pressure, and}\quad
          \int_{a_1}^{a_2} (1 - u_1(r;x))\,g'(x)\,\mathrm dx \ge 0

to what the separation outside both loses: the narrowest of such a family of contacts clears all of tension, the widest
all of overlap, as far as no flat punch pulls or sinks the surface farther than itself.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable

import numpy as np

from winkler.foundation.bed import Bed
from winkler.numerics.types import Array
from winkler.problems.normal.overlap import RISING_SAMPLES, SLOPE_ROUNDING, falling_kinks, refuse_overlap, rises
from winkler.problems.normal.single_contact import ended, pulls, refuse_tension, surely_pressed
from winkler.values.errors import NotConverged, OutsideValidity

__all__ = ["refuse_unless_discs"]


def refuse_unless_discs(bed: Bed, depth: Array, radius: Array, end: float) -> None:
    """Raise `OutsideValidity`, naming the load, unless each of many contacts is one disc.

    Where g rises from one radius to the next, what is added to the sums has a known sign: with p1 >= 0 the pressure
    rises everywhere, with u1 <= 1 the separation falls.  Of such a family the narrowest contact clears all of tension,
    the widest all of overlap.  A check that does not come to an end refuses nothing: `unfinished` reports it.
    """
    if bed.certain or not np.any(radius > 0.0):
        return
    (touching,) = np.nonzero(radius > 0.0)
    loaded = touching[np.lexsort((depth[touching], radius[touching]))]

    def tension(index: int) -> None:
        refuse_tension(bed, float(depth[index]), float(radius[index]))

    def overlap(index: int) -> None:
        refuse_overlap(bed, float(depth[index]), float(radius[index]), end)

    for family in _families(bed, radius, loaded):
        widest = float(radius[family[-1]])
        pull = np.zeros(family.shape, dtype=bool)
        if ended(functools.partial(pulls, bed, widest)):
            pull = np.array([ended(functools.partial(pulls, bed, a)) for a in radius[family].tolist()])
        pushing, pulling = family[~pull], family[pull]
        if bed.rising:
            pulling = pulling[~surely_pressed(bed, depth[pulling], radius[pulling])]
        _refuse_in_turn(tension, pushing, depth.size)
        for index in pulling:
            _refuse_in_turn(tension, np.array([index]), depth.size)
        if ended(functools.partial(_is_pressed_deepest, bed, widest)):
            _refuse_in_turn(overlap, family[::-1], depth.size)
        else:
            for index in family:
                _refuse_in_turn(overlap, np.array([index]), depth.size)


def _is_pressed_deepest(bed: Bed, radius: float) -> bool:
    """Return whether no flat punch up to a radius sinks the surface outside farther than itself."""
    return bed.medium.punch_facts(radius).most <= 1.0


def _families(bed: Bed, radius: Array, loaded: Array) -> list[Array]:
    """Return the loads, whose radii ascend, in parts: where g falls between two radii a part ends."""
    own = radius[loaded]
    if bed.rising and rises(bed, float(own[-1])):
        return [loaded]
    share = 0.5 + 0.5 * np.arange(1, RISING_SAMPLES) / RISING_SAMPLES
    falls = [falling_kinks(bed, float(own[-1]))]
    for octave in range(math.floor(math.log2(own[0] / own[-1])), 1):
        x = own[-1] * 2.0**octave * share
        slope = bed.gap_slope(x)
        falls.append(x[slope < -SLOPE_ROUNDING * np.max(slope[np.isfinite(slope)])].tolist())
    part = np.searchsorted(np.sort(np.concatenate(falls)), own)
    return np.split(loaded, np.flatnonzero(np.diff(part)) + 1)


def _refuse_in_turn(check: Callable[[int], None], order: Array, count: int) -> None:
    """Raise what a check finds of the loads in `order`, of which each that is clear clears all that follow.

    Named is the first of the loads refused, of `count`.
    """
    refused: dict[int, OutsideValidity] = {}

    def ends(place: int) -> bool | None:
        index = int(order[place])
        try:
            check(index)
        except NotConverged:
            return None
        except OutsideValidity as error:
            refused[index] = error
        return index not in refused

    place = 0
    while place < order.size and (verdict := ends(place)) is None:
        place = 2 * place + 1
    if place >= order.size or verdict:
        return
    last, clear = place, order.size
    while clear - last > 1:
        middle = (last + clear) // 2
        if ends(middle) is False:
            last = middle
        else:
            clear = middle
    first = int(np.min(order[place : last + 1]))
    if first not in refused:
        ends(int(np.argmin(order[place : last + 1])) + place)
    named = first if first in refused else int(order[place])
    raise OutsideValidity(f"{refused[named]} (load at index {named})" if count > 1 else str(refused[named]))
