r"""Two functions of the contact radius, resolved once, so that one can be evaluated as a function of the other.

Both are Chebyshev polynomials on panels that double in size from the axis on; above a kink b their variable is
:math:`y = \sqrt{a^2-b^2}`.  Where the first function rises it is inverted, for thousands of values at once, by Newton's
method on its polynomials; the functions themselves are evaluated some hundred times.
"""

from __future__ import annotations

import functools
from typing import NamedTuple

import numpy as np

from winkler.fitting.elastic.panels import DEGREE, Pair, PanelSeries, panel_nodes, resolved
from winkler.numerics.types import Array

SAMPLES = 8
MOST_NEWTON_STEPS = 5
NEWTON_TOLERANCE = 1e-9
"""Step of Newton's method on panels from -1 to 1, below which the next one is rounding error."""
FALL_TOLERANCE = 1e-9
"""Least fall of a function at a turn, relative to its largest value."""


class RisingBranch(NamedTuple):
    """An interval on which the first function rises: coordinates s and increasing values."""

    places: Array
    levels: Array


class PanelPlaces(NamedTuple):
    """Positions on the panels: index and coordinate from -1 to 1."""

    panel: Array
    t: Array


class RadiusTable(NamedTuple):
    """Two functions, panel by panel, over a coordinate s that counts panels.

    Parameters
    ----------
    base, left, right : ndarray, (panels,)
        The kink [m] from which y counts, and y where the panel begins and ends [m].
    series : ndarray, (degree + 1, 2, panels)
        Power series of the two functions in the panel's own variable, from -1 to 1.
    pieces : tuple of RisingPiece
        Where the first function rises, in the order of growing radii.
    """

    base: Array
    left: Array
    right: Array
    series: Array
    pieces: tuple[RisingBranch, ...]

    def radius(self, places: PanelPlaces) -> Array:
        """Return the contact radii a [m]."""
        base, left, right = (column[places.panel] for column in (self.base, self.left, self.right))
        y = 0.5 * (left + right) + 0.5 * (right - left) * places.t
        return np.asarray(np.where(base > 0.0, np.hypot(base, y), y))

    def start(self, piece: RisingBranch) -> PanelPlaces:
        """Return the place where a piece begins."""
        return self.places(piece.places[:1])

    def places(self, s: Array) -> PanelPlaces:
        """Return the places of numbers that count panels."""
        panel = np.minimum(s.astype(int), self.base.size - 1)
        return PanelPlaces(panel, 2.0 * (s - panel) - 1.0)

    def places_of(self, radius: Array) -> PanelPlaces:
        """Return the places of contact radii within the table [m]."""
        panel = np.searchsorted(np.hypot(self.base, self.right), radius, side="left")
        panel = np.minimum(panel, self.base.size - 1)
        base, left, right = self.base[panel], self.left[panel], self.right[panel]
        y = np.sqrt(np.maximum((radius - base) * (radius + base), 0.0))
        return PanelPlaces(panel, np.clip((2.0 * y - left - right) / (right - left), -1.0, 1.0))

    def where(self, piece: RisingBranch, target: Array) -> PanelPlaces:
        """Return the positions on a piece at which the first function takes target values."""
        right = np.clip(np.searchsorted(piece.levels, target, side="left"), 1, len(piece.levels) - 1)
        low, high = piece.places[right - 1], piece.places[right]
        bottom, top = piece.levels[right - 1], piece.levels[right]
        share = np.clip((target - bottom) / (top - bottom), 0.0, 1.0)
        share = np.where(right == 1, np.sqrt(share), share)  # most pieces begin like a square
        panel = np.minimum((0.5 * (low + high)).astype(int), self.base.size - 1)
        start, stop = 2.0 * (low - panel) - 1.0, 2.0 * (high - panel) - 1.0
        t = start + share * (stop - start)
        series = self.series[:, 0, panel]
        tolerance = 4.0 * np.finfo(float).eps * float(np.abs(piece.levels).max())
        for _ in range(MOST_NEWTON_STEPS):
            value, rise = _horner(series, t)
            converged = np.abs(value - target) <= tolerance  # at the start of a piece the next step would be 0/0
            if converged.all():
                break
            over = value > target
            start, stop = np.where(over, start, t), np.where(over, t, stop)
            with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
                new = t - (value - target) / rise
            inside = (new >= start) & (new <= stop)
            last = t
            t = np.where(converged, t, np.where(inside, new, 0.5 * (start + stop)))
            if np.all(converged | (inside & (np.abs(t - last) <= NEWTON_TOLERANCE))):
                break
        return PanelPlaces(panel, t)

    def read(self, places: PanelPlaces) -> tuple[Array, Array]:
        """Return the second function, and its derivative with respect to the first; zero where that does not rise."""
        value, (rise, gain) = _horner(self.series[:, :, places.panel], places.t)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            slope = gain / rise
        return value[1], np.where((rise > 0.0) & np.isfinite(slope), slope, 0.0)

    def level(self, places: PanelPlaces) -> Array:
        """Return the first function."""
        return _horner(self.series[:, 0, places.panel], places.t)[0]

    def read_series(self, series: Array, places: PanelPlaces) -> Array:
        """Return power series ``(degree + 1, panels)`` on these panels at positions."""
        return _horner(series[:, places.panel], places.t)[0]

    def differences(self, function: Pair, places: PanelPlaces) -> Array:
        """Return the differences of two other functions from these ``(2, m)``, at positions.

        They must be close to these, as they use the same panels.
        """
        nodes, matrix, powers = panel_nodes()
        y = 0.5 * (self.left + self.right)[:, None] + 0.5 * (self.right - self.left)[:, None] * nodes
        radius = np.where(self.base[:, None] > 0.0, np.hypot(self.base[:, None], y), y)
        other = np.stack([np.asarray(column).reshape(radius.shape) for column in function(radius.ravel())])
        change = np.moveaxis(other @ matrix.T @ powers, -1, 0) - self.series
        return _horner(change[:, :, places.panel], places.t)[0]


