r"""A height map: the heights of a surface on a rectangular grid, as an instrument or a simulation gives them."""

from __future__ import annotations

import dataclasses
import math
from typing import Annotated

import numpy as np

from winkler.numerics.types import Array, ArrayLike
from winkler.profiles.rough.spikes import Spikes
from winkler.values.checks.number_checks import NON_NEGATIVE, POSITIVE, Advice, Numbers, affordable
from winkler.values.checks.physical_size import refuse_size
from winkler.values.errors import InvalidInput, suggest
from winkler.values.limits import MOST_HOLES
from winkler.values.value import value


@value
class Topography:
    """A height map.

    Parameters
    ----------
    heights : array_like, (nx, ny)
        Heights [m] at the centres of the pixels, up towards the other body; nan, or masked, where they are missing.
    lengths : array_like, (2,)
        Lengths [m] of the map along its two directions: pixels are lengths / (nx, ny), and need not be square.
    periodic : bool, optional
        Whether the map repeats without end; otherwise (default) nothing lies outside it.
    tip_radius : float, optional
        Radius of the scanning tip [m], which limits the sharpness of features; zero if it is not known, or there was
        no tip.
    removed : str, optional
        Description of what was removed from the measured heights; written by `without_spikes` and `levelled`.
    reading : str, optional
        Interpolation of heights from points that are not on a grid; written by `read_topography`.

    Raises
    ------
    InvalidInput
        If the heights are no map of at least two by two finite numbers, or a length is not positive.

    Examples
    --------
    >>> import numpy as np
    >>> x = np.arange(64) / 64 * 1e-3
    >>> wave = Topography(1e-6 * np.cos(2 * np.pi * x[:, None] / 1e-3) + 0.0 * x, [1e-3, 1e-3], periodic=True)
    >>> round(wave.rms_height * 1e6, 6)
    0.707107
    """

    heights: Array
    lengths: Annotated[Array, Numbers(POSITIVE), Advice("two positive lengths in m")]
    periodic: bool = False
    tip_radius: Annotated[float, NON_NEGATIVE] = dataclasses.field(default=0.0, kw_only=True)
    removed: str = dataclasses.field(default="", kw_only=True)
    reading: str = dataclasses.field(default="", kw_only=True)

    def __post_init__(self) -> None:
        heights = np.asarray(self.heights)
        if heights.ndim != 2 or min(heights.shape) < 2:
            raise InvalidInput(
                f"Topography: heights have the shape {heights.shape}; give a map of at least 2 x 2 pixels, (nx, ny)."
            )
        if self.lengths.shape != (2,):
            raise InvalidInput(f"Topography: lengths are {self.lengths!r}; give two positive lengths in m.")
        if np.any(np.isinf(heights)) or np.all(np.isnan(heights)):
            raise InvalidInput("Topography: heights are infinite, or all missing; give finite ones, nan for missing.")
        refuse_size("Topography: heights", heights)

    @property
    def pixel(self) -> tuple[float, float]:
        """Size of one pixel [m]."""
        return float(self.lengths[0] / self.heights.shape[0]), float(self.lengths[1] / self.heights.shape[1])

    @property
    def area(self) -> float:
        """Area of the map [m^2]."""
        return float(self.lengths[0] * self.lengths[1])

    @property
    def missing(self) -> int:
        """The number of missing heights."""
        return int(np.count_nonzero(np.isnan(self.heights)))

    @property
    def rms_height(self) -> float:
        """Root mean square height about the mean [m], Sq."""
        return float(np.nanstd(self.heights))

    @property
    def gaps(self) -> Array:
        """The distances of the pixels below the highest one [m], (nx, ny)."""
        return np.asarray(np.nanmax(self.heights) - self.heights)

    @property
    def rms_slope(self) -> float:
        """Root mean square of the gradient [-], from differences of neighbouring pixels."""
        return math.sqrt(sum(float(np.nanmean(part**2)) for part in self._gradient()))

    @property
    def skewness(self) -> float:
        """Mean cube of the heights over that of their root mean square [-], Ssk; negative with deep valleys."""
        return self._moment(3)

    @property
    def kurtosis(self) -> float:
        """Mean fourth power of the heights over that of their root mean square [-], Sku; 3 of Gaussian ones."""
        return self._moment(4)

    def _moment(self, power: int) -> float:
        if self.rms_height == 0.0:
            raise InvalidInput("Topography: a flat map has no skewness and no kurtosis; its heights do not differ.")
        return float(np.nanmean(((self.heights - np.nanmean(self.heights)) / self.rms_height) ** power))

    def _gradient(self) -> tuple[Array, Array]:
        """Return differences of neighbours over their distance [-], along both directions."""
        parts = []
        for axis, step in enumerate(self.pixel):
            if self.periodic:
                parts.append((np.roll(self.heights, -1, axis) - self.heights) / step)
            else:
                parts.append(np.diff(self.heights, axis=axis) / step)
        return parts[0], parts[1]

    def _with(self, heights: Array, lengths: Array | None = None, periodic: bool | None = None) -> Topography:
        """Return other heights measured by the same tip."""
        sides, repeated = self.lengths if lengths is None else lengths, self.periodic if periodic is None else periodic
        return Topography(
            heights, sides, repeated, tip_radius=self.tip_radius, removed=self.removed, reading=self.reading
        )

    def detrended(self, order: int = 1) -> Topography:
        """Return the map without its mean (0), a plane (1) or a paraboloid (2), fitted by least squares.

        Raises
        ------
        InvalidInput
            If the order is not 0, 1 or 2, or the map would lose its periodicity.
        """
        return self._with(self.heights - trend_of(self.heights, order, periodic=self.periodic))

    def levelled(self, by: str = "median", along: str = "x") -> Topography:
        """Return the map with each of its scan lines levelled, its mean kept; `removed` says so.

        Parameters
        ----------
        by : str, optional
            What is removed: the median of each line, the median of differences to the nearest earlier line with common
            points (which keeps common steps), or a fitted line or parabola.
        along : str, optional
            Direction in which a line was scanned, x or y.

        Raises
        ------
        InvalidInput
            If an option is not known, or the map is periodic and would lose its periodicity. By differences, if a line
            has no common point with any earlier line.
        """
        turned = along_x(along)
        levels = line_levels(self.heights.T if turned else self.heights, by, periodic=self.periodic)
        said = f"of each scan line along {along} {LINE_LEVELS[by]}"
        heights = self.heights - (levels.T if turned else levels)
        return dataclasses.replace(self, heights=heights, removed="; ".join(filter(None, (self.removed, said))))

    def masked(self, where: ArrayLike) -> Topography:
        """Return the map with some heights missing: behind a dust grain, or where an instrument has lost contact.

        Parameters
        ----------
        where : array_like of bool, (nx, ny)
            True where a height is not reliable, such as ``surface.heights > 2e-6``.

        Raises
        ------
        InvalidInput
            If it has another shape than the map, is not boolean, or leaves no height.
        """
        lost = np.asarray(where)
        if lost.dtype != bool or lost.shape != self.heights.shape:
            raise InvalidInput(
                f"Topography: masked needs True or False for each of {self.heights.shape} pixels; there is an array of "
                f"{lost.dtype} with the shape {lost.shape}."
            )
        return self._with(np.where(lost, np.nan, self.heights))

    def spikes(self, times: float = 4.0) -> Spikes:
        """Return artefacts of the measurement, which would carry the load before the surface does.

        A height is a grain or dropout if it lies outside of Tukey's fences around it: `times` the distance of the
        quartiles above the upper or below the lower one, among the heights within four pixels; grains up to about four
        pixels wide are found.  A scar is a run of pixels along a line, up to three pixels wide, whose steps on both
        sides lie outside of these fences among the steps around; for long runs and continuations of scars half of the
        fences applies. Do not use it for structured surfaces (narrow ridges, pillars), which resemble spikes.  J. W.
        Tukey, Exploratory Data Analysis, Addison-Wesley 1977.

        Parameters
        ----------
        times : float, optional
            Threshold as a multiple of the distance of the quartiles. With 4, Gaussian and self-affine surfaces and
            smooth shapes are not changed.

        Raises
        ------
        InvalidInput
            If `times` is not positive.
        """
        if isinstance(times, bool) or not isinstance(times, int | float) or not times > 0.0:
            raise InvalidInput(f"Topography: spikes are requested with times = {times!r}; give a positive number.")
        from winkler.numerics.surfaces.bridging import bridged, spikes
        from winkler.numerics.surfaces.scars import scars

        grains = spikes(self.heights, times, self.periodic)
        clean = bridged(np.where(grains, np.nan, self.heights), self.periodic)
        scarred = scars(clean, times, self.periodic) & ~np.isnan(self.heights)
        bare = self.masked(grains | scarred).filled().heights
        return Spikes(grains, scarred & ~grains, np.where(grains | scarred, self.heights - bare, 0.0))

    def without_spikes(self, times: float = 4.0) -> Topography:
        """Return the map with grains, dropouts and scars marked as missing; `removed` describes them.

        Parameters
        ----------
        times : float, optional
            As for `spikes`.

        Raises
        ------
        InvalidInput
            If `times` is not positive.
        """
        found = self.spikes(times)
        if not np.any(found.where):
            return self
        return dataclasses.replace(
            self.masked(found.where), removed="; ".join(filter(None, (self.removed, str(found))))
        )

    def filled(self) -> Topography:
        """Return the map with missing heights interpolated smoothly from the surrounding heights.

        The filled heights solve Laplace's equation, so that none lies above the highest surrounding height.
        """
        if not self.missing:
            return self
        from winkler.numerics.surfaces.bridging import bridged

        affordable("Topography", "missing heights", self.missing, MOST_HOLES)
        return self._with(bridged(self.heights, self.periodic))

    def cropped(self, first: tuple[int, int], count: tuple[int, int]) -> Topography:
        """Return the part of `count` pixels from pixel `first` on; it is not periodic any more.

        Raises
        ------
        InvalidInput
            If it is not inside the map.
        """
        shape = self.heights.shape
        if len(first) != 2 or len(count) != 2 or not all(isinstance(n, int | np.integer) for n in (*first, *count)):
            raise InvalidInput(f"Topography: cropped needs two whole numbers twice; there are {first!r} and {count!r}.")
        inside = all(a >= 0 and n >= 2 and a + n <= m for a, n, m in zip(first, count, shape, strict=True))
        if not inside:
            raise InvalidInput(
                f"Topography: {count} pixels from {first} on are not inside a map of {shape}; give less."
            )
        part = self.heights[first[0] : first[0] + count[0], first[1] : first[1] + count[1]]
        return self._with(part, np.array(self.pixel) * count, False)

    def coarsened(self, times: int) -> Topography:
        """Return the map with means over `times` by `times` pixels.

        Pixels that do not fill a block are omitted; a mean with a missing height is missing.

        Raises
        ------
        InvalidInput
            If fewer than two by two pixels would be left.
        """
        nx, ny = (
            n // times if isinstance(times, int) and not isinstance(times, bool) and times > 0 else 0
            for n in self.heights.shape
        )
        if min(nx, ny) < 2:
            raise InvalidInput(
                f"Topography: {self.heights.shape} pixels cannot be coarsened {times!r} times; give a smaller whole "
                "number."
            )
        block = self.heights[: nx * times, : ny * times].reshape(nx, times, ny, times)
        whole = nx * times == self.heights.shape[0] and ny * times == self.heights.shape[1]
        lengths = np.array(self.pixel) * times * np.array([nx, ny])
        return self._with(block.mean(axis=(1, 3)), lengths, self.periodic and whole)


