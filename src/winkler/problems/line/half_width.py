"""How wide a line contact is under a load: the half-width that meets a force per length or a mean pressure.

Where the body is known to let w rise, Newton's method meets all loads at once.  Elsewhere the first half-width that
bears more than all narrower ones is taken, and its contact is examined: the pressure must not pull, and the surfaces
must not overlap beside it.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.numerics.equations.bracketing import between
from winkler.numerics.equations.roots import invert, rough_root
from winkler.numerics.types import Array
from winkler.profiles.profile import Profile, Sum
from winkler.profiles.wavy import Wavy
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity

SAMPLES, SAMPLES_ON_LAYERS = 513, 129
PRESSURE_SAMPLES = 129
WIDTHS_BESIDE = 8.0
"""How many half-widths beside the contact are examined for overlap."""
ROUNDING = 1e-9
CRESTS, SUNK_ERROR = 4, 0.02
"""Crests of a wave that are examined, and bound of the error of how much deeper the surface sinks in the middle."""

VERTICAL = 1e-3, 1e-5, 1e-7, 1e-9
"""Distances from a vertical end at which the load is examined, over its place."""
LOGARITHMIC = 0.9
"""Growth from one of them to the next, over that before, from which on the load is unbounded, as a logarithm is."""
STEP = 1.0 / 32.0
MOST_STEPS = 60
MOST_TRIALS = 64.0
"""A reach so many times wider than where the search begins is not tried beforehand."""
INTERPOLATED, INTERPOLATED_ON_LAYERS = 48, 32
"""Places between which a search begins."""

Level = Callable[[Array], Array]
Curve = Callable[[Array], tuple[Array, Array]]


def widest_allowed(bed: LineBed, half_width: Array) -> None:
    """Refuse half-widths beyond the profile, and those that do not determine the load."""
    refuse_beyond(bed, half_width)
    flat = bed.flat
    within = (half_width > 0.0) & (half_width <= flat)
    if within.any():
        raise OutsideValidity(
            f"half-width {half_width[within][0]:.6g} m does not determine the load: the body is flat up to "
            f"{flat:.6g} m and touches there at once; give a force per length."
        )


def refuse_beyond(bed: LineBed, half_width: Array) -> None:
    """Refuse half-widths ``(m,)`` [m] beyond the profile."""
    end = min(bed.reach, bed.rim)
    beyond = half_width > end
    if beyond.any():
        wall = "the rim of the body" if bed.rim <= bed.reach else "the reach of the profile"
        raise OutsideValidity(
            f"half-width {half_width[beyond][0]:.6g} m is beyond {wall} ({end:.6g} m); give a smaller one."
        )


def under_force(bed: LineBed, load: Array) -> Array:
    """Return the half-widths [m] under loads per length over E* ``(m,)`` [m], zero without load."""
    known = bed.half_width(load)
    if known is not None:
        return known

    def curve(a: Array) -> tuple[Array, Array]:
        return bed.load_profile(a), bed.load_profile_slope(a)

    return _met(bed, load, bed.load_profile, curve, "force per length")


def borne_at_most(bed: LineBed) -> float:
    """Return the greatest load per length over E* that the profile bears up to its reach or rim [m]."""
    return _most(bed, bed.load_profile, min(bed.reach, bed.rim))


def under_mean_pressure(bed: LineBed, mean: Array) -> Array:
    """Return the half-widths [m] at which the mean pressure over E* is given ``(m,)``."""
    if float(bed.slope(np.zeros(1))[0]) != 0.0:
        raise InvalidInput(
            "LineIndentation: the mean pressure under a sharp tip does not begin at zero and does not determine the "
            "half-width; give LineForce(force_per_length) or HalfWidth(half_width)."
        )

    def level(a: Array) -> Array:
        return np.asarray(0.5 * bed.load_profile(a) / a)

    def curve(a: Array) -> tuple[Array, Array]:
        return level(a), 0.5 * bed.load_profile_slope(a) / a - level(a) / a

    return _met(bed, mean, level, curve, "mean pressure")


def _met(bed: LineBed, target: Array, level: Level, curve: Curve, what: str) -> Array:
    end, half_width = min(bed.reach, bed.rim), np.zeros(target.shape)
    pressed = target > 0.0
    if not pressed.any():
        return half_width
    most = _most(bed, level, end)
    pinned = pressed & (target >= most) if bed.rim <= bed.reach else np.zeros(target.shape, dtype=bool)
    if (pressed & ~pinned & (target > most)).any():
        raise OutsideValidity(
            f"The {what} leads beyond the reach of the profile ({end:.6g} m), where nothing is known of it; press with "
            f"at most {most / float(np.max(target)):.6g} times the greatest one given."
        )
    half_width[pinned] = end
    free = pressed & ~pinned
    if free.any():
        wanted, flat = target[free], bed.flat
        if bed.profile.rising:
            guesses = _interpolated(bed, level, wanted)
            half_width[free] = invert(curve, wanted, lower=flat, upper=end, guess=guesses)
        else:
            half_width[free] = _first(bed, level, wanted)
    return half_width


def _most(bed: LineBed, level: Level, end: float) -> float:
    """Return what the profile bears at most; infinite if it has no end, or grows without bound towards it."""
    if not np.isfinite(end) or (end < bed.rim and end > MOST_TRIALS * bed.trial):
        return np.inf
    try:
        with np.errstate(all="ignore"):
            last = float(level(np.array([end]))[0])
    except NotConverged:
        last = np.inf
    if not np.isfinite(last):
        if not _is_vertical(bed, end):
            raise NotConverged(
                f"what the profile carries at its end, {end:.6g} m, does not settle; state its kinks, or end it before."
            )
        last = _before_vertical(level, end)
    if bed.profile.rising:
        return last
    return max(last, float(np.max(level(np.linspace(bed.flat, end, SAMPLES)[1:-1]))))


def _is_vertical(bed: LineBed, end: float) -> bool:
    with np.errstate(all="ignore"):
        return not np.isfinite(float(bed.slope(np.array([end]))[0]))


def _before_vertical(level: Level, end: float) -> float:
    """Return the level just before a vertical end; infinite where it grows as much with each step towards it."""
    found = []
    for part in VERTICAL:
        try:
            found.append(float(level(np.array([end * (1.0 - part)]))[0]))
        except NotConverged:
            break
    if len(found) < len(VERTICAL) - 1:
        raise NotConverged(
            f"the load near the end of the profile, {end:.6g} m, does not settle; state its kinks, or end it before."
        )
    growth = np.diff(found)
    return np.inf if growth[-1] > LOGARITHMIC * growth[-2] else found[-1]


def _interpolated(bed: LineBed, level: Level, target: Array) -> Array:
    """Return half-widths near to those that meet all targets, by interpolation between powers."""
    flat, end = bed.flat, min(bed.reach, bed.rim)
    near = far = _guess(bed, level, float(np.max(target))) - flat
    for _ in range(MOST_STEPS):
        if float(level(np.array([flat + near]))[0]) <= np.min(target):
            break
        near *= STEP
    for _ in range(MOST_STEPS):
        if float(level(np.array([flat + far]))[0]) >= np.max(target):
            break
        far = min(far * bed.search_step, 0.5 * (end - flat + far))
    # ratios to the farthest and the greatest: they are the same numbers in all units
    ratios = np.geomspace(near / far, 1.0, INTERPOLATED if np.isinf(bed.trial) else INTERPOLATED_ON_LAYERS)
    greatest = float(np.max(target))
    with np.errstate(divide="ignore"):
        below = np.log(level(flat + far * ratios) / greatest)
    found = np.isfinite(below)
    if not found.any():
        return np.full(target.shape, flat + far)
    return np.asarray(flat + far * np.exp(np.interp(np.log(target / greatest), below[found], np.log(ratios[found]))))


def _guess(bed: LineBed, level: Level, target: float) -> float:
    """Return a half-width of the order of the lengths of body and load, where a search begins."""
    flat, end = bed.flat, min(bed.reach, bed.rim)
    if np.isfinite(bed.trial):
        return flat + min(bed.trial, 0.02 * (end - flat))
    if np.isfinite(end):
        return flat + 0.02 * (end - flat)
    if flat > 0.0:
        return 2.0 * flat
    # a power of two, to begin with the same number in all units
    return 0.02 * bed.size if np.isfinite(bed.size) else 2.0 ** round(math.log2(rough_root(level, target)))


def _first(bed: LineBed, level: Level, target: Array) -> Array:
    """Return the first half-widths at which a level is met that may fall again."""
    most, flat, end = float(np.max(target)), bed.flat, min(bed.reach, bed.rim)
    if np.isfinite(end) and _is_vertical(bed, end):
        end *= 1.0 - VERTICAL[-1]
    top = min(end, _guess(bed, level, most), *_wavelengths(bed.profile))
    samples = SAMPLES if np.isinf(bed.trial) else SAMPLES_ON_LAYERS
    while top < end and _highest(level, np.linspace(flat, top, samples)[1:]) < most:
        if top > MOST_TRIALS * bed.trial:
            raise OutsideValidity(
                f"The load is not reached up to a half-width of {top:.6g} m, {0.5 * top / bed.trial:.3g} times the "
                "thickness of the uppermost layer; no wider strip is sought where the load may fall: press less, "
                "or give a profile that rises."
            )
        top = min(2.0 * top, end)
    places = np.linspace(flat, top, samples)[1:]
    levels = np.append(0.0, level(places))
    places = np.append(flat, places)
    after = np.argmax(levels[None, :] >= target[:, None], axis=1)
    low, high = places[after - 1], places[after]
    low = np.where(low > 0.0, low, 1e-9 * high)
    return between(lambda a, index: level(a) - target[index], low, high)


def refuse_unless_strips(bed: LineBed, half_width: Array, beside: float = WIDTHS_BESIDE) -> None:
    """Refuse contacts that pull inside or overlap outside.

    Parameters
    ----------
    bed : LineBed
    half_width : ndarray, (m,)
        a [m].
    beside : float, optional
        How many half-widths beside the contact are examined for overlap.
    """
    touching = np.unique(half_width[half_width > 0.0])
    if bed.single or touching.size == 0:
        return
    _refuse_far_crests(bed, touching, beside)
    if bed.punches_push and grows(bed, beside * touching[-1]):
        return
    for one in bed.examined(touching):
        _refuse_unless_strip(bed, float(one), beside)


def grows(bed: LineBed, end: float) -> bool:
    """Return whether w never falls up to a place [m]: then no contact pulls or overlaps."""
    growth = bed.load_profile_slope(np.linspace(0.0, min(bed.reach, bed.rim, end), SAMPLES)[1:-1])
    return bool(np.min(growth) >= -ROUNDING * np.max(np.abs(growth)))


def _refuse_far_crests(bed: LineBed, half_width: Array, beside: float) -> None:
    """Refuse overlap at the crests of waves too far away for the search beside the contact; half-widths ascend."""
    end = min(bed.reach, bed.rim)
    for crest in sorted(n * length for length in _wavelengths(bed.profile) for n in range(1, CRESTS + 1)):
        narrow = half_width[beside * half_width < crest]
        if narrow.size == 0 or crest > end:
            continue
        a = float(narrow[-1])  # under a greater load the distance at a place outside is smaller
        ends = np.geomspace(a, crest, SAMPLES)
        x = np.sqrt(ends[1:] * ends[:-1])
        sunk = float(np.sum((bed.slope(x) - bed.opening(x, a)) * np.diff(ends)))
        rise = float(np.diff(bed.profile.height(np.array([a, crest])))[0])
        if rise < (1.0 - SUNK_ERROR) * sunk:
            raise OutsideValidity(
                f"Beside a strip of the half-width {a:.6g} m the surfaces would overlap at {crest:.6g} m, at another "
                "crest: they touch in several strips; give a smoother profile, PeriodicIndentation for equal crests, "
                "or LineProfileContact."
            )


def _highest(level: Level, places: Array) -> float:
    """Return the greatest level; the last place, the most costly one, is refused before others are computed."""
    return max(float(level(places[-1:])[0]), float(np.max(level(places))))


def _wavelengths(profile: Profile) -> set[float]:
    match profile:
        case Sum(parts=parts):
            return set().union(*map(_wavelengths, parts))
        case Wavy(wavelength=length):
            return {length}
    return set()


def _refuse_unless_strip(bed: LineBed, half_width: float, beside: float) -> None:
    inside = half_width * np.linspace(0.0, 1.0, PRESSURE_SAMPLES)[1:-1]
    pressure = bed.pressure(inside, half_width, 0.0)
    if np.min(pressure) < -ROUNDING * np.max(np.abs(pressure)):
        raise OutsideValidity(
            f"A strip of the half-width {half_width:.6g} m would pull at {inside[np.argmin(pressure)]:.6g} m: the "
            "contact has parted into several; press harder, give a smoother profile, or use LineProfileContact."
        )
    outside, opened = bed.gaps(half_width, min(bed.reach, bed.rim, beside * half_width))
    if np.min(opened) < -ROUNDING * np.max(np.abs(opened)):
        raise OutsideValidity(
            f"Beside a strip of the half-width {half_width:.6g} m the surfaces would overlap at "
            f"{outside[np.argmin(opened)]:.6g} m: they touch in several strips; press harder, or give a smoother "
            "profile."
        )
