"""The adhesive cases in src/winkler/cases: their numbers, recomputed at 30 digits from the closed forms."""

from __future__ import annotations

import tomllib
from pathlib import Path

import mpmath as mp
import pytest

import winkler

CASES = Path(winkler.__file__).parent / "cases"
RUBBER, R, W = mp.mpf("1.5e6") / mp.mpf("0.75"), mp.mpf("0.01"), mp.mpf("0.07")


def stretch(e, a, w):
    return mp.sqrt(2 * mp.pi * a * w / e)


def sphere(e, r, w, force):
    p = 3 * mp.pi * w * r
    a = mp.cbrt(3 * r / (4 * e) * (force + p + mp.sqrt(2 * p * force + p * p)))
    ell = stretch(e, a, w)
    return {
        "radius": a,
        "depth": a**2 / r - ell,
        "energy_release_rate": w,
        "stress_intensity": mp.sqrt(2 * e * w),
        "pressure": 2 * e * a / (mp.pi * r) - e * ell / (mp.pi * a),
    }


def power(e, c, n, w):
    """Pull-off of f = c r^n under a dead load: a g' = 3/2 l."""
    kappa = mp.sqrt(mp.pi) * n * mp.gamma(mp.mpf(n) / 2) / (2 * mp.gamma(mp.mpf(n + 1) / 2)) * c
    a = (9 * mp.pi * w / (2 * n**2 * kappa**2 * e)) ** (mp.mpf(1) / (2 * n - 1))
    ell = stretch(e, a, w)
    force = 2 * e * a * (kappa * a**n * mp.mpf(n) / (n + 1) - ell)
    return {"radius": a, "depth": kappa * a**n - ell, "force": force}


def grips():
    a = mp.cbrt(mp.pi * R**2 * W / (8 * RUBBER))
    ell = stretch(RUBBER, a, W)
    return {"radius": a, "depth": a**2 / R - ell, "force": 4 * RUBBER * a**3 / (3 * R) - 2 * RUBBER * a * ell}


def flat():
    b = mp.mpf("3e-3")
    ell = stretch(RUBBER, b, W)
    return {"radius": b, "depth": -ell, "force": -2 * RUBBER * b * ell}


def exact_sphere():
    e, r, w = mp.mpf("5e4") / mp.mpf("0.75"), mp.mpf("1e-3"), mp.mpf("0.5")

    def force(a):
        return 2 * e * a * (a * mp.atanh(a / r) - stretch(e, a, w)) - 2 * e * mp.quad(
            lambda x: x * mp.atanh(x / r), [0, a]
        )

    slope = lambda a: mp.atanh(a / r) + (a / r) / (1 - (a / r) ** 2)  # noqa: E731
    a = mp.findroot(
        lambda a: a * slope(a) - mp.mpf(3) / 2 * stretch(e, a, w), (mp.mpf("2e-4"), mp.mpf("6e-4")), solver="anderson"
    )
    return {"radius": a, "depth": a * mp.atanh(a / r) - stretch(e, a, w), "force": force(a)}


def graded():
    k, nu = mp.mpf("0.3"), mp.mpf("0.3")
    beta = mp.sqrt((1 + k) * (1 - k * nu / (1 - nu)))
    c = 2 ** (1 + k) * mp.gamma((3 + k + beta) / 2) * mp.gamma((3 + k - beta) / 2) / (mp.pi * mp.gamma(2 + k))
    h = 2 * (1 + k) * mp.cos(k * mp.pi / 2) * mp.gamma(1 + k / 2)
    h /= mp.sqrt(mp.pi) * c * beta * mp.sin(beta * mp.pi / 2) * mp.gamma((1 + k) / 2)
    e = h * mp.mpf("2e6") / (1 - nu**2) / mp.mpf("1e-3") ** k
    a = ((3 + k) * (1 + k) * R / 4 * mp.sqrt(2 * mp.pi * W / e)) ** (2 / (3 + k))
    depth = a**2 / ((1 + k) * R) - mp.sqrt(2 * mp.pi * a ** (1 - k) * W / e)
    return {"radius": a, "depth": depth, "force": -(3 + k) / 2 * mp.pi * R * W}


