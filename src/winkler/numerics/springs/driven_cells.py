r"""Cells of a line load that move one another and creep, driven point by point: the loop of a fit.

The cells are those of `winkler.numerics.springs.coupled_cells`.  In every step :math:`a\,d+b\,F=y` is prescribed:
a depth (1, 0), the position of a machine of compliance C (1, C), or a force (0, 1).
"""

from __future__ import annotations

import functools

import numpy as np

from winkler.numerics.jit import compiled
from winkler.numerics.springs.coupled_cells import EDGE_SHIFT
from winkler.numerics.types import Array

SHIFT = EDGE_SHIFT


@functools.lru_cache(maxsize=8)
def cosine_basis(count: int) -> Array:
    """Return the orthonormal waves of cells and their mirror images, ``(2 n, n)``."""
    wave, cell = np.arange(2 * count)[:, None], np.arange(count)[None, :] + 0.5
    basis = np.cos(np.pi * wave * cell / (2 * count)) / np.sqrt(count)
    basis[0] /= np.sqrt(2.0)
    return np.ascontiguousarray(basis)


@compiled
def march(
    driven: Array,
    a: float,
    b: float,
    which: Array,
    lowers: Array,
    units: Array,
    fades: Array,
    shares: Array,
    waves: Array,
    basis: Array,
    shape: Array,
    width: float,
    depth: Array,
    force: Array,
    radius: Array,
) -> int:
    """Write depth [m], force [N] and radius [m] of every point; return how many were done.

    A contact that reaches the last cell, or is a ring, ends the march: then fewer than all are done.

    Parameters
    ----------
    driven : ndarray, (T,)
        y.
    a, b : float
        What is prescribed.
    which : ndarray of int, (T,)
        The length of the step that leads to each point.
    lowers : ndarray, (S, n, n)
        Triangular factors of the compliance in a step of each length.
    units : ndarray, (S, n)
        Their solutions for a depth of one.
    fades, shares : ndarray, (S, K)
        What a step leaves of the memory, and of a steady change of the load.
    waves : ndarray, (K, 2 n)
        How each memory moves each wave [m/Pa].
    basis : ndarray, (2 n, n)
        Of `cosine_basis`.
    shape : ndarray, (n,)
        Of the body in the cells [m].
    width : float
        Of the cells [m].
    depth, force, radius : ndarray, (T,)
        Are written.
    """
    count, terms = shape.size, fades.shape[1]
    memory, load = np.zeros((terms, 2 * count)), np.zeros(2 * count)
    dent, fresh = np.zeros(2 * count), np.zeros(2 * count)
    still, pressed, cells = np.zeros(count), np.zeros(count), np.zeros(count)
    begun = False
    for t in range(driven.size):
        if not begun and (driven[t] <= a * shape[0] if a > 0.0 else driven[t] <= 0.0):
            depth[t], force[t], radius[t] = (driven[t] / a if a > 0.0 else shape[0]), 0.0, 0.0
            continue
        begun = True
        f = which[t]
        lower, unit = lowers[f], units[f]
        for k in range(2 * count):
            dent[k] = 0.0
        for m in range(terms):
            share, fade = shares[f, m], fades[f, m]
            for k in range(2 * count):
                dent[k] += waves[m, k] * (share * load[k] - fade * memory[m, k])
        for i in range(count):
            still[i] = -width * shape[i]
        for k in range(2 * count):
            for i in range(count):
                still[i] -= basis[k, i] * dent[k]
        for i in range(count):
            known = still[i]
            for j in range(i):
                known -= lower[i, j] * still[j]
            still[i] = known / lower[i, i]
        # the depth at which independent springs bear what is prescribed, one more of them at a time
        stiffness, offset, held, d = 0.0, 0.0, 0, 0.0
        while held < count:
            whole = a + 2.0 * b * stiffness
            touched = -still[held] / unit[held]
            if whole > 0.0:
                d = (driven[t] - 2.0 * b * offset) / whole
                if d <= touched:
                    break
            elif driven[t] <= 0.0:
                d = touched
                break
            stiffness += unit[held] * unit[held]
            offset += unit[held] * still[held]
            held += 1
        if held == count:
            return t
        for i in range(count):
            pressed[i] = d * unit[i] + still[i]
        radius[t] = 0.0
        if held > 0:
            inner, outer = pressed[held - 1] / lower[held - 1, held - 1], pressed[held] / lower[held, held]
            radius[t] = width * (held - 0.5 + inner / (inner - outer) + SHIFT)
        depth[t], force[t] = d, 2.0 * (d * stiffness + offset)
        for i in range(held):
            cells[i] = pressed[i]
        for i in range(held - 1, -1, -1):
            cells[i] /= lower[i, i]
            for j in range(i):
                cells[j] -= lower[i, j] * cells[i]
        for k in range(2 * count):
            fresh[k] = 0.0
            for i in range(held):
                fresh[k] += basis[k, i] * cells[i]
        for m in range(terms):
            share, fade = shares[f, m], fades[f, m]
            for k in range(2 * count):
                memory[m, k] = fade * memory[m, k] + share * (fresh[k] - load[k])
        for k in range(2 * count):
            load[k] = fresh[k]
    return driven.size
