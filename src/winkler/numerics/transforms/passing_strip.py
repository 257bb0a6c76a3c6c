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
= a, and :math:`g_0=0`.  The recurrences of :math:`L_n` and of :math:`I_n` telescope: with :math:`\kappa=1/\lambda_k`,
:math:`\kappa'=1/\rho_j`,

.. math:: \sum_{n\ge1} n\,L_n(\kappa)\,e^{-\kappa'}I_n(\kappa') = \frac{\kappa\kappa'}{2(\kappa-\kappa')}
          \bigl[e^{\kappa-\kappa'}(I_0(\kappa')K_1(\kappa)+I_1(\kappa')K_0(\kappa)) - \tfrac1\kappa\bigr] ,

so that no series is summed for the force, and the equations of each G_k read

.. math:: \sum_j \frac{\kappa_k^2\,e^{\kappa_k-\kappa'_j}}{\kappa'_j-\kappa_k}
          \bigl[I_0(\kappa'_j)K_1(\kappa_k)+I_1(\kappa'_j)K_0(\kappa_k)\bigr]\,c_j
          = -\kappa_k e^{\kappa_k}K_1(\kappa_k) .

References
----------
S. C. Hunter, J. Appl. Mech. 28 (1961) 611-617, doi:10.1115/1.3641792, for one relaxation time by other means.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

FEWEST_TERMS, TERMS_PER_ROOT = 40, 8.7
"""Terms of a series whose coefficients fall as exp(-n^2 / (2 kappa)) once n exceeds some root of kappa."""
SMALL = 0.5
"""Below this kappa power series are summed,"""
POWERS = np.arange(16)
"""by these powers."""
TAIL_TERMS = np.array(
    [
        (2.0 * (sum(1.0 / k for k in range(1, m + 1)) - np.euler_gamma) + 1.0 / (m + 1.0))
        / (math.factorial(m) * math.factorial(m + 1))
        for m in POWERS.tolist()
    ]
)
MEAN_TERMS = np.array(
    [(-1.0) ** m * math.factorial(2 * m + 2) / (2.0 ** (m + 1) * math.factorial(m + 1) ** 3) for m in POWERS.tolist()]
)


class PassingStrip(NamedTuple):
    """The strip under a parabola x^2/2.

    Parameters
    ----------
    leading : float
        a, from the lowest point of the parabola to the leading edge.
    strengths, rates : ndarray, (m,)
        c_j and kappa'_j of the exponentials.
    """

    leading: float
    strengths: Array
    rates: Array

    def waves(self, count: int | None = None) -> Array:
        """Return g_1, g_2, ... of the pressure, so many, or all that matter."""
        from scipy.special import ive

        kappa, each = self.rates, -2.0 * self.strengths / self.rates
        if count is not None:
            found = ive(np.arange(1.0, count + 1.0)[:, None], kappa) @ each
        else:
            counts = FEWEST_TERMS + (TERMS_PER_ROOT * np.sqrt(kappa)).astype(int)
            found = np.zeros(int(np.max(counts, initial=FEWEST_TERMS)))
            for j, number in enumerate(counts.tolist()):
                found[:number] += each[j] * ive(np.arange(1, number + 1), kappa[j])
        found[0] += 1.0
        return np.asarray(found)


def first_tail(kappa: Array) -> Array:
    """Return L_1(kappa) = e^kappa K_1(kappa) - 1/kappa, to rounding where both are large too."""
    from scipy.special import iv, kve

    small = np.minimum(kappa, SMALL)
    # K_1 = 1/k + ln(k/2) I_1 - (k/4) sum of (psi(m + 1) + psi(m + 2)) (k/2)^(2 m) / (m! (m + 1)!)
    series = np.power.outer(0.25 * small * small, POWERS) @ TAIL_TERMS
    near = np.expm1(small) / small + np.exp(small) * (np.log(0.5 * small) * iv(1, small) - 0.25 * small * series)
    return np.asarray(np.where(kappa <= SMALL, near, kve(1, kappa) - 1.0 / kappa))


def _mean(kappa: Array) -> Array:
    """Return (1 - exp(-kappa) I_0(kappa)) / kappa."""
    from scipy.special import ive

    # exp(-k) I_0(k) = sum of (-k)^m (2m)! / (2^m m!^3)
    near = np.power.outer(np.minimum(kappa, SMALL), POWERS) @ MEAN_TERMS
    return np.asarray(np.where(kappa <= SMALL, near, (1.0 - ive(0, kappa)) / kappa))


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
    from scipy.special import ive, kve

    late, early, m = (1.0 / delays)[:, None], 1.0 / relaxing, creep.size
    ends, mean, tail = (ive(0, early), ive(1, early)), _mean(early), first_tail(late)
    outer = ends[0] * kve(1, late) + ends[1] * kve(0, late)
    moved = late / (early - late) * (ends[0] * tail + ends[1] * kve(0, late) - mean * early / late)
    matrix, right = np.zeros((m + 2, m + 2)), np.zeros(m + 2)
    matrix[:m, :m] = late / (early - late) * outer / kve(1, late)
    right[:m] = -1.0
    matrix[m, :m], matrix[m, m], matrix[m, m + 1] = -creep @ moved, glassy + float(np.sum(creep)), -1.0
    right[m] = float(creep @ tail[:, 0])
    matrix[m + 1, :m], matrix[m + 1, m], right[m + 1] = mean, 1.0, 1.0
    found = np.linalg.solve(matrix, right)
    return PassingStrip(float(found[m + 1]), found[:m], early)
