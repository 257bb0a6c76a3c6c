r"""Discs of one voltage in a plane: how they share a current, and their resistance to it.

On a disc of radius a the fluxes

.. math:: \psi_l^m = \frac{P_l^{|m|}(\mu)}{\mu}\,\{\cos m\varphi,\ \sin|m|\varphi\}, \qquad
          \mu=\sqrt{1-r^2/a^2}, \quad l+m\ \text{even},

make voltages :math:`\lambda_l^m P_l^{|m|}(\mu)\{\cos,\sin\}` on the disc itself (Wolfe) and smooth ones on others:
Galerkin's method converges geometrically, the faster the farther the discs are apart.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array


@functools.cache
def _basis(greatest: int) -> tuple[Array, Array, Array, Array, Array]:
    """Return places x, y on the unit disc, the weighted fluxes there, their self-energies and their degrees."""
    from scipy.special import lpmv

    rings, rays = greatest + 2, 2 * greatest + 4
    mu, dmu = gauss_legendre(rings)
    phi = 2.0 * math.pi * (np.arange(rays) + 0.5) / rays
    r = np.sqrt(1.0 - mu**2)
    x, y = np.outer(r, np.cos(phi)).ravel(), np.outer(r, np.sin(phi)).ravel()
    # dA psi = P dmu dphi: the 1/mu of the flux is taken by the area
    weight = np.outer(dmu, np.full(rays, 2.0 * math.pi / rays)).ravel()
    rows, energies, degrees = [], [], []
    for degree in range(greatest + 1):
        for order in range(-degree, degree + 1):
            if (degree + order) % 2:
                continue
            m = abs(order)
            radial = lpmv(m, degree, mu)
            around = np.cos(m * phi) if order >= 0 else np.sin(m * phi)
            rows.append(np.outer(radial, around).ravel() * weight)
            own = _eigenvalue(degree, m)
            norm = float(np.sum(np.outer(radial, around).ravel() ** 2 * weight))
            energies.append(own * norm)
            degrees.append(degree)
    return x, y, np.array(rows), np.array(energies), np.array(degrees)


def _eigenvalue(degree: int, order: int) -> float:
    """Return lambda: the voltage per flux, with 1/distance as kernel, on a unit disc."""
    gamma = math.gamma
    upper = gamma(0.5 * (degree + order + 1)) * gamma(0.5 * (degree - order + 1))
    lower = gamma(0.5 * (degree + order) + 1.0) * gamma(0.5 * (degree - order) + 1.0)
    return math.pi * upper / lower


def currents(x: Array, y: Array, radii: Array, degree: int) -> tuple[Array, Array]:
    """Return the charges of discs at unit voltage, with the kernel 1 / distance.

    Parameters
    ----------
    x, y : ndarray, (n,)
        Middles of the discs [m].
    radii : ndarray, (n,)
        [m]; the discs must not touch.
    degree : int
        Greatest l, at least 2.

    Returns
    -------
    charges, coarse : ndarray, (n,)
        [m]; of a disc alone 2 a / pi.  The coarse ones come of the degree less two.
    """
    u, v, fluxes, energies, degrees = _basis(degree)
    count, functions = radii.size, fluxes.shape[0]
    matrix = np.zeros((count, functions, count, functions))
    for i in range(count):
        matrix[i, :, i, :] = np.diag(energies / radii[i])
        for j in range(i):
            across = np.subtract.outer(x[i] - x[j] + radii[i] * u, radii[j] * u)
            along = np.subtract.outer(y[i] - y[j] + radii[i] * v, radii[j] * v)
            across *= across
            along *= along
            across += along
            block = fluxes @ (1.0 / np.sqrt(across, out=across)) @ fluxes.T
            matrix[i, :, j, :], matrix[j, :, i, :] = block, block.T
    # unknowns are charges: a flux psi on a disc of radius a carries a^2, which is taken into them
    whole = fluxes.sum(axis=1)
    solutions = []
    for used in (degrees <= degree, degrees <= degree - 2):
        size = count * int(used.sum())
        part = matrix[:, used][:, :, :, used].reshape(size, size)
        solutions.append(np.linalg.solve(part, np.tile(whole[used], count)).reshape(count, -1) @ whole[used])
    return solutions[0], solutions[1]
