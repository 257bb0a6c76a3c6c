r"""Conduction through a disc with a film: what the film adds to the constriction by spreading the flux.

Along the line, the flux :math:`q(x)` of two half-spaces that touch in a disc of radius a through a film obeys

.. math:: q(x) - \frac{\beta a}{2\pi}\,\frac{\mathrm d}{\mathrm dx}
          \int_{-a}^{a} q'(t)\,\ln\frac{1}{|x-t|}\,\mathrm dt = 1, \qquad \beta = \frac{2\sigma_f}{(\rho_1+\rho_2)\,a},

Prandtl's equation of the lifting line.  With :math:`x=a\cos\theta` and :math:`q=\sum_n A_n\sin n\theta`, n odd,
Galerkin's method weighted with :math:`\sin\theta` makes it symmetric, so that one spectral decomposition solves every
beta.  The constriction part of the resistance rises from Holm's value, that of a disc without voltage along it, to
:math:`32/(3\pi^2)` times that, that of a uniform flux.
"""

from __future__ import annotations

import functools

import numpy as np

from winkler.numerics.types import Array

UNIFORM_FLUX_RATIO = 32.0 / (3.0 * np.pi**2)
"""What uniform flux costs, over what a disc of one voltage does."""
MODE_COUNT = 240
THICK_FILM = 1e3
"""Beyond this beta the remaining distance to uniform flux goes like 1 / beta."""


@functools.cache
def _modes() -> tuple[Array, Array]:
    """Return the eigenvalues and the squared first components of the eigenvectors."""
    n = np.arange(1, 2 * MODE_COUNT, 2).astype(float)
    matrix = 1.0 / (1.0 - np.subtract.outer(n, n) ** 2) - 1.0 / (1.0 - np.add.outer(n, n) ** 2)
    values, vectors = np.linalg.eigh(matrix / np.sqrt(np.multiply.outer(n, n)))
    return values, vectors[0] ** 2


def spreading(beta: Array) -> Array:
    """Return the constriction part of the resistance over Holm's (rho_1 + rho_2) / (4 a).

    Parameters
    ----------
    beta : ndarray
        2 sigma_f / ((rho_1 + rho_2) a) [-], not negative.

    Returns
    -------
    ndarray
        From 1 to 32 / (3 pi^2); good to 1e-7.
    """
    beta = np.asarray(beta, dtype=float)
    values, weights = _modes()
    inside = np.clip(beta, 1e-30, THICK_FILM)
    sums = np.sum(weights / (values + 0.25 * np.pi * inside[..., None]), axis=-1)
    factors = np.clip(8.0 / (np.pi**2 * sums) - 2.0 * inside / np.pi, 1.0, UNIFORM_FLUX_RATIO)
    factors = np.where(
        beta > THICK_FILM,
        UNIFORM_FLUX_RATIO - (UNIFORM_FLUX_RATIO - factors) * THICK_FILM / np.maximum(beta, THICK_FILM),
        factors,
    )
    return np.where(beta > 0.0, factors, 1.0)
