"""The numbers of the cases that hold the theory's tables, computed without winkler: one function a case.

Closed forms and integrals by mpmath; the equation of motion of a contact that does not slip by scipy.  Units are those
in which E* = R = 1, unless a case states more.
"""

from __future__ import annotations

from typing import Any

import mpmath as mp
import numpy as np
from reference_solutions import ReferenceSolutions, frac
from scipy.integrate import solve_ivp

Numbers = dict[str, Any]
REFERENCES = ReferenceSolutions()
of_case = REFERENCES.of_case


# ---------------------------------------------------------------------------------------------------------------------
# normal contact and impact


@of_case
def mindlin_ratio() -> Numbers:
    return {"problem.bed.medium.shear_modulus": 2 * frac("0.7") / frac("1.7")}


@of_case
def hertz_impact_depth() -> Numbers:
    deepest = frac("0.9375") ** frac("0.4")
    return {
        "depth.100": deepest,
        "duration": 4 * mp.sqrt(mp.pi) * mp.gamma(frac("0.4")) / (5 * mp.gamma(frac("0.9"))) * deepest,
    }


# ---------------------------------------------------------------------------------------------------------------------
# friction


@of_case
def oblique_loading_sticks() -> Numbers:
    """q_x / q_z is the same for every spring: the force follows the path."""
    return {"shear_force.-1": frac("0.2") * 4 / 3, "stick_radius.-1": mp.mpf(1)}


@of_case
def gross_slip_loss() -> Numbers:
    """4 mu F U - (8 mu^2 E*^2/G*) Int (d - g)^2 dx."""
    mu, shift = frac("0.3"), frac("0.5")
    return {"loss_per_cycle": 4 * mu * mp.mpf(4) / 3 * shift - 8 * mu**2 * mp.mpf(8) / 15}


@of_case
def relaxation_damping_cone() -> Numbers:
    """16/3 G* A_x^2 A_z sin^2(phi) / g'(a), g' = pi/2 tan of the face's angle."""
    slope = mp.pi / 2 / mp.tan(mp.radians(80))
    return {"loss_per_cycle": [16 * frac("0.01") * frac("0.5") / (3 * slope) * s for s in (frac("0.25"), mp.mpf(1))]}


@of_case
def maw_barber_fawcett_no_slip() -> Numbers:
    """Springs enter unloaded and are lost as the contact shrinks: F_x' = 2 G* (a U' + a' (U - U at entry))."""
    found = []
    half = 0.5 * float(hertz_impact_depth()["duration"])

    def press(t: float, y: Any) -> list[float]:
        return [y[1], -4 / 3 * max(y[0], 0.0) ** 1.5]

    down = solve_ivp(press, (0.0, half), [0.0, 1.0], method="DOP853", rtol=1e-13, atol=1e-16, dense_output=True)
    for nu in (0.0, 0.25, 0.3, 0.5):
        ratio, pull = 2 * (1 - nu) / (2 - nu), 3.5

        def load(t: float, y: Any, ratio: float = ratio, pull: float = pull) -> list[float]:
            a = np.sqrt(max(down.sol(t)[0], 0.0))
            return [y[1], -pull * y[2], 2 * ratio * a * y[1]]

        first = solve_ivp(
            load, (0.0, half), [0.0, 1.0, 0.0], method="DOP853", rtol=1e-12, atol=1e-15, dense_output=True
        )

        def unload(s: float, y: Any, ratio: float = ratio, pull: float = pull, first: Any = first) -> list[float]:
            depth, speed = down.sol(half - s)
            a = np.sqrt(max(depth, 1e-300))
            lost = -speed / (2 * a) * (y[0] - first.sol(half - s)[0])
            return [y[1], -pull * y[2], 2 * ratio * (a * y[1] + lost)]

        end = half * (1 - 1e-9)
        last = solve_ivp(unload, (0.0, end), first.y[:, -1], method="DOP853", rtol=1e-11, atol=1e-14)
        found.append(-last.y[1, -1])
    return {"lateral_restitution": found}


# ---------------------------------------------------------------------------------------------------------------------
# torsion: mu = 0.3, G = 1, E* = 2, a = 1

STICKING = ("0.99", "0.9", "0.8", "0.7", "0.6", "0.5", "0.4", "0.3", "0.2", "0.1", "0.01")


