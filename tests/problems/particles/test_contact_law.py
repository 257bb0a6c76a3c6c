"""Contact laws as tables: the force between the rows, against closed forms, and the files against an own reader."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from scipy.interpolate import CubicHermiteSpline

import winkler as wk
from winkler.cli import main

STEEL = wk.Elastic(210e9, 0.3)
MEDIUM = wk.HalfSpace.between(STEEL, wk.Elastic(70e9, 0.33))
E_STAR, G_STAR = MEDIUM.modulus, MEDIUM.shear_modulus
RADIUS, ANGLE, FLAT = 10e-3, math.radians(70.0), 1e-3
FORCES = {
    "paraboloid": (wk.Paraboloid(RADIUS), lambda d: 4.0 / 3.0 * E_STAR * math.sqrt(RADIUS) * d**1.5),
    "cone": (wk.Cone(ANGLE), lambda d: 2.0 * E_STAR * math.tan(ANGLE) * d**2 / math.pi),
    "flat punch": (wk.FlatPunch(FLAT), lambda d: 2.0 * E_STAR * FLAT * d),
    "quartic": (wk.PowerLaw(1e6, 4.0), lambda d: 8.0 / 5.0 * E_STAR * d * (3.0 * d / 8e6) ** 0.25),
}
"""Hertz 1882, Love 1939, Boussinesq 1885, Galin 1946."""
DEEPEST = 5e-6
PLACES = np.linspace(0.0, DEEPEST, 20_001)


def law_of(name, tolerance=1e-6):
    return wk.ContactLaw(wk.Foundation(FORCES[name][0], MEDIUM), DEEPEST, tolerance).solve()


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-8])
@pytest.mark.parametrize("name", FORCES)
def test_the_cubic_keeps_the_tolerance_everywhere(name, tolerance):
    law = law_of(name, tolerance)
    true = FORCES[name][1](PLACES)
    result = CubicHermiteSpline(law.depth, law.force, law.stiffness)(PLACES)
    assert np.max(np.abs(result - true)) <= tolerance * true[-1]
    assert law.hermite_error <= tolerance


@pytest.mark.parametrize("name", FORCES)
def test_straight_lines_keep_their_bound(name):
    law = law_of(name, 1e-4)
    true = FORCES[name][1](PLACES)
    error = np.max(np.abs(np.interp(PLACES, law.depth, law.force) - true)) / true[-1]
    assert error <= law.linear_error + 1e-15
    assert law.linear_error <= 4.0 * error + 1e-12  # a bound that is not trivial


def test_rows_of_a_ball():
    law = law_of("paraboloid")
    assert law.depth[0] == law.force[0] == law.radius[0] == law.energy[0] == 0.0
    np.testing.assert_allclose(law.radius, np.sqrt(RADIUS * law.depth), rtol=1e-12)
    np.testing.assert_allclose(law.stiffness, 2.0 * E_STAR * law.radius, rtol=1e-12)
    np.testing.assert_allclose(law.shear_stiffness, 2.0 * G_STAR * law.radius, rtol=1e-12)
    np.testing.assert_allclose(law.energy, 0.4 * law.force * law.depth, rtol=1e-11)
    assert law.validity


def test_a_flat_end_is_stiff_from_the_first_touch():
    law = law_of("flat punch")
    assert law.depth.size == 9
    assert law.linear_error == 0.0
    np.testing.assert_allclose(law.stiffness, 2.0 * E_STAR * FLAT, rtol=1e-14)


@pytest.mark.slow
def test_where_no_single_number_gives_the_shear_stiffness():
    film = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(450e9, 0.1), 50e-6)], on=STEEL)
    with pytest.raises(wk.OutsideValidity, match="ContactLaw: the springs' tangential stiffness is between"):
        wk.ContactLaw(wk.Foundation(wk.Sphere(RADIUS), film), 5e-6, 1e-2).solve()


@pytest.mark.parametrize("change", [{"deepest": 0.0}, {"deepest": -1.0}, {"tolerance": 0.0}, {"tolerance": 0.5}])
def test_what_is_no_law(change):
    with pytest.raises(wk.InvalidInput, match=next(iter(change))):
        wk.ContactLaw(**{"bed": wk.Foundation(wk.Sphere(RADIUS), MEDIUM), "deepest": DEEPEST, **change})


def test_a_table_is_read_back(tmp_path):
    law = law_of("paraboloid", 1e-4)
    wk.write_law(law, tmp_path / "ball.csv")
    wk.write_law(law, tmp_path / "ball.json")
    text = (tmp_path / "ball.csv").read_text(encoding="utf-8")
    rows = np.array([line.split(",") for line in text.splitlines() if not line.startswith("#")])
    heads, numbers = rows[0], rows[1:].astype(float)
    assert heads.tolist() == [
        "depth [m]", "force [N]", "radius [m]", "stiffness [N/m]", "shear_stiffness [N/m]", "energy [J]"
    ]  # fmt: skip
    content = json.loads((tmp_path / "ball.json").read_text(encoding="utf-8"), parse_constant=pytest.fail)
    for place, name in enumerate(("depth", "force", "radius", "stiffness", "shear_stiffness", "energy")):
        np.testing.assert_array_equal(numbers[:, place], getattr(law, name))
        assert content["columns"][name]["values"] == getattr(law, name).tolist()
    assert content["hermite_error"] == law.hermite_error
    assert any("One curve for loading and unloading" in sentence for sentence in content["conventions"])


def test_what_cannot_be_written(tmp_path):
    law = law_of("cone")
    for given, path, sentence in (
        (law, "law.txt", "give .csv or .json"),
        (law, tmp_path / "none" / "law.csv", "cannot be written"),
        (law.problem, "law.csv", "is no contact law"),
    ):
        with pytest.raises(wk.InvalidInput, match=sentence):
            wk.write_law(given, path)


def test_the_command_line_writes_the_table_of_a_study(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["new", "indentation", "--output", "ball.toml"]) == 0
    assert main(["table", "ball.toml", "--output", "ball.csv", "--tolerance", "1e-4"]) == 0
    assert "rows written to ball.csv" in capsys.readouterr().out
    assert (tmp_path / "ball.csv").read_text(encoding="utf-8").startswith("# SI units")
    assert main(["table", "ball.toml", "--output", "ball.csv"]) == 2
    assert "add --overwrite" in capsys.readouterr().err
