"""Holds as a study: files of forces over time, made by formulas of the tests, and what `winkler fit` says of them."""

import numpy as np
import pytest
from biot_solution import lai_hu

import winkler as wk
from winkler.cli import main
from winkler.study.language.reading import read_study

SHEAR, DIFFUSIVITY, DEPTH, RADII = 5e3, 1e-9, 1e-4, (0.5e-3, 1e-3)
STUDY = """
title = "Two punches on a gel"
[problem]
kind = "held_contacts"
[[problem.holds]]
kind = "held_force"
profile = { kind = "flat_punch", radius = "0.5 mm" }
depth = "0.1 mm"
file = "hold0.csv"
[[problem.holds]]
kind = "held_force"
profile = { kind = "flat_punch", radius = "1 mm" }
depth = "0.1 mm"
file = "hold1.csv"
"""


def liquid(time, radius):
    """Of a network with Poisson's ratio 0, for which the formula of Lai and Hu was checked."""
    return 0.5 + 0.5 * lai_hu(DIFFUSIVITY * time / radius**2)


def solid(time, radius):
    del radius
    return 0.5 + 0.5 / (1.0 + time / 300.0) ** 0.6


def written(folder, share, study=STUDY, noise=5e-3, seed=1):
    rng, time = np.random.default_rng(seed), np.geomspace(1.0, 2e4, 60)
    for place, radius in enumerate(RADII):
        force = 8.0 * SHEAR * radius * DEPTH * share(time, radius) * (1.0 + noise * rng.standard_normal(time.size))
        rows = (f"{t!r}, {1e3 * f!r}\n" for t, f in zip(time.tolist(), force.tolist(), strict=True))
        (folder / f"hold{place}.csv").write_text("time [s], force [mN]\n" + "".join(rows), encoding="utf-8")
    (folder / "gel.toml").write_text(study, encoding="utf-8")
    return folder / "gel.toml"


def test_holds_of_files_tell_a_liquid_and_give_its_numbers(tmp_path):
    found = read_study(written(tmp_path, liquid)).problem.solve()
    assert found.verdict == "poroelastic"
    assert found.exponent == pytest.approx(2.0, abs=3.0 * found.exponent_error)
    assert found.shear == pytest.approx(SHEAR, rel=0.01)
    assert found.diffusivity == pytest.approx(DIFFUSIVITY, rel=0.05)
    assert found.poisson == pytest.approx(0.0, abs=0.02)
    assert "a viscoelastic body is excluded" in found.validity[0].statement
    assert found.validity[0].standing is wk.Standing.ASYMPTOTIC


def test_a_viscoelastic_body_is_told_and_its_poroelastic_numbers_are_disowned(tmp_path):
    found = read_study(written(tmp_path, solid)).problem.solve()
    assert found.verdict == "viscoelastic"
    assert found.validity[0].standing is wk.Standing.OUTSIDE
    assert "fit the curves with a viscoelastic body" in found.validity[0].statement


@pytest.mark.slow
def test_winkler_fit_takes_the_study(tmp_path, capsys):
    assert main(["fit", str(written(tmp_path, liquid)), "--output", str(tmp_path / "out")]) == 0
    assert "poroelastic: the times grow as the contact area" in " ".join(capsys.readouterr().out.split())
    assert (tmp_path / "out" / "report.html").exists()


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('radius = "1 mm"', 'radius = "0.51 mm"', "nearly the same; give holds at other depths"),
        ('flat_punch", radius = "1 mm', 'paraboloid", curvature_radius = "1 mm', "give holds of one shape"),
        ('file = "hold1.csv"', 'file = "hold2.csv"', "hold2.csv"),
        ('depth = "0.1 mm"\nfile = "hold1.csv"', 'file = "hold1.csv"', "depth"),
    ],
)
def test_studies_that_tell_nothing_are_refused(tmp_path, old, new, sentence):
    study = written(tmp_path, liquid, STUDY.replace(old, new))
    with pytest.raises(wk.InvalidInput, match=sentence):
        read_study(study)
