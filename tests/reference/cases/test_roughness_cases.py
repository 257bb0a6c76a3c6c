"""The cases of ellipses, square punches and rough surfaces in src/winkler/cases/*.toml, recomputed by mpmath."""

from __future__ import annotations

import tomllib
from pathlib import Path

import mpmath as mp
import pytest

import winkler
from winkler.values.units import to_si

CASES = Path(winkler.__file__).parent / "cases"


def number(raw) -> mp.mpf:
    return mp.mpf(raw if isinstance(raw, int | float) else to_si(raw, what="a case"))


def ellipse(problem: dict) -> dict:
    """Hertz's ellipse in Legendre's integrals, B/A = [E/(1-m) - K]/(K - E), for the unit modulus."""
    one, other = sorted(
        1 / (2 * number(problem["bodies"][f"{path}_curvature_radius"])) for path in ("longitudinal", "lateral")
    )
    force = number(problem["load"]["force"])

    def off(m):
        k, e = mp.ellipk(m), mp.ellipe(m)
        return (e / (1 - m) - k) / (k - e) - other / one

    m = mp.findroot(off, (mp.mpf("0.01"), mp.mpf("0.999")), solver="ridder", tol=1e-25)
    k, e = mp.ellipk(m), mp.ellipe(m)
    a = mp.cbrt(3 * force * (k - e) / (2 * mp.pi * m * one))
    b = a * mp.sqrt(1 - m)
    d = 3 * force * k / (2 * mp.pi * a)
    return {
        "longitudinal_semi_axis": a,
        "lateral_semi_axis": b,
        "depth": d,
        "equivalent_radius": 9 * force**2 / (16 * d**3),
        "peak_pressure": 3 * force / (2 * mp.pi * a * b),
        "stiffness": 3 * force / (2 * d),
    }


def persson(problem: dict) -> dict:
    """The error function of the pressure over the slope, integrated from the spectrum."""
    stated = problem["spectrum"]
    hurst, height = number(stated["hurst"]), number(stated["rms_height"])
    low, high = (2 * mp.pi / number(stated[word]) for word in ("longest", "shortest"))
    power = -2 * (hurst + 1)
    places = [low, 3 * low, 10 * low, 30 * low, high]
    strength = height**2 / (2 * mp.pi * mp.quad(lambda q: q ** (1 + power), places))
    slope = mp.sqrt(2 * mp.pi * strength * mp.quad(lambda q: q ** (3 + power), places))
    side = number(problem["side"])
    found = {}
    for place, force in enumerate(problem["load"]["force"]):
        found[f"area.{place}"] = side**2 * mp.erf(mp.sqrt(2) * number(force) / side**2 / slope)
    return found


def punch(problem: dict) -> dict:
    """Read's capacitance of the unit square."""
    assert problem["topography"]["lengths"] == ["1 m", "1 m"]
    stiffness = mp.pi * mp.mpf("0.36679")
    return {"stiffness": stiffness, "force": stiffness * number(problem["load"]["depth"])}


REFERENCES = {
    "elliptic_hertz_two_to_three": (ellipse, 1e-14),
    "elliptic_hertz_one_to_nine": (ellipse, 1e-14),
    "persson_area": (persson, 1e-14),
    "square_punch": (punch, 1e-5),
}


@pytest.mark.parametrize("name", REFERENCES)
def test_a_case_is_recomputed(name):
    case = tomllib.loads((CASES / f"{name}.toml").read_text(encoding="utf-8"))
    reference, rounding = REFERENCES[name]
    assert case["problem"]["medium"]["first"] == {"kind": "elastic", "young": "1 Pa", "poisson": 0.0}
    with mp.workdps(30):
        solutions = reference(case["problem"])
        assert {item["quantity"] for item in case["expect"]} == set(solutions)
        for item in case["expect"]:
            expected = solutions[item["quantity"]]
            assert abs(mp.mpf(item["value"]) - expected) <= rounding * abs(expected), item["quantity"]


def test_the_ellipses_have_the_digits_they_are_known_by():
    """To seven digits or more: (A, B) = (0.4, 0.6) and (0.1, 0.9) under a unit force and modulus."""
    for name, printed in (
        ("elliptic_hertz_two_to_three", (1.0446579, 0.79738613, 0.81801886, 1.0276201)),
        ("elliptic_hertz_one_to_nine", (2.0820102, 0.49458119, 0.65362614, 2.014347)),
    ):
        case = tomllib.loads((CASES / f"{name}.toml").read_text(encoding="utf-8"))
        given = [item["value"] for item in case["expect"]][:4]
        assert given == pytest.approx(printed, rel=6e-8)
