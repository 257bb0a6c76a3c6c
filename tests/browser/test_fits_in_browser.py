"""A measured curve in the app: upload it, say what it is to tell, look at the fit, and take it along."""

from __future__ import annotations

import csv
import io
import re
import tomllib
import zipfile
from pathlib import Path

import pytest

from winkler.cli import main
from winkler.study.batch.fit_run import fit_study
from winkler.study.language.fit_reading import read_fit_study
from winkler.web.form.sample_folder import sample_folder

pytestmark = pytest.mark.browser

EXAMPLES = Path(__file__).parents[2] / "examples"
GEL = EXAMPLES / "data" / "gel_bead.csv"
YOUNG = "problem.bed.medium.first.young"

GIVEN = re.compile(r'<p class="since assumed">.*?</p>|\n# of an example, given by nobody: [^\n<]*')
"""What the page adds: which numbers nobody has given."""
OWN = re.compile(r"(study\.toml|made in Python|\d{4}-\d\d-\d\dT[\d:+]+|[\d.]+ (ms|s))</code>")
"""Where, when and how fast a report was made."""
NO_CURVE = """[problem]
kind = "indentation"
[problem.bed]
kind = "foundation"
profile = { kind = "sphere", curvature_radius = "5 um" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 kPa", poisson = 0.5 } }
[fit]
curve = ""
part = "approach"
free = { "problem.bed.medium.first.young" = true }
"""


PIXEL = (
    "89504e470d0a1a0a0000000d49484452000000010000000108000000003a7e9b550000000a49444154789c63600000000200"
    "0148afa4710000000049454e44ae426082"
)
"""A PNG file of one black pixel."""


def turned(app_page):
    """Turn the page to fits."""
    app_page.page.get_by_role("button", name="Fit a curve").click()
    shown(app_page, Path("sample_curve.csv"))


def uploaded(app_page, path):
    """Upload a curve."""
    with app_page.page.expect_file_chooser() as chooser:
        app_page.page.locator('[data-upload="fit.curve"]').click()
    chooser.value.set_files(path)


def shown(app_page, path):
    """Wait until the fit of a curve is shown."""
    app_page.page.locator(".pictures", has_text=f"Curve and fit: {path.name}").wait_for(timeout=60_000)
    app_page.settled()


def rows_of(content):
    """Return name -> text of the only row of a CSV file."""
    (row,) = csv.DictReader(io.StringIO(content.decode("utf-8")))
    return {name.split(" ")[0]: text for name, text in row.items()}


def test_from_a_curve_to_its_modulus(fresh, tmp_path):
    app_page = fresh()
    turned(app_page)
    assert app_page.card("Young's modulus").startswith("4.0")
    assert app_page.page.get_by_text("A made curve, not a measurement").is_visible()
    assert app_page.page.get_by_text("is a guess: enter that of your tip").is_visible()
    app_page.shot("fit_begun")
    uploaded(app_page, GEL)
    shown(app_page, GEL)
    assert not app_page.page.get_by_text("A made curve, not a measurement").is_visible()
    app_page.type(f"fit.free.{YOUNG}.0", "10 Pa")
    app_page.type(f"fit.free.{YOUNG}.1", "10 MPa")
    app_page.busy()
    app_page.settled()
    app_page.page.locator('[data-picture="fit"] .main-svg').first.wait_for()
    app_page.shot("fit_gel")

    gel_study = read_fit_study(EXAMPLES / "studies" / "fitting" / "fit_gel.toml")
    fit = fit_study(gel_study).fitted[0].fit
    exported = rows_of(app_page.taken("csv"))
    for free in gel_study.free:
        assert float(exported[free.key]) == fit.value(free.path)
        assert float(exported[f"{free.key}_error"]) == fit.error(free.path)
    assert app_page.card("Young's modulus").startswith("3.99 kPa")

    store = tmp_path / "study.zip"
    store.write_bytes(app_page.taken("study"))
    with zipfile.ZipFile(store) as pack:
        pack.extractall(tmp_path)
    again = fit_study(read_fit_study(tmp_path / "study.toml")).fitted[0].fit
    assert again.value(gel_study.free[0].path) == fit.value(gel_study.free[0].path)
    report = app_page.taken("report").decode("utf-8")
    assert "Fitted parameters" in report
    assert main(["fit", str(tmp_path / "study.toml"), "--output", str(tmp_path / "by_command")]) == 0
    by_command = (tmp_path / "by_command" / "report.html").read_text(encoding="utf-8")
    assert '<p class="since assumed">Not yours, but an example&#x27;s: curvature radius 5\xa0um' in report
    assert GIVEN.sub("", OWN.sub("", report)) == GIVEN.sub("", OWN.sub("", by_command))
    with zipfile.ZipFile(io.BytesIO(app_page.taken("png"))) as pack:
        assert pack.namelist() == ["curve_1.png", "measured_1.png", "noise.png"]

    other = fresh()
    with other.page.expect_file_chooser() as chooser:
        other.page.get_by_role("button", name="Open a study").click()
    chooser.value.set_files(store)
    other.page.locator('[data-picture="fit"] .main-svg').first.wait_for(timeout=60_000)
    other.settled()
    assert rows_of(other.taken("csv")) == exported


