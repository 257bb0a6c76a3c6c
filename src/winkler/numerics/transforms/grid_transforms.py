r"""What all transforms of worn contacts on a grid share: functions that are straight in :math:`y = x^2` between nodes.

A slope over y in one cell adds a known function of the two ends of the cell to every result (`ring_transforms`,
`strip_transforms`).  Pressures are means over parts of the surface about the nodes, so that nothing of the force is
lost, and that they change steadily when the edge of the contact passes a node.  A function that is cut off at zero
within a cell is cut off there, not at the next node: what the cells miss is added.
"""

from __future__ import annotations

import functools

import numpy as np

from winkler.numerics.types import Array

BLOCK = 128
"""Rows of a triangular matrix that are multiplied at once."""


class Cuts:
    """Where a function given at nodes passes zero: cells, places in y, and the two slopes over y.

    Parameters
    ----------
    squares, values : ndarray, (n,)
        y [m^2] of the nodes, and the function there.
    """

    def __init__(self, squares: Array, values: Array) -> None:
        signs = values > 0.0
        self.cells: Array = (signs[:-1] != signs[1:]).nonzero()[0]
        low, high = values[self.cells], values[self.cells + 1]
        self.start, self.stop = squares[self.cells], squares[self.cells + 1]
        width = self.stop - self.start
        self.place = self.start + width * (low / (low - high))
        self.falls: Array = signs[self.cells]
        self.slope = (high - low) / width
        # what the nodes alone give: zero instead of what is negative
        self.cut_slope = np.where(self.falls, -low, high) / width

    @property
    def edge(self) -> float:
        """Where the function falls below zero for the last time, in y [m^2]; zero if nowhere."""
        falls = self.place[self.falls]
        return float(falls[-1]) if falls.size else 0.0

    @property
    def wide(self) -> Array:
        """How wide the positive part of each cell is, in y [m^2]."""
        return np.asarray(np.where(self.falls, self.place - self.start, self.stop - self.place))

    def positive(self, at_nodes: Array, at_place: Array) -> tuple[Array, Array]:
        """Return by how much something grows over the positive part of each cell, and over the whole cell.

        Parameters
        ----------
        at_nodes : ndarray, (..., n)
        at_place : ndarray, (..., cells)
        """
        start, stop = at_nodes[..., self.cells], at_nodes[..., self.cells + 1]
        return np.where(self.falls, at_place - start, stop - at_place), stop - start


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
        self._to_nodes = np.asfortranarray(self.load_of_slope(self.squares))
        self.outside = self.by_values(self._to_nodes[:, :-1] - self._to_nodes[:, 1:])
        self.rim_load = self.load_of_rim()

    @functools.cached_property
    def springs_at_nodes(self) -> Array:
        """Return `springs_within` the nodes."""
        return self.springs_within(self.squares)

    @functools.cached_property
    def node_moments(self) -> Array:
        """Return `moments` up to the nodes."""
        return self.moments(self.squares)

    def load_of_slope(self, upto: Array) -> Array:
        """Return what springs of the slope -1 over y up to places in y bear beyond each border, over E*.

        Parameters
        ----------
        upto : ndarray, (m,)

        Returns
        -------
        ndarray, (n, m)
        """
        raise NotImplementedError

    def load_of_rim(self) -> Array:
        """Return what springs displaced by one metre up to the last node bear beyond each border, over E*, ``(n,)``."""
        raise NotImplementedError

    def integral(self, values: Array, cut: Cuts) -> float:
        """Return what all springs bear that are displaced by values+, in units of which the grids state the force."""
        raise NotImplementedError

    def springs_within(self, squares: Array) -> Array:
        """Return what springs displaced by one metre bear up to places in y, as `integral` has it."""
        raise NotImplementedError

    def pressed(self, values: Array) -> tuple[float, float]:
        """Return `integral`, and how it grows with values that all grow by one metre."""
        cut, upto = Cuts(self.squares, values), self.squares[-1:] * (values[-1] > 0.0)
        ends = np.append(np.where(cut.falls, 1.0, -1.0) * self.springs_within(cut.place), self.springs_within(upto))
        return self.integral(values, cut), float(ends.sum())

    def surface_parts(self, upto: Array) -> tuple[Array, Array]:
        """Return what the surface shows at every node (rows) of springs displaced by 1 and by y, up to places in y."""
        raise NotImplementedError

    def moments(self, places: Array) -> Array:
        """Return the integrals of 1 and x^2 up to places in y ``(2, m)``."""
        roots = np.sqrt(places)
        return np.array([roots, roots * places / 3.0])

    def missed(self, cut: Cuts) -> Array:
        """Return by how much the integrals of values(x)+ over the cells of a cut exceed those by nodes alone."""
        if not cut.cells.size:
            return np.zeros(0)
        (zeroth, second), (whole, whole_second) = cut.positive(self.node_moments, self.moments(cut.place))
        base = np.where(cut.falls, cut.stop, cut.start)
        return np.asarray(cut.slope * (second - cut.place * zeroth) - cut.cut_slope * (whole_second - base * whole))

    def means(self, squares: Array, values: Array) -> Array:
        """Return the means over the parts about the nodes of a function given at the nodes of another grid.

        Parameters
        ----------
        squares, values : ndarray, (m,)
            y of the other nodes, and the function there: straight in y between them, and zero beyond.
        """
        raise NotImplementedError

    def borne(self, values: Array, cut: Cuts) -> Array:
        """Return what the parts about the nodes bear: their mean pressure over E*, under springs values+."""
        beyond = outer_product(self.outside, np.maximum(values, 0.0))
        if cut.cells.size:
            # slopes over the positive part of each cell, less those by nodes alone over the whole cell
            at_place = np.where(cut.falls, cut.slope, -cut.slope)
            at_start, at_stop = cut.cut_slope - np.where(cut.falls, cut.slope, 0.0), np.where(cut.falls, 0.0, cut.slope)
            beyond -= self.load_of_slope(cut.place) @ at_place
            beyond -= self._to_nodes[:, cut.cells] @ at_start
            beyond -= self._to_nodes[:, cut.cells + 1] @ (at_stop - cut.cut_slope)
        if values[-1] > 0.0:
            beyond += values[-1] * self.rim_load
        beyond[:-1] -= beyond[1:]
        return np.asarray(beyond / self.areas)


