"""The rolling cases in src/winkler/cases/*.toml, recomputed by mpmath from their own inputs, or with their source."""

from __future__ import annotations

import tomllib
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest
from theory_solutions import REFERENCES

import winkler
from winkler.reference import rolling as closed
from winkler.values.units import to_si

CASES = Path(winkler.__file__).parent / "cases"


def number(raw) -> mp.mpf:
    return mp.mpf(repr(raw) if isinstance(raw, int | float) else repr(to_si(raw, what="a case")))


class Pair:
    """Two like bodies, of a case."""

    def __init__(self, problem: dict) -> None:
        medium = problem.get("medium") or problem["bed"]["medium"]
        assert medium["first"] == medium["second"]
        young, nu = number(medium["first"]["young"]), number(medium["first"]["poisson"])
        self.shear, self.modulus = young / (2 * (1 + nu)), young / (2 * (1 - nu**2))
        self.friction = number(problem["friction"]["coefficient"])
        self.force = number(problem["load"]["force"])
        profile = problem.get("bed", {}).get("profile", {})
        self.ball = mp.cbrt(3 * self.force * number(profile.get("curvature_radius", 0)) / (4 * self.modulus))


def rolling_cubic_law(problem: dict) -> dict:
    """Kalker's c11 and c22 at 0.25 are 4.12 and 3.67."""
    pair = Pair(problem)
    along = mp.mpf("4.12") * number(problem["creepage"]["longitudinal"])
    across = mp.mpf("3.67") * number(problem["creepage"]["lateral"])
    tau = mp.hypot(along, across) * pair.shear * pair.ball**2 / (pair.friction * pair.force)
    force = pair.friction * pair.force * (1 - (1 - tau / 3) ** 3)
    size = mp.hypot(along, across)
    return {
        "longitudinal_force": force * along / size,
        "lateral_force": force * across / size,
        "stick_share": 1 - tau / 3,
    }


def rolling_simplified_circle(problem: dict) -> dict:
    """The strips' forces, summed over the disc."""
    pair, a = Pair(problem), number(problem["footprint"]["longitudinal_semi_axis"])
    tau = (
        mp.mpf("4.12") * number(problem["creepage"]["longitudinal"]) * pair.shear * a**2 / (pair.friction * pair.force)
    )
    w = 3 * mp.pi / 16 * tau
    edge = mp.sqrt(1 - w**2 / 4)
    stuck = mp.quad(lambda y: 2 * (1 - y**2) * w - mp.sqrt(1 - y**2) * w**2 + w**3 / 6, [0, edge])
    slid = mp.quad(lambda y: mp.mpf(4) / 3 * (1 - y**2) ** mp.mpf(1.5), [edge, 1])
    return {"longitudinal_force": pair.friction * pair.force * 4 / mp.pi * (stuck + slid)}


def rolling_shakedown_limit(problem: dict) -> dict:
    pair = Pair(problem)
    w = number(problem["amplitude"]) / pair.ball
    return {"shakedown_force": pair.friction * pair.force * (1 - 3 * w / 2 + w**3 / 2)}


def rolling_start_without_slip(problem: dict) -> dict:
    """Springs that stick gain c11 G s/2 per distance since they entered; those of the beginning since then."""
    solid, a = problem["bed"]["medium"]["first"], number(problem["load"]["radius"])
    gain = mp.mpf("4.12") * number(solid["young"]) / (1 + number(solid["poisson"])) / 4
    gain *= number(problem["creepage"]["longitudinal"])
    places = {2: a, 4: 2 * a, 8: 2 * a}
    return {f"shear_force.{place}": gain * (2 * a * X - X**2 / 2) for place, X in places.items()}


RECOMPUTED = (rolling_cubic_law, rolling_simplified_circle, rolling_shakedown_limit, rolling_start_without_slip)


def case_of(name: str) -> dict:
    return tomllib.loads((CASES / f"{name}.toml").read_text(encoding="utf-8"))


@pytest.mark.parametrize("solve_reference", RECOMPUTED, ids=lambda solve_reference: solve_reference.__name__)
def test_a_case_is_recomputed(solve_reference):
    case = case_of(solve_reference.__name__)
    assert case["grade"] == "analytical"
    with mp.workdps(30):
        found = solve_reference(case["problem"])
    assert set(found) == {expectation["quantity"] for expectation in case["expect"]}
    for expectation in case["expect"]:
        deviation = abs(found[expectation["quantity"]] / mp.mpf(repr(expectation["value"])) - 1)
        assert deviation < 5e-15, (expectation["quantity"], mp.nstr(found[expectation["quantity"]], 20))


