"""Temperatures under moving bands and ellipses of heat, computed without winkler: sums of moving sources.

A moving line source of 1 W per length has lambda T = exp(z) K0(|z|)/pi with z = V (x - s)/(2 kappa) (Jaeger).
"""

from __future__ import annotations

from typing import Any

import mpmath as mp
import numpy as np
from elliptic_solution import parameter
from reference_solutions import ReferenceSolutions, frac
from scipy.optimize import brentq, minimize
from scipy.special import k0e

Numbers = list[Any]
REFERENCES = ReferenceSolutions()
of_case = REFERENCES.of_case


def steel() -> mp.mpf:
    """E* of two steels [Pa]."""
    return frac("210e9") / (2 * frac("0.91"))


def double_exponential(low: float, high: float, count: int = 121) -> tuple[np.ndarray, np.ndarray]:
    """Distances from the lower end, and weights, of the tanh-sinh rule; logarithms at both ends do not hurt it."""
    t = np.linspace(-3.6, 3.6, count)
    part = 1.0 / (1.0 + np.exp(-np.pi * np.sinh(t)))
    weight = np.pi * np.cosh(t) * part / (1.0 + np.exp(np.pi * np.sinh(t))) * (t[1] - t[0])
    return (high - low) * part, (high - low) * weight


def band(x: float, wave: float, weight: Any) -> float:
    """The integral of weight exp(z) K0(|z|)/pi over angles from -pi/2 to pi/2, z = wave (x - sin(angle))/2, |x| < 1."""
    at, total = np.arcsin(x), 0.0
    for sign in (-1.0, 1.0):
        off, share = double_exponential(0.0, 0.5 * np.pi - sign * at)
        behind = -2.0 * np.cos(at + 0.5 * sign * off) * np.sin(0.5 * sign * off)  # x - sin(angle)
        z = 0.5 * wave * behind
        kernel = k0e(np.abs(z)) * np.exp(np.minimum(2.0 * z, 0.0))
        total += float(np.sum(weight(at + sign * off) * kernel * share))
    return total / np.pi


def hertz_band(x: float, wave: float) -> float:
    """lambda T under 1 W per length with the flux of Hertz on -1 < s < 1; the wave number is V/kappa."""
    return band(x, wave, lambda angle: 2.0 / np.pi * np.cos(angle) ** 2)


def hertz_band_peak(wave: float, low: float, high: float) -> float:
    """The greatest lambda T; its place is where the integral of q' vanishes."""
    return hertz_band(float(brentq(lambda x: band(x, wave, lambda angle: -np.sin(angle)), low, high)), wave)


def hertz_band_mean(wave: float) -> float:
    """The mean of lambda T over the band, by places at the sines of Gauss' nodes."""
    node, weight = np.polynomial.legendre.leggauss(60)
    angle = 0.5 * np.pi * node
    heights = [hertz_band(float(np.sin(each)), wave) for each in angle]
    return 0.25 * np.pi * float(np.sum(np.array(heights) * np.cos(angle) * weight))


@of_case
def line_heating_discs() -> Numbers:
    """a = 0.1 mm, R = 10 mm, both bodies of one steel at 1.2 m/s in opposite directions: Pe = 5, halves of the heat."""
    force = mp.pi * steel() * frac("1e-8") / (4 * frac("1e-2"))
    heat = frac("0.05") * force * frac("2.4")
    unit = heat / (2 * 45)
    return [heat, hertz_band_peak(10.0, 0.3, 0.9) * unit, hertz_band_mean(10.0) * unit]


# ---------------------------------------------------------------------------------------------------------------------
# ellipses: Hertz' flux of 1 W, moving point sources exp(-V (r - r_x)/(2 kappa))/(2 pi r) summed in polar coordinates