LINE_LEVELS = {
    "median": "its median",
    "differences": "the median of its differences from the line before",
    "line": "a straight line",
    "parabola": "a parabola",
}
"""What may be taken off each line of a scan, in words."""
DEGREES = {"line": 1, "parabola": 2}


def trend_of(heights: Array, order: int, *, periodic: bool) -> Array:
    """Return the mean (0), plane (1) or paraboloid (2) that is fitted to the heights by least squares.

    Raises
    ------
    InvalidInput
        If the order is another one, or a periodic map would not be so without it.
    """
    if order not in (0, 1, 2):
        raise InvalidInput(
            f"Topography: cannot detrend to the order {order!r}; give 0 for the mean, 1 for a plane, "
            "2 for a paraboloid."
        )
    if periodic and order:
        raise InvalidInput(
            "Topography: without a plane or paraboloid a periodic map would not fit its neighbours any more; give "
            "order 0, or a map that is not periodic."
        )
    x, y = (np.linspace(-1.0, 1.0, n) for n in heights.shape)
    terms = [
        (x[:, None] ** i) * (y[None, :] ** j) for i in range(order + 1) for j in range(order + 1) if i + j <= order
    ]
    measured = ~np.isnan(heights)
    rows = np.stack([term[measured] for term in np.broadcast_arrays(*terms, heights)[:-1]], axis=1)
    strengths, *_ = np.linalg.lstsq(rows, heights[measured], rcond=None)
    trend = np.zeros(heights.shape)
    for strength, term in zip(strengths, terms, strict=True):
        trend += strength * term
    return trend


