"""The conduction cases in src/winkler/cases/*.toml, recomputed by mpmath, and the closed forms."""

from __future__ import annotations

import tomllib
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest

import winkler
import winkler as wk
from winkler.numerics.fields.flux_tube import relief
from winkler.reference import conduction
from winkler.values.units import to_si

CASES = Path(winkler.__file__).parent / "cases"


def number(raw) -> mp.mpf:
    return mp.mpf(raw if isinstance(raw, int | float) else repr(to_si(raw, what="a case")))


def modulus(problem: dict) -> mp.mpf:
    medium = problem["bed"]["medium"]
    solids = [medium[which] for which in ("first", "second") if which in medium]
    return 1 / sum((1 - number(solid["poisson"]) ** 2) / number(solid["young"]) for solid in solids)


def holm_silver_ball(problem: dict) -> dict:
    contact = problem["contact"]
    curvature, force = number(contact["bed"]["profile"]["curvature_radius"]), number(contact["load"]["force"])
    radius = mp.cbrt(3 * force * curvature / (4 * modulus(contact)))
    rho = sum(number(problem["conductors"][which]["resistivity"]) for which in ("first", "second"))
    return {"radius": radius, "resistance": rho / (4 * radius), "conductance": 4 * radius / rho}


def kohlrausch_metal(problem: dict) -> dict:
    ambient, lorenz = number(problem["temperature"]), number(problem["law"]["lorenz_number"])
    voltage, radius = number(problem["drive"]["voltage"]), number(problem["contact"]["load"]["radius"])
    v = voltage / (2 * mp.sqrt(lorenz) * ambient)
    resistance = number(problem["conductors"]["first"]["resistivity"]) / (2 * radius) * v / mp.atan(v)
    assert number(problem["conductors"]["first"]["temperature_coefficient"]) * ambient == pytest.approx(1.0, rel=1e-15)
    hottest = mp.sqrt(ambient**2 + voltage**2 / (4 * lorenz))
    return {"max_temperature": hottest, "resistance": resistance, "current": voltage / resistance}


def greenwood_two_spots(problem: dict) -> dict:
    a, b = map(number, problem["radii"])
    apart = number(problem["x"][1]) - number(problem["x"][0])
    rho = number(problem["first"]["resistivity"]) + number(problem["second"]["resistivity"])
    alone = rho / (4 * (a + b))
    return {"alone": alone, "greenwood": alone + rho / mp.pi * a * b / apart / (a + b) ** 2}


def barber_bounds(problem: dict) -> dict:
    """F = 4/3 E* (R D^3)^(1/2): the tangents through the point of the offset curve."""
    star, rough, force = modulus(problem), number(problem["roughness"]), number(problem["force"])
    depth = (3 * force / (4 * star)) ** (mp.mpf(2) / 3)

    def chord(D):
        return 2 * star * mp.sqrt(D) * (depth + rough - D) - (force - mp.mpf(4) / 3 * star * D ** mp.mpf(1.5))

    roots = [mp.findroot(chord, start * depth) for start in (0.4, 2.0)]
    names = ("least_stiffness", "smooth_stiffness", "greatest_stiffness")
    return dict(zip(names, (2 * star * mp.sqrt(D) for D in (roots[0], depth, roots[1])), strict=True))


def disc_heat(problem: dict) -> dict:
    first, second = (number(problem["conductors"][which]["conductivity"]) for which in ("first", "second"))
    drop = number(problem["temperature_drop"])
    rate = 4 * number(problem["contact"]["load"]["radius"]) * drop / (1 / first + 1 / second)
    return {"heat_rate": rate, "first_drop": drop * second / (first + second)}


@pytest.mark.parametrize(
    "solve_reference",
    [holm_silver_ball, kohlrausch_metal, greenwood_two_spots, barber_bounds, disc_heat],
    ids=lambda f: f.__name__,
)
def test_a_case_is_recomputed(solve_reference):
    case = tomllib.loads((CASES / f"{solve_reference.__name__}.toml").read_text(encoding="utf-8"))
    with mp.workdps(30):
        expected = solve_reference(case["problem"])
        assert {item["quantity"] for item in case["expect"]} == set(expected)
        for item in case["expect"]:
            assert abs(mp.mpf(item["value"]) / expected[item["quantity"]] - 1) < 1e-14, item["quantity"]


def test_closed_forms_at_their_limits():
    """Discs of one point alone, of equal axes, in a wide rod, under a small voltage."""
    pair = {"first": 1.0, "second": 3.0}
    assert conduction.elliptic_resistance(1.0, 1.0, **pair) == conduction.holm_resistance(1.0, **pair)
    narrow = conduction.elliptic_resistance(4.0, 0.25, **pair)
    assert narrow < conduction.holm_resistance(1.0, **pair)
    one = conduction.greenwood_resistance(np.zeros(1), np.zeros(1), np.array([0.5]), **pair)
    assert one == conduction.holm_resistance(0.5, **pair)
    ratio = np.linspace(0.0, 0.2, 21)
    assert [conduction.roess_factor(float(one)) for one in ratio] == pytest.approx(list(relief(ratio)), abs=5e-4)
    small = conduction.small_voltage_rise(1e-3, conductivity=2.44e-8 * 300.0 / 16e-9, resistivity=16e-9)
    exact = conduction.kohlrausch_temperature(1e-3, ambient=300.0, lorenz_number=2.44e-8) - 300.0
    assert small == pytest.approx(exact, rel=1e-4)
    assert conduction.heated_growth(0.0, ambient=300.0, lorenz_number=2.44e-8) == 1.0


def test_the_package_meets_the_closed_forms_of_many_spots():
    rng = np.random.default_rng(5)
    place = np.stack(np.meshgrid(np.arange(4.0), np.arange(4.0)), -1).reshape(-1, 2) + rng.uniform(-0.2, 0.2, (16, 2))
    radii = rng.uniform(0.05, 0.2, 16)
    metals = wk.ElectricalConductor(2.0), wk.ElectricalConductor(0.5)
    cluster = wk.SpotCluster(place[:, 0], place[:, 1], radii, *metals).solve()
    expected = conduction.greenwood_resistance(place[:, 0], place[:, 1], radii, first=2.0, second=0.5)
    assert cluster.greenwood == pytest.approx(expected, rel=1e-13)
    assert cluster.resistance == pytest.approx(expected, rel=0.03)