def hertz_axes(force: mp.mpf, along: mp.mpf, across: mp.mpf) -> tuple[mp.mpf, mp.mpf]:
    """The semi-axes under the radii of curvature of steel bodies; `along` is the greater one (Johnson 4.2)."""
    m = parameter(along / across)
    k, e = mp.ellipk(m), mp.ellipe(m)
    a = mp.cbrt(3 * force * along * (k - e) / (mp.pi * steel() * m))
    return a, a * mp.sqrt(1 - m)


def elliptic(x: float, y: float, axes: tuple[float, float], wave: float, angle: float, count: int = 600) -> float:
    """lambda T at a place within the ellipse; along a ray the flux ends like a root, so that r = R sin(u)."""
    a, b = axes
    turn = 2.0 * np.pi * (np.arange(count) + 0.5) / count
    node, weight = np.polynomial.legendre.leggauss(120)
    cos, sin = np.cos(turn), np.sin(turn)
    square, mixed = (cos / a) ** 2 + (sin / b) ** 2, x * cos / a**2 + y * sin / b**2
    left = 1.0 - (x / a) ** 2 - (y / b) ** 2
    far = (-mixed + np.sqrt(mixed**2 + square * left)) / square
    near = (mixed + np.sqrt(mixed**2 + square * left)) / square
    u = 0.25 * np.pi * (node + 1.0)
    r = far[:, None] * np.sin(u)
    flux = 1.5 / (np.pi * a * b) * np.sqrt(square[:, None] * (far[:, None] - r) * (r + near[:, None]))
    lag = 0.5 * wave * (1.0 + np.cos(turn - angle))[:, None] * r  # the source lies at r in this direction
    rays = np.sum(flux * np.exp(-lag) * far[:, None] * np.cos(u) * 0.25 * np.pi * weight, axis=1)
    return float(np.mean(rays))


def elliptic_peak(axes: tuple[float, float], wave: float, angle: float) -> float:
    """The greatest lambda T: its height depends on the square of an error of the place."""
    found = minimize(
        lambda at: -elliptic(axes[0] * at[0], axes[1] * at[1], axes, wave, angle, 300),
        (0.4 * np.cos(angle), 0.4 * np.sin(angle)),
        method="Nelder-Mead",
        options={"xatol": 1e-8, "fatol": 0.0, "maxfev": 160},
    )
    return elliptic(axes[0] * found.x[0], axes[1] * found.x[1], axes, wave, angle)


@of_case
def elliptic_heating_at_rest() -> Numbers:
    """lambda T = 3 Q K(m)/(4 pi a) in the middle, 3/4 of it in the mean; 100 N on R = 20 mm and 5 mm, 1 nm/s."""
    a, b = hertz_axes(frac("100"), frac("20e-3"), frac("5e-3"))
    heat = frac("0.1") * 100 * frac("1e-9")
    top = 3 * heat * mp.ellipk(1 - (b / a) ** 2) / (4 * mp.pi * a * 45)
    return [heat, top, 3 * top / 4]


@of_case
def elliptic_heating_skew() -> Numbers:
    """100 N on R = 20 mm and 5 mm; the first body takes the heat, at 1 m/s and 30 degrees from the long axis."""
    a, b = hertz_axes(frac("100"), frac("20e-3"), frac("5e-3"))
    unit = frac("0.1") * 100 / (45 * a)
    return [unit * elliptic_peak((1.0, float(b / a)), float(a) / 12e-6, np.pi / 6)]


# ---------------------------------------------------------------------------------------------------------------------
# maps of pixels


@of_case
def square_heat_moving() -> Numbers:
    """lambda T is the integral over kappa t of X Y / sqrt(pi t): what a square that moves on holds of Gaussians."""
    side, wave = frac("1e-3"), frac("0.06") / frac("12e-6")
    heat = frac("20e6") * frac("0.03")

    def rate(s: Any) -> Any:
        """At x = 0.2 mm and y = 0 from the middle, with kappa t = s^2."""
        at = frac("2e-4") - wave * s * s
        along = (mp.erf((at + side / 2) / (2 * s)) - mp.erf((at - side / 2) / (2 * s))) / 2
        return 2 / mp.sqrt(mp.pi) * along * mp.erf(side / (4 * s))

    pieces = [0, *(frac(part) * side for part in ("0.02", "0.1", "0.25", "0.5", "1", "2", "4", "20"))]
    peak = heat * mp.quad(rate, pieces) / (45 + 15)
    return [peak, frac("45") / (45 + 15), heat * side**2, frac("0.7e-3"), wave * side / 4]


