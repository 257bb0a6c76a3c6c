r"""Matrices of two by two blocks for many wave numbers at once: sums, products and inverses, entry by entry."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import ComplexArray

__all__ = ["Four", "add", "four", "invert", "matrix", "scaled", "stacked", "times"]

Four = tuple[ComplexArray, ComplexArray, ComplexArray, ComplexArray]


def matrix(rows: list[list[ComplexArray | float]]) -> ComplexArray:
    """Return 2x2 matrices ``(..., 2, 2)`` of entries that broadcast."""
    entries = np.broadcast_arrays(*(entry for row in rows for entry in row))
    return np.stack(entries, axis=-1).reshape(*entries[0].shape, 2, 2)


def four(matrix: ComplexArray) -> Four:
    """Return the four entries of matrices of two by two."""
    parts = np.ascontiguousarray(matrix.reshape(-1, 4).T)
    return parts[0], parts[1], parts[2], parts[3]


def stacked(four: Four) -> ComplexArray:
    """Return matrices of two by two from their four entries."""
    return np.stack(four, axis=-1).reshape(-1, 2, 2)


def add(one: Four, other: Four) -> Four:
    """Return one + other."""
    return one[0] + other[0], one[1] + other[1], one[2] + other[2], one[3] + other[3]


def scaled(factor: ComplexArray | float, four: Four) -> Four:
    """Return factor times a matrix."""
    return factor * four[0], factor * four[1], factor * four[2], factor * four[3]


def times(one: Four, other: Four) -> Four:
    """Return the product of two matrices."""
    (a, b, c, d), (e, f, g, h) = one, other
    return a * e + b * g, a * f + b * h, c * e + d * g, c * f + d * h


def invert(four: Four) -> Four:
    """Return the inverse of a matrix."""
    a, b, c, d = four
    scale = 1.0 / (a * d - b * c)
    return d * scale, -b * scale, -c * scale, a * scale