def along_x(along: str) -> bool:
    """Return whether scan lines run along x, and not along y.

    Raises
    ------
    InvalidInput
        If it is neither.
    """
    if along not in ("x", "y"):
        raise InvalidInput(f"Topography: scan lines run along {along!r}; give x or y.")
    return along == "x"


def line_levels(lines: Array, by: str, *, periodic: bool) -> Array:
    """Return what is to be taken off each line of a scan, (lines, points); zero of lines without any height.

    The mean over all measured heights is kept.

    Raises
    ------
    InvalidInput
        If `by` is another word, or a periodic map would not be so without it; by differences, if a line has no point
        in common with any line before it.
    """
    if by not in LINE_LEVELS:
        raise InvalidInput(
            f"Topography: scan lines cannot be levelled by {by!r}{suggest(by, LINE_LEVELS)}; "
            f"give {', '.join(LINE_LEVELS)}."
        )
    if periodic and by != "median":
        raise InvalidInput(
            "Topography: levelled by other than the medians of its lines, a periodic map would not fit its neighbours "
            "any more; give median, or a map that is not periodic."
        )
    measured: Array = ~np.isnan(lines)
    levels = np.zeros(lines.shape)
    some = np.asarray(np.any(measured, axis=1))
    if by == "median":
        levels[some] = np.nanmedian(lines[some], axis=1)[:, None]
    elif by == "differences":
        there = np.flatnonzero(some).tolist()
        for place, line in enumerate(there[1:], 1):
            shared = (before for before in reversed(there[:place]) if np.any(measured[line] & measured[before]))
            if (before := next(shared, None)) is None:
                raise InvalidInput(
                    f"Topography: scan line {line} has no measured point beside one of a line before it, so their "
                    "difference is not known; level by median, or give a part of the map."
                )
            both = measured[line] & measured[before]
            levels[line] = levels[before] + float(np.median(lines[line, both] - lines[before, both]))
    else:
        x = np.linspace(-1.0, 1.0, lines.shape[1])
        powers = np.stack([x**degree for degree in range(DEGREES[by] + 1)], axis=1)
        for line in np.flatnonzero(some).tolist():
            kept = measured[line]
            strengths, *_ = np.linalg.lstsq(powers[kept], lines[line, kept], rcond=None)
            levels[line] = powers @ strengths
    return np.where(some[:, None], levels - float(np.mean(levels[measured])), 0.0)
