r"""Integrals over the heights of a body that is given by its area function.

With :math:`h' = h\,e^{-w}` they are smooth for any exponents, however small:

.. math:: \int_0^\infty k(h, D, h D')\,e^{-w}\,\mathrm dw , \qquad
          D = x^2 - \frac{A(h')}\pi = \sum_n \frac{C_n}\pi\,h^{p_n}\,(1-e^{-p_n w}) .
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from winkler.numerics.integrals.adaptive_quadrature import settled
from winkler.numerics.types import Array

__all__ = ["over_heights", "stored", "stretched", "stretching"]

Kernel = Callable[[Array, Array, Callable[[], Array]], Array]
"""Of the height, D and what gives h D', which not all need."""

LARGEST_ROOT = 6.3
"""Largest sqrt(w): exp(-w) is then 6e-18."""


def stretched(h: Array, fall: Array, steep: Callable[[], Array]) -> Array:
    """Return the kernel of g/x."""
    return np.asarray(h / np.sqrt(fall))


def stretching(h: Array, fall: Array, steep: Callable[[], Array]) -> Array:
    """Return the kernel of its derivative with respect to h."""
    return np.asarray((1.0 - 0.5 * steep() / fall) / np.sqrt(fall))


def stored(h: Array, fall: Array, steep: Callable[[], Array]) -> Array:
    """Return the kernel of the integral of g."""
    return np.asarray(h * np.sqrt(fall))


def over_heights(
    terms: Sequence[tuple[float, float]], h: Array, kernel: Kernel, what: str, against: Array | float = 0.0
) -> Array:
    """Integrate kernel(h, D, h dD/dh) exp(-w) over w from 0 on, for every height h; `against` as in `settled`."""
    exponents = np.array([n for _, n in terms])
    areas = np.stack([c / math.pi * h**n for c, n in terms], axis=-1)

    def integrand(node: Array, index: Array) -> Array:
        v = LARGEST_ROOT * node  # w = v^2, because D vanishes like w
        risen = -np.expm1(-exponents[:, None] * (v * v))
        parts = areas[index]  # sums over the terms are products of matrices, which cost least
        found = kernel(h[index, None], parts @ risen, lambda: (parts * exponents) @ risen)
        return found * (2.0 * LARGEST_ROOT * v * np.exp(-v * v))

    # where terms of opposite signs nearly cancel, as close to the reach, A' is not better known than that
    parts = [c * n * h**n for c, n in terms]
    lost = sum((np.abs(part) for part in parts), 0.0 * h) / np.abs(sum(parts, 0.0 * h))
    return settled(integrand, h.size, what, np.finfo(float).eps * lost, against)
