"""Where the nodes of a grid are on which a contact wears."""

from __future__ import annotations

import numpy as np

from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth, Normal
from winkler.numerics.equations.bracketing import between
from winkler.numerics.types import Array

FINER = 3.0
"""How much closer nodes are where the edge of what sticks moves, than even ones."""
GRID_GROWTH = 1.5
"""How much wider than the contact a grid begins, and how much wider it gets when the contact has grown."""


def first_nodes(bed: Foundation, normal: Normal, radius: float, core: float, count: int) -> Array:
    """Return the nodes on which a contact begins to wear.

    Parameters
    ----------
    bed : Foundation
    normal : Depth or Force
        At a depth the contact never grows beyond where the profile is as high; there the grid ends.
    radius, core : float
        Contact and stick radius before wear [m].
    count : int
        How many nodes beside the axis.
    """
    if isinstance(normal, Depth) and radius < bed.rim:
        depth = float(normal.depth)
        high = GRID_GROWTH * radius
        while high < bed.reach and float(bed.height(np.array([min(high, bed.reach)]))[0]) < depth:
            high *= GRID_GROWTH
        high = min(high, bed.reach, bed.rim)
        if float(bed.height(np.array([high]))[0]) > depth:
            crossing = between(lambda r, _: bed.height(r) - depth, np.array([0.5 * radius]), np.array([high]))
            high = min(1.02 * float(crossing[0]), bed.reach, bed.rim)
    else:
        high = min(GRID_GROWTH * radius, bed.reach, bed.rim)
    return graded_nodes(core, high, bed.rim, count)


def graded_nodes(core: float, reach: float, rim: float, count: int) -> Array:
    """Return distances from the middle to `reach`: close together beyond a core that sticks, and below a rim.

    Parameters
    ----------
    core, reach, rim : float
        Where what sticks ends, where the grid ends, and where the body ends [m].
    count : int
        How many nodes beside the one in the middle.
    """
    if reach == rim:
        nodes = reach * np.sin(0.5 * np.pi * np.linspace(0.0, 1.0, count + 1))
        nodes[-1] = reach
        return nodes
    if not 0.0 < core < 0.98 * reach:
        return np.linspace(0.0, reach, count + 1)
    inner = min(max(round(count * core / reach), count // 8), count - count // 8)
    inside = np.linspace(0.0, core, inner + 1)[:-1]
    return np.append(inside, core + (reach - core) * np.linspace(0.0, 1.0, count - inner + 1) ** 2)


def nodes_about(core: float, reach: float, count: int) -> Array:
    """Return distances from the middle to `reach`: close together on both sides of the edge of what sticks.

    Parameters
    ----------
    core, reach : float
        Where what sticks ends, and where the grid ends [m].
    count : int
        How many nodes beside the one in the middle, half of them within what sticks.
    """
    inner = count // 2
    inside = core * (1.0 - np.linspace(1.0, 0.0, inner + 1)[:-1] ** 1.5)
    return np.append(inside, core + (reach - core) * np.linspace(0.0, 1.0, count - inner + 1) ** 2)


def nodes_between(low: float, high: float, reach: float, count: int) -> Array:
    """Return distances from the middle to `reach`: close together between two radii, and beyond them.

    Parameters
    ----------
    low, high, reach : float
        Between which the edge of what sticks moves, and where the grid ends [m].
    count : int
        How many nodes beside the one in the middle.
    """
    between_both = min(round(FINER * count * (high - low) / reach), count // 3)
    high = high if between_both else low
    rest = count - between_both
    inner = min(max(round(rest * low / reach), rest // 8), rest - rest // 8)
    inside = np.linspace(0.0, low, inner + 1)[:-1]
    moved = np.linspace(low, high, between_both + 1)[:-1]
    return np.concatenate([inside, moved, high + (reach - high) * np.linspace(0.0, 1.0, rest - inner + 1) ** 2])


def halved(nodes: Array) -> Array:
    """Return every other one of nodes [m], the first and the last among them."""
    return np.unique(np.append(nodes[::2], nodes[-1]))
