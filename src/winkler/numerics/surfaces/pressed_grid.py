r"""A rigid height map pressed into an elastic half-space, without friction and adhesion, on a grid.

Pressures p >= 0 and gaps w = u + h - d >= 0 are sought of which one is zero in every pixel.  They are the minimum of
p G p / 2 + p (h - d) over p >= 0, found by conjugate gradients on the pixels in contact.  The operator smooths like
1/\|q\|; preconditioned with \|q\| the number of iterations hardly depends on the grid, and begun from the solution on
a grid of half as many pixels it takes about ten.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.arrays import cast, given, namespace_of, to_numpy
from winkler.numerics.pixels.layered import SurfaceBelow
from winkler.numerics.plates.plate_contact import PlateContact
from winkler.numerics.plates.pressed_sums import overlap_and_work, shared, unsettled
from winkler.numerics.surfaces.pressed_box import BoxContact, ByDepth, ByLoad, box_around
from winkler.numerics.surfaces.surface_grid import DOUBLE, SINGLE, SurfaceGrid
from winkler.values.errors import NotConverged, OutsideValidity

COARSEST_PIXELS = 32
"""Grids of fewer pixels along a side are not halved any more."""
COARSE_TOLERANCE = 1e-3
"""To what the coarser grids are solved."""
LARGEST_DEPTH_RATIO = 0.99
"""Coarse periodic grids are not pressed deeper than this part of the depth that closes them."""
FIRST_CONTACT_RATIO = 0.01
"""Part of the pixels, the highest ones, under which a load begins."""
MOST_ROUNDS = 20
"""How often the whole surface is checked before it has not converged; two are usual."""
SINGLE_DIGITS_CONTRAST, CONTRAST_WAVES = 1e2, 40
"""Ratio of 1 + M among these many waves up to which single digits are enough."""
SINGLE_DIGITS_TOLERANCE = 1e-5
"""To what pressures and gaps may be solved in single digits; what they leave is then found anew in double ones."""
SINGLE_DIGITS_REACH = 1e12
"""Greatest gap, over about the depth, whose square single digits hold in sums over all pixels."""
INNER_RATIO = 0.6
"""Part of the tolerance to which the box around the contact is solved, and then to less."""


class PressedSurface(NamedTuple):
    """The pressed surface.

    Parameters
    ----------
    pressure
        p / E*, (nx, ny).
    gap
        w [m], (nx, ny).
    depth
        d [m].
    penetration
        Greatest overlap that is left, over d.
    work
        Sum of p |w| over the sum of p d: zero if pressed pixels touch, and only they.
    iterations
        On the finest grid.
    """

    pressure: Any
    gap: Any
    depth: float
    penetration: float
    work: float
    iterations: int


class _Surface(NamedTuple):
    """What a grid is made on: the size of its pixels, whether it is periodic, what lies below, and what above."""

    pixel: tuple[float, float]
    periodic: bool
    layers: SurfaceBelow | None
    film: float

    def grid(self, shape: tuple[int, ...], digits: np.dtype[np.floating] = DOUBLE) -> SurfaceGrid:
        """Return the grid of this shape."""
        size = shape[0], shape[1]
        bare = SurfaceGrid.of(size, self.pixel, periodic=self.periodic, digits=digits, layers=self.layers)
        return bare.filmed(self.film)

    def rough_grid(self, whole: SurfaceGrid, shape: tuple[int, ...]) -> SurfaceGrid:
        """Return the grid for changes of pressures, whose digits suffice for the contrast of the layers."""
        digits = self._rough_digits(shape)
        return whole.in_digits(digits) if whole.shape == shape else self.grid(shape, digits)

    def _rough_digits(self, shape: tuple[int, ...]) -> np.dtype[np.floating]:
        if not self.layers:
            return SINGLE
        longest = max(n * side for n, side in zip(shape, self.pixel, strict=True))
        waves = 2.0 * np.pi * np.geomspace(1.0 / longest, 0.5 / min(self.pixel), CONTRAST_WAVES)
        whole = self.layers.whole(waves)
        return SINGLE if float(np.max(whole) / np.min(whole)) < SINGLE_DIGITS_CONTRAST else DOUBLE

    @property
    def coarser(self) -> _Surface:
        """The same in pixels of twice the size."""
        return self._replace(pixel=(2.0 * self.pixel[0], 2.0 * self.pixel[1]))


def _halved(heights: Any) -> Any:
    """Return means over two by two pixels."""
    nx, ny = 2 * (heights.shape[0] // 2), 2 * (heights.shape[1] // 2)
    rows = heights[:nx:2, :ny] + heights[1:nx:2, :ny]
    return 0.25 * (rows[:, ::2] + rows[:, 1::2])


def _doubled(pressure: Any, shape: tuple[int, ...]) -> Any:
    """Return the pressure on a grid of half the pixel size, straight between the centres, under what bears."""
    xp = namespace_of(pressure)
    fine, kept = pressure, cast(pressure > 0.0, pressure.dtype)
    for axis in (0, 1):
        fine, kept = (_stretched(xp, each, shape[axis], axis, share) for each, share in ((fine, 0.25), (kept, 0.0)))
    fine *= kept
    return fine


def _stretched(xp: Any, numbers: Any, length: int, axis: int, share: float) -> Any:
    """Return twice as many numbers along an axis, each with a share of the next one; the last for one that lacks."""
    along = (slice(None),) * axis

    def part(*ends: int | None) -> Any:
        return numbers[(*along, slice(*ends), ...)]

    near, first, last = (1.0 - share) * numbers, part(None, 1), part(-1, None)
    behind, ahead = (share * xp.concat(both, axis=axis) for both in ((first, part(None, -1)), (part(1, None), last)))
    size = tuple(length if i == axis else n for i, n in enumerate(numbers.shape))
    fine = xp.zeros(size, dtype=numbers.dtype, device=numbers.device)
    pairs = 2 * numbers.shape[axis]
    fine[(*along, slice(0, pairs, 2), ...)] = near + behind
    fine[(*along, slice(1, pairs, 2), ...)] = near + ahead
    if length > pairs:
        fine[(*along, slice(pairs, None), ...)] = fine[(*along, slice(pairs - 1, pairs), ...)]
    return fine


def press(
    heights: Any,
    pixel: tuple[float, float],
    drive: ByDepth | ByLoad,
    *,
    periodic: bool,
    ceiling: float = math.inf,
    tolerance: float = 1e-6,
    start: Any = (),
    layers: SurfaceBelow | None = None,
    film: float = 0.0,
) -> PressedSurface:
    """Solve the contact.

    Parameters
    ----------
    heights
        h [m] of the undeformed gap over the point from which depths count, (nx, ny), not negative; an array of numpy,
        or of another library of the array API, where everything then is computed.
    pixel
        (dx, dy) [m].
    drive
        What is prescribed.
    periodic
        Whether the surface is repeated without end.
    ceiling
        Hardness over E*: pressures do not rise above it.
    tolerance
        Bound on `Pressed.penetration` and `Pressed.work`.
    start
        Pressures of a contact nearby, over E*; nothing to begin on coarser grids.
    layers
        In m, what differs from a homogeneous half-space of this E*; nothing unless given.
    film
        Compliance of a film that yields only where it is pressed: displacement under a pressure of E* [m].

    Raises
    ------
    NotConverged
        If the bounds are not met, or the contrasts of the layers are too large.
    OutsideValidity
        If the pixels are too coarse for the layers.
    """
    # in pixels along the map, and in about the depth across: small and large surfaces are the same to single digits
    patch = pixel[0] * pixel[1]
    match drive:
        case ByDepth(depth):
            unit = depth
            scaled: ByDepth | ByLoad = ByDepth(1.0)
        case ByLoad(load):
            unit = load * math.sqrt(patch / math.prod(heights.shape))
            closed = float(namespace_of(heights).mean(heights)) if periodic else 0.0
            unit = min(unit, closed) if closed > 0.0 else unit  # which is never deeper than closed
            scaled = ByLoad(load * pixel[0] / unit)
    strain = unit / pixel[0]
    begin = start / strain if given(start) else ()
    below = layers.in_units_of(pixel[0]) if layers else None
    surface = _Surface((1.0, pixel[1] / pixel[0]), periodic, below, film / pixel[0])
    pressed = _pressed(heights / unit, surface, scaled, ceiling / strain, tolerance, begin)
    p, gap = pressed.pressure, pressed.gap
    p *= strain
    gap *= unit
    return pressed._replace(pressure=p, gap=gap, depth=unit * pressed.depth)


def _pressed(
    heights: Any,
    surface: _Surface,
    drive: ByDepth | ByLoad,
    ceiling: float,
    tolerance: float,
    start: Any,
) -> PressedSurface:
    """Return the contact: solved where it may be, then checked everywhere, until nothing changes."""
    xp, shape, everywhere = namespace_of(heights), heights.shape, (slice(None), slice(None))
    begun = start if given(start) else _from_coarser(heights, surface, drive, ceiling)
    p = _first(heights, drive, surface.pixel, ceiling, begun)
    del begun, start
    whole, elastic = surface.grid(shape).beside(heights), math.isinf(ceiling)
    depth, count, inner = drive.depth if isinstance(drive, ByDepth) else math.nan, 0, INNER_RATIO * tolerance
    plate = False
    for round_ in range(MOST_ROUNDS):
        gap = whole.displaced(p)
        gap += heights
        if math.isnan(depth) or (elastic and isinstance(drive, ByLoad)):  # which has been brought to the load
            pressing = p > 0.0
            depth = float(xp.sum(xp.where(pressing, gap, 0.0))) / int(xp.count_nonzero(pressing))
        gap -= depth
        left = overlap_and_work(p, gap, depth, ceiling)
        if math.isinf(max(left)):
            raise OverflowError("gaps and pressures leave the range of numbers")
        if max(left) <= tolerance:
            return PressedSurface(p, gap, depth, *left, count)
        box = box_around((p > 0.0) | (gap < 0.0)) if elastic and not surface.periodic else everywhere
        near = float(xp.max(xp.abs(gap))) < SINGLE_DIGITS_REACH
        rough = surface.rough_grid(whole, p[box].shape) if near else surface.grid(p[box].shape)
        grid = rough.beside(heights)
        digits = p.dtype
        if round_ == 0 and elastic and inner >= SINGLE_DIGITS_TOLERANCE and grid.response.dtype == xp.float32:
            digits = xp.float32
        contact = BoxContact(grid, drive, ceiling, cast(p[box], digits), cast(gap[box], digits), depth)
        del gap
        stiff = near and surface.layers is not None and grid.response.dtype == xp.float64
        plated = functools.partial(surface.grid, p[box].shape) if stiff else None
        solved, steps, plate = box_or_plate(contact, plated, ceiling, inner, plate)
        count += steps
        p[box], depth = cast(solved, p.dtype), contact.depth
        inner = inner if digits != p.dtype else max(inner * INNER_RATIO, 1e-15)
        if elastic and isinstance(drive, ByLoad):
            p *= drive.load / float(xp.sum(p))
    raise unsettled(shape, left, f"{MOST_ROUNDS} rounds", tolerance)


def _first(heights: Any, drive: ByDepth | ByLoad, pixel: tuple[float, float], ceiling: float, start: Any) -> Any:
    """Return pressures to begin with, that bear the load."""
    xp = namespace_of(heights)
    begun = given(start) and bool(xp.any(start > 0.0))
    if isinstance(drive, ByDepth):
        sunk = start if begun else xp.clip(drive.depth - heights, 0.0, math.inf) / (max(heights.shape) * max(pixel))
        return xp.clip(sunk, 0.0, ceiling)
    p = start if begun else cast(heights <= _highest(xp, heights), heights.dtype)
    p = p * (drive.load / float(xp.sum(p)))
    return p if float(xp.max(p)) <= ceiling else shared(xp.clip(p, 0.0, ceiling) - heights, ceiling, drive.load)


def _highest(xp: Any, heights: Any) -> float:
    """Return the gap up to which the highest pixels lie, under which a load begins."""
    return float(xp.sort(xp.reshape(heights, (-1,)))[math.floor(FIRST_CONTACT_RATIO * (math.prod(heights.shape) - 1))])


def _from_coarser(heights: Any, surface: _Surface, drive: ByDepth | ByLoad, ceiling: float) -> Any:
    """Return the pressures of a grid of half as many pixels along a side, or nothing where there is none."""
    xp, nothing = namespace_of(heights), ()
    if min(heights.shape) < 2 * COARSEST_PIXELS:
        return nothing
    coarse = _halved(heights)
    lowest = float(xp.min(coarse))
    easier = ByDepth(drive.depth - lowest) if isinstance(drive, ByDepth) else ByLoad(drive.load / 4.0)
    if float(xp.max(coarse)) == lowest:  # a fine grating: its means do not resolve it
        return nothing
    most = float(xp.mean(coarse)) - lowest if surface.periodic else math.inf
    if isinstance(easier, ByDepth) and not 0.0 < easier.depth < LARGEST_DEPTH_RATIO * most:
        return nothing
    try:
        pressed = _pressed(coarse - lowest, surface.coarser, easier, ceiling, COARSE_TOLERANCE, ())
    except (NotConverged, OutsideValidity):  # the coarse grid is only a first guess, or too coarse for the layers
        return nothing
    return _doubled(pressed.pressure, heights.shape)


STEPS_OF_PLATES = 60
"""Steps of conjugate gradients on layers of high contrast, after which Newton's are taken: smooth maps need forty."""


