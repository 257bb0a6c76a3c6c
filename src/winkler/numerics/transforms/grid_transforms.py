r"""What all transforms of worn contacts on a grid share: functions that are straight in :math:`y = x^2` between nodes.

A slope over y in one cell adds a known function of the two ends of the cell to every result (`ring_transforms`,
`strip_transforms`).  Pressures are means over parts of the surface about the nodes, so that nothing of the force is
lost, and that they change steadily when the edge of the contact passes a node.  A function that is cut off at zero
within a cell is cut off there, not at the next node: what the cells miss is added.
"""

from __future__ import annotations

import functools
from operator import sub
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.types import Array

BLOCK = 128
"""Rows of a triangular matrix that are multiplied at once."""


class CutCell(NamedTuple):
    """A cell in which a function given at nodes passes zero.

    Parameters
    ----------
    cell : int
        Number of the node at which it begins.
    falls : bool
        Whether the function falls there.
    start, stop, place : float
        Where the cell begins and ends, and where the function passes zero, in y [m^2].
    slope, cut_slope : float
        Over y: of the function, and of what the nodes alone give, zero instead of what is negative.
    """

    cell: int
    falls: bool
    start: float
    stop: float
    place: float
    slope: float
    cut_slope: float

    def grown(self, at_start: Any, at_place: Any, at_stop: Any) -> Any:
        """Return by how much something grows over the positive part of the cell."""
        return at_place - at_start if self.falls else at_stop - at_place


def cuts_of(squares: Array, values: Array) -> list[CutCell]:
    """Return where a function given at nodes passes zero.

    Parameters
    ----------
    squares, values : ndarray, (n,)
        y [m^2] of the nodes, and the function there.
    """
    signs, found = values > 0.0, []
    # few cells are cut, and numbers take less time than arrays of a few
    for cell in (signs[:-1] != signs[1:]).nonzero()[0].tolist():
        low, high, start, stop = values.item(cell), values.item(cell + 1), squares.item(cell), squares.item(cell + 1)
        width, falls = stop - start, low > 0.0
        place, slope = start + width * (low / (low - high)), (high - low) / width
        found.append(CutCell(cell, falls, start, stop, place, slope, (-low if falls else high) / width))
    return found


class GridTransforms:
    """Matrices of the transforms on one grid; all take what is given at the nodes to what is there.

    Parameters
    ----------
    nodes : ndarray, (n,)
        Distances from the middle [m], rising from zero.
    """

    borders: Array
    """Where the parts about the nodes begin."""
    gap: Array
    """Change of the equivalent profile by changes of the profile from that in the middle, ``(n, n)``."""
    areas: Array
    """Area [m^2], or width [m] of both sides, for which each node stands, ``(n,)``."""
    force: Array
    """Weights of `integral`, where nothing is cut off, ``(n,)``."""
    in_the_middle: float
    """How much of the springs' displacement in the middle the surface shows there."""

    def __init__(self, nodes: Array) -> None:
        self.nodes, self.squares = nodes, nodes * nodes
        self.widths = np.diff(self.squares)

    def by_values(self, by_slopes: Array) -> Array:
        """Return the matrix that takes values, from the one that takes slopes over y."""
        ratio = by_slopes / self.widths
        matrix = np.zeros((by_slopes.shape[0], self.nodes.size))
        matrix[:, 1:] += ratio
        matrix[:, :-1] -= ratio
        return matrix

    def set_loads(self) -> None:
        """Lay down the matrix of the loads beyond the borders of the parts, once these are known."""
        self._to_nodes = self.load_of_slope(self.squares[:, None], self.borders)
        self._by_slopes = (self._to_nodes[:-1] - self._to_nodes[1:]).T.copy()
        self.outside = self.by_values(self._by_slopes)
        self.rim_load = self.load_of_rim()

    @functools.cached_property
    def springs_at_nodes(self) -> Array:
        """Return `springs_within` the nodes."""
        return np.asarray(self.springs_within(self.squares))

    @functools.cached_property
    def springs_between(self) -> Array:
        """Return how `integral` grows with a depth while what is pressed ends within each cell, on average."""
        return np.cumsum(self.force)[:-1]

    @functools.cached_property
    def node_moments(self) -> list[tuple[float, ...]]:
        """Return `moments` up to each node."""
        return list(zip(*(each.tolist() for each in self.moments(self.squares)), strict=True))

    def load_of_slope(self, upto: Any, border: Array) -> Array:
        """Return what springs of the slope -1 over y up to places in y bear beyond borders, over E*.

        Parameters
        ----------
        upto : float or ndarray
        border : ndarray
            Of a shape that broadcasts with it.
        """
        raise NotImplementedError

    def load_of_rim(self) -> Array:
        """Return what springs displaced by one metre up to the last node bear beyond each border, over E*, ``(n,)``."""
        raise NotImplementedError

    def integral(self, values: Array, cuts: list[CutCell]) -> float:
        """Return what all springs bear that are displaced by values+, in units of which the grids state the force."""
        raise NotImplementedError

    def springs_within(self, squares: Any) -> Any:
        """Return what springs displaced by one metre bear up to places in y, as `integral` has it."""
        raise NotImplementedError

    def pressed(self, values: Array) -> tuple[float, float]:
        """Return `integral`, and how it grows with values that all grow by one metre."""
        cuts = cuts_of(self.squares, values)
        ends = [float(self.springs_within(cut.place)) * (1.0 if cut.falls else -1.0) for cut in cuts]
        rim = self.springs_at_nodes.item(-1) if values[-1] > 0.0 else 0.0
        return self.integral(values, cuts), sum(ends, rim)

    def surface_parts(self, upto: Any, nodes: Array) -> tuple[Array, Array]:
        """Return what the surface shows at nodes of springs displaced by 1 and by y, up to places in y.

        Both have shapes that broadcast.
        """
        raise NotImplementedError

    def moments(self, places: Any) -> tuple[Any, Any]:
        """Return the integrals of 1 and x^2 up to places in y."""
        roots = places**0.5
        return roots, roots * places / 3.0

    def missed(self, cuts: list[CutCell]) -> list[float]:
        """Return by how much the integrals of values(x)+ over the cells of cuts exceed those by nodes alone."""
        found = []
        for cell, falls, start, stop, place, slope, cut_slope in cuts:
            (low, low_second), (high, high_second) = self.node_moments[cell : cell + 2]
            own, own_second = self.moments(place)
            own, own_second = (own - low, own_second - low_second) if falls else (high - own, high_second - own_second)
            by_nodes = high_second - low_second - (stop if falls else start) * (high - low)
            found.append(slope * (own_second - place * own) - cut_slope * by_nodes)
        return found

    def means(self, squares: Array, values: Array) -> Array:
        """Return the means over the parts about the nodes of a function given at the nodes of another grid.

        Parameters
        ----------
        squares, values : ndarray, (m,)
            y of the other nodes, and the function there: straight in y between them, and zero beyond.
        """
        raise NotImplementedError

    def borne(self, values: Array, cuts: list[CutCell]) -> Array:
        """Return what the parts about the nodes bear: their mean pressure over E*, under springs values+."""
        signs = values > 0.0
        slopes = (values[1:] - values[:-1]) / self.widths * (signs[1:] & signs[:-1])
        return self.borne_by(slopes, cuts, max(values.item(-1), 0.0))

    def borne_by(self, slopes: Array, cuts: list[CutCell], rim: float) -> Array:
        """Return `borne` of springs by their slopes over y, zero in the cells of cuts, and by the last spring [m]."""
        beyond = outer_product(self._by_slopes, slopes)
        if cuts:
            inside, places = slice(cuts[-1].cell + 2), np.array([[cut.place] for cut in cuts])
            upto = self._to_nodes[[cut.cell + (not cut.falls) for cut in cuts], inside]
            signed = np.array([cut.slope if cut.falls else -cut.slope for cut in cuts])
            beyond[inside] += signed @ (upto - self.load_of_slope(places, self.borders[inside]))
        if rim > 0.0:
            beyond += rim * self.rim_load
        beyond[:-1] -= beyond[1:]
        return np.asarray(beyond / self.areas)


