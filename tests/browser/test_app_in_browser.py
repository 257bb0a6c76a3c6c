"""What a person does with the app: choose, type, slide, upload, look, and take the result along."""

from __future__ import annotations

import csv
import io
import zipfile

import numpy as np
import pytest

import winkler as wk
from winkler.study.batch.run import run
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.reading import parse_study
from winkler.study.language.template import whole_text

pytestmark = pytest.mark.browser

FORCE, RADIUS = "problem.load.force", "problem.bed.profile.curvature_radius"


def numbers_of(content):
    """Return name -> numbers of a CSV file of results."""
    rows = list(csv.DictReader(io.StringIO(content.decode("utf-8"))))
    return {name.split(" ")[0]: [row[name] for row in rows] for name in rows[0]}


@pytest.mark.parametrize("kind", [kind for kind in CATALOGUE["problem"] if kind != "indentation"] + ["indentation"])
def test_from_opening_to_a_result(kind, seen):
    seen.choose("problem", kind)
    seen.busy()
    seen.settled()
    pictures = seen.page.locator("[data-picture] .main-svg").count()
    sheets = seen.page.locator(".sheets figure svg").count()
    assert pictures + sheets >= 1
    assert seen.page.locator(".tail ul.notes li").count() >= 1
    assert not seen.page.locator(".refused").is_visible()
    seen.shot(kind)

    study = parse_study(seen.taken("study").decode("utf-8"))
    exported = numbers_of(seen.taken("csv"))
    answers = run(study).points[0].answers
    assert set(exported) == set(answers)
    assert study.problem == parse_study(whole_text(kind)).problem
    for name, numbers in answers.items():
        assert [float(item) if item else np.nan for item in exported[name]] == pytest.approx(
            numbers.tolist(), rel=0, abs=0, nan_ok=True
        )


def test_files_to_take_along(seen):
    report = seen.taken("report").decode("utf-8")
    assert "<h1>" in report
    assert "What came out" in report
    assert "http" not in report.partition("<style>")[2].partition("</style>")[0]
    with zipfile.ZipFile(io.BytesIO(seen.taken("png"))) as pack:
        names = pack.namelist()
        assert "shape.png" in names
        assert all(pack.read(name).startswith(b"\x89PNG") for name in names)


def test_typing_answers_at_once(fresh):
    seen = fresh()
    seen.type(FORCE, "200 N")
    seen.page.locator(".head .card .value", has_text="200 N").wait_for(timeout=20_000)
    steel = wk.HalfSpace(wk.Elastic(210e9, 0.3))
    depth = wk.Indentation(wk.Foundation(wk.Sphere(10e-3), steel), wk.Force(200.0)).solve().depth
    assert seen.card("depth") == f"{depth * 1e6:.4g} µm"


def test_wrong_input_is_shown_beside_its_field(fresh):
    seen = fresh()
    seen.type(FORCE, "10 kg")
    seen.settled("wrong")
    field = seen.page.locator(".q-field", has=seen.page.locator(f'input[data-path="{FORCE}"]'))
    assert "kg" in field.locator(".q-field__messages").inner_text()
    assert field.locator('[role="alert"]').count() == 1
    seen.type(RADIUS, "-1 mm")
    field = seen.page.locator(".q-field", has=seen.page.locator(f'input[data-path="{RADIUS}"]'))
    seen.type(FORCE, "10 N")
    field.get_by_text("positive").wait_for(timeout=20_000)
    seen.shot("wrong_input")
    seen.type(RADIUS, "1 mm")
    seen.settled()
    assert field.locator('[role="alert"]').count() == 0
    assert not seen.page.locator(".refused").is_visible()


def test_by_the_keyboard_alone(fresh):
    seen = fresh()
    page = seen.page
    for _ in range(40):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.dataset.path") == FORCE:
            break
    assert page.evaluate("document.activeElement.dataset.path") == FORCE
    page.keyboard.press("Control+a")
    page.keyboard.type("50 N")
    page.locator(".head .card .value", has_text="50 N").wait_for(timeout=20_000)
    page.keyboard.press("Tab")  # to its slider
    page.keyboard.press("ArrowRight")
    page.locator(".head .card .value", has_text="51.16 N").wait_for(timeout=20_000)
    assert page.locator(f'input[data-path="{FORCE}"]').input_value() == "51.16 N"
    page.get_by_role("combobox", name="profile").focus()
    page.keyboard.press("Enter")
    page.get_by_role("option", name="paraboloid", exact=True).wait_for()
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Enter")
    page.get_by_role("option", name="paraboloid", exact=True).wait_for(state="detached")
    seen.settled()
    assert 'kind = "paraboloid"' in seen.taken("study").decode()


def test_narrow_window(fresh):
    seen = fresh(width=390, height=800)
    seen.choose("problem", "tangential")
    seen.busy()
    seen.settled()
    assert seen.page.evaluate("document.documentElement.scrollWidth") <= 390
    ends = "[...document.querySelectorAll('.card, .entry, .choice')].map(e => e.getBoundingClientRect().right)"
    assert max(seen.page.evaluate(ends)) <= 391
    seen.shot("narrow")


