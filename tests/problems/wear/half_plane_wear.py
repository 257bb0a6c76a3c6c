"""A worn cylinder by boundary elements in two dimensions, step by step: a reference without winkler.

Elements of even traction on one side of a half-plane, the other is its mirror image; E* = R = 1.  Which elements touch,
and which slip, is found by trying; wear goes in small steps of Heun's method.
"""

from __future__ import annotations

import numpy as np


def lifted(y):
    """Return y ln|y| - y."""
    size = np.where(y == 0.0, 1.0, np.abs(y))
    return y * np.log(size) - y


class WornCylinder:
    """Elements between edges from the middle on, under a force per length; mu is that of friction."""

    def __init__(self, edges, force, mu):
        self.x, self.h, self.force, self.mu = 0.5 * (edges[1:] + edges[:-1]), np.diff(edges), force, mu
        far = [side * self.x[:, None] - edges[None, :] for side in (1.0, -1.0)]
        self.compliance = sum(-2.0 / np.pi * (lifted(y[:, :-1]) - lifted(y[:, 1:])) for y in far)
        # means over elements would count for nothing here: the height in their middle
        self.height = 0.5 * self.x**2
        self.touching = self.x < np.sqrt(4.0 * force / np.pi)

    def _equilibrium(self, rows, right, force):
        """Return what elements bear that are displaced by `right` but for a constant, which the force determines."""
        n = rows.size
        system = np.zeros((n + 1, n + 1))
        system[:n, :n], system[:n, n], system[n, :n] = self.compliance[np.ix_(rows, rows)], -1.0, self.h[rows]
        found = np.linalg.solve(system, np.append(right, 0.5 * force))
        return found[:n], found[n]

    def pressure(self, worn):
        height, touching = self.height + worn, self.touching.copy()
        for _ in range(200):
            rows = np.flatnonzero(touching)
            pressure, depth = np.zeros(self.x.size), 0.0
            pressure[rows], depth = self._equilibrium(rows, -height[rows], self.force)
            overlap = ~touching & (depth - height - self.compliance @ pressure > 1e-14)
            pulled = pressure < 0.0
            if not (overlap.any() or pulled.any()):
                self.touching = touching
                return pressure
            touching = (touching | overlap) & ~pulled
        raise RuntimeError("the contact was not found")

    def slip(self, pressure, shear):
        """Return how far elements slip under a shear force that grows from zero."""
        bound, touches = self.mu * pressure, pressure > 0.0
        slips = np.zeros(self.x.size, dtype=bool)
        for _ in range(200):
            stuck = touches & ~slips
            rows = np.flatnonzero(stuck)
            traction = np.where(slips, bound, 0.0)
            rest = shear - 2.0 * float(self.h @ traction)
            part, shift = self._equilibrium(rows, -(self.compliance @ traction)[rows], rest)
            traction[rows] = part
            ahead = shift - self.compliance @ traction
            over, back = stuck & (traction > bound * (1.0 + 1e-12)), slips & (ahead < -1e-14)
            if not (over.any() or back.any()):
                return np.where(slips, ahead, 0.0)
            slips = (slips | over) & ~back
        raise RuntimeError("stick and slip were not found")

    def fret(self, shear, amount, steps):
        """Return worn depths and pressures after wear of rate times cycles, in equal steps."""
        worn, step = np.zeros(self.x.size), amount / steps

        def rate(worn):
            pressure = self.pressure(worn)
            return 4.0 * pressure * self.slip(pressure, shear)

        for _ in range(steps):
            first = rate(worn)
            worn = worn + 0.5 * step * (first + rate(worn + step * first))
        return worn, self.pressure(worn)

    def slide(self, amount, steps):
        """Return worn depths and pressures after wear of rate times distance, in equal steps."""
        worn, step = np.zeros(self.x.size), amount / steps
        for _ in range(steps):
            first = self.pressure(worn)
            worn = worn + 0.5 * step * (first + self.pressure(worn + step * first))
        return worn, self.pressure(worn)
