r"""Stresses inside a half-space under a half-ellipsoid of pressure, and of traction in any direction.

The pressure :math:`p_0\sqrt{1-x^2/a^2-y^2/b^2}` has the potentials :math:`\Phi=\int p/\rho`, H and K, each the
derivative along z of the next.  Over the confocal ellipsoids s outside of a place (`winkler.media.interior.confocal`),
with :math:`Z=\sqrt s\,\omega`, :math:`\Delta^2=\alpha\beta s` and :math:`C=\pi abp_0/2`,

.. math::

    \Phi_x = -2Cx\int_\lambda^\infty\frac{\mathrm ds}{\alpha\Delta} , \qquad
    H_x = 2Cx\int_\lambda^\infty\frac{Z-z}{\alpha\Delta}\,\mathrm ds , \qquad
    K_x = -Cx\int_\lambda^\infty\frac{(Z-z)^2}{\alpha\Delta}\,\mathrm ds .

Their derivatives are Carlson's R_D and integrals that one rule of Gauss resolves.  After Boussinesq and Cerruti the
pressure gives

.. math::

    2\pi\sigma_{xx} &= 2\nu\Phi_z - (1-2\nu)H_{xx} - z\Phi_{xx} , &
    2\pi\sigma_{zz} &= \Phi_z - z\Phi_{zz} , \\
    2\pi\sigma_{xy} &= -(1-2\nu)H_{xy} - z\Phi_{xy} , &
    2\pi\sigma_{xz} &= -z\Phi_{xz} ,

and a traction along x of the same size

.. math::

    2\pi\sigma_{xx} &= 2(1+\nu)\Phi_x + 2\nu K_{xxx} - zH_{xxx} , &
    2\pi\sigma_{yy} &= 2\nu\Phi_x + 2\nu K_{xyy} - zH_{xyy} , \\
    2\pi\sigma_{xy} &= \Phi_y + 2\nu K_{xxy} - zH_{xxy} , &
    2\pi\sigma_{zz} &= -z\Phi_{xz} , \\
    2\pi\sigma_{xz} &= \Phi_z - z\Phi_{xx} , &
    2\pi\sigma_{yz} &= -z\Phi_{xy} .

References
----------
A. Sackfield, D. A. Hills, J. Strain Anal. 18 (1983) 107-110, doi:10.1243/03093247V182107;
K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 3.2 and 3.6, doi:10.1017/CBO9781139171731
"""

from __future__ import annotations

import functools
from typing import NamedTuple

import numpy as np

from winkler.media.interior.confocal import Confocal, confocal, rule
from winkler.media.interior.peak import StressSpot, greatest_around
from winkler.media.interior.tensor import Measure, Tensor
from winkler.numerics.chunks import chunks
from winkler.numerics.types import Array

PLACES_AT_ONCE = 512


def half_ellipsoid_stresses(
    x: Array, y: Array, z: Array, semi_axes: tuple[float, float], poisson: float, traction: tuple[float, float]
) -> Tensor:
    """Return the stresses over the greatest pressure.

    Parameters
    ----------
    x, y, z : ndarray
        Places [m] of one shape, z >= 0 the depth.
    semi_axes : tuple of float
        a along x and b along y [m].
    poisson : float
        Of the body.
    traction : tuple of float
        What drags the surface along x and y, over the pressure [-].
    """
    a, b = semi_axes
    if b > a:
        turned = half_ellipsoid_stresses(y, x, z, (b, a), poisson, (traction[1], traction[0]))
        return Tensor(turned.yy, turned.xx, turned.zz, turned.xy, turned.yz, turned.xz)
    places = np.stack([np.ravel(part) / a for part in (x, y, z)])
    out = np.empty((6, places.shape[1]))
    for at in chunks(places.shape[1], 1, PLACES_AT_ONCE):
        out[:, at] = _stresses(places[:, at], b / a, poisson, traction)
    return Tensor(*(part.reshape(np.shape(x)) for part in out))


class _Potential(NamedTuple):
    """Derivatives of Phi, those of the second order times z; all over 2 pi."""

    x: Array
    y: Array
    z: Array
    zxx: Array
    zyy: Array
    zxy: Array
    zxz: Array
    zyz: Array


class _Integrals(NamedTuple):
    """Integrals over the ellipsoids outside of a place, and what the ellipsoid through it adds, each over s.

    Parameters
    ----------
    j10, j20, j11 : ndarray
        Of 1 / sqrt((s - s_1)(s - s_2)) over powers of alpha and beta.
    along, across : ndarray
        z times those of beta / alpha^2 and 1 / alpha, over ((s - s_1)(s - s_2))^(3/2).
    """

    j10: Array
    j20: Array
    j11: Array
    along: Array
    across: Array


