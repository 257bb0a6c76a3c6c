"""Studies that examine fits further: calibration, depths, models, shared numbers, folders, and their files."""

from __future__ import annotations

import csv
import dataclasses
import math

import numpy as np
import pytest

from winkler.fitting.fit import fit
from winkler.io.curves import read_curve
from winkler.study.batch.fit_recording import recalled_fits
from winkler.study.batch.fit_run import fit_curves, fit_study, gather_fits, pieces
from winkler.study.batch.journal import Journal
from winkler.study.language.fit_reading import parse_fit_study
from winkler.study.report.examined.sentences import further_sentences
from winkler.study.report.writing import outcome_files, write_files
from winkler.values.errors import InvalidInput

BASE = """
[problem]
kind = "indentation"

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "5 um" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 kPa", poisson = 0.5 } }

[output]
figures = []
report = false

[fit]
curve = "CURVES"
part = "approach"
spring_constant = "0.05 N/m"
MORE

[fit.free]
"problem.bed.medium.first.young" = ["10 Pa", "10 MPa"]
contact_point = true
baseline = true
"""
YOUNG = "problem.bed.medium.first.young"
PATH = "bed.medium.first.young"
CONE = """
[fit.models.cone]
"problem.bed.profile" = { kind = "cone", half_angle = "60 deg" }
"""
STICKY = """
[fit.models.sticky]
"problem.kind" = "adhesive_indentation"
"problem.law" = { kind = "short_range", work = "10 uJ/m^2" }
free = { "problem.bed.medium.first.young" = true, "problem.law.work" = true }
"""


def study(here, more="", curves="*.csv", after=""):
    text = BASE.replace("CURVES", curves).replace("MORE", more) + after
    return parse_fit_study(text, file="gel.toml", folder=here)


def write_curve(path, young, seed, top=1e-6, touch=0.3e-6):
    """F = 4/3 E/(1-nu^2) sqrt(R) d^(3/2), nu = 1/2, R = 5 um, over the travel of the tip, as a table."""
    random, ramp = np.random.default_rng(seed), np.linspace(-1e-6, top, 120)
    force = 4.0 / 3.0 * young / 0.75 * math.sqrt(5e-6) * np.maximum(ramp, 0.0) ** 1.5
    force = force + 5e-12 * random.standard_normal(120)
    rows = (f"{1e9 * d!r}, {1e9 * f!r}\n" for d, f in zip((ramp + touch).tolist(), force.tolist(), strict=True))
    path.parent.mkdir(exist_ok=True)
    path.write_text("depth [nm], force [nN]\n" + "".join(rows), encoding="utf-8")


@pytest.fixture
def here(tmp_path):
    for number in range(4):
        write_curve(tmp_path / f"curve{number}.csv", 4e3, number, top=(0.5 + 0.2 * number) * 1e-6)
    return tmp_path


def rows(path):
    with path.open(encoding="utf-8") as file:
        return list(csv.DictReader(file))


def test_calibration_widens_the_interval(here):
    asked = study(here, 'spring_constant_error = "10 %"\nsensitivity_error = 0.03', "curve3.csv")
    assert (asked.spring_constant_error, asked.sensitivity_error) == (0.1, 0.03)
    outcome = fit_study(asked)
    found = outcome.fitted[0].fit
    plain = fit(
        read_curve(here / "curve3.csv"), asked.problem, free={PATH: (10.0, 1e7), "contact_point": (), "baseline": ()}
    )
    assert found.interval(PATH) == plain.interval(PATH)
    low, high = outcome.intervals(asked.free[0])[0]
    assert np.log(high / found.value(PATH)) > 1.96 * 0.1
    assert np.log(found.value(PATH) / low) > 1.96 * 0.1
    table = {column.name: column.content for column in outcome.table()}
    assert table[f"{YOUNG}_error"][0] == found.error(PATH)
    assert table[f"{YOUNG}_calibration"][0] > 0.1 * found.value(PATH)
    at = found.index(PATH), found.index("contact_point")
    assert table["contact_point_correlation"][0] == found.correlation[at]
    said = list(further_sentences(outcome))
    assert f"young and contact point are correlated by {found.correlation[at]:.2f}." in said