def _sliding(c: mp.mpf) -> mp.mpf:
    """Int_c^1 x^2 (K - E) dx, m = 1 - x^2."""
    return mp.quad(lambda x: x * x * (mp.ellipk(1 - x * x) - mp.ellipe(1 - x * x)), [c, (1 + c) / 2, 1])


@of_case
def lubkin_table() -> Numbers:
    """A paraboloid with F = 8/3: angle 3 mu F/(4 pi) (K - E), torque of the core and of what slides."""
    limit, peak = frac("0.3") * 8 / 3, frac("0.3") * 4 / mp.pi
    angles, torques = [], []
    for text in STICKING:
        c = frac(text)
        angle = 3 * limit / (4 * mp.pi) * (mp.ellipk(1 - c * c) - mp.ellipe(1 - c * c))
        angles.append(angle)
        torques.append(2 * (8 * angle * c**3 / 3 + 4 * peak * _sliding(c)))
    return {
        "angle": angles,
        "torque": torques,
        "stick_radius": [frac(text) for text in STICKING],
        "torque_limit": [3 * mp.pi / 16 * limit] * len(STICKING),
    }


@of_case
def torsion_flat_punch() -> Numbers:
    """q_slip = 2 mu F x/pi K(1 - x^2); F = 2 E* d = 4."""
    limit = frac("0.3") * 4
    return {
        "angle": [limit * mp.ellipk(frac("0.75")) / (4 * mp.pi)],
        "stick_radius": [frac("0.5")],
        "torque_limit": [mp.pi / 4 * limit],
    }


@of_case
def torsion_cone() -> Numbers:
    """p = (E* tan/2) arcosh(1/r), F = pi/2 E* tan, tan = 0.1; half of the radius sticks."""
    steep, c = frac("0.1"), frac("0.5")
    limit = frac("0.3") * mp.pi / 2 * 2 * steep
    angle = frac("0.3") / 2 * mp.quad(lambda w: steep * mp.acosh(1 / (c * mp.cosh(w))), [0, mp.acosh(1 / c)])

    def share(t: mp.mpf) -> mp.mpf:
        return t * t * mp.quad(lambda s: s * s * mp.ellipk(1 - s * s), [c / t, 1])

    slid = 4 * frac("0.3") / mp.pi * 2 * mp.pi / 2 * steep * mp.quad(share, [c, 1])
    return {
        "angle": [angle],
        "torque": [2 * (8 * angle * c**3 / 3 + slid)],
        "stick_radius": [c],
        "torque_limit": [mp.pi / 6 * limit],
    }


# ---------------------------------------------------------------------------------------------------------------------
# adhesion, E* = R = w = 1 unless stated


@of_case
def jkr_first_touch() -> Numbers:
    return {"radius": mp.cbrt(2 * mp.pi), "force": -4 * mp.pi / 3}


@of_case
def jkr_cycle() -> Numbers:
    """Energy E* Int (d - g)^2 dx - w pi a^2 at first touch and where fixed grips lose their hold."""

    def potential(a: mp.mpf) -> mp.mpf:
        depth = a**2 - mp.sqrt(2 * mp.pi * a)
        return mp.quad(lambda x: (depth - x**2) ** 2, [0, a]) - mp.pi * a**2

    on, off = -potential(mp.cbrt(2 * mp.pi)), potential(mp.cbrt(mp.pi / 8))
    return {"dissipation.2": on, "dissipation.-1": on + off}


@of_case
def maugis_table() -> Numbers:
    """Maugis' equations in his units, K = R = pi w = 1: the largest pull over all radii."""
    found = []
    for text in ("0.1", "0.5", "1", "2", "5"):
        lam = frac(text)

        def pull(a: mp.mpf, lam: mp.mpf = lam) -> mp.mpf:
            def closed(m: mp.mpf) -> mp.mpf:
                root = mp.sqrt(m * m - 1)
                first = lam * a * a / 2 * (root + (m * m - 2) * mp.asec(m))
                return first + 4 * lam**2 * a / 3 * (root * mp.asec(m) - m + 1) - 1

            m = mp.findroot(closed, (1 + frac("1e-6"), 1 + 5 / lam), solver="anderson", tol=1e-28)
            return a**3 - lam * a * a * (mp.sqrt(m * m - 1) + m * m * mp.asec(m))

        low, high = frac("0.3"), frac("2.5")
        grid = [low + (high - low) * i / 11 for i in range(12)]
        best = min(grid, key=pull)
        radius = mp.findroot(lambda a: mp.diff(pull, a), best)
        found.append(pull(radius))
    return {"force": found}