def tabulated(function: Pair, low: float, high: float, kinks: Array) -> RadiusTable:
    """Return two functions of the radius as a table.

    Parameters
    ----------
    function, low, high, kinks
        As for `resolved`.
    """
    return table_of(resolved(function, low, high, kinks))


def table_of(series: PanelSeries) -> RadiusTable:
    """Return the table of two functions, with the intervals on which the first rises."""
    powers = panel_nodes()[2]
    both = np.stack([(series.levels @ powers).T, (series.others @ powers).T], axis=1)
    return RadiusTable(series.base, series.left, series.right, both, _pieces(series.levels))


def _horner(series: Array, t: Array) -> tuple[Array, Array]:
    """Return the value and the derivative of power series ``(degree + 1, ..., m)`` at ``(m,)``."""
    value, slope = series[-1].copy(), np.zeros(series.shape[1:])
    for row in series[-2::-1]:
        slope *= t
        slope += value
        value *= t
        value += row
    return value, slope


@functools.lru_cache(maxsize=1)
def _grids() -> tuple[Array, Array]:
    """Return the matrices from Chebyshev coefficients to those of the derivative, and to values along a panel."""
    derivative = np.polynomial.chebyshev.chebder(np.eye(DEGREE + 1), axis=1)
    inner = (np.arange(SAMPLES) / SAMPLES * 2.0) - 1.0
    return derivative, np.polynomial.chebyshev.chebvander(inner, DEGREE).T


def _pieces(rows: Array) -> tuple[RisingBranch, ...]:
    """Return the intervals of rising D, from the Chebyshev coefficients of all panels."""
    count = rows.shape[0]
    derivative, samples = _grids()
    derived = rows @ derivative
    turns: list[float] = []
    doubtful = np.abs(derived[:, 0]) <= np.abs(derived[:, 1:]).sum(axis=1)
    for panel in np.flatnonzero(doubtful):
        row = derived[panel]
        large = np.flatnonzero(np.abs(row) > 1e-12 * np.abs(row).max())
        if large.size and large[-1] > 0:
            roots = np.polynomial.chebyshev.chebroots(row[: large[-1] + 1])
            real = roots.real[(np.abs(roots.imag) < 1e-9) & (np.abs(roots.real) < 1.0)]
            turns += (panel + 0.5 * (1.0 + np.sort(real))).tolist()
    grid = (rows @ samples).ravel()
    s = (np.arange(count)[:, None] + np.arange(SAMPLES) / SAMPLES).ravel()
    s, grid = np.append(s, count), np.append(grid, rows[-1].sum())
    if turns:
        turn_places = np.array(turns)
        panel = np.minimum(turn_places.astype(int), count - 1)
        levels_at_turns = [
            float(np.polynomial.chebyshev.chebval(2.0 * (x - k) - 1.0, rows[k]))
            for x, k in zip(turn_places, panel, strict=True)
        ]
        s, grid = np.append(s, turn_places), np.append(grid, levels_at_turns)
        rank = np.argsort(s, kind="stable")
        s, grid = s[rank], grid[rank]
    noise = FALL_TOLERANCE * float(np.abs(grid).max())
    return _rising(s, grid, noise)


def _rising(s: Array, level: Array, noise: float) -> tuple[RisingBranch, ...]:
    """Return the intervals on which samples rise; falls within the tolerance are ignored."""
    pieces: list[RisingBranch] = []
    start = 0
    falls = np.flatnonzero(np.diff(level) < 0.0)
    for stop in [*falls.tolist(), level.size - 1]:
        if stop > start and level[stop] - level[start] > noise:
            rising_level = np.maximum.accumulate(level[start : stop + 1])
            rises = np.concatenate([[True], np.diff(rising_level) > 0.0])
            pieces.append(RisingBranch(s[start : stop + 1][rises], rising_level[rises]))
        start = stop + 1
    return tuple(pieces)