class SurfaceTransform:
    """The displacement of the surface of what the springs do, on one grid."""

    def __init__(self, grid: GridTransforms) -> None:
        self.grid = grid
        y = grid.squares
        parts = grid.surface_parts(y)
        self._parts = tuple(map(np.asfortranarray, parts))
        zeroth, second = (np.diff(part, axis=1) for part in parts)
        matrix = np.zeros((y.size, y.size))
        matrix[:, 1:] += (second - y[:-1] * zeroth) / grid.widths
        matrix[:, :-1] += (y[1:] * zeroth - second) / grid.widths
        matrix[0, 0] = grid.in_the_middle
        self.matrix = matrix

    def __call__(self, values: Array, cut: Cuts) -> Array:
        """Return u [m] at the nodes of springs displaced by values+."""
        restored = inner_product(self.matrix, np.maximum(values, 0.0))
        if cut.cells.size:
            zeroth, second = map(cut.positive, self._parts, self.grid.surface_parts(cut.place))
            base = np.where(cut.falls, cut.stop, cut.start)
            restored = restored + (second[0] - cut.place * zeroth[0]) @ cut.slope
            restored = restored - (second[1] - base * zeroth[1]) @ cut.cut_slope
        return np.asarray(restored)


def inner_product(matrix: Array, values: Array) -> Array:
    """Return the product of a lower triangular matrix ``(n, n)`` and values ``(n,)``, by blocks that are not zero.

    Values are zero up to where something slips or wears, and so is the product there.
    """
    (worn,) = values.nonzero()
    result = np.zeros(values.size)
    if not worn.size:
        return result
    first, stop = int(worn[0]), int(worn[-1]) + 1
    for low, high in _blocks(first, values.size):
        result[low:high] = matrix[low:high, first : min(high, stop)] @ values[first : min(high, stop)]
    return result


def outer_product(matrix: Array, values: Array) -> Array:
    """Return the same of an upper one with one more diagonal: a part about a node begins in the cell before it.

    Values are zero beyond the contact, and so is what is borne there.
    """
    pressed = values.nonzero()[0]
    stop = int(pressed[-1]) + 1 if pressed.size else 0
    result = np.zeros(values.size)
    for low, high in _blocks(0, min(stop + 1, values.size)):
        inside = max(low - 1, 0)
        result[low:high] = matrix[low:high, inside:stop] @ values[inside:stop]
    return result


def _blocks(first: int, end: int) -> list[tuple[int, int]]:
    """Return where blocks of rows begin and end."""
    return [(low, min(low + BLOCK, end)) for low in range(first, end, BLOCK)]