@of_case
def savkoor_briggs_sheared() -> Numbers:
    """E* l_z^2 + G* l_x^2 = 2 pi a w: the contact of Johnson, Kendall and Roberts, of the work that shear has left."""
    a, across = frac("0.15"), frac("0.02")
    work, shear = frac("1e-3"), mp.mpf(1)
    left = mp.sqrt(2 * mp.pi * a * work - shear * across**2)
    return {
        "radius": a,
        "force": 4 * a**3 / 3 - 2 * a * left,
        "depth": a**2 - left,
        "shear_force": 2 * a * across,
    }


# ---------------------------------------------------------------------------------------------------------------------
# graded bodies, E0 = c0 = 1


def _stiffening(k: mp.mpf, nu: mp.mpf) -> tuple[mp.mpf, mp.mpf]:
    """h_N and beta of the power-law half-space."""
    beta = mp.sqrt((1 + k) * (1 - k * nu / (1 - nu)))
    c = mp.mpf(2) ** (1 + k) * mp.gamma((3 + k + beta) / 2) * mp.gamma((3 + k - beta) / 2) / (mp.pi * mp.gamma(2 + k))
    over = 2 * (1 + k) * mp.cos(k * mp.pi / 2) * mp.gamma(1 + k / 2)
    return over / (mp.sqrt(mp.pi) * c * beta * mp.sin(beta * mp.pi / 2) * mp.gamma((1 + k) / 2)), beta


GRADINGS, SOLIDS = ("-0.2", "0.1", "0.25", "0.5", "0.75"), ("0", "0.25", "0.3", "0.4")


@of_case
def graded_moduli() -> Numbers:
    return {
        "problem.bed.medium.modulus": [
            _stiffening(frac(k), frac(nu))[0] / (1 - frac(nu) ** 2) for k in GRADINGS for nu in SOLIDS
        ]
    }


@of_case
def graded_shear_moduli() -> Numbers:
    found = []
    for k in map(frac, ("0.25", "0.5")):
        for nu in map(frac, SOLIDS):
            stiff, beta = _stiffening(k, nu)
            soft = (1 + k) ** 2 * (1 - nu**2) / (beta**2 * stiff) + (1 + nu) / mp.cos(k * mp.pi / 2)
            found.append(2 / soft)
    return {"problem.bed.medium.shear_modulus": found}


@of_case
def graded_ball_fixed_grips() -> Numbers:
    """a g' = (1 - k)/2 Delta l with g = a^2/(1 + k), Delta l^2 = 2 pi a^(1-k) w/E*; k = 0.2, nu = 0.3, w = 1e-3."""
    k = frac("0.2")
    modulus = _stiffening(k, frac("0.3"))[0] / (1 - frac("0.09"))
    work = frac("1e-3")
    a = (mp.pi * work * (1 - k) ** 2 * (1 + k) ** 2 / (8 * modulus)) ** (1 / (3 + k))
    stretch = mp.sqrt(2 * mp.pi * a ** (1 - k) * work / modulus)
    g = a**2 / (1 + k)
    force = 2 * modulus * a ** (k + 1) * (2 * g / ((k + 1) * (k + 3)) - stretch / (k + 1))
    return {"radius": a, "depth": g - stretch, "force": force}


# ---------------------------------------------------------------------------------------------------------------------
# moving heat


def moving(peclet: float, x: float) -> float:
    """lambda a T/Q at x of Hertz' flux: point sources in polar coordinates, where the kernel is smooth."""
    node, weight = np.polynomial.legendre.leggauss(60)
    part = 0.5 * (1.0 - np.cos(0.5 * np.pi * (1.0 + node)))
    weight = 0.25 * np.pi * weight * np.sin(0.5 * np.pi * (1.0 + node))
    turn = 2.0 * np.pi * np.arange(256) / 256
    chord = x * np.cos(turn) + np.sqrt(1.0 - (x * np.sin(turn)) ** 2)
    away = chord[:, None] * part
    inside = 1.0 - x * x + 2.0 * x * away * np.cos(turn)[:, None] - away**2
    flux = 1.5 / np.pi * np.sqrt(np.maximum(inside, 0.0))
    kernel = flux * np.exp(-peclet * away * (1.0 - np.cos(turn)[:, None]))
    return float(np.mean(chord * (kernel @ weight)))


