r"""Integrals of decaying exponentials over a step, for any ratio :math:`x=h/\tau` of the step to a relaxation time.

All that a Maxwell element does in a step of steady motion is a sum of

.. math:: \varphi_1(x) = \frac{1-e^{-x}}{x}, \qquad \varphi_{k+1}(x) = \frac{1/k!-\varphi_k(x)}{x} .

Written like this nothing is left of them where x is small, so there they are summed up as series.  With the stress
:math:`S_0` before the step and the rise :math:`Q=M\,\Delta u` that it would have if nothing faded, the element bears
:math:`S=S_0e^{-xs}+Q\,s\,\varphi_1(xs)` at the part s of the step and loses

.. math:: \frac{x}{M}\int_0^1 S^2\,\mathrm ds = \frac{a\,S_0^2+b\,S_0Q+c\,Q^2}{M} , \qquad
          a = \frac{1-e^{-2x}}{2} , \quad b = x\,\varphi_1^2 , \quad c = \varphi_2-\tfrac12\varphi_1^2 .
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.jit import compiled

__all__ = ["fading", "first", "losses", "second"]

MOST_TERMS = 30
"""Of a series, at most."""
NEGLIGIBLE_TERM = 1e-19
"""Terms of a series below this do not change a sum of about one."""


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