def box_or_plate(
    contact: BoxContact,
    plated: Callable[[], SurfaceGrid] | None,
    ceiling: float,
    tolerance: float,
    plate: bool,
) -> tuple[Any, int, bool]:
    """Solve a contact; return its pressures, the number of steps, and whether Newton's were needed.

    Parameters
    ----------
    contact : BoxContact
        The contact, whose depth is written.
    plated : callable or None
        Makes the grid in double digits, of numpy; none of layers of low contrast.
    ceiling, tolerance
        As for `BoxContact`.
    plate : bool
        Whether Newton's steps are taken at once.

    Raises
    ------
    NotConverged
        If it is not solved.
    """
    if plated is None:
        return contact.p, contact.solve(tolerance), False
    if not plate:
        try:
            return contact.p, contact.solve(tolerance, STEPS_OF_PLATES), False
        except NotConverged:
            pass  # pixels went in circles
    found = PlateContact(plated(), contact.load, ceiling, to_numpy(contact.p), to_numpy(contact.gap), contact.depth)
    count = found.solve(tolerance) + (0 if plate else STEPS_OF_PLATES)
    contact.depth = found.depth
    like, xp = contact.p, namespace_of(contact.p)
    return found.p if xp is np else xp.asarray(found.p, device=like.device), count, True
