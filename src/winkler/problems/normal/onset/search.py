"""The search for the onset of yield: at which contact radius a part of the bodies reaches its strength, and where."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable

import numpy as np

from winkler.errors import NotConverged, OutsideValidity
from winkler.foundation.bed import Bed, PressedSprings
from winkler.media.halfspace import HalfSpace
from winkler.media.offers import LayerStack, offers
from winkler.problems.normal.greatest_stress import GreatestStress, greatest_stress, sharp_places
from winkler.problems.normal.single_contact import ended, refuse_tension, refuse_unless_disc, surely_pressed
from winkler.problems.normal.solve_contact import at_end, flat_radius
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.problems.normal.yield_statement import RADIUS_SHARES

__all__ = ["greatest_in", "onset_in"]

MOST_STEPS, OCTAVES = 40, 500
ROUGH_MISS = 0.02
"""Logarithm of stress over strength below which stresses in layers are sought finely."""
LAST_MISS, LAST_MISS_IN_LAYERS = 0.0, 1e-5
"""Logarithm of stress over strength whose square is the error of one more secant."""
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
    below: tuple[float, float] | None = None
    if end == widest < math.inf:
        while (share := stress(a, fine=False).value / strength) < 1.0:
            if a == end:
                return _too_wide(part, widest)
            below = (math.log(a - flat), math.log(share)) if share > 0.0 else None
            wider, bent = _before_bending(bed, a, min(flat + 2.0 * (a - flat), end))
            if bent is not None and wider == a:
                raise bent
            a = wider
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
    found = _crossing(stress, strength, flat, end, a, near, below)
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
    last: tuple[float, float] | None = None,
) -> tuple[float, GreatestStress] | str:
    """Return where the stress reaches the strength between two radii [m], from one of them on; or why it does not.

    `near` is the logarithm of stress over strength from which one more secant, without a look, suffices; `last` is the
    logarithm of a smaller radius over `flat`, and that of the stress there over the strength.
    """
    low, high, fine = flat, end, False
    for _ in range(MOST_STEPS):
        place = stress(a, fine)
        miss = math.log(place.value / strength)
        if not fine and abs(miss) < ROUGH_MISS:
            fine, place = True, stress(a, fine=True)
            miss = math.log(place.value / strength)
        if abs(miss) < 1e-10:
            return a, place
        if fine and abs(miss) < near and last is not None:
            power = (miss - last[1]) / (math.log(a - flat) - last[0])
            return flat + (a - flat) * math.exp(-miss / power), place
        if last is not None and abs(miss - last[1]) < 1e-8 * abs(math.log(a - flat) - last[0]):
            return _the_same(place.value, strength)
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
    raise NotConverged(f"YieldOnset: the radius at which yielding begins was not found in {MOST_STEPS} steps.")


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
            f"YieldOnset: at a contact radius of {radius:.6g} m the stress in the {part.name} is not found: the "
            "pressure on layers of very different moduli is lost in rounding, or the profile is not smooth; give "
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
                "YieldOnset: the slope of the profile jumps; in an incompressible body the greatest von Mises stress "
                "next to the edge is finite, but is not resolved at the first touch; give a rounded profile."
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
