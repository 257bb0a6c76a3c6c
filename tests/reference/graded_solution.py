"""Half-spaces with E = E0 (z/c0)^k, solved in mpmath: theory 8.1 with the angle as the variable of integration.

With x = r sin(phi) no integrand has a root left but the powers sin^k and cos^k themselves,

    g(x) = x Int f'(x sin) cos^k,     u(r) = (2 cos(k pi/2)/pi) Int tan^k (d - g)(r sin).

The modulus is proved by `wave_factor_by_elasticity`, which does not use h_N.
"""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any

import mp_solutions
import mpmath as mp
import numpy as np
from case_solutions import body, si


def factor(k: mp.mpf, nu: mp.mpf) -> mp.mpf:
    """h_N; by continuity at Gibson's k = 1, nu = 1/2 and Holl's nu = 1/(2 + k), where beta = 1."""
    if k == 1:
        return mp.pi / 2
    beta = mp.sqrt((1 + k) * (1 - k * nu / (1 - nu)))
    c = 2 ** (1 + k) * mp.gamma((3 + k + beta) / 2) * mp.gamma((3 + k - beta) / 2) / (mp.pi * mp.gamma(2 + k))
    top = 2 * (1 + k) * mp.cos(k * mp.pi / 2) * mp.gamma(1 + k / 2)
    return top / (mp.sqrt(mp.pi) * c * beta * mp.sin(beta * mp.pi / 2) * mp.gamma((1 + k) / 2))


def wave_factor(k: float, nu: float) -> float:
    """c of C(xi) = c xi^(k-1) for E0 = c0 = 1: a flat punch's pressure put through Hankel's transform."""
    modulus = float(factor(mp.mpf(k), mp.mpf(nu))) / (1 - nu**2)
    return math.pi / (modulus * 2 ** (k - 1) * math.gamma(0.5 * (1 + k)) ** 2)


def wave_factor_by_elasticity(k: float, nu: float) -> float:
    """The same from div sigma = 0: displacements = Y tractions, carried up from z = 20/xi to the surface.

    u_r = u J1, u_z = w J0, sigma_rz = t J1, sigma_zz = s J0 at xi = 1.  With z = y^p all coefficients are bounded.
    """
    from scipy.integrate import solve_ivp

    n, m = nu / (1 - nu), (1 - 2 * nu) / (1 - nu)
    power = 2.0 / (1.0 - abs(k))
    deep = 20.0 ** (1.0 / power)

    def rate(path: float, y: np.ndarray) -> np.ndarray:
        place = deep - path
        z, stretch = place**power, power * place ** (power - 1.0)
        shear = z**k / (2 * (1 + nu)) if place > 0 else 1.0
        soft = stretch / shear if place > 0 else 0.0
        now = y.reshape(2, 2)
        a, d = np.array([[0.0, 1.0], [-n, 0.0]]), np.array([[0.0, n], [-1.0, 0.0]])
        b, c = np.diag([1.0, 0.5 * m]), np.diag([2.0 / (1 - nu), 0.0])
        return -(stretch * (a @ now - now @ d) + soft * b - stretch * shear * now @ c @ now).ravel()

    shear = 20.0**k / (2 * (1 + nu))
    start = np.array([[-2 * (1 - nu), 1 - 2 * nu], [1 - 2 * nu, -2 * (1 - nu)]]) / (2 * shear)
    found = solve_ivp(rate, (0.0, deep), start.ravel(), method="DOP853", rtol=1e-11, atol=1e-13, max_step=deep / 200)
    return float(-found.y[3, -1])


