"""The numbers in src/winkler/cases/*.toml are those of mpmath, and the cases are complete."""

from __future__ import annotations

import math
import tomllib
from pathlib import Path

import case_solutions
import mpmath as mp
import pytest

import winkler

CASES = {path.stem: path for path in sorted((Path(winkler.__file__).parent / "cases").glob("*.toml"))}
GRADES = ("analytical", "published table", "cross-code", "independent implementation", "measured")


def read(name: str) -> dict:
    return tomllib.loads(CASES[name].read_text(encoding="utf-8"))


def ours(case: dict) -> bool:
    """Whether the case is one of the half-space contacts that this reference covers."""
    if "fit" in case or "function" in case:
        return False
    bed = case["problem"].get("bed", {})
    homogeneous = bed.get("medium", {}).get("kind") in ("half_space", "transversely_isotropic_half_space")
    if bed.get("plane_profile", {}).get("kind") == "ellipsoid":  # an even pressure
        return False
    return case["problem"]["kind"] in ("indentation", "yield_onset") and homogeneous


def test_there_are_cases():
    assert len(CASES) >= 40


def test_a_case_says_what_it_is():
    for name in CASES:
        case = read(name)
        requests = "function" if "function" in case else "problem"
        assert set(case) - {"sweep", "fit"} == {"title", "grade", "source", requests, "expect"}, name
        assert case["grade"] in GRADES, name
        assert case["title"], name
        assert case["source"], name
        assert case["expect"], name
        for expectation in case["expect"]:
            required = {"quantity", "value", "unit", "tolerance"}
            assert set(expectation) - {"r", "x", "y", "z", "scale"} == required, name
            assert 0.0 < expectation["tolerance"] <= 1e-2, name
            assert expectation["value"] != 0.0, name


OURS = [name for name in CASES if ours(read(name))]
"""Of another physics each has a test of its own, which recomputes it."""


@pytest.mark.few(1, slow=12)
@pytest.mark.parametrize("name", OURS)
def test_a_case_is_recomputed(name):
    """Analytical numbers to all digits written, published ones within their rounding."""
    case = read(name)
    with mp.workdps(20):
        solution = case_solutions.ReferenceSolution(case["problem"])
        for expectation in case["expect"]:
            expected = solution.quantity(expectation)
            given = mp.mpf(expectation["value"])
            assert expectation["unit"] in ("m", "N", "Pa", "N/m", "J")
            tolerance = 1e-14 if case["grade"] == "analytical" else expectation["tolerance"]
            assert abs(given - expected) <= tolerance * abs(expected), (expectation, mp.nstr(expected, 20))


def expected(name: str, quantity: str, **where: str) -> float:
    """The value of one expectation of a case."""
    found = [
        item["value"]
        for item in read(name)["expect"]
        if item["quantity"] == quantity and all(item.get(key) == place for key, place in where.items())
    ]
    assert len(found) == 1, (name, quantity, where)
    return float(found[0])


@pytest.mark.parametrize(
    ("name", "quantity", "where", "number"),
    [
        ("sphere_exact", "depth", {}, "0.274653072167027"),
        ("sphere_exact", "force", {}, "0.186632680417569"),
        ("truncated_cone", "depth", {}, "0.0579639740363704"),
        ("truncated_cone", "force", {}, "0.0381471384080969"),
        ("rounded_punch_ciavarella", "depth", {}, "0.113200836675051"),
        ("rounded_punch_ciavarella", "force", {}, "0.0886784482022164"),
        ("hertz_paraboloid", "force", {}, "0.166666666666667"),
        ("hertz_paraboloid", "pressure", {"r": "0 m"}, "0.318309886"),
        ("hertz_paraboloid", "displacement", {"r": "1 m"}, "0.0544988905"),
        ("transverse_moduli_1", "problem.bed.medium.modulus", {}, "9.558861079"),
        ("transverse_moduli_1", "problem.bed.medium.shear_modulus", {}, "7.110690701"),
        ("transverse_moduli_2", "problem.bed.medium.modulus", {}, "8.737080168"),
        ("transverse_moduli_2", "problem.bed.medium.shear_modulus", {}, "3.324537596"),
        ("transverse_punch_1", "stiffness", {}, "9.558861079"),
        ("transverse_punch_2", "stiffness", {}, "8.737080168"),
        ("hertz_max_shear_nu_000", "max_shear", {}, "0.384821111"),
        ("hertz_max_shear_nu_025", "max_shear", {}, "0.3216784032"),
        ("hertz_max_shear_nu_030", "max_shear", {}, "0.310020502"),
        ("hertz_max_shear_nu_050", "max_shear", {}, "0.2663485631"),
        ("hertz_axis_stress", "axial_stress", {"z": "0.5 m"}, "-0.8"),
        ("hertz_axis_stress", "axial_stress", {"z": "2 m"}, "-0.2"),
        ("hertz_edge_tension", "radial_stress", {}, "0.133333333333333"),
        ("flat_punch_subsurface", "radial_stress", {}, "-0.111543335814"),
        ("flat_punch_subsurface", "hoop_stress", {}, "-0.138748156999"),
        ("flat_punch_subsurface", "axial_stress", {}, "-0.409245048135"),
        ("flat_punch_subsurface", "shear_stress", {}, "-0.0193774365764"),
    ],
)
def test_the_numbers_of_theory_are_cases(name, quantity, where, number):
    """Every number of sections 1.1 and 1.2, to the digits printed there."""
    digits = len(number.lstrip("-").replace(".", "").lstrip("0"))
    given = expected(name, quantity, **where)
    assert given == pytest.approx(float(number), rel=5.5 * 10.0**-digits)


@pytest.mark.parametrize(
    ("exponent", "kappa"),
    [(1, math.pi / 2), (2, 2.0), (3, 3 * math.pi / 4), (4, 8 / 3), (5, 15 * math.pi / 16), (6, 16 / 5)],
)
def test_the_stretches_of_theory_are_cases(exponent, kappa):
    assert expected(f"power_law_{exponent}", "depth") == pytest.approx(0.3 * kappa, rel=1e-15)
