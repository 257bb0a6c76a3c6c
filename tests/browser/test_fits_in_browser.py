"""A measured curve in the app: upload it, say what it is to tell, look at the fit, and take it along."""

from __future__ import annotations

import csv
import io
import zipfile
from pathlib import Path

import pytest

from winkler.study.batch.fit_run import fit_study
from winkler.study.language.fit_reading import read_fit_study

pytestmark = pytest.mark.browser

EXAMPLES = Path(__file__).parents[2] / "examples"
YOUNG = "problem.bed.medium.first.young"


def turned(seen):
    """Turn the page to fits."""
    seen.page.get_by_role("button", name="Fit a curve").click()
    seen.settled("wrong")  # there is no curve yet


def uploaded(seen, path):
    """Upload a curve."""
    with seen.page.expect_file_chooser() as chooser:
        seen.page.locator('[data-upload="fit.curve"]').click()
    chooser.value.set_files(path)


def rows_of(content):
    """Return name -> text of the only row of a CSV file."""
    (row,) = csv.DictReader(io.StringIO(content.decode("utf-8")))
    return {name.split(" ")[0]: text for name, text in row.items()}


def test_from_a_curve_to_its_modulus(fresh, tmp_path):
    seen = fresh()
    turned(seen)
    assert "upload a measured curve" in seen.page.locator(".study-side .wrong", has_text="curve").first.inner_text()
    seen.shot("fit_begun")
    uploaded(seen, EXAMPLES / "data" / "gel_bead.csv")
    seen.settled()
    seen.type(f"fit.free.{YOUNG}.0", "10 Pa")
    seen.type(f"fit.free.{YOUNG}.1", "10 MPa")
    seen.busy()
    seen.settled()
    seen.page.locator('[data-picture="fit"] .main-svg').first.wait_for()
    seen.shot("fit_gel")

    gel_study = read_fit_study(EXAMPLES / "studies" / "fitting" / "fit_gel.toml")
    fit = fit_study(gel_study).fitted[0].fit
    exported = rows_of(seen.taken("csv"))
    for free in gel_study.free:
        assert float(exported[free.key]) == fit.value(free.path)
        assert float(exported[f"{free.key}_error"]) == fit.error(free.path)
    assert seen.card("Young's modulus").startswith("3.99 kPa")

    store = tmp_path / "study.zip"
    store.write_bytes(seen.taken("study"))
    with zipfile.ZipFile(store) as pack:
        pack.extractall(tmp_path)
    again = fit_study(read_fit_study(tmp_path / "study.toml")).fitted[0].fit
    assert again.value(gel_study.free[0].path) == fit.value(gel_study.free[0].path)
    assert "Fitted numbers" in seen.taken("report").decode("utf-8")
    with zipfile.ZipFile(io.BytesIO(seen.taken("png"))) as pack:
        assert pack.namelist() == ["curve_1.png"]

    other = fresh()
    with other.page.expect_file_chooser() as chooser:
        other.page.get_by_role("button", name="Open a study").click()
    chooser.value.set_files(store)
    other.page.locator('[data-picture="fit"] .main-svg').first.wait_for(timeout=60_000)
    other.settled()
    assert rows_of(other.taken("csv")) == exported


def test_what_is_wrong_stands_beside_its_field(fresh, tmp_path):
    seen = fresh()
    turned(seen)
    spoilt = tmp_path / "spoilt.csv"
    spoilt.write_text("piezo [nm], force [nN]\n1, 2\n3, four\n", encoding="utf-8")
    uploaded(seen, spoilt)
    said = seen.page.locator(".study-side .wrong", has_text="spoilt.csv")
    said.wait_for(timeout=20_000)
    seen.settled("wrong")
    seen.shot("fit_spoilt")
    uploaded(seen, EXAMPLES / "data" / "gel_bead.csv")
    seen.settled()
    assert said.count() == 0
    bound = f"fit.free.{YOUNG}.0"
    seen.type(f"fit.free.{YOUNG}.1", "10 MPa")
    seen.type(bound, "10 kg")
    field = seen.page.locator(".q-field", has=seen.page.locator(f'input[data-path="{bound}"]'))
    field.get_by_text("is a mass").wait_for(timeout=20_000)
    seen.type(bound, "10 Pa")
    seen.settled()
    seen.page.locator('[data-choice="fit.free"]').click()
    seen.page.get_by_role("option", name="medium › first › Poisson's ratio", exact=True).click()
    seen.page.locator(".study-side .wrong", has_text="only a combination of them").wait_for(timeout=20_000)
    seen.shot("fit_not_identifiable")
    seen.page.get_by_role("button", name="do not fit medium › first › Poisson's ratio").click()
    seen.settled()


def test_a_body_that_relaxes_in_a_narrow_window(fresh):
    seen = fresh(width=390, height=800)
    turned(seen)
    seen.choose("problem", "viscoelastic_indentation")
    seen.page.locator('[data-choice="fit.fitted"]').wait_for()
    uploaded(seen, EXAMPLES / "data" / "cell_loop.csv")
    seen.settled()
    seen.page.locator('[data-picture="loop"] .main-svg').first.wait_for()
    assert seen.page.locator(".sheets figure svg").count() == 1
    assert seen.card("shear modulus").startswith("499.9 Pa")
    assert seen.page.evaluate("document.documentElement.scrollWidth") <= 390
    seen.shot("fit_narrow")


def test_the_study_of_each_task_is_kept(fresh):
    seen = fresh()
    seen.type("problem.load.force", "77 N")
    seen.page.locator(".head .card .value", has_text="77 N").wait_for(timeout=20_000)
    turned(seen)
    seen.page.get_by_role("button", name="Solve a problem").focus()
    seen.page.keyboard.press("Enter")
    seen.settled()
    assert seen.page.locator('input[data-path="problem.load.force"]').input_value() == "77 N"
