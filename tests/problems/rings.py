"""A contact solver without springs: rings of uniform pressure, and complementarity.

The surface is cut into concentric rings; a ring's displacement is the difference of two uniformly loaded discs (Love),

    u(r) = (4 p b/(pi E*)) E(r^2/b^2) inside, (4 p r/(pi E*)) [E(m) - (1 - m) K(m)], m = b^2/r^2, outside.

Pressures p >= 0 and gaps f - d + u >= 0 with p gap = 0 are found by a primal-dual active set.  Any number of rings and
holes may come out; the solution is first-order accurate in the width of the rings.  E* = 1.
"""

from __future__ import annotations

import functools
from typing import NamedTuple

import numpy as np
from scipy.special import ellipe, ellipk


class Answer(NamedTuple):
    """Force, pressures on the rings, the rings in contact, and how well complementarity holds."""

    force: float
    pressure: np.ndarray
    touching: np.ndarray
    middle: np.ndarray
    edges: np.ndarray

    @property
    def patches(self) -> list[tuple[int, int]]:
        """First and last ring of each connected patch of contact."""
        marks = np.flatnonzero(np.diff(np.concatenate([[0], self.touching.astype(int), [0]])))
        return [(int(a), int(b) - 1) for a, b in zip(marks[::2], marks[1::2], strict=True)]

    @property
    def is_disc(self) -> bool:
        """Whether the contact is one disc about the axis."""
        return len(self.patches) == 1 and self.patches[0][0] == 0

    @property
    def radius(self) -> float:
        """Outer radius of the contact."""
        return float(self.edges[self.patches[-1][1] + 1])

    @property
    def clear(self) -> bool:
        """Whether every hole and every outer patch is at least three rings wide: not a matter of resolution."""
        patches = self.patches
        holes = [after[0] - before[1] - 1 for before, after in zip(patches, patches[1:], strict=False)]
        if patches and patches[0][0] > 0:
            holes.append(patches[0][0])
        return min([*holes, *[b - a + 1 for a, b in patches]], default=9) >= 3


def _disc(r: np.ndarray, b: np.ndarray) -> np.ndarray:
    inside = r <= b
    m_in = np.where(inside, r / np.where(b > 0.0, b, 1.0), 0.0) ** 2
    m_out = np.where(inside, 0.0, b / r) ** 2
    outside = r * (ellipe(m_out) - (1.0 - m_out) * ellipk(m_out))
    return 4.0 / np.pi * np.where(inside, b * ellipe(m_in), outside)


@functools.lru_cache(maxsize=8)
def influence(edges: tuple[float, ...]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Displacement of the middle of each ring under unit pressure on each ring; the middles; the edges."""
    edges = np.array(edges)
    middle = 0.5 * (edges[1:] + edges[:-1])
    discs = _disc(middle[:, None], edges[None, :])
    return np.diff(discs, axis=1), middle, edges


def press(profile, depth: float, reach: float = 1.0, count: int = 400, edges: tuple[float, ...] = ()) -> Answer:
    """Press a profile to a depth; nothing beyond `reach` (or the last of the edges) may touch."""
    matrix, middle, edges = influence(edges or tuple(np.linspace(0.0, reach, count + 1)))
    count = middle.size
    load = depth - profile.height(middle)
    touching = load > 0.0
    for _ in range(200):
        pressure = np.zeros(count)
        inside = np.flatnonzero(touching)
        if inside.size:
            pressure[inside] = np.linalg.solve(matrix[np.ix_(inside, inside)], load[inside])
        gap = matrix @ pressure - load
        new = np.where(touching, pressure > 0.0, gap < -1e-14 * depth)
        if np.array_equal(new, touching):
            break
        touching = new
    else:
        raise AssertionError("the active set did not settle")
    assert pressure.min() >= 0.0
    assert gap.min() >= -1e-10 * depth
    return Answer(float(np.pi * pressure @ np.diff(edges**2)), pressure, touching, middle, edges)
