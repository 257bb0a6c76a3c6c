r"""How far a contact closes: the depth and the radius that meet a prescribed radius, depth or force.

Where the body is known to let g rise, Newton's method meets all loads; elsewhere
`winkler.problems.normal.radius_search` does, climb by climb.  Where a rising g does not make every contact one disc,
they are looked at afterwards.

Are the contacts under many loads one disc each?  Where g rises, the check of one contact holds for many.

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
from functools import partial

import numpy as np

from winkler.foundation.bed import Bed, measured_radii
from winkler.media.body_of import thickness_of
from winkler.numerics.equations.roots import by_blocks, invert, rough_root
from winkler.numerics.types import Array, Curve
from winkler.problems.normal import radius_search
from winkler.problems.normal.overlap import RISING_SAMPLES, SLOPE_ROUNDING, falling_kinks, refuse_overlap, rises
from winkler.problems.normal.single_contact import ended, pulls, refuse_tension, surely_pressed
from winkler.values.errors import NotConverged, OutsideValidity

FARTHER = 1.1
"""How much farther than where the power of two values leads a place beyond a load is sought."""


def end_of(bed: Bed) -> float:
    """Return the radius [m] at which the profile ends, at a rim or where it is no longer known."""
    return min(bed.reach, bed.rim)


def flat_radius(bed: Bed) -> float:
    """Return the radius up to which g vanishes: the contact opens with it."""
    flat = 0.0
    for b, _ in bed.kinks:
        if b >= end_of(bed) or float(bed.gap(np.array([b]))[0]) != 0.0:
            break
        flat = b
    return flat


def at_end(bed: Bed) -> tuple[float, float]:
    """Return depth and force when the contact fills the profile; infinite if it never does."""
    end = end_of(bed)
    if not math.isfinite(end):
        return np.inf, np.inf
    place = np.array([end])
    with np.errstate(divide="ignore", invalid="ignore"):
        depth = float(bed.gap(place)[0])
        if not np.isfinite(depth):
            return np.inf, np.inf
        return depth, float((bed.stiffness(place) * depth - bed.gap_load(place))[0])


def indices_of(bad: Array) -> str:
    """Return which loads of many are bad, for a sentence; nothing of one alone."""
    places = np.flatnonzero(bad)
    if bad.size == 1:
        return ""
    return f" at index {', '.join(map(str, places[:5]))}" + (" and more" if places.size > 5 else "")


def at_radius(bed: Bed, radius: Array) -> tuple[Array, Array]:
    """Return depth and radius of contacts with given radii `(m,)`."""
    end = end_of(bed)
    bad = radius >= end
    if bad.any() and np.isfinite(at_end(bed)[0]):
        bad = radius > end
    if bad.any():
        wall = "the rim of the body" if bed.rim <= bed.reach else "the reach of the profile"
        raise OutsideValidity(
            f"radius {radius[bad][0]:.6g} m{indices_of(bad)} is beyond {wall} ({end:.6g} m); give a smaller one."
        )
    flat = end if bed.rim < np.inf and float(bed.gap(np.array([end]))[0]) == 0.0 else flat_radius(bed)
    bad = (radius > 0.0) & (radius <= flat)
    if bad.any():
        raise OutsideValidity(
            f"radius {radius[bad][0]:.6g} m{indices_of(bad)} does not determine the load: the body is flat up to "
            f"{flat:.6g} m and touches there at once; give a force or a depth."
        )
    depth = bed.gap(radius)
    refuse_unless_discs(bed, depth, radius, end)
    return depth, radius.copy()


def at_depth(bed: Bed, depth: Array) -> tuple[Array, Array]:
    """Return depth and radius of contacts at given depths `(m,)`; radius zero without contact."""
    if bed.rising:
        radius = _radii_at_depth(bed, depth)
        if rises(bed, float(radius.max(initial=0.0))):
            refuse_unless_discs(bed, depth, radius, end_of(bed))
            return depth.copy(), radius
    radius = radius_search.radii_at_depth(bed, depth, end_of(bed), _guesses(bed, bed.gap))
    refuse_unless_discs(bed, depth, radius, end_of(bed))
    return depth.copy(), radius


def _radii_at_depth(bed: Bed, depth: Array) -> Array:
    """Return the radii at which a rising g meets all depths."""

    def with_slope(a: Array) -> tuple[Array, Array]:
        return bed.gap(a), bed.gap_slope(a)

    return _rising_radii(bed, depth, bed.gap, with_slope, ("depth", "m"))


def _radii_at_force(bed: Bed, force: Array) -> Array:
    """Return the radii at which a rising g meets all forces."""

    def with_slope(a: Array) -> tuple[Array, Array]:
        stiffness = bed.stiffness(a)
        return stiffness * bed.gap(a) - bed.gap_load(a), stiffness * bed.gap_slope(a)

    return _rising_radii(bed, force, partial(radius_search.forces, bed), with_slope, ("force", "N"))


def _rising_radii(
    bed: Bed, target: Array, value: Curve, with_slope: Callable[[Array], tuple[Array, Array]], words: tuple[str, str]
) -> Array:
    """Return the radii at which a value that rises with the radius, depth or force, meets all loads."""
    most = float(target.max(initial=0.0))
    last = np.inf if _met_before(bed, value, most) else at_end(bed)[0 if words[0] == "depth" else 1]
    free, radius = target > 0.0, np.zeros(target.shape)
    if most > last:
        beyond = target > last
        if bed.rim > bed.reach:
            word, unit = words
            raise OutsideValidity(
                f"{word} {target[beyond][0]:.6g} {unit}{indices_of(beyond)} leads beyond the reach of the profile "
                f"({bed.reach:.6g} m), where nothing is known of it; give at most {last:.6g} {unit}."
            )
        free[beyond], radius[beyond] = False, end_of(bed)
    if not free.any():
        return radius
    every = bool(free.all())
    own = target if every else target[free]
    upper, guess = _bracket(bed, value, own)
    root = invert(with_slope, own, lower=flat_radius(bed), upper=upper, guess=guess)
    if flat_radius(bed) > 0.0 or bed.kinks:
        far = by_blocks(lambda radii, loads: value(radii) > (1.0 + 1e-6) * loads, root, own)
        root = _not_beyond(bed, root, far)
    if every:
        return root
    radius[free] = root
    return radius


def _met_before(bed: Bed, value: Curve, most: float) -> bool:
    """Return whether the greatest load is met well before the profile ends; there its g may take long to compute."""
    end = end_of(bed)
    if not math.isfinite(end):
        return False
    place = _guesses(bed, value)(most)
    while place < 0.5 * end:
        if float(value(np.array([place]))[0]) >= most:
            return True
        place *= 2.0
    return False


def _not_beyond(bed: Bed, radius: Array, beyond: Array) -> Array:
    """Return the radii, with the next smaller number where rounding has put one far beyond its load.

    Just above a flat g climbs like a square root: the number next to the flat's radius may lie orders of magnitude too
    high, the flat's own costs the force nothing.
    """
    if not beyond.any():
        return radius
    flat = flat_radius(bed)
    smaller = np.where(radius <= (1.0 + 1e-14) * flat, flat, np.nextafter(radius, 0.0))
    return np.where(beyond, smaller, radius)


def at_force(bed: Bed, force: Array) -> tuple[Array, Array]:
    """Return depth and radius of contacts under given forces `(m,)`."""
    tensile = force < 0.0
    if tensile.any():
        raise OutsideValidity(
            f"force {force[tensile][0]:.6g} N{indices_of(tensile)} is tensile; without adhesion bodies can only be "
            "pressed together: give a force of zero or more."
        )
    radius = _radius_at_force(bed, force)
    depth = by_blocks(partial(_depth_under, bed), force, radius)
    refuse_unless_discs(bed, depth, radius, end_of(bed))
    return depth, radius


def _depth_under(bed: Bed, force: Array, radius: Array) -> Array:
    """Return the depth [m] of contacts of known radii [m] under forces [N]."""
    # F = k(a) d - load(a) hardly depends on the rounding of a, g(a) may: close above a flat, or deep in a steep flank
    stiffness = bed.stiffness(radius)
    touching = stiffness > 0.0
    if touching.all():
        return np.asarray((force + bed.gap_load(radius)) / stiffness)
    return np.where(touching, (force + bed.gap_load(radius)) / np.where(touching, stiffness, 1.0), 0.0)


def _radius_at_force(bed: Bed, force: Array) -> Array:
    """Return the radii of contacts under forces that are not tensile."""
    if bed.rising:
        radius = _radii_at_force(bed, force)
        if rises(bed, float(radius.max(initial=0.0))):
            return radius
    return radius_search.radii_at_force(bed, force, end_of(bed), _guesses(bed, partial(radius_search.forces, bed)))


def _guesses(bed: Bed, value: Curve) -> Callable[[float], float]:
    """Return what gives, for each of many loads, a radius of the order of the lengths of body, layers and load."""
    length = _length(bed)
    return lambda target: length if math.isfinite(length) else rough_root(value, target)


def _length(bed: Bed) -> float:
    """Return a radius of the order of the lengths of body and layers; infinite if they have none."""
    flat, end, layers = flat_radius(bed), end_of(bed), thickness_of(bed.medium)
    if math.isfinite(end):
        return flat + min(0.02 * (end - flat), layers)
    if flat > 0.0:
        return flat + min(flat, layers)
    if math.isfinite(bed.size):
        return min(0.02 * bed.size, layers)
    return min([layers, *(b for b, _ in bed.kinks)])


def _bracket(bed: Bed, value: Curve, target: Array) -> tuple[float, float | Array]:
    """Return a radius beyond all that are sought, and one or many where the search may begin.

    Layers are not solved for contacts far wider than those sought: these take long, or cannot be carried.
    """
    points = measured_radii(bed)
    if points.size:  # splines bend from point to point: begin between the right ones
        points = points[points > flat_radius(bed)]
        return end_of(bed), np.exp(np.interp(np.log(target), np.log(value(points)), np.log(points)))
    end, place = end_of(bed), _guesses(bed, value)(float(target.max()))
    if not math.isfinite(thickness_of(bed.medium)):
        return end, place
    flat, most = flat_radius(bed), float(target.max())
    places, values = [place], [float(value(np.array([place]))[0])]
    while values[-1] < most:
        place = flat + _onward(places, values, flat, most) * (place - flat)
        places.append(min(place, end))
        if place >= end:  # where g may be infinite
            break
        values.append(float(value(np.array([place]))[0]))
    samples = [(place - flat, own) for place, own in zip(places, values, strict=False) if own > 0.0]
    if len(places) < 2 or not samples:
        return end, places[0]
    beside, below = np.log(np.array(samples)).T
    return places[-1], np.clip(flat + np.exp(np.interp(np.log(target), below, beside)), places[0], places[-1])


def _onward(places: list[float], values: list[float], flat: float, most: float) -> float:
    """Return how much farther than the last place beyond a flat to go: to where the power of two values leads, or 2."""
    if len(values) < 2 or not 0.0 < values[-2] < values[-1]:
        return 2.0
    steps = np.diff(np.log(np.array([places[-2:], values[-2:]]) - np.array([[flat], [0.0]])))[:, 0]
    return float(min(2.0, FARTHER * (most / values[-1]) ** (steps[0] / steps[1])))


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
