r"""Displacements inside a half-space under a half-ellipsoid of pressure, and of traction in any direction.

With the potentials of `winkler.media.interior.half_ellipsoid` the pressure moves a place by

.. math:: 4\pi G\,u_x = -(1-2\nu)H_x - z\Phi_x , \qquad 4\pi G\,u_z = 2(1-\nu)\Phi - z\Phi_z ,

and a traction along x of the same size by

.. math:: 4\pi G\,u_x = 2\Phi + 2\nu K_{xx} - zH_{xx} , \quad 4\pi G\,u_y = 2\nu K_{xy} - zH_{xy} , \quad
          4\pi G\,u_z = (1-2\nu)H_x - z\Phi_x .

References
----------
K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 3.2 and 3.6, doi:10.1017/CBO9781139171731
"""

from __future__ import annotations

import numpy as np

from winkler.media.interior.confocal import confocal, rule
from winkler.media.interior.half_ellipsoid import PLACES_AT_ONCE, third_moments
from winkler.numerics.chunks import chunks
from winkler.numerics.types import Array


def half_ellipsoid_displacements(
    x: Array, y: Array, z: Array, semi_axes: tuple[float, float], poisson: float, traction: tuple[float, float]
) -> tuple[Array, Array, Array]:
    """Return the displacements along x, y and z [m], times twice the shear modulus over the greatest pressure.

    Parameters
    ----------
    x, y, z, semi_axes, poisson, traction
        As of `winkler.media.interior.half_ellipsoid.half_ellipsoid_stresses`.
    """
    a, b = semi_axes
    if b > a:
        across, along, down = half_ellipsoid_displacements(y, x, z, (b, a), poisson, (traction[1], traction[0]))
        return along, across, down
    places = np.stack([np.ravel(part) / a for part in (x, y, z)])
    out = np.empty_like(places)
    for at in chunks(places.shape[1], 1, PLACES_AT_ONCE):
        out[:, at] = _displacements(places[:, at], b / a, poisson, traction)
    return tuple(a * part.reshape(np.shape(x)) for part in out)


def _displacements(places: Array, b: float, poisson: float, traction: tuple[float, float]) -> Array:
    from scipy.special import elliprd, elliprf

    x, y, z = places
    at = confocal(x, y, z, b)
    alpha, beta, c = at.alpha, at.beta, 0.5 * b  # 2 C / 2 pi
    along, across = elliprd(beta, at.lam, alpha) / 1.5, elliprd(alpha, at.lam, beta) / 1.5
    deep = 2.0 * at.omega / np.sqrt(alpha * beta) - z * (along + across)
    whole = 2.0 * elliprf(at.lam, alpha, beta)
    phi = 0.5 * c * (whole - x * x * along - y * y * across - z * deep)
    rest = rule(at.above, at.first + b * b, at, b)
    s = at.first[:, None] + rest.squared
    over_alpha, over_beta = 1.0 / (1.0 + s), 1.0 / (b * b + s)
    away = np.sqrt(s - at.second[:, None])
    part = 2.0 * rest.weights * rest.squared * away * over_alpha * over_beta
    e_a, e_b = (part * over_alpha).sum(axis=1), (part * over_beta).sum(axis=1)
    h_x, h_y = c * x * (e_a - z * along), c * y * (e_b - z * across)
    free, twice = 1.0 - 2.0 * poisson, 2.0 * poisson
    out = np.stack(
        [-free * h_x + c * x * z * along, -free * h_y + c * y * z * across, 2.0 * (1.0 - poisson) * phi + c * z * deep]
    )
    mu_x, mu_y = traction
    if mu_x == 0.0 == mu_y:
        return out
    part = 2.0 * rest.weights / away * over_alpha
    j10, j20, j11 = part.sum(axis=1), (part * over_alpha).sum(axis=1), (part * over_beta).sum(axis=1)
    own, mixed = third_moments(at, b)
    zh_xx = c * z * (j10 - 2.0 * x * x * j20 - y * y * j11 - z * along)
    zh_xy = -c * z * x * y * j11
    bowl = whole - along - 3.0 * x * x * own - y * y * mixed
    k_xx = -0.5 * c * (bowl - 2.0 * z * e_a + z * z * along + 2.0 * z * x * x * j20)
    k_xy = c * x * y * (mixed - z * j11)
    aside = twice * k_xy - zh_xy
    out[0] += mu_x * (2.0 * phi + twice * k_xx - zh_xx) + mu_y * aside
    out[1] += mu_x * aside + mu_y * (2.0 * phi - twice * (phi + k_xx) + c * z * -deep + zh_xx)
    out[2] += mu_x * (free * h_x + c * x * z * along) + mu_y * (free * h_y + c * y * z * across)
    return out
