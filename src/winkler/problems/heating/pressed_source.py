r"""The temperature of a surface under the heat of a pressure that pixels found: on layers, gradings and power laws.

The map of the pressure is turned so that the surface moves along its first side; every pixel then warms all others
by the closed form of `winkler.numerics.surfaces.heated_grid`.  At high speed heat flows into the depth alone, and with
t along the motion

.. math:: \lambda T\sqrt{\frac V\kappa} = \int_{-\infty}^t \frac{q(s)}{\sqrt{\pi(t-s)}}\,\mathrm ds .
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.loading.loads import Depth, Force
from winkler.media.mapped import MappedMedium
from winkler.numerics.caching import cached_by_value
from winkler.numerics.fields.elliptic_source import EllipticSource
from winkler.numerics.fields.warmest_place import PeakTemperature, turned
from winkler.numerics.surfaces.heated_grid import HeatedGrid
from winkler.numerics.types import Array
from winkler.problems.normal.elliptic import pressed_ellipse
from winkler.profiles.ellipse import CurvedBodies
from winkler.values.errors import OutsideValidity
from winkler.values.value import value

MARGIN = 1.05
"""Half the side of a turned map over how far the ellipse of the semi-axes reaches."""
FEWEST, MOST = 96, 384
"""Pixels along a side of a turned map."""
ACROSS = 20.0
"""Pixels over the smaller semi-axis, where their number allows it."""
FARTHEST = 4.0
"""How far away temperatures beside the contact are found, over how far its longer side reaches."""


@value
class PressedSource:
    """1 W on the contact of two bodies of two curvatures, distributed like the pressure of `EllipticIndentation`.

    Parameters
    ----------
    bodies : CurvedBodies
    medium : CoatedHalfSpace, SlidingFilm, StackedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
    load : Force or Depth
        One, positive.
    """

    bodies: CurvedBodies
    medium: MappedMedium
    load: Force | Depth

    def half_length(self, angle: float) -> float:
        """Return how far an ellipse of these semi-axes reaches at an angle [rad] from its middle [m]."""
        reach = pressed_ellipse(self.bodies, self.medium, self.load)[1].contour((0.0, 0.5 * math.pi))
        return EllipticSource(float(reach[0]), float(reach[1])).half_length(angle)

    def surface(self, wave: float, x: Array, y: Array, angle: float = 0.0) -> Array:
        """Return lambda T [W/m] on the surface; parameters as of `EllipticSource.surface`.

        Raises
        ------
        OutsideValidity
            If a place is farther away than four times the contact reaches along its longer side.
        """
        from scipy.ndimage import map_coordinates

        pixels = _turned(self, angle)
        places = np.stack([np.ravel(place) for place in turned(x, y, -angle)])
        reach = np.abs(places) * (1.0 + 2.0 / FEWEST) / np.array(pixels.half_sides)[:, None]
        far = float(np.max(np.abs(places), initial=0.0)) / max(pixels.half_sides)
        if far > FARTHEST:
            raise OutsideValidity(
                f"HeatedBody: a place is {far:.3g} times as far away as the contact reaches; on layers and graded "
                f"bodies temperatures are known up to {FARTHEST:g} times: give nearer places."
            )
        times = 2.0 ** np.ceil(np.log2(np.maximum(reach, 1.0)))
        found = np.empty(places.shape[1])
        for each in np.unique(times, axis=1).T:
            here, wider = np.all(times == each[:, None], axis=0), pixels.widened((int(each[0]), int(each[1])))
            rows = [
                (place + side) / pixel - 0.5
                for place, side, pixel in zip(places[:, here], wider.half_sides, wider.pixel, strict=True)
            ]
            found[here] = map_coordinates(wider.warmed(wave), rows, order=3, mode="nearest")
        return found.reshape(np.shape(x))

    def peak(self, wave: float, angle: float = 0.0) -> PeakTemperature:
        """Return the greatest lambda T and its place; parameters as of `EllipticSource.peak`."""
        pixels = _turned(self, angle)
        height, place = _summit(np.where(pixels.flux > 0.0, pixels.warmed(wave), 0.0))
        x, y = (
            (row + 0.5) * pixel - side for row, pixel, side in zip(place, pixels.pixel, pixels.half_sides, strict=True)
        )
        return PeakTemperature(height, x, y).turned(angle)

    def mean(self, wave: float, angle: float = 0.0) -> float:
        """Return the mean of lambda T over the contact [W/m]; parameters as of `EllipticSource.mean`."""
        pixels = _turned(self, angle)
        return float(np.mean(pixels.warmed(wave)[pixels.flux > 0.0]))

    def fast(self, angle: float = 0.0) -> float:
        """Return what the greatest lambda T times the root of V / kappa tends to in fast motion [W m^-3/2]."""
        pixels = _turned(self, angle)
        step, count = pixels.pixel[0], pixels.flux.shape[0]
        passed = np.diff(np.sqrt(np.maximum(np.arange(count + 1) - 0.5, 0.0))) * 2.0 * math.sqrt(step / math.pi)
        lag = np.subtract.outer(np.arange(count), np.arange(count))
        return _summit(np.where(lag >= 0, passed[np.abs(lag)], 0.0) @ pixels.flux)[0]


class _Turned(NamedTuple):
    """A map of 1 W whose first side points along the motion.

    Parameters
    ----------
    half_sides
        [m].
    flux
        [W/m^2], (nx, ny).
    """

    half_sides: tuple[float, float]
    flux: Array

    @property
    def pixel(self) -> tuple[float, float]:
        """Sides of a pixel [m]."""
        (along, across), (nx, ny) = self.half_sides, self.flux.shape
        return 2.0 * along / nx, 2.0 * across / ny

    def warmed(self, wave: float) -> Array:
        """Return lambda T of the middles of the pixels [W/m]."""
        nx, ny = self.flux.shape
        return HeatedGrid.of((nx, ny), self.pixel, 1.0, wave).warmed(self.flux)

    def widened(self, times: tuple[int, int]) -> _Turned:
        """Return a map of as many pixels, each so many `times` as long and as wide."""
        rows, columns = (
            ((np.arange(n) + 0.5 - 0.5 * n) / part + 0.5 * n).astype(int)
            for n, part in zip(self.flux.shape, times, strict=True)
        )
        flux = np.zeros(self.flux.shape)
        np.add.at(flux, (rows[:, None], columns[None, :]), self.flux / (times[0] * times[1]))
        return _Turned((times[0] * self.half_sides[0], times[1] * self.half_sides[1]), flux)


@cached_by_value(16)
def _turned(source: PressedSource, angle: float) -> _Turned:
    """Return the map of a source, turned by an angle [rad]."""
    found = pressed_ellipse(source.bodies, source.medium, source.load)[1]
    reach = [float(each) for each in found.contour((0.0, 0.5 * math.pi))]
    cosine, sine = math.cos(angle), math.sin(angle)
    half = (
        MARGIN * math.hypot(reach[0] * cosine, reach[1] * sine),
        MARGIN * math.hypot(reach[0] * sine, reach[1] * cosine),
    )
    counts = [8 * math.ceil(min(max(2.0 * side / min(reach) * ACROSS, FEWEST), MOST) / 8) for side in half]
    along, across = (side * ((np.arange(n) + 0.5) * (2.0 / n) - 1.0) for side, n in zip(half, counts, strict=True))
    u, v = along[:, None], across[None, :]
    places = np.broadcast_arrays(*turned(u, v, angle))
    borne = found._replace(pressure=1.0 * (found.pressure > 0.0), edge_power=1.0).pressure_at(*places)
    area = 4.0 * half[0] * half[1] / borne.size
    count = round(found.area / area)  # pixels beyond the last that bear are cut off
    touching = (borne > 0.0) & (borne >= np.partition(borne, -count, axis=None)[-count])
    pressure = np.where(touching, found.pressure_at(*places), 0.0)
    return _Turned(half, pressure / (area * float(np.sum(pressure))))


def _summit(heights: Array) -> tuple[float, tuple[float, float]]:
    """Return the greatest height of a map, and its row and column, between pixels by parabolas."""
    place = np.unravel_index(int(np.argmax(heights)), heights.shape)
    top = float(heights[place])
    height, offsets = top, []
    for axis, at in enumerate(place):
        row = np.take(heights, int(place[1 - axis]), axis=1 - axis)
        if not 0 < at < row.size - 1:
            offsets.append(0.0)
            continue
        before, after = float(row[at - 1]), float(row[at + 1])
        bend = before - 2.0 * top + after
        offset = 0.5 * (before - after) / bend if bend < 0.0 else 0.0
        offsets.append(offset)
        height += 0.25 * offset * (after - before)
    return height, (float(place[0]) + offsets[0], float(place[1]) + offsets[1])
