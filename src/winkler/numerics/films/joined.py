"""What is joined on a grid: islands, paths from one side to the other, and the narrowest place of the widest path."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array


class WidestPath(NamedTuple):
    """The path through a film whose narrowest place is as wide as possible.

    Parameters
    ----------
    gap
        Width of its narrowest place; zero if no path leads through.
    place
        Pixel of that place; (-1, -1) if there is none.
    """

    gap: float
    place: tuple[int, int]


def islands(where: Array, wraps: tuple[bool, bool], *, corners: bool) -> tuple[Array, int]:
    """Return the number of the island of each pixel, zero outside, and how many islands there are.

    Parameters
    ----------
    where
        True on islands, (nx, ny).
    wraps
        Whether the last row joins the first one, along both directions.
    corners
        Whether pixels are joined that touch at a corner only.
    """
    from scipy import ndimage
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    labels, count = ndimage.label(where, np.ones((3, 3)) if corners else None)
    first, second = [np.empty(0, dtype=int)], [np.empty(0, dtype=int)]
    for axis in (0, 1):
        if not wraps[axis]:
            continue
        last, start = np.take(labels, -1, axis), np.take(labels, 0, axis)
        # a corner may lie across both seams: the row beside is shifted round if it wraps, too
        for shift in (-1, 0, 1) if corners else (0,):
            beside = np.roll(start, shift)
            if shift and not wraps[1 - axis]:
                beside[0 if shift > 0 else -1] = 0
            both = (last > 0) & (beside > 0)
            first.append(last[both])
            second.append(beside[both])
    one, other = np.concatenate(first), np.concatenate(second)
    if one.size == 0:
        return labels, int(count)
    graph = coo_array((np.ones(one.size), (one, other)), shape=(count + 1, count + 1))
    groups, group = connected_components(graph, directed=False)
    names = np.zeros(groups, dtype=int)
    order = np.unique(group[1:])
    names[order] = np.arange(1, order.size + 1)
    joined = np.where(labels > 0, names[group[labels]], 0)
    return joined, int(order.size)


def through(where: Array, *, wraps: bool) -> Array:
    """Return the pixels of the parts that join the first to the last row, by their edges, (nx, ny).

    Parameters
    ----------
    where
        True where it is open, (nx, ny).
    wraps
        Whether the last column joins the first one.
    """
    labels, count = islands(where, (False, wraps), corners=False)
    spans = np.zeros(count + 1, dtype=bool)
    spans[np.intersect1d(labels[0], labels[-1])] = True
    spans[0] = False
    return np.asarray(spans[labels])


def widest_path(gap: Array, *, wraps: bool) -> WidestPath:
    """Return the path from the first to the last row whose narrowest place is as wide as possible.

    Parameters
    ----------
    gap
        Width of the film, (nx, ny), zero where it is closed.
    wraps
        Whether the last column joins the first one.
    """
    widths = np.unique(gap[gap > 0.0])
    low, high = -1, widths.size  # open at widths[low], closed at widths[high]
    while high - low > 1:
        middle = (low + high) // 2
        if through(gap >= widths[middle], wraps=wraps).any():
            low = middle
        else:
            high = middle
    if low < 0:
        return WidestPath(0.0, (-1, -1))
    width = widths[low]
    place = np.argwhere((gap == width) & through(gap >= width, wraps=wraps))[0]
    return WidestPath(float(width), (int(place[0]), int(place[1])))
