"""Coated bodies by another road: all conditions of elasticity in one matrix, and the pressure of least energy.

Nothing of winkler is used.  A layer carries four waves, two that fade downward and two that fade upward; one linear
system holds the tractions at the surface and the continuity at every interface, and gives the compliance C(xi).  The
pressure under a punch is a sum of those whose line loads are Legendre polynomials,

    q(x) = Sum c_n P_2n(x/a),     p^(xi) = (a/pi) Sum c_n (-1)^n j_2n(xi a),

and minimises  pi Int C p^^2 xi dxi - Int p h 2 pi r dr:  a small symmetric system.  There is no integral equation, no
kernel and no grid in x.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from typing import NamedTuple

import mpmath as mp
import numpy as np
from scipy.special import eval_legendre, j0, spherical_jn

FINE = 0.02
"""Below this xi times the thinnest layer the waves of a layer are nearly alike: 40 digits are needed."""


class Sheet(NamedTuple):
    """A layer."""

    young: float
    poisson: float
    thickness: float


class Stack(NamedTuple):
    """Layers from the top, their base (None: rigid), and the other body (None: rigid)."""

    layers: tuple[Sheet, ...]
    base: tuple[float, float] | None = None
    other: tuple[float, float] | None = None

    @property
    def length(self) -> float:
        return self.layers[0].thickness

    @property
    def surface(self) -> float:
        """1/E* of the uppermost layer and the other body: C xi / 2 of very short waves."""
        top = self.layers[0]
        return flexibility(top.young, top.poisson) + (flexibility(*self.other) if self.other else 0.0)


class Profile(NamedTuple):
    """A body with E(z) = deep + (surface - deep) exp(-z/scale), and the other body (None: rigid)."""

    shallow: float
    deep: float
    length: float
    poisson: float
    other: tuple[float, float] | None = None

    @property
    def surface(self) -> float:
        """1/E* at the very top."""
        return flexibility(self.shallow, self.poisson) + (flexibility(*self.other) if self.other else 0.0)


def flexibility(young: float, poisson: float) -> float:
    """(1 - nu^2) / E."""
    return (1 - poisson**2) / young


def _waves(young, poisson, x, fade_down, fade_up, count, wide):
    """Rows u_r, u_z, shear, normal traction; columns the waves; everything over the unit shear modulus times xi.

    A wave is e^{-sx} (u, w) with s = 1 (falling) or -1 (rising), from div sigma = 0 in cylindrical coordinates.
    """
    shear = young / (2 * (1 + poisson))
    kappa = 3 - 4 * poisson
    columns = []
    for s, fade in ((1, fade_down), (-1, fade_up))[: count // 2]:
        # u, w, du/dx, dw/dx and the dilatation over 1 - 2 nu, which stays finite at nu = 1/2
        for u, w, du, dw, swell in (
            (1, s, -s, -1, 0),
            (x, s * x + kappa, 1 - s * x, s - s * (s * x + kappa), -2 * s),
        ):
            parts = (u, w, shear * (du - w), 2 * shear * (dw + poisson * swell))
            columns.append([wide(part) * fade for part in parts])
    return columns


def compliance_exactly(stack: Stack, xi: float) -> float:
    """xi C(xi) of the coated body, in 40 digits."""
    with mp.workdps(40):
        k = mp.mpf(float(xi))
        layers = [(mp.mpf(str(s.young)), mp.mpf(str(s.poisson)), mp.mpf(str(s.thickness))) for s in stack.layers]
        size = 4 * len(layers) + (2 if stack.base else 0)
        matrix, right = mp.zeros(size), mp.zeros(size, 1)

        def put(row: int, column: int, columns, rows: slice, sign: int) -> None:
            for j, entries in enumerate(columns):
                for i, entry in enumerate(entries[rows]):
                    matrix[row + i, column + j] = sign * entry

        top = None
        row = 2
        for i, (young, nu, h) in enumerate(layers):
            whole = mp.exp(-k * h)
            upper = _waves(young, nu, mp.mpf(0), mp.mpf(1), whole, 4, mp.mpf)
            lower = _waves(young, nu, k * h, whole, mp.mpf(1), 4, mp.mpf)
            if top is None:
                top = upper
                put(0, 0, upper, slice(2, 4), 1)
            else:
                put(row - 4, 4 * i, upper, slice(0, 4), -1)
            put(row, 4 * i, lower, slice(0, 4) if i + 1 < len(layers) or stack.base else slice(0, 2), 1)
            row += 4
        if stack.base:
            young, nu = (mp.mpf(str(v)) for v in stack.base)
            put(row - 4, 4 * len(layers), _waves(young, nu, mp.mpf(0), mp.mpf(1), None, 2, mp.mpf), slice(0, 4), -1)
        right[1] = -1
        waves = mp.lu_solve(matrix, right)
        return float(mp.fsum(top[j][1] * waves[j] for j in range(4)))


def _compliance_quickly(stack: Stack, xi: np.ndarray) -> np.ndarray:
    """The same for many wave numbers at once, in doubles."""
    size = 4 * len(stack.layers) + (2 if stack.base else 0)
    matrix, right = np.zeros((xi.size, size, size)), np.zeros((xi.size, size, 1))

    def put(row: int, column: int, columns, rows: slice, sign: int) -> None:
        for j, entries in enumerate(columns):
            for i, entry in enumerate(entries[rows]):
                matrix[:, row + i, column + j] = sign * entry

    def wide(number):
        return np.broadcast_to(np.asarray(number, dtype=float), xi.shape)

    one, top, row = np.ones_like(xi), None, 2
    for i, (young, nu, h) in enumerate(stack.layers):
        whole = np.exp(-xi * h)
        upper = _waves(young, nu, 0.0, one, whole, 4, wide)
        lower = _waves(young, nu, xi * h, whole, one, 4, wide)
        if top is None:
            top = upper
            put(0, 0, upper, slice(2, 4), 1)
        else:
            put(row - 4, 4 * i, upper, slice(0, 4), -1)
        put(row, 4 * i, lower, slice(0, 4) if i + 1 < len(stack.layers) or stack.base else slice(0, 2), 1)
        row += 4
    if stack.base:
        put(row - 4, 4 * len(stack.layers), _waves(*stack.base, 0.0, one, one, 2, wide), slice(0, 4), -1)
    right[:, 1] = -1.0
    waves = np.linalg.solve(matrix, right)[:, :4, 0]
    return np.sum(np.stack([column[1] for column in top], axis=-1) * waves, axis=1)


def _graded_compliance(body: Profile, xi: np.ndarray) -> np.ndarray:
    """xi C(xi) of a body graded in depth, all waves at once: displacements = Y tractions / xi, carried upward.

    From div sigma = 0 with u_r = u J1, u_z = w J0, sigma_rz = t J1, sigma_zz = s J0, where u, w, t/xi, s/xi follow

        u' = w + t/G,  w' = -n u + m s/(2G),  t' = 2 G u/(1-nu) + n s,  s' = -t,  each over xi,

    n = nu/(1-nu), m = (1-2nu)/(1-nu): without layers.
    """
    from scipy.integrate import solve_ivp

    nu = body.poisson
    n, m = nu / (1 - nu), (1 - 2 * nu) / (1 - nu)
    # nothing changes below 40 lengths, and nothing matters below 20/xi
    start = np.minimum(40.0 * body.length, 20.0 / xi)

    def shear(z: np.ndarray) -> np.ndarray:
        return (body.deep + (body.shallow - body.deep) * np.exp(-z / body.length)) / (2 * (1 + nu))

    def rate(path: float, y: np.ndarray) -> np.ndarray:
        # Y is symmetric: u of a shear load, u of a pressure (or w of a shear load), w of a pressure
        a, b, c = y.reshape(3, -1)
        g = shear(start * path**2)  # z = start path^2: finer near the surface
        stretch, hoop = 2.0 * path * start * xi, 2.0 * g / (1 - nu)
        change = [2.0 * b + 1.0 / g - hoop * a**2, c - n * a - hoop * a * b, 0.5 * m / g - 2.0 * n * b - hoop * b**2]
        return np.concatenate([stretch * part for part in change])

    g = shear(start)
    first = np.array([-2 * (1 - nu) / (2 * g), (1 - 2 * nu) / (2 * g), -2 * (1 - nu) / (2 * g)])
    found = solve_ivp(
        rate, (1.0, 0.0), first.ravel(), method="DOP853", rtol=1e-11, atol=1e-13 / body.deep, max_step=0.01
    )
    return -found.y[:, -1].reshape(3, -1)[2]


def compliance(stack: Stack | Profile, xi: np.ndarray) -> np.ndarray:
    """xi C(xi) [1/Pa] of both bodies."""
    xi = np.asarray(xi, dtype=float)
    if isinstance(stack, Profile):
        return _graded_compliance(stack, xi) + (2.0 * flexibility(*stack.other) if stack.other else 0.0)
    fine = xi * min(layer.thickness for layer in stack.layers) < FINE
    found = np.empty_like(xi)
    found[fine] = [compliance_exactly(stack, wave) for wave in xi[fine]]
    found[~fine] = _compliance_quickly(stack, xi[~fine])
    return found + (2.0 * flexibility(*stack.other) if stack.other else 0.0)


@functools.cache
def _quadrature(stack: Stack | Profile, reach: float, count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Wave numbers up to `reach` over the thickness of the top layer, weights, and M(xi) = xi C E*/2 - 1."""
    s, w = np.polynomial.legendre.leggauss(count)
    top = stack.length
    # denser towards long waves, over which the deeper layers act
    xi = reach / top * (0.5 * (s + 1.0)) ** 2
    weights = reach / top * 0.5 * (s + 1.0) * w
    return xi, weights, compliance(stack, xi) / (2.0 * stack.surface) - 1.0


