"""Studies with [fit]: what they say, what they refuse, and that their numbers are those of the truth and of fit()."""

from __future__ import annotations

import csv
import math
import re
from pathlib import Path

import numpy as np
import pytest

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit
from winkler.io.curves import PlacedCurve, read_curve
from winkler.plot.fitting.fits import Grid, grid_of
from winkler.study.batch.fit_outcome import Fitted, Refused
from winkler.study.batch.fit_run import fit_curves, fit_study, gather_fits, measured_curve
from winkler.study.language.correcting import CORRECTIONS
from winkler.study.language.fit_reading import parse_fit_study, read_fit_study
from winkler.study.language.reading import parse_study
from winkler.study.report.fit_writing import dataset, map_grid
from winkler.study.report.writing import outcome_files, write_files
from winkler.values.errors import InvalidInput

STUDY = """
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
curve = "curve.csv"
part = "approach"

[fit.free]
"problem.bed.medium.first.young" = ["10 Pa", "10 MPa"]
contact_point = true
baseline = true
"""
YOUNG = "problem.bed.medium.first.young"


def hertz(depth, young):
    """F = 4/3 E/(1-nu^2) sqrt(R) d^(3/2), nu = 1/2, R = 5 um."""
    return 4.0 / 3.0 * young / 0.75 * math.sqrt(5e-6) * np.maximum(depth, 0.0) ** 1.5


def curve_of(young, seed, touch=0.3e-6):
    random = np.random.default_rng(seed)
    ramp = np.linspace(-1e-6, 1e-6, 120)
    return ForceCurve(ramp + touch, hertz(ramp, young) + 5e-12 * random.standard_normal(ramp.size), name=f"seed {seed}")


def table_of(curve) -> str:
    rows = (f"{1e9 * d!r}, {1e9 * f!r}\n" for d, f in zip(curve.position.tolist(), curve.force.tolist(), strict=True))
    return "depth [nm], force [nN]\n" + "".join(rows)


@pytest.fixture
def here(tmp_path) -> Path:
    (tmp_path / "curve.csv").write_text(table_of(curve_of(4e3, 1)), encoding="utf-8")
    return tmp_path


def test_the_numbers_are_those_of_fit_and_of_the_truth(here):
    outcome = fit_study(parse_fit_study(STUDY, file="gel.toml", folder=here))
    (result,) = outcome.fitted
    bed = wk.Foundation(wk.Paraboloid(5e-6), wk.HalfSpace.between(wk.Elastic(1e3, 0.5)))
    names = {"bed.medium.first.young": (10.0, 1e7), "contact_point": (), "baseline": ()}
    direct = fit(read_curve(here / "curve.csv"), wk.Indentation(bed, wk.Depth(0.0)), free=names)
    assert result.fit.values.tolist() == direct.values.tolist()
    for path, truth in (("bed.medium.first.young", 4e3), ("contact_point", 0.3e-6), ("baseline", 0.0)):
        assert abs(direct.value(path) - truth) < 4.0 * direct.error(path)
    columns = {column.name: column for column in outcome.table()}
    assert columns[YOUNG].word.unit == "Pa"
    low, high = columns[f"{YOUNG}_low"].content[0], columns[f"{YOUNG}_high"].content[0]
    assert low < columns[YOUNG].content[0] < high
    assert (low, high) == direct.interval("bed.medium.first.young", 0.95)


def test_the_load_of_the_model_does_not_matter(here):
    loaded = STUDY.replace('kind = "indentation"', 'kind = "indentation"\nload = { kind = "force", force = "3 N" }', 1)
    plain = parse_fit_study(STUDY, file="gel.toml", folder=here)
    assert parse_fit_study(loaded, file="gel.toml", folder=here).problem == plain.problem


