"""How far the upper body goes down under a force, and the pressures on every place of contact."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.media.mapped import MappedMedium, layers_of
from winkler.media.offers import PowerOfDepth, offers
from winkler.numerics.surfaces.pressed_box import ByDepth
from winkler.numerics.surfaces.pressed_grid import press
from winkler.numerics.types import Array
from winkler.problems.profile_pair.gap_map import GapMap, windows
from winkler.problems.profile_pair.placing import PlacedBody, Placing
from winkler.values.errors import NotConverged, OutsideValidity

ROUNDS = 3
"""How often windows that are far from each other are solved again with what the others sink them."""
MOST_TRIALS = 30
FORCE_TOLERANCE = 1e-7
HERTZ_POWER, LEAST_POWER = 1.5, 0.3
"""Power of the drop by which the force rises: the first guess, and the least that is believed."""
MOST_CHANGE = 2.0
"""Of the logarithm of the drop in one trial."""
COARSE_PIXELS, COARSE_TOLERANCE = 32, 1e-3
"""Pixels along a side, and error of the force, of the first search."""
BESIDE = 4.0
"""Gap that stands for none, over the overlap: beside the bodies nothing touches."""


class Region(NamedTuple):
    """A window of the lower surface with its pressures.

    Parameters
    ----------
    gaps
        Along the normals.
    overlap
        The greatest one along a normal [m], less what other windows sink this one.
    pressure
        [Pa], of the pixels of the gaps.
    """

    gaps: GapMap
    overlap: float
    pressure: Array

    @property
    def force(self) -> Array:
        """What presses the upper body, across and up [N]."""
        return np.asarray(self.gaps.normal @ self.pressure.sum(axis=0) * self.gaps.pixel[0] * self.gaps.pixel[1])

    def reaches_end(self) -> bool:
        """Return whether the contact reaches the end of a profile, or of the window."""
        from scipy.ndimage import binary_dilation

        p = self.pressure > 0.0
        beside = binary_dilation(p) & np.isinf(self.gaps.gap)
        return bool(beside.any() or p[0].any() or p[-1].any() or p[:, 0].any() or p[:, -1].any())


class PressedWindows(NamedTuple):
    """Two bodies that are pressed together.

    Parameters
    ----------
    drop
        How far the upper body went down since first touch [m].
    regions
        Where the bodies touch.
    """

    drop: float
    regions: tuple[Region, ...]

    @property
    def force(self) -> Array:
        """What presses the upper body, across and up [N]."""
        return np.asarray(np.sum([region.force for region in self.regions], axis=0))


def change_of(coarse: PressedWindows, fine: PressedWindows) -> float:
    """Return the greatest relative change of force and greatest pressure."""
    peaks = [max(float(np.max(region.pressure)) for region in pair.regions) for pair in (coarse, fine)]
    return max(abs(peaks[0] / peaks[1] - 1.0), abs(float(coarse.force[1] / fine.force[1]) - 1.0))


def heights_of(gaps: GapMap) -> tuple[Array, float]:
    """Return heights of a map (negative gaps, finite everywhere), and the overlap [m]."""
    overlap = -float(np.min(gaps.gap))
    most = float(np.max(gaps.gap[np.isfinite(gaps.gap)]))
    return -np.where(np.isfinite(gaps.gap), gaps.gap, most + BESIDE * max(overlap, 0.0)), overlap


def pressed_by_drop(
    lower: PlacedBody,
    upper: PlacedBody,
    placing: Placing,
    drop: float,
    medium: MappedMedium,
    pixels: int,
    tolerance: float,
) -> PressedWindows:
    """Return the pair with the upper body let down by `drop` [m] since first touch.

    Parameters
    ----------
    lower, upper : PlacedBody
    placing : Placing
        Of both.
    drop : float
        [m].
    medium : HomogeneousMedium, CoatedHalfSpace, SlidingFilm, StackedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
        Both bodies.
    pixels : int
        Along a side of each window.
    tolerance : float
        As of `winkler.numerics.surfaces.pressed_grid.press`.

    Raises
    ------
    OutsideValidity
        If the bodies overlap nowhere, or farther than they reach.
    """
    touch = float(np.nanmin(placing.gap))
    down = upper.raised(-touch - drop)
    maps = [GapMap.of(lower, down, window, (pixels, pixels)) for window in windows(lower, down, placing, touch + drop)]
    if not all(np.any(np.isfinite(gaps.gap)) for gaps in maps):
        raise OutsideValidity(
            f"ProfilePair: let down by {drop:.3g} m since first touch one body goes through the other; give a smaller "
            "load, or check its unit and those of the moduli."
        )
    regions = [_pressed(gaps, np.zeros(1), medium, tolerance) for gaps in maps]
    for _ in range(ROUNDS if len(maps) > 1 else 0):
        regions = [
            _pressed(
                gaps, _sunk(gaps, [other for other in regions if other.gaps is not gaps], medium), medium, tolerance
            )
            for gaps in maps
        ]
    found = tuple(region for region in regions if np.any(region.pressure))
    if not found:
        raise OutsideValidity(
            f"ProfilePair: let down by {drop:.3g} m since first touch the bodies do not overlap in any pixel: heights "
            "of the profiles are not known so well; give a greater load, or check its unit and those of the moduli."
        )
    return PressedWindows(drop, found)


def _pressed(gaps: GapMap, sunk: Array, medium: MappedMedium, tolerance: float) -> Region:
    """Return a window with its pressures; without any where the bodies are apart."""
    heights, overlap = heights_of(gaps._replace(gap=gaps.gap + sunk))
    if overlap <= 0.0:
        return Region(gaps, 0.0, np.zeros(gaps.gap.shape))
    lowered, layers = float(np.max(heights)) - heights, layers_of(medium)
    try:
        solved = press(lowered, gaps.pixel, ByDepth(overlap), periodic=False, tolerance=tolerance, layers=layers)
    except OutsideValidity as error:
        raise OutsideValidity(f"ProfilePair: {error}") from None
    return Region(gaps, overlap, medium.modulus * solved.pressure)


def _sunk(gaps: GapMap, others: list[Region], medium: MappedMedium) -> Array:
    """Return how far the forces of other windows open the gap of this one, as forces at points [m]."""
    opened, layers = np.zeros(gaps.gap.shape), layers_of(medium)
    if offers(medium, PowerOfDepth):
        raise OutsideValidity(
            "ProfilePair: the bodies touch in places far from each other; how a force sinks places far away is known "
            "for layers and homogeneous bodies, not for power laws: give a DepthGradedHalfSpace, or another load."
        )
    for other in others:
        whole = float(np.sum(other.pressure))
        if whole == 0.0:
            continue
        along, across = other.pressure.sum(axis=1) / whole, other.pressure.sum(axis=0) / whole
        x, y, z = float(along @ other.gaps.x), float(across @ other.gaps.y), float(across @ other.gaps.z)
        far = np.sqrt((gaps.x[:, None] - x) ** 2 + (gaps.y - y) ** 2 + (gaps.z - z) ** 2)
        share = layers.whole(1.0 / far) if layers else 1.0  # of layers what waves as long as the distance feel
        opened += np.maximum(other.force @ gaps.normal, 0.0) * share / (math.pi * medium.modulus * far)
    return opened


def pressed_by_force(
    lower: PlacedBody,
    upper: PlacedBody,
    placing: Placing,
    force: float,
    medium: MappedMedium,
    pixels: int,
    tolerance: float,
) -> PressedWindows:
    """Return the pair under a force upwards on the upper body; parameters as of `pressed_by_drop`.

    Raises
    ------
    OutsideValidity
        As of `pressed_by_drop`.
    NotConverged
        If the force is not found.
    """
    lowest = int(np.nanargmin(placing.gap))
    radius = 1.0 / float(placing.bending[lowest])
    drop = radius * (0.75 * force / (medium.modulus * radius**2)) ** (2.0 / 3.0)  # that of a ball
    coarse = _found(lower, upper, placing, force, medium, drop, min(COARSE_PIXELS, pixels), 1e-4, COARSE_TOLERANCE)
    return _found(lower, upper, placing, force, medium, coarse.drop, pixels, tolerance, FORCE_TOLERANCE)


def _found(
    lower: PlacedBody,
    upper: PlacedBody,
    placing: Placing,
    force: float,
    medium: MappedMedium,
    drop: float,
    pixels: int,
    tolerance: float,
    exactness: float,
) -> PressedWindows:
    """Return the pair at the drop where the forces agree, by secants between logarithms."""
    before: tuple[float, float] | None = None
    power = HERTZ_POWER
    for _ in range(MOST_TRIALS):
        pair = pressed_by_drop(lower, upper, placing, drop, medium, pixels, tolerance)
        over = math.log(float(pair.force[1]) / force)
        if abs(over) <= exactness:
            return pair
        if before is not None and before[0] != drop:
            rise = (over - before[1]) / math.log(drop / before[0])
            power = rise if rise > LEAST_POWER else power
        before = drop, over
        drop *= math.exp(-min(max(over / power, -MOST_CHANGE), MOST_CHANGE))
    raise NotConverged(
        f"ProfilePair: the drop under {force:.6g} N is not found within {MOST_TRIALS} trials; the profiles are rough, "
        "or end within the contact: smooth them, or give longer ones."
    )