@pytest.mark.parametrize(
    ("name", "word", "power", "coefficient"),
    [
        ("rolling_contact_longitudinal", "longitudinal", 1, "4.3181073836784"),
    ],
)
def test_a_slope_is_that_of_its_table(name, word, power, coefficient):
    """F = G (a b)^power c times the creepage, so small that hardly anything slides."""
    case = case_of(name)
    assert case["grade"] == "cross-code"
    pair, ellipse = Pair(case["problem"]), case["problem"]["footprint"]
    area = number(ellipse["longitudinal_semi_axis"]) * number(ellipse["lateral_semi_axis"])
    wanted = pair.shear * area**power * mp.mpf(coefficient) * number(case["problem"]["creepage"][word])
    assert case["expect"][0]["value"] == pytest.approx(float(wanted), rel=1e-12)


def test_every_rolling_case_is_recomputed_or_cited():
    kinds = {"rolling", "simplified_rolling", "rolling_start", "oscillating_rolling"}
    names = {path.stem for path in CASES.glob("*.toml")}
    found = {name for name in names if case_of(name).get("problem", {}).get("kind") in kinds}
    stated = {"rolling_contact_longitudinal"} | {f"kalker_c{n}{of}" for n in (11, 22, 23) for of in ("", "_ellipses")}
    assert found - set(REFERENCES) == {solve_reference.__name__ for solve_reference in RECOMPUTED} | stated


class TestCarter:
    """A cylinder rolls with a creepage: what the tractions strain the surface by is the creepage, where it sticks."""

    @pytest.mark.slow
    @pytest.mark.parametrize(
        "ratio", [0.2, pytest.param(0.6, marks=pytest.mark.slow), pytest.param(0.95, marks=pytest.mark.slow)]
    )
    def test_the_zone_of_stick_is_strained_evenly(self, ratio):
        a, radius, modulus, mu = 1.0, 100.0, 200.0, 0.3
        peak = modulus * a / (2.0 * radius)
        c = float(closed.carter_stick_half_width(a, ratio))
        xi = float(closed.carter_creepage(mu, a, radius, ratio))

        def traction(x):
            return mp.mpf(float(closed.carter_traction(mu * peak, a, c, float(x))))

        # strain difference of two like half-planes under a traction: -(2 / (pi E*)) P.V. integral of tau / (x - s)
        for share in (0.15, 0.5, 0.85):
            x = a - 2.0 * c * share
            near = mp.quad(
                lambda t, x=x: (traction(x + t) - traction(x - t)) / t, [0, min(a - x, x + a) / 2, min(a - x, x + a)]
            )
            low, high = -a, 2.0 * x + a if x < 0.0 else 2.0 * x - a
            rest = (
                mp.quad(lambda s, x=x: traction(s) / (s - x), mp.linspace(2 * x + a, a, 9))
                if x < 0.0
                else mp.quad(lambda s, x=x: traction(s) / (s - x), mp.linspace(low, high, 9))
            )
            strain = 2.0 / (mp.pi * modulus) * (near + rest)
            assert abs(float(strain)) == pytest.approx(xi, rel=2e-3)

    def test_force_is_the_integral_and_inverts(self):
        ratio = np.array([0.1, 0.5, 0.9])
        xi = closed.carter_creepage(0.3, 1e-3, 0.1, ratio)
        np.testing.assert_allclose(closed.carter_force(0.3, 1e-3, 0.1, xi), ratio, rtol=1e-13)
        np.testing.assert_allclose(closed.carter_force(0.3, 1e-3, 0.1, -xi), -ratio, rtol=1e-13)
        assert float(closed.carter_force(0.3, 1e-3, 0.1, 0.1)) == 1.0
        x = np.linspace(-1.0, 1.0, 200_001)
        for part in ratio:
            c = float(closed.carter_stick_half_width(1.0, part))
            whole = np.trapezoid(closed.carter_traction(1.0, 1.0, c, x), x) / (0.5 * np.pi)
            assert whole == pytest.approx(part, abs=1e-6)

    def test_sliding_throughout(self):
        assert float(closed.carter_stick_half_width(1.0, 1.0)) == 0.0
        assert float(closed.carter_traction(1.0, 1.0, 0.0, 0.0)) == 1.0
