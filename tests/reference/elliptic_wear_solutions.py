"""The numbers of the cases of worn elliptic contacts, computed without winkler, in the order of [[expect]]."""

from __future__ import annotations

import mpmath as mp
from elliptic_solution import parameter
from reference_solutions import ReferenceSolutions, frac

WORN_ELLIPSES = ReferenceSolutions()


@WORN_ELLIPSES.of_case
def elliptic_wear_one_to_four() -> list:
    """Slider kappa p0 s and kappa F s; track by quadrature along the sliding; half-width by its extreme."""
    force, far, passes, angle = mp.mpf(100), mp.mpf(2), mp.mpf(5), mp.pi / 6
    slider, track = frac("1e-17"), frac("1e-15")
    long, short, modulus = frac("0.02"), frac("0.005"), frac("210e9") / (2 * frac("0.91"))
    m = parameter(long / short)
    # with p0 = 3F/(2 pi a b) in 1/(2 R_a) = (p0/E*) (b/(a^2 m)) (K - E)
    a = mp.cbrt(3 * force * long * (mp.ellipk(m) - mp.ellipe(m)) / (mp.pi * modulus * m))
    b = a * mp.sqrt(1 - m)
    peak = 3 * force / (2 * mp.pi * a * b)

    def pressure(x, y):
        return peak * mp.sqrt(max(1 - (x / a) ** 2 - (y / b) ** 2, mp.mpf(0)))

    # a chord ends where the pressure does
    chord = 1 / mp.sqrt((mp.cos(angle) / a) ** 2 + (mp.sin(angle) / b) ** 2)
    deepest = 2 * mp.quad(lambda u: pressure(u * mp.cos(angle), u * mp.sin(angle)), [0, chord])
    # the place of the ellipse that is farthest across the sliding
    turn = mp.atan2(b * mp.cos(angle), -a * mp.sin(angle))
    half_width = -a * mp.cos(turn) * mp.sin(angle) + b * mp.sin(turn) * mp.cos(angle)
    return [slider * peak * far, slider * force * far, passes * track * deepest, half_width, passes * track * force]
