r"""Relaxation of the force on a poroelastic half-space, from dual integral equations: sealed below the indenter,
drained beside it.

Biot's theory with incompressible constituents in Hankel (k) and Laplace (s) space, D = a = 1, by the displacement
functions of McNamee and Gibson: with m = sqrt(k^2 + s), eta = (1 - nu)/(1 - 2 nu), K = eta (m + k)/(eta (m + k) - k),
total pressure q and pore pressure p of the surface,

    displacement   u = [K (q - p) + p] / (2 G k),
    flux           f = K (m - k) (q - p) - k p .

q = int phi(t) cos(kt) dt and p = int psi(t) sin(kt)/k dt vanish beside the contact; Abel's transform of u and of f = 0
below the indenter gives two equations of the second kind for phi and psi, solved at the midpoints of panels.  The force
is 2 pi int phi dt; Stehfest's algorithm inverts Laplace's transform.
"""

from __future__ import annotations

import math
import warnings

import numpy as np
from scipy.integrate import quad
from scipy.interpolate import CubicSpline

TERMS = 12
SHAPES = {"flat": lambda x: np.ones(x.size), "ball": lambda x: 1.0 - x**2, "cone": lambda x: 1.0 - x}


def stehfest():
    """Stehfest's weights, Comm. ACM 13 (1970) 47, doi:10.1145/361953.361969."""
    half, weights = TERMS // 2, []
    for i in range(1, TERMS + 1):
        terms = (
            k**half
            * math.factorial(2 * k)
            / (
                math.factorial(half - k)
                * math.factorial(k)
                * math.factorial(k - 1)
                * math.factorial(i - k)
                * math.factorial(2 * k - i)
            )
            for k in range((i + 1) // 2, min(i, half) + 1)
        )
        weights.append((-1) ** (i + half) * sum(terms))
    return weights


WEIGHTS = stehfest()


class Body:
    """The kernels of one Poisson's ratio, as functions of sqrt(s) times a distance."""

    def __init__(self, poisson, farthest):
        self.poisson, self.eta = poisson, (1.0 - poisson) / (1.0 - 2.0 * poisson)
        self.late = 1.0 / (1.0 - 0.5 / self.eta)  # K far out
        z = np.concatenate(
            [
                np.geomspace(1e-5, 0.05, 30, endpoint=False),
                np.linspace(0.05, 6.0, 90, endpoint=False),
                np.geomspace(6.0, farthest, 45),
            ]
        )
        places = np.append(0.0, z)

        def spline(function, kind, start):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                rows = [quad(function, 0.0, np.inf, weight=kind, wvar=y, limit=300)[0] for y in z]
            return CubicSpline(places, np.append(start, rows))

        even = quad(lambda u: self.kernel(u) - self.late, 0.0, np.inf)[0]
        self.bending = spline(lambda u: self.kernel(u) - self.late, "cos", even)
        self.seeping = spline(
            lambda u: (1.0 - self.kernel(u)) / u if u > 0.0 else -1.0 / self.eta, "sin", 0.5 * np.pi * (1.0 - self.late)
        )
        self.flowing = spline(lambda u: self.kernel(u) * (math.sqrt(1.0 + u * u) - u), "sin", 0.25 * np.pi * self.late)
        self.summed = self.flowing.antiderivative()

    def kernel(self, u):
        return 1.0 / (1.0 - u / (self.eta * (u + math.sqrt(1.0 + u * u))))

    def forces(self, s, count):
        """Forces of the three shapes over those of an incompressible body, for a step of depth."""
        root, h = math.sqrt(s), 1.0 / count
        x = (np.arange(count) + 0.5) * h
        apart, together = x[:, None] - x, x[:, None] + x

        def odd(function, y):
            return np.sign(y) * function(root * np.abs(y))

        near, far = root * np.abs(apart), root * together
        identity = 0.5 * np.pi * np.eye(count)
        matrix = np.block(
            [
                [
                    self.late * identity + 0.5 * h * root * (self.bending(near) + self.bending(far)),
                    0.5 * h * (odd(self.seeping, together) - odd(self.seeping, apart)),
                ],
                [
                    0.5 * h * s * (odd(self.flowing, together) + odd(self.flowing, apart)),
                    -identity + 0.5 * h * root * (self.summed(near) - self.summed(far)),
                ],
            ]
        )
        right = np.column_stack([shape(x) for shape in SHAPES.values()])
        found = np.linalg.solve(matrix, np.vstack([right, np.zeros(right.shape)]))[:count]
        return 0.5 * np.pi * found.sum(axis=0) / right.sum(axis=0)

    def shares(self, tau, count=160):
        """g of the three shapes at one time."""
        rate, last = math.log(2.0) / tau, 0.5 / (1.0 - self.poisson)
        force = sum(w * self.forces(i * rate, count) / i for i, w in enumerate(WEIGHTS, 1))
        return dict(zip(SHAPES, (force - last) / (1.0 - last), strict=True))


def lai_hu(tau):
    """g of a flat punch: Y. Lai, Y. Hu, Soft Matter 13 (2017) 852-861."""
    return (
        0.242 * np.exp(-3.13 * tau)
        + 0.536 * np.exp(-1.71 * np.sqrt(tau))
        - 0.043 * np.exp(-12.8 * np.cbrt(tau))
        + 0.266 * np.exp(-0.892 * tau**0.25)
    )