def maugis(strength):
    """The least force of Maugis' curve, by Newton's method on m = c/a."""
    big = 4 * RUBBER / 3
    q = 2 * mp.mpf(strength) * mp.cbrt(R / (mp.pi * W * big**2))

    def state(x):
        m = 1 + mp.exp(x)
        root = mp.sqrt(m * m - 1)
        angle = mp.atan(root)
        first, second = q / 2 * (root + (m * m - 2) * angle), 4 * q**2 / 3 * (root * angle - m + 1)
        a = (-second + mp.sqrt(second**2 + 4 * first)) / (2 * first)
        return a, a**3 - q * a**2 * (root + m * m * angle), a**2 - mp.mpf(4) / 3 * a * q * root

    places = [mp.mpf(i) / 10 for i in range(-90, 50)]
    start = min(places, key=lambda x: state(x)[1])
    x = mp.findroot(lambda x: mp.diff(lambda y: state(y)[1], x), (start - mp.mpf("0.03"), start + mp.mpf("0.03")))
    a, f, d = state(x)
    return {
        "radius": a * mp.cbrt(mp.pi * W * R**2 / big),
        "depth": d * mp.cbrt(mp.pi**2 * W**2 * R / big**2),
        "force": f * mp.pi * W * R,
    }


def wavy(pull_off):
    h, w, k = mp.mpf("1e-4"), mp.mpf("1e-4"), 100 * mp.pi

    def depth(a):
        return a**2 + mp.pi / 2 * h * k * a * mp.struveh(0, k * a) - stretch(1, a, w)

    def force(a):
        return 2 * a * depth(a) - 2 * (a**3 / 3 + mp.pi / 2 * h * a * mp.struveh(1, k * a))

    # the brackets come from the brute-force searches of test_equilibrium.py
    if pull_off:
        a = mp.findroot(lambda a: mp.diff(force, a), (mp.mpf("0.0770"), mp.mpf("0.0775")))
    else:
        a = mp.findroot(force, (mp.mpf("0.118"), mp.mpf("0.119")), solver="anderson")
    return {"radius": a, "depth": depth(a), "force": force(a)}


def far():
    a = mp.cbrt(3 * R / (4 * RUBBER) * 2 * mp.pi * R * W)
    return {"radius": a, "depth": a**2 / R}


KNOWN = {
    "jkr_rubber_no_load": lambda: sphere(RUBBER, R, W, mp.mpf(0)),
    "jkr_rubber_pressed": lambda: sphere(RUBBER, R, W, mp.mpf("0.02")),
    "jkr_pull_off": lambda: power(RUBBER, 1 / (2 * R), 2, W),
    "jkr_pull_off_fixed_grips": grips,
    "kendall_flat_punch": flat,
    "maugis_barquins_cone": lambda: power(RUBBER, 1 / mp.tan(mp.mpf("1.4")), 1, W),
    "adhesive_fourth_power": lambda: power(RUBBER, mp.mpf(1000), 4, W),
    "adhesive_exact_sphere": exact_sphere,
    "graded_adhesive_ball": graded,
    "maugis_soft": lambda: maugis("2e3"),
    "maugis_middle": lambda: maugis("2e4"),
    "maugis_strong": lambda: maugis("2e5"),
    "derjaguin_ball": far,
    "guduru_wavy_pull_off": lambda: wavy(True),
    "guduru_wavy_no_load": lambda: wavy(False),
}


@pytest.mark.parametrize("name", KNOWN)
def test_a_case_is_recomputed(name):
    case = tomllib.loads((CASES / f"{name}.toml").read_text(encoding="utf-8"))
    with mp.workdps(30):
        solutions = KNOWN[name]()
        for expectation in case["expect"]:
            assert abs(mp.mpf(expectation["value"]) / solutions[expectation["quantity"]] - 1) < mp.mpf("1e-15")
