"""A number that varies, in the app: choose it, say over what, watch the points come in, and take them along."""

from __future__ import annotations

import csv
import io

import pytest

from winkler.study.batch.run import run
from winkler.study.language.reading import parse_study

pytestmark = pytest.mark.browser

FORCE, RADIUS = "problem.load.force", "problem.bed.profile.curvature_radius"


def unfolded(seen):
    """Open what varies."""
    seen.page.get_by_text("Vary", exact=True).click()
    seen.page.locator('[data-choice="sweep"]').wait_for()


def varied(seen, words):
    """Let one more number vary, and wait for its answers."""
    seen.page.locator('[data-choice="sweep"]').click()
    seen.page.get_by_role("option", name=words, exact=True).click()
    seen.page.locator(".vary", has_text=words).wait_for()
    seen.settled()


def rows_of(content):
    return list(csv.DictReader(io.StringIO(content.decode("utf-8"))))


def test_from_a_number_that_varies_to_its_curve(fresh):
    seen = fresh()
    unfolded(seen)
    varied(seen, "load › force")
    seen.type(f"sweep.{FORCE}.from", "10 N")
    seen.type(f"sweep.{FORCE}.to", "1 kN")
    seen.type(f"sweep.{FORCE}.count", "7")
    seen.busy()
    seen.settled()
    seen.choose(f"sweep.{FORCE}", "in equal ratios")
    seen.busy()
    seen.settled()
    varied(seen, "profile › curvature radius")
    seen.choose(f"sweep.{RADIUS}", "these values")
    seen.page.locator(f'input[data-path="sweep.{RADIUS}.values"]').wait_for()
    seen.type(f"sweep.{RADIUS}.values", "5 mm, 10 mm, 20 mm")
    seen.busy()
    seen.settled()
    assert seen.page.locator(".sheets figure svg").count() >= 3
    seen.shot("sweep")
    study = parse_study(seen.taken("study").decode("utf-8"))
    assert dict(zip(study.dims, study.shape, strict=True)) == {FORCE: 7, RADIUS: 3}
    exported, expected = rows_of(seen.taken("csv")), run(study)
    assert len(exported) == 21
    assert [float(row["depth [m]"]) for row in exported] == expected.answer("depth").ravel().tolist()
    assert seen.taken("netcdf").startswith(b"\x89HDF")
    seen.page.get_by_role("button", name="do not vary profile › curvature radius").click()
    seen.busy()
    seen.settled()
    assert parse_study(seen.taken("study").decode("utf-8")).shape == (7,)


def test_which_number_matters(fresh):
    seen = fresh(width=390, height=800)
    unfolded(seen)
    varied(seen, "load › force")
    varied(seen, "profile › curvature radius")
    seen.page.locator('[data-choice="sweep.design"]').click()
    seen.page.get_by_role("option", name="which matters: Sobol indices", exact=True).click()
    seen.page.locator('input[data-path="sweep.design.count"]').wait_for()
    seen.settled()
    seen.page.get_by_text("What makes depth scatter").first.wait_for(timeout=30_000)
    assert seen.page.evaluate("document.documentElement.scrollWidth") <= 390
    seen.shot("sensitivity_narrow")
    seen.type("sweep.design.count", "60")
    field = seen.page.locator(".q-field", has=seen.page.locator('input[data-path="sweep.design.count"]'))
    field.get_by_text("power of two").wait_for(timeout=20_000)
    seen.type("sweep.design.count", "1024")
    seen.page.locator(".study-side .wrong", has_text="winkler run").wait_for(timeout=20_000)
    seen.type("sweep.design.count", "32")
    seen.settled()
    assert len(rows_of(seen.taken("csv"))) == 32 * 4


def test_points_come_in_and_can_be_stopped(fresh):
    seen = fresh()
    seen.choose("problem", "viscoelastic_adhesion")
    seen.busy()
    seen.settled()
    unfolded(seen)
    seen.page.locator('[data-choice="sweep"]').click()
    seen.page.get_by_role("option", name="law › work", exact=True).click()
    count = "sweep.problem.law.work.count"
    seen.page.locator(f'input[data-path="{count}"]').wait_for()
    seen.type(count, "900")
    seen.page.locator(".status", has_text="of 900 points").wait_for(timeout=60_000)
    seen.page.get_by_role("button", name="Stop").click()
    seen.page.locator(".refused", has_text="Stopped").wait_for(timeout=10_000)
    seen.type(count, "2")
    seen.settled()
    assert seen.page.locator(".sheets figure svg").count() >= 1


def test_a_study_that_takes_too_long_is_stopped_and_says_so(impatient):
    seen = impatient
    seen.choose("problem", "viscoelastic_adhesion")
    unfolded(seen)
    seen.page.locator('[data-choice="sweep"]').click()
    seen.page.get_by_role("option", name="law › work", exact=True).click()
    count = "sweep.problem.law.work.count"
    seen.page.locator(f'input[data-path="{count}"]').wait_for()
    seen.type(count, "900")
    seen.page.locator(".refused", has_text="took longer than 5 s and was stopped; ask for less").wait_for(
        timeout=60_000
    )
    assert seen.page.locator('.answer-side[data-state="wrong"]').count() == 1
    seen.choose("problem", "indentation")
    seen.settled()
    assert seen.card("depth").endswith("µm")
