r"""Integrals of decaying exponentials over a step, for any ratio :math:`x=h/\tau` of the step to a relaxation time.

All that a Maxwell element does in a step of steady motion is a sum of

.. math:: \varphi_1(x) = \frac{1-e^{-x}}{x}, \qquad \varphi_{k+1}(x) = \frac{1/k!-\varphi_k(x)}{x} .

Written like this nothing is left of them where x is small, so there they are summed up as series.  With the stress
:math:`S_0` before the step and the rise :math:`Q=M\,\Delta u` that it would have if nothing faded, the element bears
:math:`S=S_0e^{-xs}+Q\,s\,\varphi_1(xs)` at the part s of the step and loses

.. math:: \frac{x}{M}\int_0^1 S^2\,\mathrm ds = \frac{a\,S_0^2+b\,S_0Q+c\,Q^2}{M} , \qquad
          a = \frac{1-e^{-2x}}{2} , \quad b = x\,\varphi_1^2 , \quad c = \varphi_2-\tfrac12\varphi_1^2 .

Where the motion bends by a steady acceleration, the rate differs from its mean by :math:`s-\tfrac12` times what it
gains in the step.  With the stress B that this gain would give if nothing faded, the element bears :math:`BR(s)` more,
:math:`R'=-xR+s-\tfrac12`, :math:`R=s^2\varphi_2(xs)-\tfrac12s\varphi_1(xs)`.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.jit import compiled

MOST_TERMS = 30
"""Of a series, at most."""
NEGLIGIBLE_TERM = 1e-19
"""Terms of a series below this do not change a sum of about one."""
BENDS = 8
"""How many numbers `bends` writes."""
GAUSS_PLACES, GAUSS_WEIGHTS = (
    0.5 * (x + y) for x, y in zip(np.polynomial.legendre.leggauss(6), (1.0, 0.0), strict=True)
)
"""Of a sum in place of an integral from 0 to 1."""


@compiled
def first(x):  # type: ignore[no-untyped-def]
    """Return phi_1 of x >= 0, which cancels nowhere."""
    return -np.expm1(-x) / x if x > 0.0 else 1.0


@compiled
def second(x):  # type: ignore[no-untyped-def]
    """Return phi_2 of x >= 0."""
    if x >= 1.0:
        return (1.0 - first(x)) / x
    term, total = 0.5, 0.0
    for k in range(MOST_TERMS):
        total += term
        term *= -x / (k + 3.0)
        if abs(term) < NEGLIGIBLE_TERM:
            break
    return total


@compiled
def fading(x, out):  # type: ignore[no-untyped-def]
    """Write phi_1 .. phi_4 of x >= 0 into `out` (4,)."""
    if x < 1.0:
        term, total = 1.0 / 24.0, 0.0
        for j in range(MOST_TERMS):
            total += term
            term *= -x / (j + 5.0)
            if abs(term) < NEGLIGIBLE_TERM:
                break
        out[3] = total
        out[2] = 1.0 / 6.0 - x * out[3]
        out[1] = 0.5 - x * out[2]
        out[0] = 1.0 - x * out[1]
        return
    out[0] = first(x)
    out[1] = (1.0 - out[0]) / x
    out[2] = (0.5 - out[1]) / x
    out[3] = (1.0 / 6.0 - out[2]) / x


@compiled
def losses(x, phi):  # type: ignore[no-untyped-def]
    """Return a, b and c of the energy that an element loses in a step; `phi` as `fading` writes it."""
    one = phi[0]
    if x < 1.0:
        # c/x is the sum of (2^(k+2) - 2) (-x)^k / (k+3)!
        term, power, total = 1.0 / 6.0, 4.0, 0.0
        for k in range(MOST_TERMS):
            total += (power - 2.0) * term
            term *= -x / (k + 4.0)
            power *= 2.0
            if power * abs(term) < NEGLIGIBLE_TERM:
                break
        return -0.5 * np.expm1(-2.0 * x), x * one * one, x * total
    return -0.5 * np.expm1(-2.0 * x), one * -np.expm1(-x), phi[1] - 0.5 * one * one


@compiled
def bends(x, phi, out):  # type: ignore[no-untyped-def]
    """Write what a bend of the motion adds to a step.

    Parameters
    ----------
    x : float
        Length of the step over the relaxation time.
    phi : ndarray, (4,)
        As `fading` writes it for this x; it is used up.
    out : ndarray, (8,)
        R at the end and its mean; the means of (s - 1/2) times e^(-xs), s phi_1(xs) and R, by which the bend does work;
        and by which energy is lost with S_0 B, Q B and B^2.
    """
    fade, one, two = np.exp(-x), phi[0], phi[1]
    out[0] = x * (0.5 * two - phi[2])
    if x < 0.5:
        for k in range(1, BENDS):
            out[k] = 0.0
        for g in range(GAUSS_PLACES.size):
            place, weight = GAUSS_PLACES[g], GAUSS_WEIGHTS[g]
            fading(x * place, phi)
            e, p, r = np.exp(-x * place), place * phi[0], place * (place * phi[1] - 0.5 * phi[0])
            out[1] += weight * r
            out[2] += weight * (place - 0.5) * np.expm1(-x * place)
            out[3] += weight * (place - 0.5) * p
            out[4] += weight * (place - 0.5) * r
            out[5] += 2.0 * x * weight * e * r
            out[6] += 2.0 * x * weight * p * r
            out[7] += x * weight * r * r
        return
    out[1] = (0.5 - two) / x - 0.5 * two
    out[2] = (one - fade) / x - 0.5 * one
    out[3] = -out[2] / x
    out[4] = (1.0 / 12.0 - out[3]) / x - 0.5 * out[3]
    out[5] = out[2] - fade * out[0]
    out[6] = out[1] + out[3] - one * out[0]
    out[7] = out[4] - 0.5 * out[0] * out[0]
