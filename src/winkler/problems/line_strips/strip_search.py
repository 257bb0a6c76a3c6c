"""The search for the strips in which a section touches a half-plane, layers or a power law under one load.

Boundary elements on an even grid find which places touch.  From their edges the strips of smooth sections are refined
(`winkler.numerics.surfaces.refined_strips`) and examined; where that fails on finer grids too, and for measured
points, the elements themselves are the result, beside what half as many would have given.
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple, cast

import numpy as np

from winkler.numerics.fields.strips_below import Below
from winkler.numerics.pixels.power_law import PowerLawSurface
from winkler.numerics.surfaces.found_strips import ElementStrips, FoundStrips, RefinedStrips, runs
from winkler.numerics.surfaces.pressed_line import PressedLine, press_line
from winkler.numerics.surfaces.refined_strips import examined, refined
from winkler.numerics.surfaces.strip_elements import power_compliance
from winkler.numerics.surfaces.strip_equations import LineCurve, Spots
from winkler.numerics.transforms.cosine_transform import WaveResponse
from winkler.numerics.types import Array
from winkler.profiles.sections.section import Section
from winkler.values.errors import NotConverged, OutsideValidity

MOST_PLACES, FINER = 20000, 4
"""Places of the finest grid on which a refinement is begun, and how much finer each is."""
WIDENINGS, WIDER = 60, 1.0
"""How often a window is widened at whose end bodies touch, and by how much of itself."""
ZOOMS, FILLED = 8, 0.35
"""How often a smooth section is taken closer, up to which part of the window is filled."""
ALLOWED = 1e-8
"""Tension, overlap and what may be left of the equations, each over its scale."""
WALL_ROUNDS = 6


class Pushed(NamedTuple):
    """One load.

    Parameters
    ----------
    modulus
        E* [Pa].
    force
        P [N/m], positive.
    tilt
        theta; what it is begun with if the line of action is given.
    action
        Place of the line of action [m]; NaN if the tilt is prescribed.
    elements
        Places of the first grid.
    response
        Of the layers to pressures, or the power law of the moduli; none of a half-plane.
    """

    modulus: float
    force: float
    tilt: float
    action: float
    elements: int
    response: WaveResponse | PowerLawSurface | None = None

    def below(self, unit: float) -> Below | PowerLawSurface | None:
        """Return the layers or the power law, for lengths over a unit [m]."""
        if isinstance(self.response, PowerLawSurface):
            return self.response.in_units_of(unit)
        return None if self.response is None else Below(self.response, unit)


class _OnGrid(NamedTuple):
    places: Array
    pressed: PressedLine


@functools.lru_cache(maxsize=64)
def find_strips(section: Section, load: Pushed) -> FoundStrips:
    """Return the strips.

    Raises
    ------
    OutsideValidity
        If the contact reaches the end of what is known of the section.
    NotConverged
        If the elements in contact are not found.
    """
    seen = [_first_grid(section, load)]
    if section.smooth:
        for _ in range(ZOOMS):
            closer = _closer(section, load, seen[-1])
            if closer is None:
                break
            seen.append(closer)
        checked = np.concatenate([grid.places for grid in seen])
        count = load.elements
        fine = seen[-1]
        while _refines(load):
            found = _refined(section, load, fine, checked)
            if found is not None:
                return found
            count *= FINER
            if count > MOST_PLACES:
                break
            x = np.linspace(fine.places[0], fine.places[-1], count)
            fine = _OnGrid(x, _press(section, load, x))
    return _elements(section, load, seen[-1])


def _refines(load: Pushed) -> bool:
    """Return whether strips may be refined: not on gradings, whose kernels are no logarithm of the half-plane."""
    if isinstance(load.response, PowerLawSurface):
        return False
    return load.response is None or load.response.smooth == load.response.length


def _press(section: Section, load: Pushed, x: Array) -> PressedLine:
    """Return the elements, in lengths over the window."""
    unit, middle = float(x[-1] - x[0]), 0.5 * float(x[0] + x[-1])
    f = np.asarray(section.height(x))
    if section.pads:
        rounding = 1e-12 * unit
        inside = np.any([(x >= a - rounding) & (x <= b + rounding) for a, b in section.pads], axis=0)
        f = np.where(inside, f, np.inf)
    force = 2.0 * load.force / (load.modulus * unit)
    free = not math.isnan(load.action)
    moment = force * (load.action - middle) / unit if free else math.nan
    tilt = 0.0 if free else load.tilt
    pressed = press_line((x - middle) / unit, f / unit, force, tilt=tilt, moment=moment, below=load.below(unit))
    return pressed._replace(gap=unit * pressed.gap)


def _first_grid(section: Section, load: Pushed) -> _OnGrid:
    start, end = section.window(load.force / load.modulus)
    if math.isfinite(load.action):
        beside = 0.5 * (end - start)
        start = max(section.start, min(start, load.action - beside))
        end = min(section.end, max(end, load.action + beside))
    for _ in range(WIDENINGS):
        x = section.grid(start, end, load.elements)
        pressed = _press(section, load, x)
        bears = pressed.pressure > 0.0
        at_start = bool(bears[0]) and not section.pads
        at_end = bool(bears[-1]) and not section.pads
        if not (at_start or at_end):
            return _OnGrid(x, pressed)
        for reached, known in ((at_start, section.start), (at_end, section.end)):
            if reached and math.isfinite(known):
                raise OutsideValidity(
                    f"LineProfileContact: under {load.force:.6g} N/m the contact reaches the end of the section at "
                    f"{known:.6g} m, beyond which nothing is known of it; give a wider section, or press less."
                )
        width = WIDER * (end - start)
        start, end = start - width * at_start, end + width * at_end
    raise NotConverged("LineProfileContact: the contact has no end; give a section whose height rises on both sides.")


def _closer(section: Section, load: Pushed, grid: _OnGrid) -> _OnGrid | None:
    """Return the elements on the part of the window that touches, or nothing where it fills the window."""
    x, bears = grid.places, np.flatnonzero(grid.pressed.pressure > 0.0)
    spacing = (x[-1] - x[0]) / (x.size - 1)
    first, last = float(x[bears[0]]) - spacing, float(x[bears[-1]]) + spacing
    if last - first > FILLED * (x[-1] - x[0]):
        return None
    beside = 0.5 * (last - first)
    closer = np.linspace(max(first - beside, float(x[0])), min(last + beside, float(x[-1])), load.elements)
    try:
        pressed = _press(section, load, closer)
    except NotConverged:
        return None
    inner = pressed.pressure > 0.0
    cut = (inner[0] and closer[0] > x[0]) or (inner[-1] and closer[-1] < x[-1])
    return None if cut else _OnGrid(closer, pressed)


def _guess(section: Section, grid: _OnGrid) -> tuple[Array, Array]:
    """Return edges [m] and whether they are walls, from elements that touch."""
    x, bears = grid.places, grid.pressed.pressure > 0.0
    half = 0.5 * float(x[-1] - x[0]) / (x.size - 1)
    edges, pinned = [], []
    for low, high in section.pads or ((-math.inf, math.inf),):
        for i, j in runs(bears & (x >= low - half) & (x <= high + half)):
            first, last = float(x[i]) - half, float(x[j]) + half
            held = first - half <= low, last + half >= high
            valleys = [place for place, jump, _ in section.breaks if jump < 0.0 and first < place < last]
            beside = [side for place in valleys for side in (place - 0.2 * half, place + 0.2 * half)]
            ends = [low if held[0] else first, *beside, high if held[1] else last]
            edges += [[ends[k], ends[k + 1]] for k in range(0, len(ends), 2)]
            walls = [held[0], *(False for _ in beside), held[1]]
            pinned += [(walls[k], walls[k + 1]) for k in range(0, len(ends), 2)]
    return np.array(edges), np.array(pinned, dtype=bool)


def _refined(section: Section, load: Pushed, grid: _OnGrid, checked: Array) -> RefinedStrips | None:
    """Return refined strips, or nothing where they are not found or pull, overlap or leave something."""
    edges, pinned = _guess(section, grid)
    origin, unit = 0.5 * float(edges[0, 0] + edges[-1, 1]), 0.5 * float(edges[-1, 1] - edges[0, 0])
    curve = _curve(section, origin, unit)._replace(below=cast(Below | None, load.below(unit)))
    force = 2.0 * load.force / (load.modulus * unit)
    moment = force * (load.action - origin) / unit
    places = (checked - origin) / unit
    if section.pads:
        inside = np.any([(checked >= low) & (checked <= high) for low, high in section.pads], axis=0)
        places = places[inside]
    ends = (edges - origin) / unit
    try:
        for _ in range(WALL_ROUNDS):
            spots = refined(curve, ends, pinned, force, tilt=grid.pressed.tilt, moment=moment)
            ends = np.array([[strip.start, strip.end] for strip in spots.strips])
            changed = _walls(section, spots, origin, unit)
            if changed is None:
                break
            ends, pinned = changed
        else:
            return None
    except NotConverged:
        return None
    error = float(max(examined(curve, spots, places)))
    return RefinedStrips(load.modulus, origin, unit, curve, spots, error) if error <= ALLOWED else None


def _walls(section: Section, spots: Spots, origin: float, unit: float) -> tuple[Array, Array] | None:
    """Return edges and whether they are walls where that must change: walls that pull, edges beyond the body."""
    if not section.pads:
        return None
    pads = (np.array(section.pads) - origin) / unit
    ends = np.array([[strip.start, strip.end] for strip in spots.strips])
    pinned, changed = spots.pinned.copy(), False
    for j, strip in enumerate(spots.strips):
        pad = pads[np.argmin(np.abs(pads.mean(axis=1) - strip.middle))]
        pad = next((one for one in pads if one[0] <= strip.middle <= one[1]), pad)
        for side, sign in ((0, -1.0), (1, 1.0)):
            if pinned[j, side] and strip.walls[0] + sign * strip.walls[1] < 0.0:
                pinned[j, side], changed = False, True
                ends[j, side] -= sign * 0.02 * strip.half
            elif not pinned[j, side] and sign * (ends[j, side] - pad[side]) > 0.0:
                pinned[j, side], ends[j, side], changed = True, pad[side], True
    return (ends, pinned) if changed else None


def _curve(section: Section, origin: float, unit: float) -> LineCurve:
    breaks = np.array(section.breaks).reshape(-1, 3)
    scaled = np.stack([(breaks[:, 0] - origin) / unit, breaks[:, 1], breaks[:, 2] * unit], axis=1)
    return LineCurve(
        lambda x: np.asarray(section.height(origin + unit * x)) / unit,
        lambda x: np.asarray(section.slope(origin + unit * x)),
        scaled,
    )


def _elements(section: Section, load: Pushed, grid: _OnGrid) -> ElementStrips:
    """Return the elements, compared with half as many."""
    half = grid.places[::2]
    error = math.inf
    try:
        coarse, fine = _press(section, load, half).pressure, grid.pressed.pressure
        length = 2.0 * np.count_nonzero(coarse > 0.0) / np.count_nonzero(fine > 0.0)
        error = max(abs(length - 1.0), abs(float(np.max(coarse) / np.max(fine)) - 1.0))
        # counted elements may change by none: each strip is as long as so many elements, give or take one; on a
        # grading, where they are the result for smooth sections, too, one at each edge
        missed = 1.0 if _refines(load) else 2.0
        error = max(error, missed * len(runs(fine > 0.0)) / int(np.count_nonzero(fine > 0.0)))
    except NotConverged:
        pass
    return ElementStrips(
        load.modulus, grid.places, grid.pressed, error, functools.partial(_beyond, section, load, grid)
    )


def _beyond(section: Section, load: Pushed, grid: _OnGrid, x: Array) -> Array:
    """Return the distance of the deformed surfaces [m] at places beyond a grid, where elements are as line loads."""
    ends, bears = grid.places[[0, -1]], grid.pressed.pressure > 0.0
    unit, loads = float(ends[1] - ends[0]), grid.pressed.pressure[bears] / (grid.places.size - 1)
    places, below = grid.places[bears] / unit, load.below(unit)

    def height(at: Array) -> Array:
        if isinstance(below, PowerLawSurface):
            sunk = power_compliance(below, at[:, None] / unit - places)
        else:
            sunk = -np.log(np.abs(at[:, None] / unit - places)) / math.pi
            sunk = sunk if below is None else sunk + below.raised(at / unit, places)
        return np.asarray(section.height(at) - grid.pressed.tilt * at + unit * (sunk @ loads))

    start = height(ends) - grid.pressed.gap[[0, -1]]
    return np.asarray(height(x) - np.where(x < ends[0], start[0], start[1]))
