"""A cylinder on a layer, in plane strain, by collocation: nothing of winkler is used.

The slope of the surface below the pressure p is, with the surface compliance C(k) = 2/(E* k) (1 + M),

    x / R = 2/(pi E*) Int p(s) [1/(x - s) + Int_0^inf M sin k(x - s) dk] ds ,

solved after Erdogan and Gupta: p = sqrt(1 - s^2) g at the zeros of U_n, the equation at those of T_(n+1).  All in
mpmath, with a = h = R = 1.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import mpmath as mp

LAST, PIECES, ORDER = 26, 8, 20
"""End of the wave numbers times h, pieces of Gauss-Legendre rules, their order."""


class StripContact(NamedTuple):
    """Load per length, greatest pressure, and depth (none on an elastic base), all over E* of the layer alone."""

    load: Any
    peak: Any
    depth: Any


def bonded(poisson: Any) -> Callable[[Any], Any]:
    """1 + M of a layer of thickness 1 bonded to a rigid base."""
    kappa = 3 - 4 * poisson

    def relative(k: Any) -> Any:
        above = 2 * kappa * mp.sinh(2 * k) - 4 * k
        return above / (2 * kappa * mp.cosh(2 * k) + 1 + kappa**2 + 4 * k * k)

    return relative


def coating(ratio: Any, poisson: Any, base_poisson: Any) -> Callable[[Any], Any]:
    """1 + M of a layer of thickness 1 on a half-plane with the shear modulus G_base = G_layer / ratio.

    From Burmister's stress function A e^(kz) + B e^(-kz) + C z e^(kz) + D z e^(-kz) in the layer, decaying below.
    """

    def state(k: Any, z: Any, nu: Any, shear: Any, sign: int, power: int) -> list[Any]:
        # F = z^power e^(sign k z) sin kx: tractions and displacements times 2 G from plane strain
        e, s = mp.exp(sign * k * z), sign * k
        f = [e, s * e, s * s * e, s**3 * e]
        if power:
            f = [z * f[0], z * f[1] + f[0], z * f[2] + 2 * f[1], z * f[3] + 3 * f[2]]
        sigma_z, tau = -k * k * f[0], -k * f[1]
        # 2 G du/dx = (1 - nu) F'' + nu k^2 F; 2 G dw/dz = -(1 - nu) k^2 F - nu F''
        u = -((1 - nu) * f[2] + nu * k * k * f[0]) / k / (2 * shear)
        w = (-(1 - nu) * k * k * _integral(k, z, sign, power) - nu * f[1]) / (2 * shear)
        return [sigma_z, tau, u, w]

    def _integral(k: Any, z: Any, sign: int, power: int) -> Any:
        s = sign * k
        return mp.exp(s * z) * (z / s - 1 / s**2) if power else mp.exp(s * z) / s

    def relative(k: Any) -> Any:
        k = mp.mpf(k)
        with mp.workdps(60):
            layer, below = mp.mpf(1), 1 / mp.mpf(ratio)
            waves = [(1, 0), (-1, 0), (1, 1), (-1, 1)]
            fading = [(-1, 0), (-1, 1)]
            matrix = mp.zeros(6)
            for column, wave in enumerate(waves):
                top = state(k, mp.mpf(0), poisson, layer, *wave)
                face = state(k, mp.mpf(1), poisson, layer, *wave)
                for row, entry in enumerate([top[0], top[1], *face]):
                    matrix[row, column] = entry
            for column, wave in enumerate(fading, 4):
                for row, entry in enumerate(state(k, mp.mpf(1), base_poisson, below, *wave), 2):
                    matrix[row, column] = -entry
            found = mp.lu_solve(matrix, mp.matrix([-1, 0, 0, 0, 0, 0]))
            sunk = sum(found[j] * state(k, mp.mpf(0), poisson, layer, *wave)[3] for j, wave in enumerate(waves))
            return sunk * k / (1 - poisson)

    return relative


def cylinder(relative: Callable[[Any], Any], count: int = 20, *, rigid_base: bool) -> StripContact:
    """The contact of the half-width 1 of a cylinder of the radius 1 on a layer of the thickness 1."""
    nodes = _rule()
    spectrum = [(k, weight * (relative(k) - 1)) for k, weight in nodes]
    s = [mp.cos(mp.pi * j / (count + 1)) for j in range(1, count + 1)]
    shares = [mp.pi * (1 - place**2) / (count + 1) for place in s]
    x = [mp.cos(mp.pi * (2 * i - 1) / (2 * (count + 1))) for i in range(1, count // 2 + 1)]
    half = count // 2  # even in s: half of the unknowns
    matrix, right = mp.zeros(half), mp.zeros(half, 1)
    for i, place in enumerate(x):
        right[i] = mp.pi / 2 * place
        sines = [mp.sin(k * place) * weight for k, weight in spectrum]
        for j in range(half):
            # the kernel at s and -s together: sin k(x-s) + sin k(x+s) = 2 sin kx cos ks
            smooth = 2 * mp.fsum(sine * mp.cos(k * s[j]) for sine, (k, _) in zip(sines, spectrum, strict=True))
            matrix[i, j] = shares[j] * (1 / (place - s[j]) + 1 / (place + s[j]) + smooth)
    g = mp.lu_solve(matrix, right)
    load = 2 * mp.fsum(shares[j] * g[j] for j in range(half))
    # g at the middle by its Chebyshev series of the second kind
    series = [2 * sum(2 / mp.pi * shares[j] * g[j] * mp.chebyu(2 * m, s[j]) for j in range(half)) for m in range(half)]
    peak = mp.fsum(c * (-1) ** m for m, c in enumerate(series))
    if not rigid_base:
        return StripContact(load, peak, None)
    # depth = 1/2 + u(1), u(1) = 2/(pi E*) Int p [K] ds with K = Int (1 + M) cos k(1 - s) / k dk
    tail = [(k, weight, relative(k)) for k, weight in nodes]

    def kernel(distance: Any) -> Any:
        # Int_0^inf (1 + M - (1 - e^-k)) cos kr / k dk + 1/2 ln(1 + 1/r^2)
        waves = mp.fsum(w * (m - 1 + mp.exp(-k)) * mp.cos(k * distance) / k for k, w, m in tail)
        return waves + mp.log(1 + 1 / distance**2) / 2

    def pressed(t: Any) -> Any:  # s = cos t
        return mp.sin(t) ** 2 * mp.fsum(c * mp.chebyu(2 * m, mp.cos(t)) for m, c in enumerate(series))

    rule = _rule(mp.pi, 10)
    total = mp.fsum(w * pressed(t) * (_regular(kernel, t)) for t, w in rule)
    logarithm = _logarithm(series)
    return StripContact(load, peak, mp.mpf(1) / 2 + 2 / mp.pi * (total + logarithm))


def _regular(kernel: Callable[[Any], Any], t: Any) -> Any:
    r = 1 - mp.cos(t)
    return kernel(r) + mp.log(r)


def _logarithm(series: list[Any]) -> Any:
    """-Int sqrt(1 - s^2) U_2m ln(1 - s) ds: -ln(1 - s) = ln 2 + 2 Sum T_n / n, 2 (1 - s^2) U_2m = T_2m - T_2m+2."""
    total = mp.mpf(0)
    for m, c in enumerate(series):
        first = mp.log(2) * mp.pi if m == 0 else mp.pi / (2 * m)
        total += c / 2 * (first - mp.pi / (2 * m + 2))
    return total


def _rule(last: Any = LAST, pieces: int = PIECES) -> list[tuple[Any, Any]]:
    """Nodes and weights on [0, last]; pieces of one length."""
    legendre = [(x, w) for x, w in _gauss()]
    step = mp.mpf(last) / pieces
    return [(step * (i + (x + 1) / 2), step * w / 2) for i in range(pieces) for x, w in legendre]


def _gauss() -> list[tuple[Any, Any]]:
    import numpy as np

    found = []
    for guess in np.polynomial.legendre.leggauss(ORDER)[0]:
        x = mp.findroot(lambda y: mp.legendre(ORDER, y), mp.mpf(float(guess)))
        slope = ORDER * (mp.legendre(ORDER - 1, x) - x * mp.legendre(ORDER, x)) / (1 - x * x)
        found.append((x, 2 / ((1 - x * x) * slope**2)))
    return found