def test_the_body_turns_and_grows(fresh):
    """It is drawn by a script of ours: keys and the mouse show other sides of it, and a new answer is drawn."""
    seen = fresh()
    canvas = seen.page.locator('[data-picture="shape"] canvas')

    def look():
        return canvas.evaluate("canvas => canvas.toDataURL()")

    looks = [look()]
    canvas.focus()
    for key in ("ArrowLeft", "ArrowUp"):
        seen.page.keyboard.press(key)
        looks.append(look())
    box = canvas.bounding_box()
    seen.page.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
    seen.page.mouse.down()
    seen.page.mouse.move(box["x"] + 0.7 * box["width"], box["y"] + 0.5 * box["height"], steps=4)
    seen.page.mouse.up()
    looks.append(look())
    assert len(set(looks)) == len(looks)
    canvas.dblclick()
    assert look() == looks[0]
    edge = "() => document.querySelector('[data-picture=shape]').data.edge.radius"
    before = seen.page.evaluate(edge)
    seen.type(FORCE, "50 N")
    seen.page.locator(".head .card .value", has_text="50 N").wait_for(timeout=20_000)
    seen.settled()
    assert seen.page.evaluate(edge) == pytest.approx(before * 0.5 ** (1 / 3), rel=1e-3)  # in the frame that is held
    assert look() != looks[0]


def test_a_history_plays(fresh):
    seen = fresh()
    seen.choose("problem", "tangential")
    seen.busy()
    seen.settled()
    counter = seen.page.locator(".counter")
    before = counter.inner_text()
    seen.page.get_by_role("button", name="play the history").click()
    seen.page.wait_for_function("text => document.querySelector('.counter').innerText !== text", arg=before)
    seen.page.get_by_role("button", name="play the history").click()
    seen.page.locator('[data-picture="shear_force_over_shift"] .main-svg').first.wait_for()


def test_a_measured_profile_is_uploaded(fresh, tmp_path):
    tip = tmp_path / "my tip (1).csv"
    r = np.linspace(0.0, 2e-3, 41)
    tip.write_text("radius [mm], height [um]\n" + "".join(f"{a * 1e3}, {a * a / 0.02 * 1e6}\n" for a in r))
    seen = fresh()
    seen.choose("problem.bed.profile", "measured")
    seen.page.locator('[data-upload="problem.bed.profile"]').wait_for()
    with seen.page.expect_file_chooser() as chooser:
        seen.page.locator('[data-upload="problem.bed.profile"]').click()
    chooser.value.set_files(tip)
    seen.page.get_by_text("my_tip_1_.csv").first.wait_for(timeout=20_000)
    seen.settled()
    study = parse_study(seen.taken("study").decode("utf-8"))
    measured = study.problem.bed.profile
    assert isinstance(measured, wk.Measured)
    assert measured.radii.size == 41
    exported = numbers_of(seen.taken("csv"))
    assert float(exported["depth"][0]) == wk.Indentation(study.problem.bed, wk.Force(100.0)).solve().depth
    # a measured parabola answers as the parabola does
    steel = study.problem.bed.medium
    hertz = wk.Indentation(wk.Foundation(wk.Paraboloid(10e-3), steel), wk.Force(100.0)).solve()
    assert float(exported["depth"][0]) == pytest.approx(hertz.depth, rel=1e-6)


STUDY = """
title = "From a file"
[problem]
kind = "indentation"
[problem.bed]
kind = "foundation"
profile = {profile}
[problem.bed.medium]
kind = "half_space"
first = {{ kind = "elastic", young = "210 GPa", poisson = 0.3 }}
[problem.load]
kind = "force"
force = "30 N"
[sweep]
"problem.load.force" = ["1 N", "10 N", "30 N"]
"""


def opened(seen, tmp_path, profile):
    """Open a study file with a profile."""
    path = tmp_path / "mine.toml"
    path.write_text(STUDY.format(profile=profile), encoding="utf-8")
    with seen.page.expect_file_chooser() as chooser:
        seen.page.get_by_role("button", name="Open a study").click()
    chooser.value.set_files(path)


def test_a_study_is_opened(fresh, tmp_path):
    seen = fresh()
    opened(seen, tmp_path, '{ kind = "cone", half_angle = "80 deg" }')
    seen.page.locator('input[data-path="problem.bed.profile.half_angle"]').wait_for(timeout=20_000)
    seen.settled()
    exported = numbers_of(seen.taken("csv"))
    assert [float(item) for item in exported["force"]] == [1.0, 10.0, 30.0]
    assert parse_study(seen.taken("study").decode()).title == "From a file"


def test_nothing_outside_the_folder_is_read(fresh, tmp_path):
    seen = fresh()
    opened(seen, tmp_path, '{ kind = "measured", file = "../../../../etc/passwd" }')
    seen.page.locator(".astext .wrong", has_text="uploaded files only").wait_for(timeout=20_000)
    assert "root:" not in seen.page.content()
    assert seen.page.locator(f'input[data-path="{RADIUS}"]').count() == 1  # the study before is still there


def test_a_formula_is_only_a_formula(fresh):
    seen = fresh()
    seen.choose("problem.bed.profile", "formula")
    seen.page.locator('input[data-path="problem.bed.profile.expression"]').wait_for()
    seen.type("problem.bed.profile.expression", "__import__('os').getcwd()")
    seen.settled("wrong")
    assert seen.page.locator(".study-side").get_by_text("expression", exact=False).count() >= 1
