r"""Strips on layers by another route than the package's: singular integral equations, waves by matrix exponentials.

The pressure of a body f on layers of E* = 1 (of the uppermost one), under a rigid body, satisfies

.. math:: \int K(x-s)\,p(s)\,\mathrm ds = \tfrac\pi2\,f'(x) , \qquad
          K(x) = \frac1x + \int_0^\infty M(k)\sin kx\,\mathrm dk .
"""

from __future__ import annotations

import numpy as np

NODES = 12


class Kernel:
    """K of an excess M over the thickness 1, for strips up to a half-width."""

    def __init__(self, excess, widest):
        step = min(0.5, 1.0 / widest)
        edges = np.concatenate([[0.0], step * 2.0 ** -np.arange(12.0, 0.0, -1.0), np.arange(step, 22.0, step)])
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        self.k = (edges[:-1, None] + np.diff(edges)[:, None] * 0.5 * (nodes + 1.0)).ravel()
        self.weighted = (0.5 * np.diff(edges)[:, None] * weights).ravel() * excess(self.k)

    def __call__(self, x, s):
        sines, cosines = np.sin(np.outer(x, self.k)), np.cos(np.outer(x, self.k))
        smooth = (sines * self.weighted) @ np.cos(np.outer(self.k, s))
        return 1.0 / (x[:, None] - s) + smooth - (cosines * self.weighted) @ np.sin(np.outer(self.k, s))

    def even(self, x, end):
        """Return the integral over s from -end to end."""
        waves = np.sin(np.outer(x, self.k)) @ (2.0 * self.weighted * np.sin(self.k * end) / self.k)
        return np.log(np.abs((x + end) / (x - end))) + waves


def released(kernel, half_width, load, slope, count=120):
    """Return the stress intensity at the edges of a strip under a load, with infinite tension there [E* = 1]."""
    angle = np.pi * (np.arange(count) + 0.5) / count
    s, x = half_width * np.cos(angle), half_width * np.cos(np.pi * np.arange(1, count) / count)
    share = np.pi / count  # of p sqrt(a^2 - s^2)
    rows = np.vstack([kernel(x, s) * share, np.full((1, count), share)])
    g = np.linalg.solve(rows, np.append(0.5 * np.pi * slope(x), load))
    order = np.arange(1, count)
    at_edge = np.mean(g) + 2.0 / count * np.sum(g @ np.cos(np.outer(angle, order)))
    return -at_edge * np.sqrt(np.pi / half_width)


def attracted(kernel, half_width, outer, strength, slope, count=120):
    """Return load and gap at the end of a constant attraction beside a strip whose pressure stays finite."""
    angle = np.pi * np.arange(1, count + 1) / (count + 1)
    s, shares = half_width * np.cos(angle), half_width * np.pi * np.sin(angle) ** 2 / (count + 1)
    x = half_width * np.cos(np.pi * (np.arange(1, count + 2) - 0.5) / (count + 1))
    side = 0.5 * np.pi * slope(x) + strength * kernel.even(x, outer)
    g = np.linalg.lstsq(kernel(x, s) * shares, side, rcond=None)[0]
    inner = shares * g
    order = np.arange(1, count + 1)  # of Chebyshev's U_n, whose Hilbert transform beside the strip is a power
    series = 2.0 / (count + 1) * np.sin(np.outer(order, angle)) @ (np.sin(angle) * g)
    node, weight = np.polynomial.legendre.leggauss(120)
    t = 0.5 * (node + 1.0)
    ramp, grown = t**3 * (10.0 - 15.0 * t + 6.0 * t * t), 30.0 * (t * (1.0 - t)) ** 2
    beside = half_width + (outer - half_width) * ramp
    ratio = beside / half_width
    powers = (ratio - np.sqrt((ratio - 1.0) * (ratio + 1.0)))[:, None] ** order
    pressed = np.pi * powers @ series + (kernel(beside, s) - 1.0 / (beside[:, None] - s)) @ inner
    opening = slope(beside) - 2.0 / np.pi * (pressed - strength * kernel.even(beside, outer))
    gap = 0.5 * (outer - half_width) * float(np.sum(weight * grown * opening))
    return float(np.sum(inner)) - 2.0 * strength * outer, gap
