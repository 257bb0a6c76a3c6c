"""The search for the onset of yield: at which contact radius a part of the bodies reaches its strength, and where."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Sequence

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings
from winkler.media.halfspace import HalfSpace
from winkler.media.offers import LayerStack, offers
from winkler.problems.normal.greatest_stress import GreatestStress, greatest_stress, sharp_places
from winkler.problems.normal.single_contact import ended, refuse_tension, refuse_unless_disc, surely_pressed
from winkler.problems.normal.solve_contact import at_end, flat_radius
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.problems.normal.yield_statement import RADIUS_SHARES
from winkler.values.errors import NotConverged, OutsideValidity

MOST_STEPS, OCTAVES = 40, 500
ROUGH_MISS = 0.02
"""Logarithm of stress over strength below which stresses in layers are sought finely."""
LAST_MISS, LAST_MISS_IN_LAYERS = 0.0, 2e-6
"""Logarithm of stress over strength from which one more step, by stresses sought less finely too, errs by 1e-9."""
POINTS_INTERPOLATED, MOST_BENT = 4, 0.5
"""Points through which the expected radius goes, and by how much less one more must move it than that before."""
LONGEST_STEP = 20.0
"""Greatest logarithm of the ratio of two radii of which the second is expected by the first."""
SEEN_DISTANCE = 0.15
"""Part of the contact radius at the onset within which the stress at a smaller radius need not be sought again."""
BEYOND_ONSET, NEARER_STEPS = 6.0, 4
"""Slope of the equivalent profile of a ball that yields, times modulus over strength, or a little more (it is 5.1 for
Poisson's ratios of 0.3); steps towards the radius at which a profile has it."""
FIRST_ON_LAYER, WIDEST_ON_LAYER = 8.0, 4096.0
"""Contact radius over the thickness of the uppermost layer from which, and up to which, the onset is sought."""
BENT_STEP = math.sqrt(2.0)
"""Ratio of the contact radii at which layers are asked whether they bend away; of a stiff one they do so over more."""
REACH_SHARE = 0.999
"""Part of the reach of a profile that becomes vertical there, up to which the onset is sought."""


def onset_in(bed: Bed, part: StrongPart, mu: float) -> tuple[float, GreatestStress] | str:
    """Return the contact radius at which one body yields, and where; or why it does not."""
    strength, flat, buried = part.solid.strength, flat_radius(bed), part.top > 0.0
    sharp = [b for b, jump in bed.kinks if jump != 0.0 and not buried]  # below a layer the stress stays finite
    widest = math.inf
    if offers(bed.medium, LayerStack):
        widest = WIDEST_ON_LAYER * bed.medium.layers[0].thickness
        if flat > widest:
            return _too_wide(part, widest)
    end = min([bed.reach, bed.rim, widest, *(b for b in sharp if b > flat)])
    a = _start(bed, flat, end, min(one.solid.strength for one in strong_parts(bed.medium)))  # parts share their radii
    if not buried:
        _refuse_first_touch(bed, part, a, flat, sharp, mu)
    elif bed.rim < math.inf and float(bed.gap(np.array([bed.rim]))[0]) == 0.0:
        return _pinned(bed, part)

    seen: list[float] = []

    def stress(radius: float, fine: bool = True) -> GreatestStress:
        seen.append(radius)
        return greatest_in(bed, part, radius, fine, mu)

    with np.errstate(divide="ignore", invalid="ignore"):
        vertical = not math.isfinite(float(bed.gap_slope(np.array([end]))[0]))  # as the equator of a ball
    known: list[tuple[float, float]] = []
    fine, wider = False, end
    if end == widest < math.inf:
        while (share := stress(a, fine).value / strength) < 1.0:
            if a == end:
                return _too_wide(part, widest)
            if fine and share > 1.0 - ROUGH_MISS:
                end = wider
                break
            if share > 0.0:
                known.append((math.log(share), math.log(a - flat)))
            wider, bent = _before_bending(bed, a, min(flat + 2.0 * (a - flat), end))
            if bent is not None and wider == a:
                raise bent
            expected = _at_strength(known)
            fine = len(known) > 2 and math.log(a - flat) < expected < math.log(wider - flat)
            a = flat + math.exp(expected) if fine else wider
        else:
            end = a
    elif isinstance(bed.medium, HalfSpace) and math.isfinite(end) and stress(a).value >= strength:
        end = a  # what happens at the end of the profile does not matter
    elif end in sharp or (math.isfinite(at_end(bed)[0]) and not vertical):
        place = stress(end)
        if place.value < strength:
            if buried and bed.rim <= bed.reach:
                return _pinned(bed, part)
            if end in sharp or bed.rim <= bed.reach:  # reached first, and there the stress is infinite
                return end, GreatestStress(math.inf, end, 0.0, "")
            return (
                f"YieldOnset: within the profile's reach ({end:.6g} m) the largest von Mises stress stays below "
                f"{strength:.6g} Pa; the body does not yield before the profile ends."
            )
    elif math.isfinite(end):
        end *= REACH_SHARE
        place = stress(end)
        if place.value < strength:
            return (
                f"YieldOnset: at {end:.6g} m, where the profile is nearly vertical, the largest von Mises stress is "
                f"{place.value:.6g} Pa, below the strength, {strength:.6g} Pa: the body does not yield before; check "
                "the units of strength and modulus."
            )
    homogeneous = isinstance(bed.medium, HalfSpace)
    near = LAST_MISS if homogeneous else LAST_MISS_IN_LAYERS
    found = _crossing(stress, strength, flat, end, a, near, known, fine)
    if isinstance(found, str) or homogeneous:
        return found
    for share in RADIUS_SHARES[:-1]:  # in layers the stress need not grow with the load
        earlier = flat + share * (found[0] - flat)
        if any(abs(radius - earlier) < SEEN_DISTANCE * (found[0] - flat) for radius in seen):
            continue
        if stress(earlier, fine=False).value >= strength:
            return _crossing(stress, strength, flat, earlier, 0.5 * (flat + earlier), near)
    return found


def _crossing(
    stress: Callable[..., GreatestStress],
    strength: float,
    flat: float,
    end: float,
    a: float,
    near: float,
    known: Sequence[tuple[float, float]] = (),
    fine: bool = False,
) -> tuple[float, GreatestStress] | str:
    """Return where the stress reaches the strength between two radii [m], from one of them on; or why it does not.

    `near` is the logarithm of stress over strength from which one more step, without a look, suffices; `known` are
    logarithms of the stress over the strength, and of the radii over `flat` at which it is found.
    """
    low, high, points = flat, end, list(known)
    for _ in range(MOST_STEPS):
        place = stress(a, fine)
        miss = math.log(place.value / strength)
        if not fine and abs(miss) < ROUGH_MISS:
            fine, place = True, stress(a, fine=True)
            miss = math.log(place.value / strength)
        if abs(miss) < 1e-10:
            return a, place
        if points and abs(miss - points[-1][0]) < 1e-8 * abs(math.log(a - flat) - points[-1][1]):
            return _the_same(place.value, strength)
        low, high = (a, high) if miss < 0.0 else (low, a)
        points.append((miss, math.log(a - flat)))
        expected, last = _at_strength(points), points[-1][1]
        new = flat + math.exp(min(max(expected, last - LONGEST_STEP), last + LONGEST_STEP))
        if fine and abs(miss) < near and math.isfinite(new):
            return new, place
        fine = fine or abs(expected - last) < ROUGH_MISS
        if not low < new < high:
            new = 0.5 * (low + high) if math.isfinite(high) else 2.0 * a
        if abs(new - a) <= 1e-14 * a:
            return a, place
        a = new
    raise NotConverged(f"YieldOnset: the radius at which yielding begins was not found in {MOST_STEPS} steps.")


def _at_strength(known: Sequence[tuple[float, float]]) -> float:
    """Return the logarithm of the radius at which the strength is expected; nan where the stress does not grow.

    A polynomial of the logarithm of the stress goes through the nearest points: of power laws it is a straight line.
    Through a single point the stress is taken to grow like the radius.
    """
    points = sorted(known, key=lambda point: abs(point[0]))[:POINTS_INTERPOLATED]
    if not points:
        return math.nan
    if len(points) == 1:
        points.append((points[0][0] - 1.0, points[0][1] - 1.0))
    misses, radii = np.array(points).T
    if np.unique(misses).size < radii.size or (radii[0] > radii[1]) != (misses[0] > misses[1]):
        return math.nan
    expected, product, change = float(radii[0]), 1.0, math.nan
    for order in range(1, radii.size):
        radii = (radii[1:] - radii[:-1]) / (misses[order:] - misses[:-order])
        product *= -float(misses[order - 1])
        before, change = change, abs(product * float(radii[0]))
        if change > MOST_BENT * before:  # the points are too far apart for one more
            break
        expected += product * float(radii[0])
    return expected


def greatest_in(bed: Bed, part: StrongPart, radius: float, fine: bool, mu: float) -> GreatestStress:
    """Return the greatest stress in a part at a contact radius.

    Raises
    ------
    OutsideValidity
        If the stress is not found since the contact is no disc.
    NotConverged
        If it is not found although it is one.
    """
    pressed = PressedSprings(bed, float(bed.gap(np.array([radius]))[0]), radius)
    try:
        return greatest_stress(pressed, part, mu, fine=fine)
    except NotConverged:  # where a stiff layer bends away nearly all of the pressure cancels
        refuse_unless_disc(bed, pressed.depth, radius, min(bed.reach, bed.rim))
        if not offers(bed.medium, LayerStack):
            raise
        raise NotConverged(
            f"YieldOnset: at a contact radius of {radius:.6g} m the stress in the {part.name} is not found. The "
            "pressure on layers of very different moduli is lost in rounding, or the profile is not smooth: give "
            "moduli that differ less, or list the kinks of the profile."
        ) from None


def _before_bending(bed: Bed, known: float, radius: float) -> tuple[float, OutsideValidity | None]:
    """Return the widest contact radius up to the one wanted before which no layer bends away, and why it ends there.

    A wider contact may be a disc again, but whether a body yields on the way is not known.
    """
    medium = bed.medium
    if not offers(medium, LayerStack) or not bed.medium.punch_facts(radius).pulls:
        return radius, None
    narrowest = max(known, medium.layers[0].thickness)
    steps = math.ceil(math.log(radius / narrowest) / math.log(BENT_STEP)) if radius > narrowest else 0
    last = narrowest
    for a in np.geomspace(narrowest, radius, steps + 1)[1:].tolist():
        depth = float(bed.gap(np.array([a]))[0])
        if not surely_pressed(bed, np.array([depth]), np.array([a]))[0]:
            try:
                ended(functools.partial(refuse_tension, bed, depth, a))
            except OutsideValidity as bent:
                return last, bent
        last = a
    return radius, None


def _too_wide(part: StrongPart, widest: float) -> str:
    return (
        f"YieldOnset: up to a contact radius of {widest:.6g} m, {WIDEST_ON_LAYER:g} times the thickness of the "
        f"uppermost layer, the {part.name} does not reach its strength, {part.solid.strength:.6g} Pa; leave so thin a "
        "layer out."
    )


def _start(bed: Bed, flat: float, end: float, strength: float) -> float:
    """Return a radius [m] where the modulus times the slope of the equivalent profile is about the strength.

    On half-spaces it lies a little beyond the onset under a ball, so that no larger radius need be looked at.
    """
    wanted = strength / bed.medium.modulus  # type: ignore[attr-defined]
    middle, before = 0.5 * (flat + end), math.nan
    a = middle if math.isfinite(end) else 2.0 * flat or 1.0
    if offers(bed.medium, LayerStack):  # flat punches far wider than the layers are costly
        a = min(middle, flat + FIRST_ON_LAYER * bed.medium.layers[0].thickness)
        a, _ = _before_bending(bed, flat, a)
    for _ in range(OCTAVES):
        slope = float(np.abs(bed.gap_slope(np.array([a])))[0])
        if 0.25 * wanted <= slope <= 4.0 * wanted or slope == before or (slope < wanted and a >= middle):
            break
        before = slope
        if slope > wanted:
            a = flat + 0.25 * (a - flat)
        else:
            a, bent = _before_bending(bed, a, min(flat + 4.0 * (a - flat), middle))
            if bent is not None:
                break
    if isinstance(bed.medium, HalfSpace):
        for _ in range(NEARER_STEPS):
            slope = float(np.abs(bed.gap_slope(np.array([a])))[0])
            nearer = flat + (a - flat) * min(max(BEYOND_ONSET * wanted / slope, 0.25), 4.0) if slope > 0.0 else a
            a = min(nearer, 0.5 * (a + end)) if math.isfinite(end) else nearer
    return a


def _refuse_first_touch(bed: Bed, part: StrongPart, a: float, flat: float, sharp: list[float], mu: float) -> None:
    """Refuse a profile that is sharp where it touches first."""
    advice = "yielding begins at the first touch; give a rounded profile."
    if bed.rim < math.inf and float(bed.gap(np.array([bed.rim]))[0]) == 0.0:
        raise OutsideValidity(f"YieldOnset: the rim is sharp, so the stress is infinite there and {advice}")
    if flat in sharp:
        if part.solid.poisson == 0.5 and mu == 0.0:
            raise OutsideValidity(
                "YieldOnset: the slope of the profile jumps; in an incompressible body the maximum von Mises "
                "stress next to the edge is finite, but is not resolved at the first touch; give a rounded "
                "profile."
            )
        raise OutsideValidity(
            f"YieldOnset: the slope of the profile jumps, so the stress is infinite there and {advice}"
        )
    pressed = PressedSprings(bed, float(bed.gap(np.array([a]))[0]), a)
    if any(place == 0.0 for place, _ in sharp_places(pressed, part.solid.poisson, mu)):
        raise OutsideValidity(f"YieldOnset: the apex is pointed, so the stress is infinite there and {advice}")


def _pinned(bed: Bed, part: StrongPart) -> str:
    return (
        f"YieldOnset: the {part.name} stays elastic until the contact is pinned at its rim ({bed.rim:.6g} m), beyond "
        "which the onset below layers is not sought; give a wider profile, or read the validity of an Indentation."
    )


def _the_same(stress: float, strength: float) -> str:
    """Return what it means that the greatest stress does not depend on the load."""
    if stress < strength:
        verdict = "does not reach the strength, {:.6g} Pa: the body does not yield."
    else:
        verdict = "is more than the strength, {:.6g} Pa: yielding begins at the first touch."
    return f"YieldOnset: the greatest von Mises stress is {stress:.6g} Pa under every load, and {verdict}".format(
        strength
    )