@pytest.mark.slow
def test_depths_are_written(here, tmp_path):
    asked = study(here, "over_depth = 4", "curve3.csv")
    outcome = fit_study(dataclasses.replace(asked, output=dataclasses.replace(asked.output, report=True)))
    (series,) = outcome.fitted[0].further.depths
    assert series.values[-1] == outcome.fitted[0].fit.value(PATH)
    (tmp_path / "out").mkdir()
    write_files(outcome_files(outcome), tmp_path / "out")
    written = rows(tmp_path / "out" / "depths.csv")
    assert [float(row[f"{YOUNG} [Pa]"]) for row in written] == series.values.tolist()
    assert [float(row["depth [m]"]) for row in written] == series.depths.tolist()
    assert "young over depth: constant" in (tmp_path / "out" / "report.html").read_text(encoding="utf-8")


@pytest.mark.slow
def test_models_are_compared(here, tmp_path):
    asked = study(here, 'model = "ball"', "curve[23].csv", CONE + STICKY)
    assert [one.name for one in asked.models] == ["cone", "sticky"]
    assert [free.path for free in asked.models[1].free] == ["contact_point", "baseline", PATH, "law.work"]
    outcome = fit_study(asked)
    table = {column.name: column.content.tolist() for column in outcome.table()}
    assert all("cone" not in possible for possible in table["models"])
    assert all("ball" in possible for possible in table["models"])
    assert min(table["aic_cone"]) > 10.0
    (tmp_path / "out").mkdir()
    write_files(outcome_files(outcome), tmp_path / "out")
    written = rows(tmp_path / "out" / "models.csv")
    assert {row["model"]: row["possible [-]"] for row in written if row["curve"] == "curve3.csv"}["cone"] == "0.0"
    assert "Model 'cone': distinguished from all others in 0, possible in 0 of 2 curves." in list(
        further_sentences(outcome)
    )


def test_a_comparison_goes_on_beside_a_curve_without_contact(here):
    noise = 1e-3 * np.random.default_rng(3).standard_normal(200)
    lines = [f"{z},{force}" for z, force in zip(np.linspace(0.0, 2000.0, 200), noise, strict=True)]
    (here / "curve31.csv").write_text("\n".join(["piezo [nm],force [nN]", *lines, ""]), encoding="utf-8")
    outcome = fit_study(study(here, 'model = "ball"', "curve[23]*.csv", CONE))
    assert [one.name for one in outcome.refused] == ["curve31.csv"]
    said = list(further_sentences(outcome))
    assert "Model 'cone': distinguished from all others in 0, possible in 0 of 3 curves, not fitted in 1." in said
    assert "Not compared, as no model could be fitted: curve31.csv (no_contact)." in said


@pytest.mark.slow
def test_shared_numbers_are_those_of_all_curves(here, tmp_path):
    outcome = fit_study(study(here, f'shared = ["{YOUNG}"]'))
    (joint,) = outcome.joint
    low, high = joint.interval(PATH)
    assert low < 4e3 < high
    assert joint.error(PATH) < outcome.errors(outcome.study.free[0]).min()
    (tmp_path / "out").mkdir()
    write_files(outcome_files(outcome), tmp_path / "out")
    written = rows(tmp_path / "out" / "shared.csv")
    assert len(written) == 4
    assert {float(row[f"{YOUNG} [Pa]"]) for row in written} == {joint.value(PATH)}
    assert sum(float(row[f"{YOUNG}_share [-]"]) for row in written) == pytest.approx(1.0)


def test_one_curve_shares_nothing_and_says_so(here):
    outcome = fit_study(study(here, f'shared = ["{YOUNG}"]', "curve1.csv"))
    assert outcome.joint == ()
    assert "1 curve cannot share numbers" in outcome.joint_failure
    assert any("not fitted together" in sentence for sentence in further_sentences(outcome))


def test_a_curve_whose_error_would_decide_the_mean_is_named(here):
    """A thousandth of its error would give the first curve all of the weight; a fifth, four fifths of it."""
    write_curve(here / "curve4.csv", 4e3, 4)
    outcome = fit_study(study(here))
    place = outcome.fitted[0].fit.index(PATH)
    usual, middle = np.median([[one.fit.error(PATH), one.fit.value(PATH)] for one in outcome.fitted], axis=0)

    def said(share):
        first = outcome.fitted[0]
        errors, values = first.fit.standard_errors.copy(), first.fit.values.copy()
        errors[place], values[place] = share * usual, middle
        changed = dataclasses.replace(first.fit, standard_errors=errors, values=values)
        changed = dataclasses.replace(first, fit=changed)
        return list(further_sentences(dataclasses.replace(outcome, results=(changed, *outcome.results[1:]))))

    doubt = (
        "The error of young is less than a tenth of the others', or unknown. It was replaced by theirs, since it would "
        "decide the mean: curve0.csv."
    )
    assert doubt in said(1e-3)
    assert doubt not in said(0.2)
    assert any(one.startswith("curve0.csv alone has ") and one.endswith(" in the mean of young.") for one in said(0.2))
    assert not any("curve0.csv" in one for one in said(1.0))