class Press:
    """A round contact of radius a on a stack."""

    def __init__(
        self, stack: Stack | Profile, radius: float, *, terms: int = 14, count: int = 240, reach: float = 22.0
    ) -> None:
        self.stack, self.a, self.terms = stack, radius, terms
        self.xi, self.weights, self.excess = _quadrature(stack, reach, count)
        self.bessel = np.array([(-1) ** n * spherical_jn(2 * n, self.xi * radius) for n in range(terms)])
        matrix = self.bessel * (self.weights * self.excess) @ self.bessel.T
        if isinstance(stack, Profile):  # beyond the last wave M = m/xi, and j_2n^2 is 1/(2 xi^2 a^2) on average
            matrix = matrix + self.excess[-1] / (2.0 * radius * self.xi[-1]) ** 2 * self.xi[-1]
        matrix += np.diag([np.pi / (2.0 * radius * (4 * n + 1)) for n in range(terms)])  # the half-space of the top
        self.matrix = 4.0 * radius**2 / np.pi * stack.surface * matrix

    def solution(self, h: Callable[[np.ndarray], np.ndarray], cuts: Sequence[float] = ()) -> np.ndarray:
        """Coefficients of q for the plane displacement h(x), smooth between the cuts."""
        ends = [0.0, *(b for b in cuts if b < self.a), self.a]
        s, w = np.polynomial.legendre.leggauss(80)
        moments = np.zeros(self.terms)
        for low, high in zip(ends[:-1], ends[1:], strict=True):
            x = low + 0.5 * (high - low) * (s + 1.0)
            weight = (high - low) * w * h(x)  # both sides of the axis
            moments += np.array([weight @ eval_legendre(2 * n, x / self.a) for n in range(self.terms)])
        return np.linalg.solve(self.matrix, moments)

    @functools.cached_property
    def flat(self) -> np.ndarray:
        """Under a flat punch at unit depth."""
        return self.solution(np.ones_like)

    @property
    def stiffness(self) -> float:
        """k(a)."""
        return float(2.0 * self.a * self.flat[0])

    def closed(self, h: Callable[[np.ndarray], np.ndarray]) -> tuple[float, np.ndarray]:
        """Depth and coefficients of a contact that closes smoothly: q(a) = 0."""
        body = self.solution(h)
        depth = float(body.sum() / self.flat.sum())
        return depth, depth * self.flat - body

    def force(self, coefficients: np.ndarray) -> float:
        return float(2.0 * self.a * coefficients[0])

    def energy(self, coefficients: np.ndarray) -> float:
        return float(0.5 * coefficients @ self.matrix @ coefficients)

    def pressure(self, coefficients: np.ndarray, r: float) -> float:
        """p(r) = q(a)/(pi sqrt(a^2-r^2)) - (1/pi) Int_r^a q'(x)/sqrt(x^2-r^2) dx, r < a."""
        series = np.zeros(2 * self.terms - 1)
        series[::2] = coefficients
        slope = np.polynomial.legendre.Legendre(series).deriv()
        s, w = np.polynomial.legendre.leggauss(200)
        edge = np.sqrt(self.a**2 - r**2)
        leg = 0.5 * edge * (s + 1.0)  # x = hypot(r, leg): dx / sqrt(x^2 - r^2) = dleg / x
        x = np.hypot(r, leg)
        inner = np.sum(0.5 * edge * w * slope(x / self.a) / self.a / x)
        return float((coefficients.sum() / edge - inner) / np.pi)

    def displacement(self, coefficients: np.ndarray, r: float) -> float:
        """The surface at r: the half-space of the top by its own transform, the rest by the compliance."""
        series = np.zeros(2 * self.terms - 1)
        series[::2] = coefficients
        load = np.polynomial.legendre.Legendre(series)
        s, w = np.polynomial.legendre.leggauss(120)
        end = np.arcsin(min(1.0, self.a / r)) if r > 0.0 else 0.0
        angle = 0.5 * end * (s + 1.0)  # x = r sin(angle)
        own = np.sum(0.5 * end * w * load(r * np.sin(angle) / self.a)) if r > 0.0 else 0.5 * np.pi * load(0.0)
        pressed = self.a / np.pi * (coefficients @ self.bessel)
        more = np.sum(self.weights * self.excess * pressed * j0(self.xi * r))
        return float(self.stack.surface * (2.0 / np.pi * own + 2.0 * more))
