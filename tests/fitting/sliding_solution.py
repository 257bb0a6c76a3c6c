"""A layer that slides on its base, by routes of the tests: elasticity in one wave, and a Galerkin solution.

The layer as a strip under a pressure cos(k x): displacements e^(s z) with the roots s = +-k, each twice, so that four
amplitudes follow from no shear on both faces, the pressure above, and the base below.  The contact of a disc of radius
a: pressures P_2n(y) / y with y = (1 - r^2/a^2)^(1/2), whose Hankel transforms are |P_2n(0)| j_2n, spherical Bessel
functions.
"""

from __future__ import annotations

import functools

import numpy as np
from scipy.special import spherical_jn

import winkler as wk


def compliance(wave, *, poisson, base=None):
    """u / p of the upper face of a layer of thickness 1 and G = 1, on a rigid base or a half-space (G, nu)."""
    lame = 2.0 * poisson / (1.0 - 2.0 * poisson)
    kappa = 3.0 - 4.0 * poisson
    # u_x = f(z) sin kx, u_z = g(z) cos kx, z from 0 down to 1: f, g, f', g' of four solutions of Navier's equations
    pairs = []
    for sign in (1.0, -1.0):

        def without_volume(z, s=sign):
            e = np.exp(s * wave * z)
            return e, -s * e, s * wave * e, -wave * e

        def with_volume(z, s=sign):
            e = np.exp(s * wave * z)
            bent = (2.0 * s * (1.0 - 2.0 * poisson) - wave * z) * e
            return z * e, (kappa / wave - s * z) * e, (1.0 + s * wave * z) * e, bent

        pairs += [without_volume, with_volume]

    def shear(pair, z):
        _, g, df, _ = pair(z)
        return df - wave * g

    def normal(pair, z):
        f, _, _, dg = pair(z)
        return lame * (wave * f + dg) + 2.0 * dg

    yields = 0.0 if base is None else (1.0 - base[1]) / base[0] / wave
    rows = [
        [shear(pair, 0.0) for pair in pairs],
        [normal(pair, 0.0) for pair in pairs],
        [shear(pair, 1.0) for pair in pairs],
        [pair(1.0)[1] + yields * normal(pair, 1.0) for pair in pairs],
    ]
    amplitudes = np.linalg.solve(rows, [0.0, -1.0, 0.0, 0.0])
    return float(amplitudes @ [pair(0.0)[1] for pair in pairs])


def excess(x):
    """C / C(half-space) - 1 of a layer on a rigid base, by the double layer under pressures on both faces."""
    x = np.asarray(x, dtype=float)
    whole = (np.cosh(2.0 * np.minimum(x, 300.0)) - 1.0) / (np.sinh(2.0 * np.minimum(x, 300.0)) + 2.0 * x)
    return np.where(x < 20.0, whole - 1.0, 0.0)


@functools.lru_cache(maxsize=4096)
def inverse(ratio, count=16):
    """The inverse of the Galerkin matrix of a contact of a/h = ratio."""
    nodes, weights = np.polynomial.legendre.leggauss(400)
    x = 10.0 * (nodes + 1.0)  # xi h; beyond 20 the layer is a half-space to 1e-15
    bessel = spherical_jn(2 * np.arange(count)[:, None], x * ratio)
    added = (bessel * (10.0 * weights * excess(x) * ratio)) @ bessel.T
    return np.linalg.inv(np.diag(0.5 * np.pi / (4.0 * np.arange(count) + 1.0)) + added)


def punch(ratio):
    """k / (2 E* a) of a flat punch on a layer that slides on a rigid base."""
    return 0.5 * np.pi * inverse(ratio)[0, 0]


def ball(ratio, thickness, radius):
    """Depth and F / E* of a ball (a paraboloid) at the contact radius ratio * thickness."""
    a, matrix = ratio * thickness, inverse(ratio)
    push, shape = np.zeros(len(matrix)), np.zeros(len(matrix))
    push[0], shape[0], shape[1] = 1.0, -1.0 / 3.0 * a**2 / radius, 2.0 / 15.0 * a**2 / radius
    signs = (-1.0) ** np.arange(len(matrix))  # all P_2n(y) are P_2n(0) at the edge, where there is no pressure
    depth = -(signs @ matrix @ shape) / (signs @ matrix @ push)
    return depth, np.pi * a * float((matrix @ (depth * push + shape))[0])


def young_of(modulus, poisson):
    """An incompressible or other solid with a plane strain modulus E*."""
    return wk.Elastic(modulus * (1.0 - poisson**2), poisson)
