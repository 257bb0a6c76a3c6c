r"""Matrices of two by two blocks for many wave numbers at once: sums, products and inverses, entry by entry."""

from __future__ import annotations

from winkler.numerics.types import ComplexArray

Four = tuple[ComplexArray, ComplexArray, ComplexArray, ComplexArray]


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