def _stresses(places: Array, b: float, poisson: float, traction: tuple[float, float]) -> Array:
    from scipy.special import elliprd

    x, y, z = places
    at = confocal(x, y, z, b)
    alpha, beta = at.alpha, at.beta
    c = 0.5 * b  # 2 C / 2 pi
    along = elliprd(beta, at.lam, alpha) / 1.5
    across = elliprd(alpha, at.lam, beta) / 1.5
    both, root = np.sqrt(alpha * beta), np.sqrt(at.lam)
    crowded = at.lam * ((x / alpha) ** 2 + (y / beta) ** 2) + at.omega**2
    inverse = np.where(crowded > 0.0, 1.0 / np.where(crowded > 0.0, crowded, 1.0), 0.0) / both
    shift, slant = at.lam * at.omega * inverse, at.omega**2 * root * inverse
    phi = _Potential(
        x=-c * x * along,
        y=-c * y * across,
        z=-c * (2.0 * at.omega / both - z * (along + across)),
        zxx=-c * (z * along - 2.0 * (x / alpha) ** 2 * shift),
        zyy=-c * (z * across - 2.0 * (y / beta) ** 2 * shift),
        zxy=2.0 * c * x * y / (alpha * beta) * shift,
        zxz=2.0 * c * x / alpha * slant,
        zyz=2.0 * c * y / beta * slant,
    )
    rubbed = traction != (0.0, 0.0)
    outer = _integrals(at, z, b, rubbed)
    h_xx = c * (outer.j10 - 2.0 * x * x * outer.j20 - y * y * outer.j11 - z * along)
    h_xy = -c * x * y * outer.j11
    free, twice = 1.0 - 2.0 * poisson, 2.0 * poisson
    out = np.stack(
        [
            twice * phi.z - free * h_xx - phi.zxx,
            twice * phi.z + free * (phi.z + h_xx) - phi.zyy,
            phi.z + phi.zxx + phi.zyy,
            -free * h_xy - phi.zxy,
            -phi.zxz,
            -phi.zyz,
        ]
    )
    if not rubbed:
        return out
    k = third_moments(at, b)
    edge = 2.0 * root * at.lam * inverse
    zh_xxx = c * (x**3 * (edge / alpha**3 - outer.along) - 3.0 * x * z * outer.j20)
    zh_xxy = c * y * (x**2 * (edge / (alpha**2 * beta) - outer.across) - z * outer.j11)
    k_xxx = c * x * (3.0 * k[0] - 3.0 * z * outer.j20 - x**2 * outer.along)
    k_xxy = c * y * (k[1] - z * outer.j11 - x**2 * outer.across)
    first = twice * k_xxx - zh_xxx, twice * k_xxy - zh_xxy
    others = -twice * phi.x + phi.zxz - first[0], -twice * phi.y + phi.zyz - first[1]
    mu_x, mu_y = traction
    out += mu_x * np.stack(
        [
            (2.0 + twice) * phi.x + first[0],
            twice * phi.x + others[0],
            -phi.zxz,
            phi.y + first[1],
            phi.z - phi.zxx,
            -phi.zxy,
        ]
    )
    out += mu_y * np.stack(
        [
            twice * phi.y + first[1],
            (2.0 + twice) * phi.y + others[1],
            -phi.zyz,
            phi.x + others[0],
            -phi.zxy,
            phi.z - phi.zyy,
        ]
    )
    return out


def _integrals(at: Confocal, z: Array, b: float, rubbed: bool) -> _Integrals:
    rest = rule(at.above, at.first + b * b, at, b)
    s = at.first[:, None] + rest.squared
    over_alpha, over_beta = 1.0 / (1.0 + s), 1.0 / (b * b + s)
    over_away = 1.0 / (s - at.second[:, None])
    part = 2.0 * rest.weights * np.sqrt(over_away) * over_alpha
    j10, j20, j11 = part.sum(axis=1), (part * over_alpha).sum(axis=1), (part * over_beta).sum(axis=1)
    if not rubbed:
        return _Integrals(j10, j20, j11, j20, j20)
    # what is singular at s_1 by parts: the boundary term is finite times z
    part *= 2.0 * over_away
    bound = 2.0 * np.sqrt(at.lam / (at.alpha * at.beta)) / (at.lam - at.second) / at.alpha
    across = bound - z * (part * (over_alpha + 1.5 * over_away)).sum(axis=1)
    part *= over_alpha
    along = bound * at.beta / at.alpha
    along += z * (part * (1.0 - (2.0 * over_alpha + 1.5 * over_away) / over_beta)).sum(axis=1)
    return _Integrals(j10, j20, j11, along, across)


def third_moments(at: Confocal, b: float) -> tuple[Array, Array]:
    """Return the integrals of s / (alpha^2 Delta) and s / (alpha beta Delta)."""
    rest = rule(at.lam, np.full(at.lam.shape, b * b), at, b)
    over_alpha, over_beta = 1.0 / (1.0 + rest.squared), 1.0 / (b * b + rest.squared)
    part = 2.0 * rest.weights * rest.squared * over_alpha * np.sqrt(over_alpha * over_beta)
    return (part * over_alpha).sum(axis=1), (part * over_beta).sum(axis=1)


@functools.lru_cache(maxsize=512)
def greatest_in_half_ellipsoid(
    measure: Measure, ratio: float, poisson: float, traction: tuple[float, float] = (0.0, 0.0)
) -> StressSpot:
    """Return the greatest of a stress over the greatest pressure, and its place over a, b, and the smaller of both.

    Parameters
    ----------
    measure
        Takes the tensor, returns what is compared.
    ratio : float
        b / a, of the semi-axes along y and x.
    poisson : float
    traction : tuple of float
        What drags the surface along x and y, over the pressure [-].
    """

    def values(x: Array, y: Array, z: Array) -> Array:
        return measure(half_ellipsoid_stresses(x, y, z, (1.0, ratio), poisson, traction))

    even = (traction[0] == 0.0, traction[1] == 0.0)
    spot = greatest_around(values, ratio=ratio, even=even)
    return StressSpot(spot.value, spot.x, spot.y / ratio, spot.z / min(1.0, ratio))
