"""Temperatures under moving bands and ellipses of heat, computed without winkler: sums of moving sources by mpmath.

A moving line source of 1 W per length has lambda T = exp(z) K0(|z|)/pi with z = V (x - s)/(2 kappa) (Jaeger).
"""

from __future__ import annotations

from typing import Any

import mpmath as mp
from reference_solutions import ReferenceSolutions, frac

Numbers = list[Any]
REFERENCES = ReferenceSolutions()
of_case = REFERENCES.of_case


def steel() -> mp.mpf:
    """E* of two steels [Pa]."""
    return frac("210e9") / (2 * frac("0.91"))


def band(x: mp.mpf, wave: mp.mpf, weight: Any, more: tuple[Any, ...] = ()) -> mp.mpf:
    """The integral of weight(s) exp(z) K0(|z|)/pi over -1 < s < 1, s = sin(angle), weight with its cos(angle)."""

    def kernel(angle: mp.mpf) -> mp.mpf:
        z = wave * (x - mp.sin(angle)) / 2
        return weight(angle) * mp.exp(z) * mp.besselk(0, abs(z)) if z else mp.mpf(0)

    cuts = sorted({-mp.pi / 2, mp.asin(x) if abs(x) <= 1 else mp.mpf(0), mp.pi / 2, *more})
    return mp.quad(kernel, cuts) / mp.pi


def hertz_band(x: mp.mpf, wave: mp.mpf) -> mp.mpf:
    """lambda T under 1 W per length with the flux of Hertz on -1 < s < 1; the wave number is V/kappa."""
    return band(x, wave, lambda angle: 2 / mp.pi * mp.cos(angle) ** 2)


def hertz_band_peak(wave: mp.mpf, near: str) -> mp.mpf:
    """The greatest lambda T; its place is where the integral of q' vanishes."""

    def slope(x: mp.mpf) -> mp.mpf:
        return band(x, wave, lambda angle: -mp.sin(angle))

    with mp.workdps(12):  # the height depends on the square of an error of the place
        place = mp.findroot(slope, (frac(near), frac(near) + frac("0.01")))
    return hertz_band(place, wave)


def hertz_band_mean(wave: mp.mpf) -> mp.mpf:
    """The mean of lambda T over the band: the integral of exp(t) K0(t) is t exp(t) (K0 + K1) - 1."""

    def downstream(z: mp.mpf) -> mp.mpf:
        return z * mp.exp(z) * (mp.besselk(0, z) + mp.besselk(1, z)) - 1 if z else mp.mpf(0)

    def upstream(z: mp.mpf) -> mp.mpf:
        return 1 - z * mp.exp(-z) * (mp.besselk(1, z) - mp.besselk(0, z)) if z else mp.mpf(0)

    def one(angle: mp.mpf) -> mp.mpf:
        whole = downstream(wave * (1 - mp.sin(angle)) / 2) + upstream(wave * (1 + mp.sin(angle)) / 2)
        return 2 / mp.pi * mp.cos(angle) ** 2 * whole

    return mp.quad(one, [-mp.pi / 2, 0, mp.pi / 2]) / (mp.pi * wave)


@of_case
def line_heating_discs() -> Numbers:
    """a = 0.1 mm, R = 10 mm, both bodies of one steel at 1.2 m/s in opposite directions: Pe = 5, halves of the heat."""
    force = mp.pi * steel() * frac("1e-8") / (4 * frac("1e-2"))
    heat = frac("0.05") * force * frac("2.4")
    unit = heat / (2 * 45)
    return [heat, hertz_band_peak(frac("10"), "0.6") * unit, hertz_band_mean(frac("10")) * unit]
