r"""Partial slip of a cylinder on layers by another route than the package's: singular integral equations of one strip.

Waves are crossed by matrix exponentials (`layer_waves`).  Pressure and traction of a cylinder of the radius 1 on layers
under a rigid body satisfy, with the Hilbert kernel and what the layers add to it,

.. math:: \int_{-a}^a K_N(x-s)\,p\,\mathrm ds = \frac{\pi E^*}2x , \qquad
          \int_{-c}^c K_L(x-s)\,q^*\,\mathrm ds = \mu\int_{-a}^aK_L(x-s)\,p\,\mathrm ds , \quad |x| < c ,

where :math:`q=\mu p-q^*` (Cattaneo).  Both are collocated after Erdogan and Gupta, bounded at both ends.
"""

from __future__ import annotations

import numpy as np
from layer_waves import excesses

NODES = 12


class SlippingCylinder:
    """A cylinder of the radius 1 under a rigid body, E* = 1 of the uppermost layer: half-width a, stick half-width c.

    Parameters
    ----------
    layers, on
        As of `excesses`.
    a, c : float
        Half-widths of contact and stick.
    """

    def __init__(self, layers, on, a, c, count=120):
        thickness = layers[0][2]
        step = min(0.5 / thickness, 2.0 / a, 0.3)
        edges = np.concatenate(
            [[0.0], step * 2.0 ** -np.arange(9.0, 0.0, -1.0), np.arange(step, 22.0 / thickness, step)]
        )
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        self.k = (edges[:-1, None] + np.diff(edges)[:, None] * 0.5 * (nodes + 1.0)).ravel()
        self.weights = (0.5 * np.diff(edges)[:, None] * weights).ravel()
        self.normal, self.along = excesses(layers, on, self.k)
        self.a, self.c = a, c
        self.s, self.shares, x = self.rule(a, count)
        kernel = 1.0 / (x[:, None] - self.s) + self.smooth(self.normal, x, self.s)
        self.p = np.linalg.lstsq(kernel * self.shares, 0.5 * np.pi * x, rcond=None)[0]
        self.load = float(self.shares @ self.p)
        self.inner, self.inner_shares, x = self.rule(c, count)
        kernel = 1.0 / (x[:, None] - self.inner) + self.smooth(self.along, x, self.inner)
        self.q = np.linalg.lstsq(kernel * self.inner_shares, self.dragged(x), rcond=None)[0]
        self.shear = self.load - float(self.inner_shares @ self.q)

    @staticmethod
    def rule(a, count):
        """Return places and shares of sqrt(a^2 - s^2) g(s), and where equations are collocated."""
        angle = np.pi * np.arange(1, count + 1) / (count + 1)
        x = a * np.cos(np.pi * (np.arange(1, count + 2) - 0.5) / (count + 1))
        return a * np.cos(angle), a * np.pi * np.sin(angle) ** 2 / (count + 1), x

    def smooth(self, excess, x, s):
        sines, cosines = np.sin(np.outer(x, self.k)), np.cos(np.outer(x, self.k))
        weighted = excess * self.weights
        return (sines * weighted) @ np.cos(np.outer(self.k, s)) - (cosines * weighted) @ np.sin(np.outer(self.k, s))

    def dragged(self, x):
        """Return the right-hand side for mu = 1, inside of the contact."""
        return 0.5 * np.pi * x + self.smooth(self.along - self.normal, x, self.s) @ (self.shares * self.p)

    def loss(self, count=400):
        """Return the loss per length over mu^2, of pushing once under a steady force: traction times slip."""
        node, weight = np.polynomial.legendre.leggauss(count)
        t = 0.5 * (node + 1.0)
        x = self.c + (self.a - self.c) * t**2  # the slope of the slip begins like a root
        step = (self.a - self.c) * t * weight
        kernel = 1.0 / (x[:, None] - self.inner) + self.smooth(self.along, x, self.inner)
        slope = 2.0 / np.pi * (self.dragged(x) - kernel @ (self.inner_shares * self.q))
        g = np.polynomial.chebyshev.Chebyshev.fit(self.s / self.a, self.p, 40)
        pressure = np.sqrt(self.a**2 - x**2) * g(x / self.a) / self.a
        # integral of p s = integral of s' times what bears farther out
        beyond = np.cumsum((step * pressure)[::-1])[::-1] - 0.5 * step * pressure
        return 2.0 * float(np.sum(step * slope * beyond))