@of_case
def heating_speeds() -> Numbers:
    """The greatest temperature on the line of motion at Pe = 0.01 ... 10, and the excess of the rule at rest."""
    tops = []
    for peclet in (0.01, 0.05, 0.1, 0.5, 1.0, 5.0, 10.0):
        place, width = 0.45, 0.45
        for _ in range(4):
            x = place + width * np.cos(np.pi * (np.arange(13) + 0.5) / 13)
            fit = np.polynomial.Polynomial.fit(x, [moving(peclet, each) for each in x], 12)
            fine = np.linspace(place - width, place + width, 4001)
            place, width = float(fine[np.argmax(fit(fine))]), 0.2 * width
            place = min(max(place, width), 0.98 - width)
        tops.append(float(fit(fine).max()))
    return {"top": tops, "overestimate": [0.375 / top - 1.0 for top in tops]}


# ---------------------------------------------------------------------------------------------------------------------
# rolling, two bodies of G = 1 in units of mu F_N


@of_case
def rolling_simplified_saturation() -> Numbers:
    """The strips' forces summed over the disc, at tau = c11 G a^2 s/(mu F_N) = 0.3, 1, 2, 3."""
    found = []
    for tau in map(frac, ("0.3", "1", "2", "3")):
        w = 3 * mp.pi / 16 * tau
        edge = mp.sqrt(1 - w**2 / 4) if w < 2 else mp.mpf(0)
        stuck = mp.quad(lambda y: 2 * (1 - y**2) * w - mp.sqrt(1 - y**2) * w**2 + w**3 / 6, [0, edge])  # noqa: B023
        slid = mp.quad(lambda y: mp.mpf(4) / 3 * (1 - y**2) ** mp.mpf(1.5), [edge, 1])
        found.append(4 / mp.pi * (stuck + slid))
    return {"share": found}


@of_case
def rolling_cubic_saturation() -> Numbers:
    return {"share": [1 - (1 - frac(tau) / 3) ** 3 for tau in ("0.3", "1", "2", "3")]}


@of_case
def rolling_uncalibrated() -> Numbers:
    """Slope 2 G* a^2 = 4/(2 - nu) G a^2 in the limit of no creepage; here the whole cubic at xi = 1e-4."""
    xi = frac("1e-4")
    return {"share": [1 - (1 - xi) ** 3], "slopes": [4 / (2 - frac(nu)) for nu in ("0", "0.25", "0.5")]}


@of_case
def shakedown_limit() -> Numbers:
    w = frac("0.2")
    return {"share": [1 - 3 * w / 2 + w**3 / 2]}


# ---------------------------------------------------------------------------------------------------------------------
# wear: lengths in a0 = sqrt(R d), heights in d


def _limiting(core: str) -> Numbers:
    c = frac(core)

    def shape(r: mp.mpf) -> mp.mpf:
        unworn = (r * r * mp.asin(c / r) - c * mp.sqrt(r * r - c * c)) / 2
        return 2 / mp.pi * (unworn + mp.acos(c / r))

    end = mp.findroot(lambda r: shape(r) - r * r / 2, (c * frac("1.02"), frac("1.42")), solver="anderson", tol=1e-25)
    volume = mp.quad(
        lambda s: 2 * mp.pi * s * (shape(mp.hypot(c, s)) - (c * c + s * s) / 2), [0, mp.sqrt(end**2 - c**2)]
    )
    return {"stick_radius": c, "radius": end, "worn_volume": volume, "force": 2 * (c - c**3 / 3)}


@of_case
def limiting_profile_wide_core() -> Numbers:
    return _limiting("0.8")


@of_case
def limiting_profile_nearly_stuck() -> Numbers:
    return _limiting("0.95")


# ---------------------------------------------------------------------------------------------------------------------
# particles


@of_case
def particle_yield_onset() -> Numbers:
    """4 E_c sqrt(x)/(3 pi) = Y (1.75 exp(-4.4 x) + 1), x = d/R."""
    ec, strength = frac("5e6") / (1 - frac("0.16")), frac("1.9e5")
    root = mp.findroot(
        lambda x: 4 * ec * mp.sqrt(x) / (3 * mp.pi) - strength * (frac("1.75") * mp.exp(-frac("4.4") * x) + 1), 0.035
    )
    return {"yield_depth": root}
