"""A number that varies, in the app: choose it, say over what, watch the points come in, and take them along."""

from __future__ import annotations

import csv
import io

import pytest

from winkler.study.batch.run import run
from winkler.study.language.reading import parse_study

pytestmark = pytest.mark.browser

FORCE, RADIUS = "problem.load.force", "problem.bed.profile.curvature_radius"


def unfolded(app_page):
    """Open what varies."""
    app_page.page.get_by_text("Vary", exact=True).click()
    app_page.page.locator('[data-choice="sweep"]').wait_for()


def varied(app_page, words):
    """Let one more number vary, and wait for its answers."""
    app_page.pick("sweep", words)
    app_page.page.locator(".vary", has_text=words).wait_for()
    app_page.busy()
    app_page.settled()


def rows_of(content):
    return list(csv.DictReader(io.StringIO(content.decode("utf-8"))))


def test_from_a_number_that_varies_to_its_curve(fresh):
    app_page = fresh()
    unfolded(app_page)
    varied(app_page, "load › force")
    app_page.type(f"sweep.{FORCE}.from", "10 N")
    app_page.type(f"sweep.{FORCE}.to", "1 kN")
    app_page.type(f"sweep.{FORCE}.count", "7")
    app_page.busy()
    app_page.settled()
    app_page.choose(f"sweep.{FORCE}", "in equal ratios")
    app_page.busy()
    app_page.settled()
    varied(app_page, "profile › curvature radius")
    app_page.choose(f"sweep.{RADIUS}", "these values")
    app_page.page.locator(f'input[data-path="sweep.{RADIUS}.values"]').wait_for()
    app_page.type(f"sweep.{RADIUS}.values", "5 mm, 10 mm, 20 mm")
    app_page.busy()
    app_page.settled()
    assert app_page.page.locator(".sheets figure svg").count() >= 3
    app_page.shot("sweep")
    study = parse_study(app_page.taken("study").decode("utf-8"))
    assert dict(zip(study.dims, study.shape, strict=True)) == {FORCE: 7, RADIUS: 3}
    exported, expected = rows_of(app_page.taken("csv")), run(study)
    assert len(exported) == 21
    assert [float(row["depth [m]"]) for row in exported] == expected.answer("depth").ravel().tolist()
    assert app_page.taken("netcdf").startswith(b"\x89HDF")
    app_page.page.get_by_role("button", name="do not vary profile › curvature radius").click()
    app_page.busy()
    app_page.settled()
    assert parse_study(app_page.taken("study").decode("utf-8")).shape == (7,)


def test_which_number_matters(fresh):
    app_page = fresh(width=390, height=800)
    unfolded(app_page)
    varied(app_page, "load › force")
    varied(app_page, "profile › curvature radius")
    app_page.pick("sweep.design", "which matters: Sobol indices")
    app_page.page.locator('input[data-path="sweep.design.count"]').wait_for()
    app_page.busy()
    app_page.settled()
    app_page.page.get_by_text("What makes depth scatter").first.wait_for(timeout=30_000)
    assert app_page.page.evaluate("document.documentElement.scrollWidth") <= 390
    app_page.shot("sensitivity_narrow")
    app_page.type("sweep.design.count", "60")
    field = app_page.page.locator(".q-field", has=app_page.page.locator('input[data-path="sweep.design.count"]'))
    field.get_by_text("power of two").wait_for(timeout=20_000)
    app_page.type("sweep.design.count", "1024")
    app_page.page.locator(".study-side .wrong", has_text="winkler run").wait_for(timeout=20_000)
    app_page.type("sweep.design.count", "32")
    app_page.settled()
    assert len(rows_of(app_page.taken("csv"))) == 32 * 4


def test_points_come_in_and_can_be_stopped(fresh):
    app_page = fresh()
    app_page.choose("problem", "viscoelastic_adhesion")
    app_page.busy()
    app_page.settled()
    unfolded(app_page)
    app_page.pick("sweep", "law › work")
    count = "sweep.problem.law.work.count"
    app_page.page.locator(f'input[data-path="{count}"]').wait_for()
    app_page.type(count, "900")
    app_page.page.locator(".status", has_text="of 900 points").wait_for(timeout=60_000)
    app_page.page.get_by_role("button", name="Stop").click()
    app_page.page.locator(".refused", has_text="Stopped").wait_for(timeout=10_000)
    app_page.type(count, "2")
    app_page.settled()
    assert app_page.page.locator(".sheets figure svg").count() >= 1


def test_a_study_that_takes_too_long_is_stopped_and_says_so(impatient):
    app_page = impatient
    app_page.choose("problem", "viscoelastic_adhesion")
    app_page.page.locator('input[data-path="problem.law.work"]').wait_for()  # a form of this kind, still folded
    unfolded(app_page)
    app_page.pick("sweep", "law › work")
    count = "sweep.problem.law.work.count"
    app_page.page.locator(f'input[data-path="{count}"]').wait_for()
    app_page.type(count, "900")
    app_page.page.locator(".refused", has_text="took longer than 5 s and was stopped; ask for less").wait_for(
        timeout=60_000
    )
    app_page.page.locator('.answer-side[data-state="wrong"]').wait_for(timeout=10_000)
    app_page.choose("problem", "indentation")
    app_page.settled()
    assert app_page.card("depth").endswith("µm")