def test_bounds_typed_while_a_curve_arrives_are_kept(fresh):
    """The upload is held back until the bounds stand in their boxes, from where they are sent after a pause."""
    app_page, held = fresh(), []
    turned(app_page)
    app_page.page.route("**/upload/**", lambda route: held.append(route))
    uploaded(app_page, GEL)
    while not held:
        app_page.page.wait_for_timeout(20)
    low, high = f"fit.free.{YOUNG}.0", f"fit.free.{YOUNG}.1"
    app_page.type(low, "10 Pa")
    app_page.type(high, "10 MPa")
    held[0].continue_()
    shown(app_page, GEL)
    app_page.page.wait_for_timeout(2_000)  # longer than the pause before typed text is sent
    app_page.settled()
    assert app_page.page.locator(f'input[data-path="{low}"]').input_value() == "10 Pa"
    assert app_page.page.locator(f'input[data-path="{high}"]').input_value() == "10 MPa"
    with zipfile.ZipFile(io.BytesIO(app_page.taken("study"))) as pack:
        study = tomllib.loads(pack.read("study.toml").decode("utf-8"))
    assert study["fit"]["free"][YOUNG] == ["10 Pa", "10 MPa"]


def test_a_late_answer_does_not_replace_what_is_wrong(fresh):
    """The sample is still being fitted when a study without a curve is opened."""
    app_page = fresh()
    app_page.page.get_by_role("button", name="Fit a curve").click()
    app_page.busy()
    app_page.page.locator('input[type="file"]').first.set_input_files(
        {"name": "s.toml", "mimeType": "text/plain", "buffer": NO_CURVE.encode()}
    )
    app_page.settled("wrong")
    app_page.page.wait_for_timeout(5_000)
    app_page.settled("wrong")


def test_a_picture_given_as_a_curve_is_refused_without_errors_of_the_browser(fresh, tmp_path):
    """Two errors stood on the console: the field that takes files showed the picture, which the policy forbids."""
    app_page = fresh()
    turned(app_page)
    said = []
    app_page.page.on("console", lambda message: said.append(message.text) if message.type == "error" else None)
    picture = tmp_path / "photo.png"
    picture.write_bytes(bytes.fromhex(PIXEL))
    uploaded(app_page, picture)
    app_page.page.locator(".study-side .wrong", has_text="photo.png").wait_for(timeout=20_000)
    app_page.settled("wrong")
    assert said == []
    assert app_page.mistakes == []


