"""A ball under a Lennard-Jones law of the surfaces on rings, after Greenwood: the gap of its middle is prescribed."""

from __future__ import annotations

import math

import numpy as np
from scipy.special import ellipk

NODES, RING_NODES = 24, 160


def pull_off(tabor: float) -> float:
    """Return the greatest pull over pi R w; lengths across in sqrt(R z0), gaps in z0."""
    edges = np.concatenate((np.linspace(0.0, 6.0, RING_NODES), 6.0 + 34.0 * np.linspace(0.0, 1.0, 50)[1:] ** 2))
    r = 0.5 * (edges[1:] + edges[:-1])
    sunk = tabor**1.5 * _sunk(edges, r)
    height, area = 0.5 * r * r, math.pi * np.diff(edges**2)
    middle, pulls = np.concatenate((np.geomspace(6.0, 1.2, 40), np.linspace(1.19, 0.9, 60))), []
    gap, depth, n = height + middle[0], -middle[0], r.size
    for wanted in middle:
        for _ in range(60):
            p = -8.0 / 3.0 * (gap**-3 - gap**-9)
            bend = -8.0 / 3.0 * (9.0 * gap**-10 - 3.0 * gap**-4)
            left = np.append(gap - height + depth - sunk @ p, gap[0] - wanted)
            matrix = np.zeros((n + 1, n + 1))
            matrix[:n, :n] = np.eye(n) - sunk * bend
            matrix[:n, n], matrix[n, 0] = 1.0, 1.0
            step = np.linalg.solve(matrix, -left)
            share = 1.0
            while np.any(gap + share * step[:n] < 0.6 * gap):
                share *= 0.5
            gap, depth = gap + share * step[:n], depth + share * step[n]
            if share == 1.0 and np.max(np.abs(step)) < 1e-10:
                break
        pulls.append(float(np.sum(area * p)))
    return -min(pulls) / math.pi


def _sunk(edges: np.ndarray, r: np.ndarray) -> np.ndarray:
    """Return displacements at r under unit pressures on rings, E* = 1, by quadrature graded to the middle of each."""
    x, w = np.polynomial.legendre.leggauss(NODES)
    t, matrix = 0.5 * (x + 1.0), np.zeros((r.size, r.size))
    for j, middle in enumerate(r):
        for end in (edges[j], edges[j + 1]):
            s = middle + (end - middle) * t**3
            weight = 0.5 * w * 3.0 * t * t * abs(end - middle)
            total = r[:, None] + s
            m = np.minimum(4.0 * r[:, None] * s / total**2, 1.0 - 1e-15)
            matrix[:, j] += 4.0 / math.pi * np.sum(s / total * ellipk(m) * weight, axis=1)
    return matrix


def walled_pull_off(tabor: float, count: int) -> float:
    """Return the greatest pull over pi R w under the exponential law behind a wall; lengths across in sqrt(R r).

    First the gap of the middle is prescribed, then how many rings are in touch; the last of them bears the strength.
    """
    wide = 2.9 * math.sqrt(tabor)
    edges = np.concatenate(
        (np.linspace(0.0, wide, count), wide + (10.0 + 0.2 * wide) * np.linspace(0, 1, 60)[1:] ** 1.6)
    )
    r = 0.5 * (edges[1:] + edges[:-1])
    sunk, height, n = tabor**1.5 * _sunk(edges, r), 0.5 * r * r, r.size
    p, depth, pulls = np.zeros(n), -6.0, []
    steps = [(0, gap) for gap in np.linspace(6.0, 0.02, 60)]
    steps += [(touching, 0.0) for touching in range(1, int(0.75 * count), max(1, count // 60))]
    for touching, wanted in steps:
        inside = np.arange(n) < touching
        for _ in range(80):
            gap = height - depth + sunk @ p
            pull = np.exp(-np.clip(gap, -3.0, 60.0))
            matrix, left = np.zeros((n + 1, n + 1)), np.append(np.where(inside, gap, p + pull), 0.0)
            matrix[:n, :n] = np.where(inside[:, None], sunk, np.eye(n) - pull[:, None] * sunk)
            matrix[:n, n] = np.where(inside, -1.0, pull)
            if touching:
                matrix[n, touching - 1], left[n] = 1.0, p[touching - 1] + 1.0
            else:
                matrix[n, :n], matrix[n, n], left[n] = sunk[0], -1.0, gap[0] - wanted
            step = np.linalg.solve(matrix, -left)
            share = min(1.0, 1.0 / np.max(np.abs(sunk @ step[:n] - step[n])))
            p, depth = p + share * step[:n], depth + share * step[n]
            if share == 1.0 and np.max(np.abs(step)) < 1e-9:
                break
        pulls.append(float(np.sum(math.pi * np.diff(edges**2) * p)))
    return -min(pulls) / math.pi
