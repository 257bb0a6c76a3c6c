r"""What all transforms of worn contacts on a grid share: functions that are straight in :math:`y = x^2` between nodes.

A slope over y in one cell adds a known function of the two ends of the cell to every result (`ring_transforms`,
`strip_transforms`).  Pressures are means over parts of the surface about the nodes, so that nothing of the force is
lost, and that they change steadily when the edge of the contact passes a node.  A function that is cut off at zero
within a cell is cut off there, not at the next node: what the cells miss is added.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array

__all__ = ["Cuts", "GridTransforms", "SurfaceTransform"]


class Cuts:
    """Where a function given at nodes passes zero: cells, places in y, and the two slopes over y.

    Parameters
    ----------
    squares, values : ndarray, (n,)
        y [m^2] of the nodes, and the function there.
    """

    def __init__(self, squares: Array, values: Array) -> None:
        signs = values > 0.0
        (self.cells,) = np.nonzero(signs[:-1] != signs[1:])
        low, high = values[self.cells], values[self.cells + 1]
        self.start, self.stop = squares[self.cells], squares[self.cells + 1]
        width = self.stop - self.start
        self.place = self.start + width * (low / (low - high))
        self.falls = low > 0.0
        self.slope = (high - low) / width
        # what the nodes alone give: zero instead of what is negative
        self.cut_slope = (np.maximum(high, 0.0) - np.maximum(low, 0.0)) / width
        # where the positive part begins and ends
        self.first = np.where(self.falls, self.start, self.place)
        self.last = np.where(self.falls, self.place, self.stop)

    @property
    def edge(self) -> float:
        """Where the function falls below zero for the last time, in y [m^2]; zero if nowhere."""
        return float(self.place[self.falls][-1]) if np.any(self.falls) else 0.0


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
        to_nodes = self.load_of_slope(np.broadcast_to(self.squares, (self.nodes.size, self.nodes.size)))
        self.outside = self.by_values(to_nodes[:, :-1] - to_nodes[:, 1:])
        self.rim_load = self.load_of_rim()

    def load_of_slope(self, upto: Array) -> Array:
        """Return what springs of the slope -1 over y up to places in y bear beyond each border, over E*.

        Parameters
        ----------
        upto : ndarray, (n, m)
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

    def inside(self, cut: Cuts, upto: float) -> float:
        """Return what springs displaced by one metre bear where a function is positive, if it is so at the axis."""
        whole = float(self.springs_within(np.array([upto]))[0])
        if not cut.cells.size:
            return whole
        ends = self.springs_within(cut.place)
        total = float(np.sum(np.where(cut.falls, ends, -ends)))
        return total if cut.falls[-1] else total + whole

    def surface_parts(self, upto: Array) -> tuple[Array, Array]:
        """Return what the surface shows at every node (rows) of springs displaced by 1 and by y, up to places in y."""
        raise NotImplementedError

    def moments(self, low: Array, high: Array) -> tuple[Array, Array]:
        """Return the integrals of 1 and x^2 between places in y."""
        return np.sqrt(high) - np.sqrt(low), (high**1.5 - low**1.5) / 3.0

    def missed(self, cut: Cuts) -> Array:
        """Return by how much the integrals of values(x)+ over the cells of a cut exceed those by nodes alone."""
        zeroth, second = self.moments(cut.first, cut.last)
        whole = cut.slope * (second - cut.place * zeroth)
        base = np.where(cut.falls, cut.stop, cut.start)
        zeroth, second = self.moments(cut.start, cut.stop)
        return np.asarray(whole - cut.cut_slope * (second - base * zeroth))

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
        beyond = self.outside @ np.maximum(values, 0.0)
        if cut.cells.size:
            shape = (self.nodes.size, cut.cells.size)
            last, first, stop, start = (
                self.load_of_slope(np.broadcast_to(place, shape))
                for place in (cut.last, cut.first, cut.stop, cut.start)
            )
            beyond = beyond - np.sum(cut.slope * (last - first) - cut.cut_slope * (stop - start), axis=1)
        if values[-1] > 0.0:
            beyond = beyond + values[-1] * self.rim_load
        return np.asarray(-np.diff(np.append(beyond, 0.0)) / self.areas)


class SurfaceTransform:
    """The displacement of the surface of what the springs do, on one grid."""

    def __init__(self, grid: GridTransforms) -> None:
        self.grid = grid
        y = grid.squares
        zeroth, second = grid.surface_parts(np.broadcast_to(y[None, :], (y.size, y.size)))
        zeroth, second = np.diff(zeroth, axis=1), np.diff(second, axis=1)
        matrix = np.zeros((y.size, y.size))
        matrix[:, 1:] += (second - y[:-1] * zeroth) / grid.widths
        matrix[:, :-1] += (y[1:] * zeroth - second) / grid.widths
        matrix[0, 0] = grid.in_the_middle
        self.matrix = matrix

    def __call__(self, values: Array, cut: Cuts) -> Array:
        """Return u [m] at the nodes of springs displaced by values+."""
        restored = self.matrix @ np.maximum(values, 0.0)
        if cut.cells.size:
            zeroth, second = self._between(cut.first, cut.last)
            restored = restored + np.sum(cut.slope * (second - cut.place * zeroth), axis=1)
            base = np.where(cut.falls, cut.stop, cut.start)
            zeroth, second = self._between(cut.start, cut.stop)
            restored = restored - np.sum(cut.cut_slope * (second - base * zeroth), axis=1)
        return np.asarray(restored)

    def _between(self, first: Array, last: Array) -> tuple[Array, Array]:
        ends, begins = self.grid.surface_parts(last[None, :]), self.grid.surface_parts(first[None, :])
        return ends[0] - begins[0], ends[1] - begins[1]
