"""The cases on graded, coated and measured bodies agree with independent solutions; and these are checked."""

from __future__ import annotations

import tomllib
from pathlib import Path

import elliptic_solution
import graded_solution
import layered_case
import mpmath as mp
import numpy as np
import pytest
from case_solutions import si
from layered_solution import Press, Sheet, Stack, compliance, compliance_exactly, flexibility

import winkler

CASES = {
    path.stem: tomllib.loads(path.read_text(encoding="utf-8"))
    for pattern in ("graded_*", "coated_*", "depth_graded_*", "measured_*")
    for path in sorted((Path(winkler.__file__).parent / "cases").glob(f"{pattern}.toml"))
}
# cases of moduli alone are checked in test_theory_cases
CASES = {
    name: case
    for name, case in CASES.items()
    if case.get("problem", {}).get("kind") == "indentation"
    and not any(one["quantity"].startswith("problem.") for one in case["expect"])
}
GRADED = [name for name in CASES if name.startswith("graded_")]
LAYERED = [name for name in CASES if name.startswith(("coated_", "depth_graded_"))]
SLOW = {
    "coated_substrate_limit",
    "coated_winkler_paraboloid",
    "coated_rubber_film",
    "coated_garcia_film",
    "coated_three_layers",
    "depth_graded_soft_skin",
}
"""Where the independent solution takes more than a second."""


def slowly(names: list[str]) -> list:
    return [pytest.param(name, marks=pytest.mark.slow) if name in SLOW else name for name in names]


def given(expectation: dict) -> np.ndarray:
    return np.atleast_1d(np.array(expectation["value"], dtype=float))


def test_every_case_has_a_reference_solution():
    assert len(GRADED) >= 8
    assert len(LAYERED) >= 16
    assert set(CASES) == {*GRADED, *LAYERED, "measured_elliptic"}


@pytest.mark.parametrize("name", GRADED)
def test_graded(name):
    """Every digit written."""
    case = CASES[name]
    assert case["grade"] == "analytical"
    with mp.workdps(20):
        solution = graded_solution.ReferenceSolution(case["problem"])
        for expectation in case["expect"]:
            assert float(solution.quantity(expectation)) == pytest.approx(expectation["value"], rel=1e-15), expectation


@pytest.mark.parametrize("name", slowly(LAYERED))
def test_layered(name):
    """Solutions to the last digit but two; tables and asymptotic formulas within the tolerance of the case."""
    case = CASES[name]
    solution = layered_case.ReferenceSolution(case["problem"])
    for expectation in case["expect"]:
        tolerance = 5e-11 if case["grade"] == "independent implementation" else expectation["tolerance"]
        np.testing.assert_allclose(solution.quantity(expectation), given(expectation), rtol=tolerance)


def test_measured_elliptic():
    """The points of the table and the values between them: F = C d^(3/2), k = 3 F/(2 d), U = 2 F d/5."""
    case = CASES["measured_elliptic"]
    modulus = mp.mpf(70) * 10**9 / (1 - mp.mpf("0.2") ** 2)
    bed, load = case["problem"]["bed"], case["problem"]["load"]

    def force(depth: mp.mpf) -> mp.mpf:
        return elliptic_solution.force(depth, mp.mpf("40e-3"), mp.mpf("10e-3"), modulus)

    for radius, stiffness, depth in zip(*(bed[word] for word in ("radii", "stiffnesses", "depths")), strict=True):
        steep = 3 * force(si(depth)) / (2 * si(depth))
        number, unit = stiffness.split()
        assert unit == "MN/m"
        assert float(mp.mpf(number) * 10**6 / steep) == pytest.approx(1.0, rel=1e-15)
        assert float(si(radius) * 2 * modulus / steep) == pytest.approx(1.0, rel=1e-15)
    for index, place in enumerate(load["depth"]):
        depth = si(place)
        steep = 3 * force(depth) / (2 * depth)
        true = {
            "force": force(depth),
            "stiffness": steep,
            "radius": steep / (2 * modulus),
            "energy": 2 * force(depth) * depth / 5,
        }
        for expectation in case["expect"]:
            assert given(expectation)[index] == pytest.approx(float(true[expectation["quantity"]]), rel=1e-15)