@pytest.mark.parametrize(
    ("before", "after", "why"),
    [
        ('curve = "curve.csv"', 'curve = "curv.csv"', "did you mean 'curve.csv'"),
        ('curve = "curve.csv"', 'curve = "*.txt"', "no file fits the pattern '*.txt'"),
        ('part = "approach"', 'part = "aproach"', "did you mean 'approach'"),
        ('part = "approach"', 'part = "approach"\nspring_konstant = "1 N/m"', "did you mean 'spring_constant'"),
        ('part = "approach"', 'part = "approach"\nspring_constant = "-1 N/m"', "it must be positive"),
        ('part = "approach"', 'part = "approach"\nnoise = "10 pm"', "fit.noise"),
        ('part = "approach"', 'part = "approach"\ncorrect = ["basline"]', "did you mean 'baseline'"),
        ("first.young", "fist.young", "did you mean 'first'"),
        (
            '"problem.bed.medium.first.young"',
            "problem.bed.medium.first.young",
            "'problem.' and stands in quotes",
        ),
        ("first.young", "first.youngs", "did you mean 'young'"),
        ("first.young", "first", "is no finite number"),
        ('"10 Pa", "10 MPa"', '"10 Pa", "10 mm"', 'first.young"[1]'),
        ('"10 Pa", "10 MPa"', '"10 MPa", "10 Pa"', "is not below the upper one"),
        ('["10 Pa", "10 MPa"]', "false", "leave out what is not fitted"),
        ("contact_point", "contact_pint", "did you mean 'contact_point'"),
        ('kind = "indentation"', 'kind = "pull_off"', "no curve can be fitted to"),
        ("[fit]", "[fields]\nr = ['1 a']\n[fit]", "a study with [fit] has no fields"),
    ],
)
def test_mistakes_get_one_sentence(here, before, after, why):
    assert before in STUDY
    with pytest.raises(InvalidInput) as message:
        parse_fit_study(STUDY.replace(before, after, 1), file="gel.toml", folder=here)
    assert why in str(message.value)
    assert str(message.value).startswith("gel.toml: ")
    assert "\n" not in str(message.value)


def test_run_sends_to_fit_and_fit_to_run(here):
    with pytest.raises(InvalidInput, match=r"`winkler fit gels/gel\.toml` fits it"):
        parse_study(STUDY, file="gel.toml", folder=Path("gels"))
    with pytest.raises(InvalidInput, match=r"no section \[fit\]"):
        parse_fit_study(STUDY.partition("[fit]")[0], file="gel.toml", folder=here)


def test_units_of_a_number_that_depends_on_another(here):
    profile = '{ kind = "power_law", coefficient = "1e15 m^-3", exponent = 4.0 }'
    text = STUDY.replace('{ kind = "paraboloid", curvature_radius = "5 um" }', profile)
    text = text.replace("[fit.free]", '[fit.free]\n"problem.bed.profile.coefficient" = "2e-3 nm^-3"')
    study = parse_fit_study(text, file="gel.toml", folder=here)
    assert study.free[0].given == pytest.approx((2e24,), rel=1e-12)
    assert study.word("problem.bed.profile.coefficient").unit == "m^-3"


def test_a_layer_is_named_by_its_number_in_both_forms(here):
    medium = (
        'medium = { kind = "coated_half_space", on = { kind = "rigid" }, layers = [{ kind = "layer", thickness = '
        '"3 um", solid = { kind = "elastic", young = "1 kPa", poisson = 0.4 } }] }'
    )
    start = STUDY.index("medium = {")
    text = STUDY[:start] + medium + STUDY[STUDY.index("\n", start) :]
    for written in ("layers.0.solid", "layers[0].solid"):
        study = parse_fit_study(text.replace("first", written), file="gel.toml", folder=here)
        assert study.free[0].path == "bed.medium.layers[0].solid.young"
        assert study.free[0].key == "problem.bed.medium.layers.0.solid.young"


def test_a_batch_survives_what_cannot_be_fitted(here):
    for number, young in ((2, 3e3), (10, 5e3)):
        (here / f"gel{number}.csv").write_text(table_of(curve_of(young, number)), encoding="utf-8")
    flat = ForceCurve(np.linspace(0.0, 1e-6, 60), 1e-12 * np.sin(np.arange(60.0) ** 2))
    (here / "gel5.csv").write_text(table_of(flat), encoding="utf-8")
    (here / "gel7.csv").write_text("nothing\n", encoding="utf-8")
    outcome = fit_study(parse_fit_study(STUDY.replace("curve.csv", "gel*.csv"), file="gel.toml", folder=here))
    assert [result.name for result in outcome.results] == ["gel2.csv", "gel5.csv", "gel7.csv", "gel10.csv"]
    assert [type(result) for result in outcome.results] == [Fitted, Refused, Refused, Fitted]
    assert "no_contact" in outcome.refused[0].reason
    assert "there is no table of a force curve" in outcome.refused[1].reason
    numbers = outcome.numbers(outcome.study.free[0])
    assert np.allclose(numbers[[0, 3]], [3e3, 5e3], rtol=0.02)
    folder = here / "out"
    folder.mkdir()
    write_files(outcome_files(outcome), folder)
    rows = list(csv.DictReader((folder / "fit.csv").open(encoding="utf-8")))
    assert [float(row[f"{YOUNG} [Pa]"] or "nan") for row in rows] == pytest.approx(numbers.tolist(), nan_ok=True)
    assert rows[1]["failure"] == outcome.refused[0].reason
    assert sorted(path.name for path in (folder / "curves").iterdir()) == ["gel10.csv", "gel2.csv"]
    data = dataset(outcome)
    assert data["residual"].attrs["units"] == "N"
    assert np.allclose(data["force"] - data["fitted_force"], data["residual"], equal_nan=True)
    assert not np.isfinite(data["force"][1]).any()


