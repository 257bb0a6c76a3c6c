r"""A parabola that passes over a half-plane which creeps: its strip of contact at a steady speed.

All lengths are over the half-length of the strip, which reaches from a - 2 to a.  The pressure has the transform
:math:`g(x)=\frac1\pi\int\frac{p(s)}{x-s}\mathrm ds`, and particles come from ahead, from x to x - V t, so that

.. math:: J_0\,g(x) + \sum_k J_k\,G_k(x) = x , \qquad
          G_k(x) = \int_0^\infty \frac{e^{-s/\lambda_k}}{\lambda_k}\,g(x+s)\,\mathrm ds , \qquad a-2 < x < a .

Of a solid with :math:`J_0+\sum J_k=1` the transform within the strip is a straight line and one exponential for each
relaxation time, :math:`\rho_j` times the speed,

.. math:: g(x) = g_a + (x-a) + \sum_j c_j\,\rho_j\bigl(1-e^{(x-a)/\rho_j}\bigr) .

With t = x - a + 1 its Chebyshev coefficients :math:`g_n` are Bessel functions, :math:`p=\sqrt{1-t^2}\,\sum_{n\ge1} g_n
U_{n-1}(t)` is bounded at both ends when :math:`g_0=0`, and ahead of the strip :math:`g=\sum g_n e^{-n\theta}`, t =
cosh theta.  Then :math:`G_k(a)=g_a-\sum n\,g_n L_n(1/\lambda_k)` with

.. math:: L_n(\kappa) = \int_0^\infty e^{-\kappa(\cosh\theta-1)-n\theta}\,\mathrm d\theta , \qquad
          n L_n + \frac\kappa2\,(L_{n-1}-L_{n+1}) = 1 , \qquad L_0 = e^\kappa K_0(\kappa) ,

and :math:`c_j,\ g_a,\ a` follow from linear equations: those of each G_k at the leading edge, the first one above at x
= a, and :math:`g_0=0`.

References
----------
S. C. Hunter, J. Appl. Mech. 28 (1961) 611-617, doi:10.1115/1.3641792, for one relaxation time by other means.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

__all__ = ["PassingStrip", "passing_strip", "tails"]

FEWEST_TERMS, TERMS_PER_ROOT = 40, 8.7
"""Terms of a series whose coefficients fall as exp(-n^2 / (2 kappa)) once n exceeds some root of kappa."""
BEYOND, BEYOND_PER_ROOT = 60, 4.0
"""Terms from which a recurrence is run back, beyond those that are used."""
SMALL = 0.5


class PassingStrip(NamedTuple):
    """The strip under a parabola x^2/2.

    Parameters
    ----------
    leading : float
        a, from the lowest point of the parabola to the leading edge.
    waves : ndarray, (n,)
        g_1, g_2, ... of the pressure.
    """

    leading: float
    waves: Array


def tails(kappa: float, count: int) -> Array:
    """Return L_1(kappa), ..., L_count(kappa)."""
    from scipy.linalg import solve_banded
    from scipy.special import kve

    root = np.sqrt(kappa)
    size = max(count, int(TERMS_PER_ROOT * root)) + BEYOND + int(BEYOND_PER_ROOT * root)
    bands = np.zeros((3, size))
    bands[0, 1:], bands[1], bands[2, :-1] = -0.5 * kappa, np.arange(1.0, size + 1.0), 0.5 * kappa
    right = np.ones(size)
    right[0] -= 0.5 * kappa * kve(0, kappa)
    right[-1] += 0.5 * kappa / np.hypot(size + 1.0, root)  # its error dies out towards the first ones
    return np.asarray(solve_banded((1, 1), bands, right)[:count])


def _mean(kappa: Array) -> Array:
    """Return (1 - exp(-kappa) I_0(kappa)) / kappa."""
    from scipy.special import ive

    small = np.minimum(kappa, SMALL)
    # exp(-k) I_0(k) = sum of (-k)^m (2m)! / (2^m m!^3)
    term, total = np.ones(kappa.shape), np.zeros(kappa.shape)
    for m in range(1, 24):
        term = term * (-small if m > 1 else -1.0) * (2.0 * m - 1.0) / m**2
        total -= term
    return np.where(kappa <= SMALL, total, (1.0 - ive(0, kappa)) / kappa)


def passing_strip(glassy: float, creep: Array, delays: Array, relaxing: Array) -> PassingStrip:
    """Return the strip of a solid with the final compliance 1.

    Parameters
    ----------
    glassy : float
        J_0, positive.
    creep, delays : ndarray, (m,)
        J_k and the retardation times, times the speed over the half-length, lambda_k.
    relaxing : ndarray, (m,)
        The relaxation times of the same solid, times the speed over the half-length, rho_j.
    """
    from scipy.special import ive

    kappa, m = 1.0 / relaxing, creep.size
    counts = FEWEST_TERMS + (TERMS_PER_ROOT * np.sqrt(kappa)).astype(int)
    size = int(np.max(counts, initial=FEWEST_TERMS))
    each = np.zeros((size, m))
    for j, count in enumerate(counts):
        each[:count, j] = -2.0 * ive(np.arange(1, count + 1), kappa[j]) / kappa[j]
    ahead = np.arange(1, size + 1) * np.array([tails(1.0 / delay, size) for delay in delays]).reshape(m, size)
    moved = ahead @ each
    matrix, right = np.zeros((m + 2, m + 2)), np.zeros(m + 2)
    matrix[:m, :m] = moved / delays[:, None] + relaxing / (delays[:, None] - relaxing)
    right[:m] = -1.0 - ahead[:, 0] / delays
    matrix[m, :m], matrix[m, m], matrix[m, m + 1] = -creep @ moved, glassy + float(np.sum(creep)), -1.0
    right[m] = float(creep @ ahead[:, 0])
    matrix[m + 1, :m], matrix[m + 1, m], right[m + 1] = _mean(kappa), 1.0, 1.0
    found = np.linalg.solve(matrix, right)
    waves = each @ found[:m]
    waves[0] += 1.0
    return PassingStrip(float(found[m + 1]), waves)