WHEEL = {"a": "5.88e-3", "b": "10.54e-3", "speed": "30"}


def wheel_effusivity() -> mp.mpf:
    """Of the steel of CONTACT's wheel, sqrt(lambda rho c)."""
    return mp.sqrt(frac("50") * frac("7850") * frac("450"))


@of_case
def wheel_temperature_sliding() -> Numbers:
    """Hertz' flux at 1 m/s on a strip of the ellipse, half into each body; heat goes into the depth only."""
    a, b = (frac(WHEEL[name]) for name in "ab")
    heat = frac("0.03") * 3 * frac("1e5") / (2 * mp.pi * a * b)

    def passed(t: Any) -> Any:
        """The integral of sqrt(1 - s^2)/sqrt(t - s) from -1 to t, with t - s = (1 + t) sin(u)^2."""
        return mp.quad(
            lambda u: 2 * (1 + t) * mp.cos(u) ** 2 * mp.sqrt(1 - t + (1 + t) * mp.sin(u) ** 2), [0, mp.pi / 2]
        )

    at = mp.findroot(lambda t: mp.diff(passed, t), (frac("0.6"), frac("0.7")), solver="anderson")
    rise = heat / 2 * mp.sqrt(a / (mp.pi * frac(WHEEL["speed"]))) / wheel_effusivity() * passed(at)
    return [rise, frac("0.03") * frac("1e5")]


@of_case
def wheel_hot_on_rail() -> Numbers:
    """Like bodies that pass fast have the mean; heat flows as from one half-space to another since they touched."""
    a, b = (frac(WHEEL[name]) for name in "ab")
    flow = 150 / frac(2) * wheel_effusivity() * mp.sqrt(frac(WHEEL["speed"]) / mp.pi)
    widths = mp.quad(lambda s: (1 - s * s) ** frac("0.25"), [-1, 1])
    return [frac(75), flow * 2 * mp.sqrt(2 * a) * b * widths]


# ---------------------------------------------------------------------------------------------------------------------
# current through a strip


@of_case
def line_constriction_roller() -> Numbers:
    """rho/pi arsinh(d/a) in each body, and the film over 2 a; a = 0.1 mm."""
    first, second = (
        frac(rho) / mp.pi * mp.asinh(frac(depth) / frac("1e-4")) for rho, depth in (("2e-7", "5e-3"), ("3e-7", "8e-3"))
    )
    return [first + second + frac("1e-8")]


@of_case
def band_heating_one_body() -> Numbers:
    """Jaeger's band at Pe = 1: the integral of exp(t) K0(|t|) from 0 to z is exp(z) (z K0(|z|) + |z| K1(|z|)) - 1."""

    def rise(x: mp.mpf) -> mp.mpf:
        ends = (x + 1, x - 1)
        found = [mp.exp(z) * (z * mp.besselk(0, abs(z)) + abs(z) * mp.besselk(1, abs(z))) for z in ends]
        return frac("1e8") * frac("1e-4") / (mp.pi * 45) * (found[0] - found[1])

    low, high = mp.mpf(0), mp.mpf(1)
    for _ in range(40):  # the kernels of both edges are equal where it is warmest
        x = (low + high) / 2
        gains = mp.exp(2) * mp.besselk(0, 1 + x) > mp.besselk(0, 1 - x)
        low, high = (x, high) if gains else (low, x)
    fast = 2 * frac("1e8") / 45 * mp.sqrt(2 * frac("12e-6") * frac("1e-4") / (mp.pi * frac("0.24")))
    return [rise(low), fast, rise(mp.mpf(0)), rise(mp.mpf(3))]
