"""The numbers of the cases of rolling lines, computed without winkler, in the order of [[expect]]."""

from __future__ import annotations

import mpmath as mp
from reference_solutions import ReferenceSolutions, frac

ROLLING_LINES = ReferenceSolutions()


@ROLLING_LINES.of_case
def line_rolling_carter() -> list:
    """E* = R = 1: c/a = 1 - xi R/(mu a), Q = mu P (1 - (c/a)^2), P = pi E* a^2/(4 R); xi Q is lost."""
    a, mu, xi = frac("0.1"), frac("0.3"), frac("0.01")
    share = 1 - xi / (mu * a)
    force = mu * mp.pi * a**2 / 4 * (1 - share**2)
    return [force, share, xi * force, 1 - share**2]


@ROLLING_LINES.of_case
def line_rolling_start_carter() -> list:
    """In the end xi = mu (a - c)/R, c/a = (1 - Q/(mu P))^(1/2)."""
    share = mp.sqrt(1 - frac("0.64"))
    return [frac("0.3") * frac("0.1") * (1 - share), share]


@ROLLING_LINES.of_case
def line_rolling_resistance_hunter() -> list:
    """The transform of the pressure is a line and an exponential; its parts and the edges from three equations.

    g = alpha x + beta + C exp((x - a)/rho) in the strip; no infinite pressure at its ends; and at the leading edge the
    delayed part is the integral of the pressure with the kernel exp(y) E_1(y), y = (a - s)/lambda.
    """
    ell, radius, rho, lam = frac("0.01"), mp.mpf(1), frac("0.005"), frac("0.02")
    quick, slow = frac("0.25"), frac("0.75")  # compliances, 1/E* in the end is 1
    alpha = 1 / (2 * radius)
    beta = -alpha * slow * lam
    kappa = ell / rho
    bessel = [mp.exp(-kappa) * mp.besseli(n, kappa) for n in range(40)]

    def delayed(waves: list) -> mp.mpf:
        def part(angle: mp.mpf) -> mp.mpf:
            y = ell / lam * 2 * mp.sin(angle / 2) ** 2
            pressure = sum(wave * mp.sin((n + 1) * angle) for n, wave in enumerate(waves))
            return pressure * mp.exp(y) * mp.e1(y) * mp.sin(angle)

        return ell / (mp.pi * lam) * mp.quad(part, [0, mp.pi / 2, mp.pi])

    straight, curved = [alpha * ell], [2 * each for each in bessel[1:]]
    # unknown C and a: C (1/(1 - lam/rho) - delayed(curved)) + alpha a = delayed(straight) - beta - alpha lam
    #                  C I_0 + alpha (a - ell) + beta = 0
    system = mp.matrix([[1 / (1 - lam / rho) - delayed(curved), alpha], [bessel[0], alpha]])
    right = mp.matrix([delayed(straight) - beta - alpha * lam, alpha * ell - beta])
    strength, a = mp.lu_solve(system, right)
    waves = [straight[0] + strength * curved[0], *(strength * each for each in curved[1:])]
    force = mp.pi / 2 * ell * waves[0]
    resisting = (force * (a - ell) + mp.pi / 4 * ell**2 * waves[1]) / radius
    at = mp.acos((ell - a) / ell)  # under the lowest point
    pressure = sum(wave * mp.sin((n + 1) * at) for n, wave in enumerate(waves))
    assert abs(quick + slow - 1) < frac("1e-15")
    return [force, resisting, a, a - 2 * ell, pressure]