def test_what_is_wrong_stands_beside_its_field(fresh, tmp_path):
    app_page = fresh()
    turned(app_page)
    spoilt = tmp_path / "spoilt.csv"
    spoilt.write_text("piezo [nm], force [nN]\n1, 2\n3, four\n", encoding="utf-8")
    uploaded(app_page, spoilt)
    sentence = app_page.page.locator(".study-side .wrong", has_text="spoilt.csv")
    sentence.wait_for(timeout=20_000)
    app_page.settled("wrong")
    app_page.shot("fit_spoilt")
    uploaded(app_page, GEL)
    shown(app_page, GEL)
    assert sentence.count() == 0
    bound = f"fit.free.{YOUNG}.0"
    app_page.type(f"fit.free.{YOUNG}.1", "10 MPa")
    app_page.type(bound, "10 kg")
    field = app_page.page.locator(".q-field", has=app_page.page.locator(f'input[data-path="{bound}"]'))
    field.get_by_text("is a mass").wait_for(timeout=20_000)
    app_page.type(bound, "10 Pa")
    app_page.settled()
    app_page.pick("fit.free", "medium › first › Poisson's ratio")
    app_page.page.locator(".study-side .wrong", has_text="only a combination of them").wait_for(timeout=20_000)
    app_page.shot("fit_not_identifiable")
    app_page.page.get_by_role("button", name="do not fit medium › first › Poisson's ratio").click()
    app_page.settled()


def test_a_body_that_relaxes_in_a_narrow_window(fresh):
    app_page = fresh(width=390, height=800)
    turned(app_page)
    app_page.choose("problem", "viscoelastic_indentation")
    app_page.page.locator('[data-choice="fit.fitted"]').wait_for()
    uploaded(app_page, EXAMPLES / "data" / "cell_loop.csv")
    app_page.settled()
    app_page.page.locator('[data-picture="loop"] .main-svg').first.wait_for()
    app_page.page.locator(".sheets figure svg").nth(2).wait_for()
    assert app_page.page.locator(".sheets figure svg").count() == 3
    assert app_page.card("shear modulus").startswith("499.9 Pa")
    assert app_page.page.evaluate("document.documentElement.scrollWidth") <= 390
    app_page.shot("fit_narrow")


def test_the_study_of_each_task_is_unchanged(fresh):
    app_page = fresh()
    app_page.type("problem.load.force", "77 N")
    app_page.page.locator(".head .card .value", has_text="77 N").wait_for(timeout=20_000)
    turned(app_page)
    app_page.page.get_by_role("button", name="Solve a problem").focus()
    app_page.page.keyboard.press("Enter")
    app_page.settled()
    assert app_page.page.locator('input[data-path="problem.load.force"]').input_value() == "77 N"


def test_a_folder_of_curves(fresh, tmp_path):
    """A list, a map and a histogram; a click on either shows a curve, and what is saved holds the folder."""
    app_page = fresh()
    page = app_page.page
    turned(app_page)
    app_page.pick("fit.curve", "sample_curves: a folder of 26 files")
    page.locator('[data-picture="map"] .main-svg').first.wait_for()
    app_page.settled()
    page.get_by_role("button", name="sample_curves/place_13.csv").click()
    page.locator(".pictures", has_text="Curve and fit: sample_curves/place_13.csv").wait_for()
    app_page.settled()
    app_page.shot("fit_folder")
    page.locator('[data-picture="map"]').scroll_into_view_if_needed()
    ground = page.locator('[data-picture="map"] .nsewdrag').bounding_box()
    page.mouse.move(ground["x"] + 0.5 * ground["width"], ground["y"] + 0.9 * ground["height"])
    page.locator('[data-picture="map"] .hoverlayer .hovertext').first.wait_for()
    page.mouse.click(ground["x"] + 0.5 * ground["width"], ground["y"] + 0.95 * ground["height"])  # the lowest row
    page.locator(".pictures", has_text="Curve and fit: sample_curves/place_03.csv").wait_for()
    folder = tmp_path / "run"
    folder.mkdir()
    for name, content in list(sample_folder())[::8]:
        (folder / name).write_bytes(content)
    (folder / "empty.csv").write_bytes(b"")
    with page.expect_file_chooser() as chooser:
        page.locator('[data-upload="fit.curve.folder"]').click()
    chooser.value.set_files(folder)
    page.locator(".curve-list", has_text="4 of 5 curves were fitted").wait_for()
    app_page.settled()
    with zipfile.ZipFile(io.BytesIO(app_page.taken("study"))) as pack:
        assert sorted(pack.namelist())[:2] == ["curves/empty.csv", "curves/place_01.csv"]
    page.get_by_role("button", name="Remove them").click()
    page.locator(".counter", has_text="of 25: sample_curves/").wait_for()
