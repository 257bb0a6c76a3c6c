"""Wear on layers by another route: rings of even pressure, whose displacements are Hankel integrals of the compliance.

No springs, no tables: the compliance of the stack in closed form, or from the equations of its interface.
"""

import numpy as np
from scipy.linalg import expm
from scipy.special import ellipe, ellipk, j0, j1


def bonded_on_rigid(poisson):
    """1 + M of one layer of unit thickness that is bonded to a rigid base."""
    kappa = 3.0 - 4.0 * poisson

    def compliance(x):
        return (2.0 * kappa * np.sinh(2.0 * x) - 4.0 * x) / (
            2.0 * kappa * np.cosh(2.0 * x) + 4.0 * x**2 + 1.0 + kappa**2
        )

    return compliance


def sliding_on_elastic(ratio):
    """1 + M of a layer of unit thickness that slides on a base that is as compliant as `ratio` layers."""

    def compliance(x):
        s, c = np.sinh(x), np.cosh(x)
        return (s**2 + ratio * (s * c + x)) / (s * c + x + ratio * (s**2 - x**2))

    return compliance


class Discs:
    """Displacements under discs of unit pressure on a layered body of the modulus E*, lengths in m."""

    def __init__(self, compliance, thickness, modulus, share=1.0, reach=16.0, count=600):
        nodes, weights = np.polynomial.legendre.leggauss(count)
        x = 0.5 * reach * (nodes + 1.0)
        self.xi = x / thickness
        self.weights = reach / thickness * 0.5 * weights * share * (compliance(x) - 1.0)
        self.modulus = modulus

    def __call__(self, r, b):
        """u(r) [m/Pa] ``(r, b)``."""
        r, b = np.asarray(r, dtype=float)[:, None], np.asarray(b, dtype=float)[None, :]
        inner, outer = np.minimum(r, b), np.maximum(r, b)
        k = (inner / np.where(outer > 0.0, outer, 1.0)) ** 2
        apart = np.where(k < 1.0, (1.0 - k) * ellipk(np.minimum(k, 1.0 - 1e-15)), 0.0)
        half_space = np.where(r <= b, b * ellipe(k), r * (ellipe(k) - apart)) * 4.0 / (np.pi * self.modulus)
        layers = (j0(r * self.xi) * self.weights / self.xi) @ (b.T * j1(b.T * self.xi)).T
        return half_space + 2.0 / self.modulus * layers


def rings(discs, edges):
    """Displacements at the middles of rings under rings of unit pressure, and their areas and middles."""
    middles = np.sqrt(0.5 * (edges[1:] ** 2 + edges[:-1] ** 2))
    return np.diff(discs(middles, edges), axis=1), np.pi * np.diff(edges**2), middles


def flat_pin(discs, edges, force, rate, distance):
    """Pressures, and what a flat pin has lost, after a distance: a linear problem, by one matrix exponential."""
    matrix, areas, middles = rings(discs, edges)
    inverse = np.linalg.inv(matrix)
    stiff = inverse.sum(axis=1)
    start = force * stiff / (areas @ stiff)
    sinking = np.outer(np.ones(areas.size), areas @ inverse) / (areas @ stiff)
    pressure = expm(rate * distance * inverse @ (sinking - np.eye(areas.size))) @ start
    bent = matrix @ pressure
    depth = (rate * force * distance + areas @ bent) / areas.sum()
    return middles, pressure, depth - bent


def pressed(matrix, areas, height, force):
    """Pressures of rings that bear a force under a height, without tension."""
    touching = np.ones(areas.size, dtype=bool)
    while True:
        (some,) = np.nonzero(touching)
        both = np.block([[matrix[np.ix_(some, some)], -np.ones((some.size, 1))], [areas[some][None], np.zeros((1, 1))]])
        found = np.linalg.solve(both, np.append(-height[some], force))
        pressure = np.zeros(areas.size)
        pressure[some] = found[:-1]
        gap = matrix @ pressure + height - found[-1]
        following = np.where(touching, pressure > 0.0, gap < 0.0)
        if np.all(following == touching):
            return pressure
        touching = following


def ball(discs, edges, curvature, force, rate, distance, steps):
    """What a ball has lost, and its pressures, after a distance, by steps of second order that grow with it."""
    matrix, areas, middles = rings(discs, edges)
    # the mean height of a ring, by which volumes are right
    height, worn = 0.25 * (edges[1:] ** 2 + edges[:-1] ** 2) / curvature, np.zeros(areas.size)
    for step in np.diff(distance * np.linspace(0.0, 1.0, steps + 1) ** 2):
        first = rate * pressed(matrix, areas, height + worn, force)
        worn = worn + step * rate * pressed(matrix, areas, height + worn + 0.5 * step * first, force)
    return middles, pressed(matrix, areas, height + worn, force), worn
