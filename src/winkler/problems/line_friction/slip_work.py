r"""The loss of a step, and the shift that slip allows.

Without a bulk stress both are sums over the memory.  With one the normal force is steady, so that what slips in a step
bears its final traction all the time,

.. math:: D = \int_{-a}^a q\,\Delta s\,\mathrm dx , \qquad U_s = \int_{-a}^a\frac{s}{\pi\sqrt{a^2-x^2}}\,\mathrm dx ,

the second by reciprocity with a flat punch: it is the shift of the bodies beyond that of a strip that sticks.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np

from winkler.foundation.line import LineFoundation
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array
from winkler.problems.friction.slip_memory import LossPiece, SlipMemory
from winkler.problems.friction.slip_sums import SlipSums
from winkler.problems.line_friction.strips import Strip, slipped, traction

__all__ = ["shift_of_memory", "shift_of_strips", "work_of_strips"]

NODES = 20
"""Between the edges of two strips, where roots at both ends are mapped away."""


def shift_of_memory(sums: SlipSums, memory: SlipMemory, modulus: float) -> float:
    """Return by how much the second body is shifted along x beyond a strip that sticks under this force [m].

    Parameters
    ----------
    sums : SlipSums
        Of the bed.
    memory : SlipMemory
    modulus : float
        E* [Pa].
    """
    if not memory.left.size:
        return 0.0
    force = float(memory.left[0])
    pieces = [
        LossPiece(start, stop, force - right, (right - left) / (stop - start), 0.0)
        for start, stop, left, right in zip(
            memory.edges.tolist(), memory.edges[1:].tolist(), memory.left.tolist(), memory.right.tolist(), strict=False
        )
        if not left == right == force
    ]
    return sums.lost(pieces) / modulus


def work_of_strips(bed: LineFoundation, before: tuple[Strip, ...], after: tuple[Strip, ...]) -> float:
    """Return the friction loss per length of a step under a steady normal force [J/m]."""

    def rubbed(x: Array) -> Array:
        return np.asarray(traction(bed, after, x) * (slipped(bed, after, x) - slipped(bed, before, x)))

    return max(_over_contact(rubbed, (*before, *after)), 0.0)


def shift_of_strips(bed: LineFoundation, strips: tuple[Strip, ...]) -> float:
    """Return by how much the second body is shifted along x beyond a strip that sticks under this force [m]."""
    a = strips[-1].half_width

    def weighed(x: Array) -> Array:
        return np.asarray(slipped(bed, strips, x) / (np.pi * np.sqrt((a - x) * (a + x))))

    return _over_contact(weighed, strips)


def _over_contact(function: Callable[[Array], Array], strips: tuple[Strip, ...]) -> float:
    """Return the integral over the widest strip [m], piece by piece between the edges of all."""
    a = strips[-1].half_width
    ends = [strip.middle + side * strip.half_width for strip in strips for side in (-1.0, 1.0)]
    edges = np.unique(np.clip([-a, *ends, a], -a, a))
    nodes, weights = gauss_legendre(NODES)
    angle = 0.5 * np.pi * (2.0 * nodes - 1.0)
    pieces = [(0.5 * (low + high), 0.5 * (high - low)) for low, high in pairwise(edges.tolist())]
    x = np.concatenate([middle + half * np.sin(angle) for middle, half in pieces])
    share = np.concatenate([np.pi * half * weights * np.cos(angle) for _, half in pieces])
    inside = np.abs(x) < a
    return float(share[inside] @ function(x[inside]))