class SurfaceTransform:
    """The displacement of the surface of what the springs do, on one grid."""

    def __init__(self, grid: GridTransforms) -> None:
        self.grid = grid
        y = grid.squares
        parts = grid.surface_parts(y, grid.nodes[:, None])
        self._parts = tuple(map(np.asfortranarray, parts))
        zeroth, second = (np.diff(part, axis=1) for part in parts)
        matrix = np.zeros((y.size, y.size))
        matrix[:, 1:] += (second - y[:-1] * zeroth) / grid.widths
        matrix[:, :-1] += (y[1:] * zeroth - second) / grid.widths
        matrix[0, 0] = grid.in_the_middle
        self.matrix = matrix

    def __call__(self, values: Array, cuts: list[CutCell]) -> Array:
        """Return u [m] at the nodes of springs displaced by values+."""
        restored = inner_product(self.matrix, np.maximum(values, 0.0))
        for cut in cuts:
            beyond, base = slice(cut.cell + 1, None), cut.stop if cut.falls else cut.start
            at_place = self.grid.surface_parts(cut.place, self.grid.nodes[beyond])
            at_start, at_stop = ([part[beyond, node] for part in self._parts] for node in (cut.cell, cut.cell + 1))
            zeroth, second = map(cut.grown, at_start, at_place, at_stop)
            whole, whole_second = map(sub, at_stop, at_start)
            by_nodes = cut.cut_slope * (whole_second - base * whole)
            restored[beyond] += cut.slope * (second - cut.place * zeroth) - by_nodes
        return restored


def inner_product(matrix: Array, values: Array) -> Array:
    """Return the product of a lower triangular matrix ``(n, n)`` and values ``(n,)``, by blocks that are not zero.

    Values are zero up to where something slips or wears, and so is the product there.
    """
    if values.size <= BLOCK:
        return np.asarray(matrix @ values)
    (worn,) = values.nonzero()
    result = np.zeros(values.size)
    if not worn.size:
        return result
    first, stop = int(worn[0]), int(worn[-1]) + 1
    for low, high in _blocks(first, values.size):
        result[low:high] = matrix[low:high, first : min(high, stop)] @ values[first : min(high, stop)]
    return result


def outer_product(matrix: Array, values: Array) -> Array:
    """Return the same of an upper one ``(n, n - 1)`` with one more diagonal: a part begins in the cell before its node.

    Values are zero beyond the contact, and so is what is borne there.
    """
    if values.size <= BLOCK:
        return np.asarray(matrix @ values)
    pressed = values.nonzero()[0]
    stop = int(pressed[-1]) + 1 if pressed.size else 0
    result = np.zeros(len(matrix))
    for low, high in _blocks(0, stop + 1):
        inside = max(low - 1, 0)
        result[low:high] = matrix[low:high, inside:stop] @ values[inside:stop]
    return result


def _blocks(first: int, end: int) -> list[tuple[int, int]]:
    """Return where blocks of rows begin and end."""
    return [(low, min(low + BLOCK, end)) for low in range(first, end, BLOCK)]
