r"""Wear of a cylinder on layers by other routes than the package's, under a rigid body; E* of the uppermost layer is 1.

Waves are crossed by matrix exponentials (`layer_waves`).  `WornOnLayers` marches boundary elements, to whose compliance
what the layers add is summed wave by wave; `LoneCore` is the contact in which fretting ends: a core that bears alone,
by integral equations collocated after Erdogan and Gupta, unbounded at both ends,

.. math:: \int_{-c}^c K_N(x-s)\,p\,\mathrm ds = \frac{\pi E^*}2x , \qquad \int_{-c}^c K_L(x-s)\,q\,\mathrm ds = 0 ,

at whose edge the traction is as great as friction allows.
"""

from __future__ import annotations

import numpy as np
from half_plane_wear import WornCylinder
from slip_of_layers import excesses

NODES = 12


def wave_rule(thickness, a):
    """Return wave numbers and weights for places up to 4 a apart."""
    step = min(0.5 / thickness, 1.0 / a, 0.3)
    edges = np.concatenate([[0.0], step * 2.0 ** -np.arange(9.0, 0.0, -1.0), np.arange(step, 22.0 / thickness, step)])
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    k = (edges[:-1, None] + np.diff(edges)[:, None] * 0.5 * (nodes + 1.0)).ravel()
    return k, (0.5 * np.diff(edges)[:, None] * weights).ravel()


class WornOnLayers(WornCylinder):
    """Elements between edges from the middle on, on layers (shear, poisson, thickness) on (shear, poisson)."""

    def __init__(self, layers, on, edges, force, mu, half_width):
        super().__init__(edges, force, mu)
        self.touching = self.x < half_width
        k, weights = wave_rule(layers[0][2], edges[-1])
        normal, along = excesses(layers, on, k)
        plain = self.compliance
        self.compliance, self.along = (plain + self.added(excess * weights, k, edges) for excess in (normal, along))

    def added(self, weighted, k, edges):
        """Return what layers add, but for a constant, on both sides together."""
        sines = (np.sin(np.outer((side * self.x[:, None] - edges).ravel(), k)) @ (weighted / k**2) for side in (1, -1))
        rows = (2.0 / np.pi * each.reshape(self.x.size, edges.size) for each in sines)
        even = 4.0 / np.pi * np.diff(edges) * float(np.sum(weighted / k))
        return sum(row[:, :-1] - row[:, 1:] for row in rows) - even

    def slip(self, pressure, shear):
        kept, self.compliance = self.compliance, self.along
        try:
            return super().slip(pressure, shear)
        finally:
            self.compliance = kept


class LoneCore:
    """A core of the half-width c that bears a load per length alone: what it may be pushed with, and where wear ends.

    `shear` is the shear force over mu at which its edge is about to slip.
    """

    def __init__(self, layers, on, c, load, count=80):
        self.k, self.weights = wave_rule(layers[0][2], 3.0 * c)
        self.normal, along = excesses(layers, on, self.k)
        self.c = c
        self.s = c * np.cos(np.pi * (2.0 * np.arange(1, count + 1) - 1.0) / (2.0 * count))
        x = c * np.cos(np.pi * np.arange(1, count) / count)
        share = np.pi / count
        self.p = self.solved(self.normal, x, share, 0.5 * np.pi * x, load)
        q = self.solved(along, x, share, 0.0 * x, 1.0)
        at_edge = [np.polynomial.chebyshev.Chebyshev.fit(self.s / c, g, 40)(1.0) for g in (self.p, q)]
        self.shear = at_edge[0] / at_edge[1]
        self.borne = share * self.p

    def solved(self, excess, x, share, right, load):
        """Return g of g(s)/sqrt(c^2 - s^2), which bears a load."""
        away = x[:, None] - self.s
        added = np.sin(away[..., None] * self.k) @ (excess * self.weights)
        system = share * np.vstack([1.0 / away + added, np.ones(self.s.size)])
        return np.linalg.solve(system, np.append(right, load))

    def worn_less(self, x, place):
        """Return the worn depth at places beyond the core, less than that at another place."""
        level, there = self.level(np.asarray(x)), self.level(np.array([place]))
        return there - level - 0.5 * (np.asarray(x) ** 2 - place**2)

    def level(self, x):
        """Return by how much the surface is sunk at places beyond the core, but for a constant."""
        far = x[:, None] - self.s
        waves = (np.cos(far[..., None] * self.k) - 1.0) @ (self.normal * self.weights / self.k)
        return 2.0 / np.pi * (waves - np.log(np.abs(far))) @ self.borne