class ReferenceSolution:
    """The contact of one case on graded bodies; to be evaluated within mp.workdps."""

    def __init__(self, problem: dict[str, Any]) -> None:
        self.problem = problem
        medium = problem["bed"]["medium"]
        solids = [
            medium[word] for word in ("first", "second") if medium.get(word, {}).get("kind") == "power_law_graded"
        ]
        self.k = mp.mpf(str(solids[0]["exponent"]))
        assert all(mp.mpf(str(solid["exponent"])) == self.k for solid in solids)
        flexible = mp.mpf(0)
        for solid in solids:
            nu = mp.mpf(str(solid["poisson"]))
            surface = si(solid["young"]) / si(solid["depth_scale"]) ** self.k
            flexible += (1 - nu**2) / (factor(self.k, nu) * surface)
        self.surface = 1 / flexible
        self.body: mp_solutions.Body = body(problem["bed"]["profile"])
        assert len(self.body.pieces) == 1, "smooth bodies alone"
        self.exponent = mp.mpf({"paraboloid": 2, "cone": 1, "flat_punch": 1}.get(problem["bed"]["profile"]["kind"], 0))
        if problem["bed"]["profile"]["kind"] == "power_law":
            self.exponent = mp.mpf(str(problem["bed"]["profile"]["exponent"]))
        assert self.exponent > 0, "powers of r alone"

    def gap_by_quadrature(self, x: mp.mpf) -> mp.mpf:
        """g(x) of any smooth body."""
        slope = self.body.pieces[0].slope
        return x * mp.quad(lambda t: slope(x * mp.sin(t)) * mp.cos(t) ** self.k, [0, mp.pi / 4, mp.pi / 2])

    def gap(self, x: mp.mpf) -> mp.mpf:
        """g(x) of c r^n: the same integral is a beta function."""
        n = self.exponent
        return mp.beta(n / 2, (1 + self.k) / 2) / 2 * x * self.body.pieces[0].slope(x)

    def gap_slope(self, x: mp.mpf) -> mp.mpf:
        return self.exponent * self.gap(x) / x

    def _springs(self, power: int) -> mp.mpf:
        """Int x^k (d - g)^power dx, with x = a s^(1/(1+k)): no power of x is left."""
        n = 1 + self.k
        a, d = self.radius, self.depth
        return a**n / n * mp.quad(lambda s: (d - self.gap(a * s ** (1 / n))) ** power, [0, mp.mpf(1) / 2, 1])

    @cached_property
    def radius(self) -> mp.mpf:
        load = self.problem["load"]
        if self.body.rim < mp.inf:
            return self.body.rim
        if load["kind"] == "radius":
            return si(load["radius"])
        assert load["kind"] == "depth", "radius or depth"
        depth = si(load["depth"])
        size = si(self.problem["bed"]["profile"]["curvature_radius"])
        return mp.findroot(lambda a: self.gap(a) / depth - 1, mp.sqrt(size * depth))

    @cached_property
    def depth(self) -> mp.mpf:
        load = self.problem["load"]
        return si(load["depth"]) if load["kind"] == "depth" else self.gap(self.radius)

    @cached_property
    def force(self) -> mp.mpf:
        return 2 * self.surface * self._springs(1)

    @cached_property
    def energy(self) -> mp.mpf:
        return self.surface * self._springs(2)

    @property
    def stiffness(self) -> mp.mpf:
        return 2 * self.surface * self.radius ** (1 + self.k) / (1 + self.k)

    def pressure(self, r: mp.mpf) -> mp.mpf:
        """(E*/(pi c0^k)) [Int g'(x) (x^2-r^2)^((k-1)/2) dx + (d - g(a)) (a^2-r^2)^((k-1)/2)]."""
        leg = mp.sqrt(self.radius**2 - r**2)
        inner = mp.mpf(0)
        if self.body.rim == mp.inf:

            def density(w: mp.mpf) -> mp.mpf:  # x = hypot(r, w)
                x = mp.hypot(r, w)
                return self.gap_slope(x) * w**self.k / x

            inner = mp.quad(density, [0, leg / 2, leg])
        edge = self.depth - self.gap(self.radius) if self.body.rim < mp.inf else mp.mpf(0)
        return self.surface / mp.pi * (inner + edge * leg ** (self.k - 1))

    def displacement(self, r: mp.mpf) -> mp.mpf:
        end = mp.asin(min(mp.mpf(1), self.radius / r))

        def density(t: mp.mpf) -> mp.mpf:
            return mp.tan(t) ** self.k * (self.depth - self.gap(r * mp.sin(t)))

        return 2 * mp.sin((1 - self.k) * mp.pi / 2) / mp.pi * mp.quad(density, [0, end / 2, end])

    def quantity(self, expectation: dict[str, Any]) -> mp.mpf:
        """The number that an entry of [[expect]] requests, SI."""
        if "r" in expectation:
            return getattr(self, expectation["quantity"])(si(expectation["r"]))
        return getattr(self, expectation["quantity"])
