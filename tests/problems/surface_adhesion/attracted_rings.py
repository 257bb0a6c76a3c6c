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


def walled_pull_off(tabor: float, fine: int = 8) -> float:
    """Return the greatest pull over pi R w under the exponential law behind a wall; lengths across in sqrt(R r).

    The edge of what touches is led over rings of which so many, and twice as many, span the zone of attraction beside
    it; the last ring that touches bears the strength.  What is left falls with the square of the rings: 3e-4 at most.
    """
    coarse, finer = _edge_pull_off(tabor, fine), _edge_pull_off(tabor, 2 * fine)
    return finer + (finer - coarse) / 3.0


def _edge_pull_off(tabor: float, fine: int) -> float:
    stiff = tabor**-1.5  # E*, and the zone, in the units of pressures w / r
    jkr = (9.0 * math.pi / 8.0 / stiff) ** (1.0 / 3.0)
    step, inner, outer = stiff / fine, [0.8 * jkr], [1.15 * jkr]
    while inner[-1] > 0.0:
        inner.append(inner[-1] - min(1.15 * (inner[-2] - inner[-1]) if len(inner) > 1 else step, 0.03 * jkr))
    inner[-1] = 0.0
    while outer[-1] < 3.0 * jkr + 10.0:
        outer.append(outer[-1] + (1.12 * (outer[-1] - outer[-2]) if len(outer) > 1 else step))
    edges = np.concatenate((inner[:0:-1], np.arange(inner[0], outer[0] - 0.5 * step, step), outer))
    r, n = 0.5 * (edges[1:] + edges[:-1]), len(edges) - 1
    sunk, height = _sunk(edges, r) / stiff, 0.5 * r * r
    first = int(np.searchsorted(edges, 1.05 * jkr))
    a = edges[first]
    root = np.sqrt(np.clip(1.0 - (r / a) ** 2, 1e-9, None))
    p = np.maximum(2.0 * stiff * a / math.pi * root - math.sqrt(2.0 * stiff / (math.pi * a)) / root, -1.0)
    p, depth = np.where(r < a, p, 0.0), a * a - math.sqrt(2.0 * math.pi * a / stiff)  # JKR, to begin with
    p = np.where(r < a, p, -np.exp(-np.clip(height - depth + sunk @ p, 0.0, 50.0)))
    pulls = []
    for touching in range(first, int(np.searchsorted(edges, 0.82 * jkr)), -max(1, fine // 2)):
        inside = np.arange(n) < touching
        for _ in range(200):
            gap = height - depth + sunk @ p
            pull = np.exp(-np.clip(gap, -3.0, 60.0))
            matrix, left = np.zeros((n + 1, n + 1)), np.append(np.where(inside, gap, p + pull), p[touching - 1] + 1.0)
            matrix[:n, :n] = np.where(inside[:, None], sunk, np.eye(n) - pull[:, None] * sunk)
            matrix[:n, n] = np.where(inside, -1.0, pull)
            matrix[n, touching - 1] = 1.0
            change = np.linalg.solve(matrix, -left)
            share = min(1.0, 1.0 / np.max(np.abs(sunk @ change[:n] - change[n])))
            p, depth = p + share * change[:n], depth + share * change[n]
            if share == 1.0 and np.max(np.abs(change)) < 1e-9:
                break
        pulls.append(float(np.sum(math.pi * np.diff(edges**2) * p)))
    assert 0 < int(np.argmin(pulls)) < len(pulls) - 1
    return -min(pulls) / math.pi