def test_no_answer_at_all_is_the_error_of_the_first(here):
    (here / "curve.csv").write_text("nothing\n", encoding="utf-8")
    with pytest.raises(InvalidInput, match=r"curve\.csv: there is no table of a force curve"):
        fit_study(parse_fit_study(STUDY, file="gel.toml", folder=here))


def test_corrections_are_made_in_their_order_and_stated(here):
    ramp = np.linspace(-1e-6, 1e-6, 200)
    there_and_back = np.concatenate([ramp, ramp[::-1]])
    drag, tilt = 0.4e-9, 2e-5
    direction = np.repeat([1.0, -1.0], ramp.size)
    force = hertz(there_and_back, 4e3) + drag * direction + tilt * there_and_back + 0.1e-9
    force = force + 5e-12 * np.random.default_rng(4).standard_normal(force.size)
    (here / "curve.csv").write_text(table_of(ForceCurve(there_and_back, force)), encoding="utf-8")
    changed = STUDY.replace('part = "approach"', 'part = "both"\ncorrect = ["drag", "baseline"]')
    (result,) = fit_study(parse_fit_study(changed, file="gel.toml", folder=here)).fitted
    assert [step.partition(":")[0] for step in result.steps] == ["drag", "baseline"]
    assert result.fit.value("bed.medium.first.young") == pytest.approx(4e3, rel=0.005)


def held_and_back():
    """Return a curve of 60 points in, 40 held, and 60 out, with times, in which the hold is plain."""
    ramp = np.concatenate([np.linspace(-1e-6, 1e-6, 60), np.full(40, 1e-6), np.linspace(1e-6, -1e-6, 61)[1:]])
    rows = (
        f"{1e9 * d!r}, {1e9 * f!r}, {0.1 * k!r}\n" for k, (d, f) in enumerate(zip(ramp, hertz(ramp, 4e3), strict=True))
    )
    return "depth [nm], force [nN], time [s]\n" + "".join(
        row.replace("np.float64(", "").replace(")", "") for row in rows
    )


@pytest.mark.parametrize(
    ("segments", "fitted"),
    [
        ("", 60),
        ('segments = "found"', 60),
        ('segments = ["loading 0", "hold 50", "unloading 100"]', 50),
        ('segments = ["loading 0 s", "hold 5.5 s", "last unloading 10 s"]', 55),
    ],
)
def test_segments_are_found_or_stated(here, segments, fitted):
    (here / "curve.csv").write_text(held_and_back(), encoding="utf-8")
    changed = STUDY.replace('part = "approach"', f'part = "approach"\n{segments}').replace("baseline = true\n", "")
    (result,) = fit_study(parse_fit_study(changed, file="gel.toml", folder=here)).fitted
    assert result.fit.curve.count == pytest.approx(fitted, abs=1)
    assert result.steps[0].startswith(
        f"segments: by the numbers of their points, loading (0 to {result.fit.curve.count - 1})"
    )


@pytest.mark.parametrize(
    ("segments", "sentence"),
    [
        ("3", "fit.segments is 3; give 'found', or a list of kinds with their beginnings"),
        ("[]", "fit.segments is \\[\\]; give 'found'"),
        ('["loading"]', "fit.segments holds 'loading', which has no beginning"),
        ('["loading 0", "holding 30"]', "line 1 is a 'holding' .*; give loading, hold or unloading"),
        ('["loading 0", "hold 500"]', "line 1 begins at the point 500; .* below 120"),
        ('["loading 0", "hold 3 s"]', "fit.segments: 'hold 3 s' is a time, and the curve has none"),
        ('["loading 0", "hold 3 N"]', "fit.segments, 'hold 3 N': .* give a time such as '2 ms'"),
    ],
)
def test_segments_that_are_refused(here, segments, sentence):
    changed = STUDY.replace('part = "approach"', f'part = "approach"\nsegments = {segments}')
    with pytest.raises(InvalidInput, match=sentence):
        fit_study(parse_fit_study(changed, file="gel.toml", folder=here))