# ------------------------------------------------------------------------------ the numbers of theory 8.2, as printed


def values(name: str, quantity: str, **where: str) -> np.ndarray:
    found = [
        given(item)
        for item in CASES[name]["expect"]
        if item["quantity"] == quantity and all(item.get(key) == place for key, place in where.items())
    ]
    assert len(found) == 1, (name, quantity, where)
    return found[0]


def lengths(name: str, kind: str) -> np.ndarray:
    given_ = CASES[name]["problem"]["load"][kind]
    return np.array([float(si(item)) for item in (given_ if isinstance(given_, list) else [given_])])


def modulus(name: str) -> float:
    """E* of the uppermost layer."""
    solid = CASES[name]["problem"]["bed"]["medium"]["layers"][0]["solid"]
    return 1.0 / flexibility(float(si(solid["young"])), float(solid["poisson"]))


def assert_printed(found: np.ndarray, printed: str) -> None:
    """Half a unit of the last printed digit, and what the printing itself may have been rounded from."""
    for number, text in zip(found, printed.split(), strict=True):
        assert number == pytest.approx(float(text), rel=0, abs=0.61 * 10.0 ** -len(text.partition(".")[2])), printed


@pytest.mark.parametrize(
    ("name", "printed"),
    [
        ("coated_hard_stiffness", ".680722 .311850 .208799 .156872 .126553"),
        ("coated_soft_stiffness", "1.083543 1.517171 2.135176 3.195387 5.113847"),
        ("coated_cartilage_030", "1.20656 1.47261 1.78475 2.48352"),
        ("coated_cartilage_050", "1.2806 1.6837 2.2129 3.6187"),
    ],
)
def test_stiffnesses_of_theory(name, printed):
    assert_printed(values(name, "stiffness") / (2.0 * modulus(name) * lengths(name, "radius")), printed)


def test_substrate_limit_of_theory():
    name = "coated_substrate_limit"
    relative = values(name, "stiffness") / (2.0 * modulus(name) / 3.0 * lengths(name, "radius"))
    assert_printed(relative, "1.4982 1.0780 1.0214")


@pytest.mark.parametrize(
    ("name", "depth", "force"),
    [
        ("coated_hard_paraboloid", ".55951 2.30283", "8.831005 5.942376"),
        ("coated_soft_paraboloid", ".693461", ".121938"),
        ("coated_half_paraboloid", ".847415", ".549976"),
        ("coated_twice_paraboloid", "1.237564", "1.751246"),
    ],
)
def test_paraboloids_of_theory(name, depth, force):
    """Theory has R = h = 1; here h = 1 um and R = 100 um, E0 = 20 GPa."""
    assert_printed(values(name, "depth") / 1e-8, depth)
    hertz = 4.0 / 3.0 * 20e9 / 0.91 * lengths(name, "radius") ** 3 / 100e-6
    assert_printed(values(name, "force") / hertz, force)


def test_incompressible_film_of_theory():
    name = "coated_rubber_film"
    hertz = 4.0 / 3.0 * modulus(name) * np.sqrt(0.1) * lengths(name, "depth") ** 1.5
    assert_printed(values(name, "force") / hertz, "1.05903 1.12355 1.44003 1.85716 3.37145")


def test_pressure_of_theory():
    """Section 0.3: 9.95 and 8.60 for G of the substrate 1, R = h = a = 1."""
    scale = 20e9 / 2.6 * 1e-2
    found = [values("coated_pressure", "pressure", r=r)[0] / scale for r in ("0 um", "0.6 um")]
    assert_printed(np.array(found), "9.95 8.60")


# ------------------------------------------------------------------------------------- references of the references


@pytest.mark.few(2)
@pytest.mark.parametrize(("k", "nu"), [(0.5, 0.3), (-0.3, 0.3), (0.75, 0.45), (0.3, 0.5), (-0.6, 0.1)])
def test_the_modulus_of_a_power_law_by_elasticity(k, nu):
    """h_N needs no paper: the equations of elasticity in z give the same response to a wave."""
    assert graded_solution.wave_factor_by_elasticity(k, nu) == pytest.approx(
        graded_solution.wave_factor(k, nu), rel=1e-10
    )