@pytest.mark.slow
def test_mean_and_folders(tmp_path):
    for number in range(4):
        scatter = math.exp(0.05 * math.sin(9.0 * number))
        write_curve(tmp_path / "control" / f"a{number}.csv", 4e3 * scatter, number)
        write_curve(tmp_path / "treated" / f"b{number}.csv", 2e3 * scatter, 10 + number)
    outcome = fit_study(study(tmp_path, 'spring_constant_error = "10 %"', "*/*.csv"))
    said = " ".join(further_sentences(outcome))
    assert "Mean of young over 8 curves" in said
    assert "with 10.0% by the calibration" in said
    assert "young in treated over that in control: 0.5 " in said
    assert "they differ" in said


@pytest.mark.slow
def test_an_interrupted_batch_goes_on_with_all_that_was_examined(here, tmp_path):
    asked = study(here, 'over_depth = 3\nspring_constant_error = "5 %"', "*.csv", CONE)
    todo, path = pieces(asked), tmp_path / "x.journal"
    whole = gather_fits(asked, fit_curves(asked, todo), started=0.0)
    with Journal(path, asked) as journal:
        stream = fit_curves(asked, todo, journal=journal)
        next(stream), next(stream)
    with Journal(path, asked) as journal:
        known = recalled_fits(asked, todo, journal)
        again = gather_fits(asked, fit_curves(asked, todo, known, journal=journal), started=0.0)
    assert len(known) == 2
    for column, other in zip(whole.table(), again.table(), strict=True):
        assert repr(column.content.tolist()) == repr(other.content.tolist())
    assert repr(whole.results) == repr(again.results)
    with pytest.raises(InvalidInput, match="--anew"), Journal(path, dataclasses.replace(asked, over_depth=4)):
        pass


@pytest.mark.parametrize(
    ("more", "after", "says"),
    [
        ('spring_constant_error = "0.004 N/m"', "", "give the standard error as a part"),
        ("spring_constant_error = 2", "", "give the standard error as a part"),
        ("over_depth = 1", "", "whole number of depths"),
        ('shared = "young"', "", "give a list of free numbers"),
        ('shared = ["problem.bed.medium.first.yung"]', "", "is not free"),
        ('spring_constant_by = "thermal"', "", "only matters with sensitivity_error"),
        ("over_dept = 5", "", "over_depth"),
        ('model = "cone"', CONE, "the name of the problem itself"),
        ("", '[fit.models.cone]\n"bed.profile" = 1', "no key of the problem"),
        ("", "[fit.models.cone]", "nothing is changed"),
        ("", '[fit.models.cone]\n"problem.bed.profil.kind" = "cone"', "leads nowhere"),
        ("", '[fit.models.cone]\n"problem.bed.profile" = { kind = "cone", half_angle = "60 N" }', "fit.models.cone: "),
        ("", '[fit.models.film]\nfree = { "problem.bed.medium.layers.0.solid.young" = true }', "fit.models.film: "),
    ],
)
def test_mistakes_are_named(here, more, after, says):
    with pytest.raises(InvalidInput, match=says):
        study(here, more, after=after)


def test_depths_need_a_body_without_a_history(here):
    text = BASE.replace("CURVES", "*.csv").replace("MORE", "over_depth = 4")
    text = text.replace('kind = "indentation"', 'kind = "viscoelastic_indentation"')
    text = text.replace(
        'medium = { kind = "half_space", first = { kind = "elastic", young = "1 kPa", poisson = 0.5 } }',
        'medium = { kind = "viscoelastic_half_space", first = { kind = "prony", relaxed_shear = "1 kPa", '
        'shears = ["1 kPa"], relaxation_times = ["1 s"] } }',
    ).replace("first.young", "first.relaxed_shear")
    with pytest.raises(InvalidInput, match="the body relaxes"):
        parse_fit_study(text, file="gel.toml", folder=here)