def test_a_compliant_frame(here):
    stiffness = 0.05
    curve = curve_of(4e3, 6)
    bent = ForceCurve(curve.position + hertz(curve.position - 0.3e-6, 4e3) / stiffness, curve.force)
    (here / "curve.csv").write_text(table_of(bent), encoding="utf-8")
    changed = STUDY.replace('part = "approach"', 'part = "approach"\nframe_stiffness = "0.05 N/m"')
    (result,) = fit_study(parse_fit_study(changed, file="gel.toml", folder=here)).fitted
    assert abs(result.fit.value("bed.medium.first.young") - 4e3) < 4.0 * result.fit.error("bed.medium.first.young")


def test_a_force_map_is_laid_on_its_grid(here):
    study = parse_fit_study(STUDY, file="gel.toml", folder=here)
    truth = np.array([[3e3, 4e3, 5e3], [6e3, 7e3, 8e3]])
    todo = [
        PlacedCurve(curve_of(truth[row, column], 10 * row + column), 1e-3 + 2e-6 * column, 3e-6 * row)
        for column in (2, 0, 1)
        for row in (1, 0)
    ]
    outcome = gather_fits(study, fit_curves(study, todo), started=0.0)
    grid = map_grid(outcome)
    assert isinstance(grid, Grid)
    assert np.allclose(grid.arranged(outcome.numbers(study.free[0])), truth, rtol=0.02)
    assert np.allclose(grid.x, 1e-3 + 2e-6 * np.arange(3), rtol=1e-12)


def test_places_that_are_no_grid():
    places = np.random.default_rng(2).uniform(0.0, 1e-5, (2, 30))
    assert grid_of(*places) == ()
    assert grid_of(np.full(9, np.nan), np.full(9, np.nan)) == ()
    assert grid_of(np.arange(9.0), np.zeros(9)) == ()


def test_the_examples_give_what_is_known(root):
    studies = root / "examples" / "studies"
    (result,) = fit_study(read_fit_study(studies / "fitting" / "fit_gel.toml")).fitted
    sticky = fit_study(read_fit_study(studies / "fitting" / "fit_sticky.toml")).fitted[0].fit
    known = (
        (result.fit, "bed.medium.first.young", 4e3),
        (result.fit, "contact_point", 2.4e-6),
        (result.fit, "baseline", 35e-12),
        (sticky, "bed.medium.first.young", 40e3),
        (sticky, "law.work", 0.2e-3),
        (sticky, "contact_point", 2.4e-6),
    )
    for found, name, truth in known:
        assert abs(found.value(name) - truth) < 4.0 * found.error(name), name
        # the mean of slow noise would be a part of the baseline, and 300 points do not exclude it
        assert found.error(name) < (0.2 if name == "baseline" else 0.05) * truth, name


def test_the_indenter_of_an_instrument_gives_the_same_modulus(shared_data, tmp_path):
    """Chiaro wrote E = 117.007 Pa (nu = 0.5, Hertz, R = 27.5 um) into its file; its own window of the curve differs."""
    import zipfile

    with zipfile.ZipFile(shared_data / "force_curves" / "fmt-chiaro-txt_AEBP1_Indentation_002.zip") as archive:
        (name,) = archive.namelist()
        (tmp_path / "chiaro.txt").write_bytes(archive.read(name))
    text = STUDY.replace("5 um", "27.5 um").replace("curve.csv", "chiaro.txt").replace('"10 Pa"', '"1 Pa"')
    (result,) = fit_study(parse_fit_study(text, file="chiaro.toml", folder=tmp_path)).fitted
    assert abs(result.fit.value("bed.medium.first.young") - 117.007) < 2.0 * result.fit.error("bed.medium.first.young")
    assert "misfit" in [flag.name for flag in result.fit.flags]


