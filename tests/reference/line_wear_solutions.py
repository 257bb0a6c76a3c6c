"""The numbers of the cases of worn line contacts, computed without winkler, in the order of [[expect]]."""

from __future__ import annotations

import mpmath as mp
from reference_solutions import ReferenceSolutions, frac

WORN_LINES = ReferenceSolutions()


def worn_cylinder(force, swing, mu, radius, modulus) -> list:
    """Return c, the end of the worn part and the worn volume per length of a cylinder that has fretted to its end.

    The pressure of the core is that of Hertz, beside which the surface has the slope (x - (x^2-c^2)^(1/2))/R, and of a
    flat punch, beside which it has 2 (Q/mu)/(pi E* (x^2-c^2)^(1/2)); what was worn off grows by both less x/R.
    """
    width = mp.sqrt(4 * force * radius / (mp.pi * modulus))
    core = width * mp.sqrt(1 - swing / (mu * force))

    def growth(t):
        """Return how the worn depth grows with t, x = c + t^2."""
        root = t * mp.sqrt(2 * core + t * t)  # of x^2 - c^2
        punch = 4 * (swing / mu) / (mp.pi * modulus * mp.sqrt(2 * core + t * t))
        return punch - 2 * t * root / radius

    def worn(t):
        return mp.quad(growth, [0, t])

    last = mp.findroot(worn, (mp.sqrt(width - core), mp.sqrt(2 * width - core)), solver="anderson", tol=1e-19)
    # by parts: the integral of worn(t) dx, x = c + t^2
    volume = -2 * mp.quad(lambda t: t * t * growth(t), [0, last])
    end = core + last**2
    return [core, end, volume]


@WORN_LINES.of_case
def line_limiting_cylinder() -> list:
    """E* = R = 1."""
    return worn_cylinder(mp.mpf(1), frac("0.25"), frac("0.4"), mp.mpf(1), mp.mpf(1))


@WORN_LINES.of_case
def line_fretting_reaches_the_limit() -> list:
    """The same, reached cycle by cycle."""
    core, _, volume = worn_cylinder(mp.mpf(1), frac("0.25"), frac("0.4"), mp.mpf(1), mp.mpf(1))
    return [core, volume]


@WORN_LINES.of_case
def line_punch_worn_even() -> list:
    """Volume kappa P s; even pressure P/2b; the rim is worn by their quotient 2b and what an even pressure bends."""
    force, half, rate, far = mp.mpf(10) ** 5, frac("0.001"), frac("1e-14"), mp.mpf(20)
    modulus = frac("210e9") / (2 * (1 - frac("0.3") ** 2))
    even = force / (2 * half)

    def bent(x):  # the surface at x below that in the middle
        return 2 * even / (mp.pi * modulus) * ((half + x) * mp.log(1 + x / half) + (half - x) * mp.log(1 - x / half))

    rim = 4 * even * half * mp.log(2) / (mp.pi * modulus)
    mean = mp.quad(bent, [0, half / 2, half]) / half
    volume = rate * force * far
    return [volume, even, volume / (2 * half) + rim - mean]
