r"""Biot's equations below an indenter at a constant depth, by axisymmetric finite elements in space and steps in time.

Another route than `biot_solution`: no transform.  Displacements are quadratic, pore pressures linear (Taylor and Hood);
steps are implicit.  G = D = a = 1, the mesh is graded towards the rim and the surface, and ends at a distance `far`;
below the indenter the surface is sealed, beside it drained.  The parts of the force at first and at last are those of
the same mesh.
"""

from __future__ import annotations

import numpy as np
import scipy.sparse as sparse
from scipy.optimize import brentq
from scipy.sparse.linalg import splu

SHAPES = {
    "flat": lambda r: np.ones(r.size),
    "ball": lambda r: 1.0 - r**2 / 2.0,
    "cone": lambda r: 1.0 - 2.0 / np.pi * r,
}


def graded(first, count, length):
    """Distances that grow in a geometric series from `first` to `length`."""
    growth = brentq(lambda q: first * (q**count - 1.0) / (q - 1.0) - length, 1.0001, 5.0)
    return first * (growth ** np.arange(count + 1) - 1.0) / (growth - 1.0)


def quadratic(x):
    return np.array([x * (x - 1.0) / 2.0, 1.0 - x * x, x * (x + 1.0) / 2.0]), np.array([x - 0.5, -2.0 * x, x + 0.5])


def linear(x):
    return np.array([(1.0 - x) / 2.0, (1.0 + x) / 2.0]), np.array([-0.5, 0.5])


def assembled(r, z, poisson):
    """Stiffness, coupling and flow, as sparse matrices."""
    lame, rows, columns = 2.0 * poisson / (1.0 - 2.0 * poisson), r.size - 1, z.size - 1
    deep, nodes, corners = 2 * columns + 1, (2 * rows + 1) * (2 * columns + 1), r.size * z.size
    i, j = (index.ravel() for index in np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij"))
    at = np.stack([(2 * i + p) * deep + 2 * j + q for p in range(3) for q in range(3)], 1)
    at = np.concatenate([at, at + nodes], 1)
    corner = np.stack([(i + p) * z.size + j + q for p in range(2) for q in range(2)], 1)
    wide, high, middle = np.diff(r)[i], np.diff(z)[j], 0.5 * (r[1:] + r[:-1])[i]
    elastic = np.diag([2.0, 2.0, 2.0, 1.0])
    elastic[:3, :3] += lame
    stiff, coupled, flowing = np.zeros((i.size, 18, 18)), np.zeros((i.size, 18, 4)), np.zeros((i.size, 4, 4))
    for x, one in zip(*np.polynomial.legendre.leggauss(3), strict=True):
        for y, two in zip(*np.polynomial.legendre.leggauss(3), strict=True):
            radius = middle + wide * x / 2.0
            weight = (one * two * wide * high / 4.0 * radius * 2.0 * np.pi)[:, None, None]
            (a, da), (b, db), (c, dc), (e, de) = quadratic(x), quadratic(y), linear(x), linear(y)
            along, down = (
                np.outer(da, b).ravel() * (2.0 / wide)[:, None],
                np.outer(a, db).ravel() * (2.0 / high)[:, None],
            )
            strain = np.zeros((i.size, 4, 18))
            strain[:, 0, :9], strain[:, 1, 9:], strain[:, 2, :9] = along, down, np.outer(a, b).ravel() / radius[:, None]
            strain[:, 3, :9], strain[:, 3, 9:] = down, along
            stiff += weight * (strain.transpose(0, 2, 1) @ elastic @ strain)
            coupled += weight * strain[:, :3].sum(1)[:, :, None] * np.outer(c, e).ravel()
            slope = np.stack(
                [np.outer(dc, e).ravel() * (2.0 / wide)[:, None], np.outer(c, de).ravel() * (2.0 / high)[:, None]], 1
            )
            flowing += weight / (lame + 2.0) * (slope.transpose(0, 2, 1) @ slope)

    def summed(parts, left, right, shape):
        places = np.repeat(left, right.shape[1], 1).ravel(), np.tile(right, (1, left.shape[1])).ravel()
        return sparse.csr_matrix((parts.ravel(), places), shape=shape)

    return (
        summed(stiff, at, at, (2 * nodes, 2 * nodes)),
        summed(coupled, at, corner, (2 * nodes, corners)),
        summed(flowing, corner, corner, (corners, corners)),
    )


def shares(tau, poisson, *, inside=10, outside=20, below=26, far=60.0, steps=14):
    """g of the three shapes at times: the part of what relaxes that is still there."""
    inner = 1.0 - np.linspace(1.0, 0.0, inside + 1) ** 2
    first = inner[-1] - inner[-2]
    r, z = np.append(inner, 1.0 + graded(first, outside, far - 1.0)[1:]), graded(first, below, far)
    stiff, coupled, flowing = assembled(r, z, poisson)
    deep, across, corners = 2 * z.size - 1, 2 * r.size - 1, r.size * z.size
    nodes, top = deep * across, np.arange(across) * deep
    radii = np.interp(np.arange(across), np.arange(0, across, 2), r)
    touched = top[radii < 1.0 + 1e-9] + nodes
    pressed = np.stack([shape(radii[radii < 1.0 + 1e-9]) for shape in SHAPES.values()], 1)
    walls = [np.arange(deep), nodes - 1 - np.arange(deep), nodes + top + deep - 1]
    drained = [
        np.arange(inside, r.size) * z.size,
        np.arange(r.size) * z.size + z.size - 1,
        corners - 1 - np.arange(z.size),
    ]

    def solved(matrix, right, held):
        """Return the unknowns where some are zero and those below the indenter are prescribed."""
        free, found = np.ones(matrix.shape[0], bool), np.zeros((matrix.shape[0], 3))
        free[np.concatenate(held)] = free[touched] = False
        found[touched] = pressed
        found[free] = splu(matrix[free][:, free].tocsc()).solve((right - matrix @ found)[free])
        return found

    def force(moved, pore):
        return (stiff @ moved - coupled @ pore)[touched].sum(axis=0)

    last = force(solved(stiff, np.zeros((2 * nodes, 3)), walls), np.zeros((corners, 3)))
    moved, times = (
        np.zeros((2 * nodes, 3)),
        np.geomspace(tau[0] / 30.0, tau[-1], int(steps * np.log10(30.0 * tau[-1] / tau[0]))),
    )
    forces = []
    for step in np.diff(np.concatenate([[0.0, 1e-9], times])):
        matrix = sparse.bmat([[stiff, -coupled], [-coupled.T, -step * flowing]], format="csr")
        right = np.concatenate([np.zeros((2 * nodes, 3)), -coupled.T @ moved])
        found = solved(matrix, right, [*walls, *(2 * nodes + places for places in drained)])
        moved = found[: 2 * nodes]
        forces.append(force(moved, found[2 * nodes :]))
    shares_ = (np.array(forces) - last) / (forces[0] - last)
    return {name: np.interp(np.log(tau), np.log(times), g) for name, g in zip(SHAPES, shares_[1:].T, strict=True)}