def test_the_page_on_fits_is_right(root):
    import re

    page = (root / "docs" / "fits.md").read_text(encoding="utf-8")
    (text,) = re.findall(r"^<!-- fit -->\n```toml\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    study = parse_fit_study(text, file="gel.toml", folder=root / "examples" / "studies")
    assert study.problem == read_fit_study(root / "examples" / "studies" / "fitting" / "fit_gel.toml").problem
    for name in CORRECTIONS:
        assert f"`{name}`" in page


def test_a_fit_is_drawn_with_labels_and_units(here):
    from winkler.plot import draw

    (result,) = fit_study(parse_fit_study(STUDY, file="gel.toml", folder=here)).fitted
    above, below = draw(result.fit).axes
    assert below.get_xlabel() == "position from first touch $D - D_0$ [µm]"
    assert (above.get_ylabel(), below.get_ylabel()) == ("force $F_N$ [nN]", "residual [pN]")
    shown = below.collections[0].get_offsets()
    assert np.allclose(shown[:, 1], 1e12 * result.fit.residuals)
    with pytest.raises(InvalidInput, match="no extent; leave it out"):
        draw(result.fit, extent=1.0)


def loop_of(late=0.0, ripple=0.0):
    """A loop with times, whose force is late, and which light disturbs by a sinusoid of a period of 125 nm."""
    random = np.random.default_rng(7)
    position = np.concatenate([np.linspace(-1e-6, 1e-6, 400), np.full(200, 1e-6), np.linspace(1e-6, -1e-6, 400)])
    time = 1e-3 * np.arange(1000.0)
    force = np.interp(time - late, time, hertz(position, 4e3)) + ripple * np.sin(2.0 * np.pi * position / 125e-9)
    return position + 0.3e-6, force + 5e-12 * random.standard_normal(1000), time


def loop_study(folder, lines, **disturbed):
    columns = [column.tolist() for column in loop_of(**disturbed)]
    rows = (f"{1e9 * d!r}, {1e9 * f!r}, {t!r}\n" for d, f, t in zip(*columns, strict=True))
    (folder / "curve.csv").write_text("depth [nm], force [nN], time [s]\n" + "".join(rows), encoding="utf-8")
    return parse_fit_study(STUDY.replace('part = "approach"', f'part = "approach"\n{lines}'), folder=folder)


def test_interference_is_subtracted_and_stated(here):
    (result,) = fit_study(loop_study(here, 'correct = ["interference"]', ripple=3e-11)).fitted
    (step,) = (step for step in result.steps if step.startswith("interference"))
    assert re.search(r"amplitude (29|30|31)\.\d+ ± [0-2]\.\d+ pN and the period 12[45]\.\d+ ± [01]\.\d+ nm", step)
    low, high = result.fit.interval(result.fit.names[0])
    assert low < 4e3 < high


def test_the_clock_is_set_and_stated(here):
    plain, mended = (fit_study(loop_study(here, lines, late=0.02)).fitted[0] for lines in ("", 'correct = ["clock"]'))
    (step,) = (step for step in mended.steps if step.startswith("clock"))
    assert re.search(r"recorded late by (19|20)\.\d+ ± 0\.\d+ ms, and was shifted", step)
    young = mended.fit.names[0]
    assert mended.fit.value(young) == pytest.approx(4e3, rel=0.01)
    assert abs(plain.fit.value("contact_point") - 0.3e-6) > 5.0 * abs(mended.fit.value("contact_point") - 0.3e-6)


def test_what_is_not_there_is_not_corrected(here):
    (result,) = fit_study(loop_study(here, 'correct = ["interference", "clock"]')).fitted
    assert any("no sinusoid over the position stands out" in step for step in result.steps)
    assert any("which is not certain; nothing was shifted" in step for step in result.steps)


def test_events_are_stated(here):
    lines = 'events = ["baseline 0 s to 0.1 s", "pop-in 320"]\ncorrect = ["baseline"]'
    study = loop_study(here, lines)
    (result,) = fit_study(study).fitted
    assert "events: as stated, baseline 0 s to 0.1 s, pop-in 320." in result.steps
    measured = measured_curve(study, result)
    assert [(event.first, event.last) for event in measured.events.of("baseline before contact")] == [(0, 100)]
    assert [event.first for event in measured.events.of("pop-in")] == [320]
    assert measured.count == 1000
    nothing = loop_study(here, 'events = "none"')
    assert (
        "events: stated as none; snap-in, pop-ins and pull-off were not sought." in fit_study(nothing).fitted[0].steps
    )
    assert loop_study(here, 'events = "found"').events == ()


@pytest.mark.parametrize(
    ("events", "sentence"),
    [
        ("3", "fit.events is 3; give 'found', 'none', or a list of events"),
        ("[]", r"fit.events is \[\]; give 'found', 'none'"),
        ('["pop-in"]', "fit.events holds 'pop-in', which is no event with its place"),
        ('["popin 3"]', r"fit.events holds 'popin 3', a 'popin' \(did you mean 'pop-in'\?\); there are baseline"),
        ('["pop-in 3000"]', "events: line 0 spans the points 3000 to 3000; give indices from 0 to 999"),
        ('["pop-in 3 N"]', "fit.events, 'pop-in 3 N': .* give a time"),
    ],
)
def test_events_that_are_refused(here, events, sentence):
    with pytest.raises(InvalidInput, match=sentence):
        fit_study(loop_study(here, f"events = {events}"))
