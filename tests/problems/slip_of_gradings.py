r"""Partial slip of a cylinder on a grading by another route than the package's: an equation of Riccati, and Cauchy's.

With depths times the wave number :math:`\xi`, displacements times it, v = (U, W), and tractions t = (T, S), a wave in a
solid whose moduli change with the depth obeys

.. math:: U' = W + T/G,\quad W' = -nU + S/C_{33},\quad T' = cU + nS,\quad S' = -T ,

so that the compliance, v = Y t, follows from :math:`Y' = A_{11}Y + A_{12} - Y(A_{21}Y + A_{22})` upward from the depth
where nothing changes.  The strip is that of `slip_of_layers`, with the kernel :math:`\int M\sin kx\,\mathrm dk` from
splines and the sine integral of what falls like 1 / k.
"""

from __future__ import annotations

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline
from scipy.special import sici
from slip_of_layers import SlippingCylinder

SHORTEST = 3e3
"""Wave number beyond which M falls like 1 / k, over the inverse of the depth scale."""


def compliance(young, poisson, settled, k):
    """Return Y (2, 2) of a grading at one wave number, from the depth `settled` or where the wave has died out."""

    def parts(z):
        shear = float(young(z)) / (2.0 * (1.0 + poisson))
        n, c = poisson / (1.0 - poisson), 2.0 * shear / (1.0 - poisson)
        stiff = 2.0 * shear * (1.0 - poisson) / (1.0 - 2.0 * poisson)
        return n, c, np.array([[0.0, 1.0], [-n, 0.0]]), np.diag([1.0 / shear, 1.0 / stiff])

    def rate(x, flat):
        y = flat.reshape(2, 2)
        n, c, moved, strained = parts(-x / k)
        loaded, turned = np.array([[c, 0.0], [0.0, 0.0]]), np.array([[0.0, n], [-1.0, 0.0]])
        # upward: x is minus the depth times k
        return -(moved @ y + strained - y @ (loaded @ y + turned)).ravel()

    start = min(settled, 25.0 / k)
    n, c, _, _ = parts(start)
    first = np.array([[-2.0, 1.0 - n], [1.0 - n, -2.0]]) / c
    found = solve_ivp(rate, (-start * k, 0.0), first.ravel(), method="DOP853", rtol=1e-10, atol=1e-13)
    return found.y[:, -1].reshape(2, 2)


class SlippingOnGrading(SlippingCylinder):
    """A cylinder of the radius 1 under a rigid body, E* = 1 of the surface: half-width a, stick half-width c.

    Parameters
    ----------
    young, poisson, settled
        E(z), with E* = 1 at the surface, nu, and the depth below which nothing changes.
    a, c : float
        Half-widths of contact and stick.
    """

    def __init__(self, young, poisson, settled, a, c, count=160):
        places = np.concatenate([[0.0], np.geomspace(1e-3, SHORTEST, 140)])
        found = [compliance(young, poisson, settled, max(k, 1e-6)) for k in places]
        short = 2.0 * (1.0 - poisson**2) / float(young(0.0))
        shares = -np.array([[y[1, 1], y[0, 0]] for y in found]) / short - 1.0
        # k M over k: finite at both ends
        self.normal, self.along = (
            self.kernel(CubicSpline(np.log1p(1e2 * places), (1.0 + places) * share), 2.0 * a) for share in shares.T
        )
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
    def kernel(weighted, end):
        """Return the spline of the integral of M sin kx by k, from 0 to `end`."""
        edges = np.concatenate(
            [[0.0], np.geomspace(1e-3, 1.0 / end, 12), np.arange(1.0, SHORTEST * end, 4.0)[1:] / end]
        )
        edges = np.append(edges, SHORTEST)
        node, weight = np.polynomial.legendre.leggauss(8)
        k = (edges[:-1, None] + np.diff(edges)[:, None] * 0.5 * (node + 1.0)).ravel()
        weights = (0.5 * np.diff(edges)[:, None] * weight).ravel()
        x = end * np.linspace(0.0, 1.0, 600) ** 2
        weights = weights * weighted(np.log1p(1e2 * k)) / (1.0 + k)
        whole = np.array([np.sin(k * place) @ weights for place in x])
        whole += float(weighted(np.log1p(1e2 * SHORTEST))) * (0.5 * np.pi - sici(SHORTEST * x)[0])
        jump = 0.5 * np.pi * float(weighted(np.log1p(1e2 * SHORTEST)))
        whole[1:] -= jump
        whole[0] = 0.0
        return jump, CubicSpline(x, whole)

    def smooth(self, kernel, x, s):
        """Return the kernel over the shares of `rule`: its jump at zero is integrated in closed form."""
        jump, rest = kernel
        far = x[:, None] - s
        return np.sign(far) * rest(np.abs(far)) + jump * self.signs(x, s)

    @staticmethod
    def signs(x, s):
        """Return what stands for sign(x - s): pressures are sums of sin m theta, s = a cos theta."""
        count = s.size
        angle, order = np.pi * np.arange(1, count + 1) / (count + 1), np.arange(2, count + 1)
        a = s[0] / np.cos(angle[0])

        def borne(place):
            first = 0.5 * (place - 0.5 * np.sin(2.0 * place))
            later = np.sin(np.outer(place, order - 1)) / (order - 1) - np.sin(np.outer(place, order + 1)) / (order + 1)
            return np.concatenate([first[:, None], 0.5 * later], axis=1)

        turned = borne(np.full(1, np.pi)) - 2.0 * borne(np.arccos(np.clip(x / a, -1.0, 1.0)))
        modes = np.sin(np.outer(np.arange(1, count + 1), angle)) * (2.0 / (count + 1))
        return turned @ modes / (np.pi * np.sin(angle) / (count + 1))

    def dragged(self, x):
        """Return the right-hand side for mu = 1, inside of the contact."""
        added = self.smooth(self.along, x, self.s) - self.smooth(self.normal, x, self.s)
        return 0.5 * np.pi * x + added @ (self.shares * self.p)
