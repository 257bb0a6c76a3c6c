r"""A shape pressed by pixels: a gap h(x, y) on a map as large as the contact itself, on two grids.

.. math:: w = h(x, y) - d + \int K(x - x', y - y')\,p\,\mathrm dA' \ge 0 , \qquad p \ge 0 , \qquad p\,w = 0 ,

with the kernel K of layers, gradings and power laws, by the solver of `winkler.problems.rough.surface_contact`.  The
map is enlarged or reduced on a coarse grid until the contact nearly fills it, so that pixels are as small along either
axis as the contact requires.  Depth, force and greatest pressure then converge with the square of the pixels; the
edge, and what depends on it, with the pixels.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple, TypeAlias

import numpy as np

from winkler.loading.loads import Depth, Force
from winkler.media.mapped import MappedMedium, layers_of
from winkler.media.offers import PowerOfDepth, offers
from winkler.numerics.pixels.contact_area import contact_area
from winkler.numerics.surfaces.pressed_box import ByDepth, ByLoad
from winkler.numerics.surfaces.pressed_grid import press
from winkler.numerics.surfaces.punched_grid import punch
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.pressed_shape.surface_load import SurfaceLoad
from winkler.values.errors import NotConverged, OutsideValidity

Gap: TypeAlias = Callable[[Array, Array], Array]
"""Takes x (nx, 1) and y (1, ny) [m], returns the distance of the undeformed bodies (nx, ny) [m]; zero at the origin."""
PIXELS = 192
"""Along each side of the finer map."""
SEARCHED_PIXELS = 48
"""Along each side of the maps on which the size of the contact is sought."""
MARGIN = 1.08
"""Half the side of the map over how far the contact reaches."""
CLOSE = 1.2
"""Ratio of one size of the map to the next at which it is found."""
MOST_SIZES = 60
PUNCH_TOLERANCE = 3e-3
"""As of `winkler.problems.rough.surface_contact`: the stiffness errs by its square."""
EDGE_SAFETY = 2.0
"""Error of what depends on the edge over its change from half as many pixels, with which it falls as they do."""
EDGE_PIXELS = 0.1
"""Error of the edge that stays where the change from half as many pixels happens to be less [pixel]."""
EDGE_EXCESS = 0.07
"""By how many pixels squares of pressures lead beyond the edge, measured on discs, ellipses and layers."""
FITTED = 4
"""Places along a ray, inside the last pixel, through whose squared pressures a parabola meets the edge."""


class PressedMap(NamedTuple):
    """A shape pressed on one grid.

    Parameters
    ----------
    depth, force
        [m], since the bodies touch at the origin, and [N].
    x, y
        Centres of the pixels [m].
    pixel
        (dx, dy) [m].
    pressure
        [Pa], (nx, ny).
    stiffness
        dF/dd [N/m], of a flat punch of the shape of the contact; nan of a map on which only the size is sought.
    edge_power
        Power of the pressure that falls to zero at the edge in a straight line.
    """

    depth: float
    force: float
    x: Array
    y: Array
    pixel: tuple[float, float]
    pressure: Array
    stiffness: float = math.nan
    edge_power: float = 2.0

    @property
    def peak_pressure(self) -> float:
        """The greatest [Pa]."""
        return float(np.max(self.pressure))

    @property
    def area(self) -> float:
        """Of the contact [m^2], without what pixels count too much along its edge."""
        return contact_area(self.pressure > 0.0, self.pixel, periodic=False)[0]

    def pressure_at(self, x: Array, y: Array) -> Array:
        """Return the pressure [Pa] at places of one shape [m], straight between pixels in its `edge_power`."""
        from scipy.ndimage import map_coordinates

        rows = np.stack([np.ravel(x - self.x[0]) / self.pixel[0], np.ravel(y - self.y[0]) / self.pixel[1]])
        raised = map_coordinates(self.pressure**self.edge_power, rows, order=1, mode="constant")
        return np.asarray((np.maximum(raised, 0.0) ** (1.0 / self.edge_power)).reshape(np.shape(x)))

    def load(self, traction: tuple[float, float] = (0.0, 0.0)) -> SurfaceLoad:
        """Return what acts on the first body, dragged along x and y by these parts of the pressure."""
        (x_part, y_part), pixel = traction, np.array(self.pixel)
        corner = np.array([self.x[0], self.y[0]]) - 0.5 * pixel
        sides = pixel * self.pressure.shape
        return SurfaceLoad(self.pressure, sides, x_part * self.pressure, y_part * self.pressure, corner)

    def contour(self, angles: ArrayLike) -> Array:
        """Return how far the contact reaches from the origin [m] along directions at angles to x [rad].

        At the edge the square of the pressure falls to zero in a straight line; on power laws another power does.
        """
        return np.array([self._reach(math.cos(angle), math.sin(angle)) for angle in np.ravel(angles)])

    def _reach(self, cosine: float, sine: float) -> float:
        from scipy.ndimage import map_coordinates

        dx, dy = self.pixel
        step = min(dx / max(abs(cosine), 1e-300), dy / max(abs(sine), 1e-300))
        r = (np.arange(2.0 * math.hypot(self.x[-1], self.y[-1]) / step) + 0.5) * step
        rows = (r * cosine - self.x[0]) / dx, (r * sine - self.y[0]) / dy
        borne = map_coordinates(1.0 * (self.pressure > 0.0), rows, order=1, mode="constant") > 1.0 - 1e-9
        count = int(np.argmin(borne)) if not borne.all() else borne.size
        last = slice(max(count - 1 - FITTED, 0), max(count - 1, 1))
        raised = map_coordinates(self.pressure**self.edge_power, rows, order=1, mode="constant")[last]
        if count < FITTED + 1:
            return float(r[max(count - 1, 0)])
        beyond = (r[last] - r[count - 1]) / step
        roots = np.roots(np.polyfit(beyond, raised / np.max(raised), 2))
        real = roots[np.isreal(roots)].real
        ahead = real[real > 0.0]
        return float(r[count - 1] + step * ((np.min(ahead) if ahead.size else 0.5) - EDGE_EXCESS))


def pressed_levels(
    owner: str,
    gap: Gap,
    medium: MappedMedium,
    load: Force | Depth,
    start: tuple[float, float],
    *,
    limits: tuple[float, float] = (math.inf, math.inf),
    pixels: int = PIXELS,
) -> tuple[PressedMap, PressedMap]:
    """Return the shape pressed on a grid of half as many pixels along a side, and on the grid itself.

    Parameters
    ----------
    owner
        Who asks, for messages.
    gap
        Of the undeformed bodies, lowest near the origin.
    medium
        Both bodies.
    load
        One positive number.
    start
        A guess how far the contact reaches from the origin along x and y [m].
    limits
        How far the shape does [m].
    pixels
        Along each side, an even number.

    Raises
    ------
    NotConverged
        If the pressures are not found, or the contact does not end.
    OutsideValidity
        If the pixels are too coarse for an incompressible layer.
    """
    try:
        half = _half_sides(gap, medium, load, start, limits)
        coarse, fine = (_stiffened(_pressed(gap, medium, load, half, n), medium) for n in (pixels // 2, pixels))
        return coarse, fine
    except NotConverged as error:
        raise NotConverged(f"{owner}: under the load {_number(load):.6g}, {error}") from None
    except OutsideValidity as error:
        raise OutsideValidity(f"{owner}: {error}") from None


def grid_error(coarse: PressedMap, fine: PressedMap) -> float:
    """Return the greatest relative change of depth, force and greatest pressure from one grid to the other.

    It is not less than what the greatest pressure may lose between the middles of pixels.
    """
    words = ("depth", "force", "peak_pressure")
    between = 0.5 * (2.0 / float(min(fine.pressure.shape))) ** 2
    changes = [float(getattr(coarse, word)) / float(getattr(fine, word)) - 1.0 for word in words]
    return float(max(between, *map(abs, changes)))


def edge_error(coarse: PressedMap, fine: PressedMap, angles: ArrayLike) -> float:
    """Return the relative error of area, stiffness and contour that the finer grid leaves, in directions [rad]."""
    contour = fine.contour(angles)
    changes = [coarse.area / fine.area, coarse.stiffness / fine.stiffness, *coarse.contour(angles) / contour]
    pixels = max(side / float(np.max(np.abs(row))) for side, row in zip(fine.pixel, (fine.x, fine.y), strict=True))
    return max(EDGE_SAFETY * float(np.max(np.abs(np.array(changes) - 1.0))), EDGE_PIXELS * pixels)


def _number(load: Force | Depth) -> float:
    return float(np.asarray(load.force if isinstance(load, Force) else load.depth))


def _pressed(gap: Gap, medium: MappedMedium, load: Force | Depth, half: tuple[float, float], pixels: int) -> PressedMap:
    """Return the shape pressed on a map whose sides are twice `half` [m]; nothing bears where all of it is deeper."""
    x, y = (side * ((np.arange(pixels) + 0.5) * (2.0 / pixels) - 1.0) for side in half)
    pixel = 2.0 * half[0] / pixels, 2.0 * half[1] / pixels
    heights = gap(x[:, None], y[None, :])
    lowest = float(np.min(heights))
    drive: ByDepth | ByLoad
    if isinstance(load, Force):
        drive = ByLoad(float(load.force) / (medium.modulus * math.prod(pixel)))
    else:
        drive = ByDepth(float(load.depth) - lowest)
        if drive.depth <= 0.0:
            return PressedMap(float(load.depth), 0.0, x, y, pixel, np.zeros(heights.shape))
    solved = press(heights - lowest, pixel, drive, periodic=False, layers=layers_of(medium))
    force = medium.modulus * math.prod(pixel) * float(np.sum(solved.pressure))
    return PressedMap(solved.depth + lowest, force, x, y, pixel, medium.modulus * solved.pressure)


def _stiffened(pressed: PressedMap, medium: MappedMedium) -> PressedMap:
    touching, pixel = pressed.pressure > 0.0, pressed.pixel
    under = punch(touching, pixel, periodic=False, tolerance=PUNCH_TOLERANCE, layers=layers_of(medium))
    power = 2.0 / (1.0 + medium.exponent) if offers(medium, PowerOfDepth) else 2.0
    stiffness = medium.modulus * math.prod(pixel) * float(np.sum(under))
    return pressed._replace(stiffness=stiffness, edge_power=power)


def _half_sides(
    gap: Gap, medium: MappedMedium, load: Force | Depth, start: tuple[float, float], limits: tuple[float, float]
) -> tuple[float, float]:
    """Return half the sides of a map [m] that the contact nearly fills."""
    half = min(start[0], limits[0]), min(start[1], limits[1])
    for _ in range(MOST_SIZES):
        touching = _searched(gap, medium, load, half).pressure > 0.0
        wanted = tuple(_wanted(side, np.any(touching, axis=1 - axis), limits[axis]) for axis, side in enumerate(half))
        if all(side / CLOSE <= new <= side * CLOSE for side, new in zip(half, wanted, strict=True)):
            return wanted[0], wanted[1]
        half = wanted[0], wanted[1]
    raise NotConverged("the size of the contact is not found; check the units of shape, moduli and load.")


def _searched(gap: Gap, medium: MappedMedium, load: Force | Depth, half: tuple[float, float]) -> PressedMap:
    """Return the contact on as few pixels as the layers allow."""
    pixels = SEARCHED_PIXELS
    while True:
        try:
            return _pressed(gap, medium, load, half, pixels)
        except OutsideValidity:  # too coarse for an incompressible layer
            if pixels >= 2 * PIXELS:
                raise
            pixels *= 2


def _wanted(side: float, touching: Array, limit: float) -> float:
    """Return half the side that fits a contact which touches in these rows of a map of half the side `side`."""
    if not touching.any():
        return 0.25 * side
    rows = np.flatnonzero(touching)
    if side < limit and (rows[0] == 0 or rows[-1] == touching.size - 1):
        return min(2.0 * side, limit)
    first, last = 2.0 * float(rows[0]) / touching.size - 1.0, 2.0 * float(rows[-1] + 1) / touching.size - 1.0
    reach = max(abs(first), abs(last))
    return min(MARGIN * reach * side, limit)
