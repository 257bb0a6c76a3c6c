"""The numbers of the wear cases and the closed forms, checked by quadrature."""

import tomllib
from pathlib import Path

import mpmath
import pytest

from winkler.reference.wear import cap_radius, limiting_force, limiting_height, punch_bulge

CASES = Path(__file__).resolve().parents[3] / "src" / "winkler" / "cases"


def expected(case):
    content = tomllib.loads((CASES / f"{case}.toml").read_text(encoding="utf-8"))
    return content, {item["quantity"]: item["value"] for item in content["expect"]}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("case", "share"), [("limiting_profile_small_core", "0.2"), ("limiting_profile_half_core", "0.5")]
)
def test_the_limiting_profile_of_a_ball(case, share):
    content, numbers = expected(case)
    # lengths in a_0 = 100 um, heights in d = 1 um: g = x^2, f = r^2 / 2
    c, nu = mpmath.mpf(share), mpmath.mpf("0.3")

    def shape(r):
        unworn = mpmath.quad(lambda w: (r * mpmath.sin(w)) ** 2, [0, mpmath.asin(c / r)])
        return 2 / mpmath.pi * (unworn + mpmath.acos(c / r))

    end = mpmath.findroot(lambda r: shape(r) - r * r / 2, (1.1, 1.4), solver="anderson")
    # r^2 = c^2 + s^2 takes the root at the core away
    volume = mpmath.quad(
        lambda s: 2 * mpmath.pi * s * (shape(mpmath.hypot(c, s)) - (c * c + s * s) / 2),
        [0, mpmath.sqrt(end**2 - c**2)],
        maxdegree=4,
    )
    modulus = mpmath.mpf("210e9") / (2 * (1 - nu**2))
    force = 2 * modulus * (c - c**3 / 3) * mpmath.mpf("1e-10")
    swing = mpmath.mpf("0.5") * (2 - nu) / (2 * (1 - nu)) * (1 - c * c)
    assert float(content["problem"]["amplitude"]["shift"].split()[0]) == pytest.approx(float(swing), rel=1e-14)
    assert numbers["stick_radius"] == pytest.approx(float(100 * c), rel=1e-14)
    assert numbers["radius"] == pytest.approx(float(100 * end), rel=1e-12)
    assert numbers["worn_volume"] == pytest.approx(float(volume) * 1e-14, rel=1e-9)
    assert numbers["force"] == pytest.approx(float(force), rel=1e-12)
    lengths = {"core": float(c) * 1e-4, "depth": 1e-6, "curvature_radius": 10e-3}
    assert limiting_force(**lengths, modulus=float(modulus)) == pytest.approx(float(force), rel=1e-12)
    for r in (0.6, 1.0, 1.2):
        assert limiting_height(r * 1e-4, **lengths) == pytest.approx(float(shape(mpmath.mpf(r))) * 1e-6, rel=1e-12)


def test_the_march_has_the_same_numbers():
    _, limit = expected("limiting_profile_half_core")
    _, march = expected("fretting_reaches_the_limit")
    for quantity in ("force", "worn_volume", "stick_radius"):
        assert march[f"{quantity}.-1"] == limit[quantity]


def test_an_even_pressure_sinks_the_rim_less():
    # Love: u(r) = 4 p a / (pi E*) E(r^2 / a^2) under an even pressure
    difference = 4 / mpmath.pi * (mpmath.ellipe(0) - mpmath.ellipe(1))
    assert punch_bulge(pressure=1.0, radius=1.0, modulus=1.0) == pytest.approx(float(difference), rel=1e-14)
    _, numbers = expected("flat_punch_worn_even")
    assert numbers["worn_volume.-1"] == pytest.approx(1e-14 * 100.0 * 10.0)
    assert numbers["mean_pressure.-1"] == pytest.approx(float(100 / mpmath.pi), rel=1e-14)


def test_a_cap_holds_its_volume():
    # the plane at the height of a paraboloid at a: pi a^4 / (4 R)
    volume = mpmath.quad(lambda r: 2 * mpmath.pi * r * (mpmath.mpf("0.09") - r * r) / 2, [0, 0.3])
    assert cap_radius(float(volume), 1.0) == pytest.approx(0.3, rel=1e-12)