def test_the_gap_of_a_power_is_a_beta_function():
    with mp.workdps(20):
        for name in ("graded_cone", "graded_fourth_power"):
            solution = graded_solution.ReferenceSolution(CASES[name]["problem"])
            x = mp.mpf("0.37") * solution.radius
            assert float(solution.gap_by_quadrature(x) / solution.gap(x)) == pytest.approx(1.0, rel=1e-14)


def test_a_compliance_in_closed_form():
    """One layer on a half-space (theory 8.2), and both methods of solving for the waves."""
    stack = Stack((Sheet(10.0, 0.3, 1.0),), (1.0, 0.2))
    xi = np.array([1e-3, 0.05, 0.6, 3.0])
    al, g1, g3 = 10.0 / 1.3 * 1.2, 3 - 4 * 0.3, 3 - 4 * 0.2
    a, b, e = (al * g3 - g1) / (1 + al * g3), (al - 1) / (al + g1), np.exp(-2 * xi)
    closed = (1 + 4 * b * xi * e - a * b * e**2) / (1 - (a + b + 4 * b * xi**2) * e + a * b * e**2)
    np.testing.assert_allclose(compliance(stack, xi) / (2.0 * stack.surface), closed, rtol=1e-11)
    exactly = [compliance_exactly(stack, wave) for wave in xi]
    np.testing.assert_allclose(compliance(stack, xi), exactly, rtol=1e-11)


def test_least_energy_on_a_half_space_is_hertz():
    stack = Stack((Sheet(2.0, 0.3, 1.0),), (2.0, 0.3))
    press = Press(stack, 0.8)
    depth, load = press.closed(lambda x: x**2)
    rigid = 1.0 / stack.surface
    assert depth == pytest.approx(0.64, rel=1e-12)
    assert press.force(load) == pytest.approx(4.0 / 3.0 * rigid * 0.8**3, rel=1e-12)
    assert press.energy(load) == pytest.approx(8.0 / 15.0 * rigid * 0.8**5, rel=1e-12)
    assert press.pressure(load, 0.3) == pytest.approx(2.0 * rigid / np.pi * np.sqrt(0.64 - 0.09), rel=1e-11)
    assert press.displacement(load, 0.3) == pytest.approx(0.64 - 0.045, rel=1e-11)
    outside = ((2 * 0.64 - 2.25) * np.arcsin(0.8 / 1.5) + 0.8 * np.sqrt(2.25 - 0.64)) / np.pi
    assert press.displacement(load, 1.5) == pytest.approx(outside, rel=1e-11)


@pytest.mark.parametrize("poisson", [0.2, pytest.param(0.5, marks=pytest.mark.slow)])
def test_the_function_of_gao_is_the_first_order(poisson):
    """dk/dE of the coating over k of the half-space, by central differences of the independent solution."""
    for radius in (0.5, 3.0):
        soft, hard = (
            Press(Stack((Sheet(1.0 + e, poisson, 1.0),), (1.0, poisson)), radius, terms=24, count=300).stiffness
            for e in (-1e-3, 1e-3)
        )
        x = 1.0 / radius
        first = 2.0 / np.pi * np.arctan(x) + ((1 - 2 * poisson) * x * np.log((1 + x**2) / x**2) - x / (1 + x**2)) / (
            2 * np.pi * (1 - poisson)
        )
        assert (hard - soft) / 2e-3 * flexibility(1.0, poisson) / (2.0 * radius) == pytest.approx(first, abs=3e-7)


def test_a_ball_on_a_round_body_is_a_limit_of_the_elliptic_contact():
    with mp.workdps(30):
        found = elliptic_solution.force(mp.mpf("1e-6"), mp.mpf("1.000001"), mp.mpf(1), mp.mpf(3))
        assert float(found / (4 * mp.mpf("1e-6") ** 1.5)) == pytest.approx(1.0 + 0.25e-6, rel=1e-11)
