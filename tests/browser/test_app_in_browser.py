"""What a person does with the app: choose, type, slide, upload, look, and take the result along."""

from __future__ import annotations

import csv
import io
import zipfile

import numpy as np
import pytest
from shown_kinds import WHOLE

import winkler as wk
from winkler.study.batch.run import run
from winkler.study.language.reading import parse_study
from winkler.study.language.template import whole_text

pytestmark = pytest.mark.browser

FORCE, RADIUS = "problem.load.force", "problem.bed.profile.curvature_radius"


def numbers_of(content):
    """Return name -> numbers of a CSV file of results."""
    rows = list(csv.DictReader(io.StringIO(content.decode("utf-8"))))
    return {name.split(" ")[0]: [row[name] for row in rows] for name in rows[0]}


@pytest.mark.parametrize("kind", WHOLE)
def test_from_opening_to_a_result(kind, app_page):
    app_page.settled()  # with the sheets of the kind before
    app_page.choose("problem", kind)
    app_page.busy()
    app_page.settled()
    pictures = app_page.page.locator("[data-picture] .main-svg").count()
    sheets = app_page.page.locator(".sheets figure svg").count()
    assert pictures + sheets >= 1
    assert app_page.page.locator(".tail ul.notes li").count() >= 1
    assert not app_page.page.locator(".refused").is_visible()
    app_page.shot(kind)
    app_page.page.set_viewport_size({"width": 390, "height": 800})
    assert app_page.overflow() == []
    app_page.page.set_viewport_size({"width": 1400, "height": 950})

    study = parse_study(app_page.taken("study").decode("utf-8"))
    exported = numbers_of(app_page.taken("csv"))
    answers = run(study).points[0].answers
    assert set(exported) == set(answers)
    assert type(study.problem) is type(parse_study(whole_text(kind)).problem)  # its bodies are those chosen before
    for name, numbers in answers.items():
        assert [float(item) if item else np.nan for item in exported[name]] == pytest.approx(
            numbers.tolist(), rel=0, abs=0, nan_ok=True
        )


def test_files_to_take_along(app_page):
    report = app_page.taken("report").decode("utf-8")
    assert "<h1>" in report
    assert "Results" in report
    assert "http" not in report.partition("<style>")[2].partition("</style>")[0]
    with zipfile.ZipFile(io.BytesIO(app_page.taken("png"))) as pack:
        names = pack.namelist()
        assert "shape.png" in names
        assert all(pack.read(name).startswith(b"\x89PNG") for name in names)


def test_typing_answers_at_once(fresh):
    app_page = fresh()
    app_page.type(FORCE, "200 N")
    app_page.page.locator(".head .card .value", has_text="200 N").wait_for(timeout=20_000)
    steel = wk.HalfSpace(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))
    depth = wk.Indentation(wk.Foundation(wk.Sphere(10e-3), steel), wk.Force(200.0)).solve().depth
    assert app_page.card("depth") == f"{depth * 1e6:.4g} µm"


def test_wrong_input_is_shown_beside_its_field(fresh):
    app_page = fresh()
    app_page.type(FORCE, "10 kg")
    app_page.settled("wrong")
    field = app_page.page.locator(".q-field", has=app_page.page.locator(f'input[data-path="{FORCE}"]'))
    assert "kg" in field.locator(".q-field__messages").inner_text()
    assert field.locator('[role="alert"]').count() == 1
    app_page.type(RADIUS, "-1 mm")
    field = app_page.page.locator(".q-field", has=app_page.page.locator(f'input[data-path="{RADIUS}"]'))
    app_page.type(FORCE, "10 N")
    field.get_by_text("positive").wait_for(timeout=20_000)
    app_page.shot("wrong_input")
    app_page.type(RADIUS, "1 mm")
    app_page.settled()
    assert field.locator('[role="alert"]').count() == 0
    assert not app_page.page.locator(".refused").is_visible()


def test_by_the_keyboard_alone(fresh):
    app_page = fresh()
    page = app_page.page
    for _ in range(60):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.dataset.path") == FORCE:
            break
    assert page.evaluate("document.activeElement.dataset.path") == FORCE
    page.keyboard.press("Control+a")
    page.keyboard.type("50 N")
    page.locator(".head .card .value", has_text="50 N").wait_for(timeout=20_000)
    page.keyboard.press("Tab")  # to its unit
    assert page.evaluate("document.activeElement.dataset.unit") == FORCE
    page.keyboard.press("Tab")  # to its slider
    page.keyboard.press("ArrowRight")
    page.locator(".head .card .value", has_text="51.16 N").wait_for(timeout=20_000)
    assert page.locator(f'input[data-path="{FORCE}"]').input_value() == "51.16 N"
    page.get_by_role("combobox", name="profile").focus()
    page.keyboard.press("Enter")
    page.get_by_role("option", name="paraboloid", exact=True).wait_for()
    page.keyboard.press("ArrowDown")
    app_page.note()
    page.keyboard.press("Enter")
    page.get_by_role("option", name="paraboloid", exact=True).wait_for(state="detached")
    app_page.busy()
    app_page.settled()
    assert 'kind = "paraboloid"' in app_page.taken("study").decode()


def test_narrow_window(fresh):
    app_page = fresh(width=390, height=800)
    app_page.choose("problem", "tangential")
    app_page.busy()
    app_page.settled()
    assert app_page.page.evaluate("document.documentElement.scrollWidth") <= 390
    ends = "[...document.querySelectorAll('.card, .entry, .choice')].map(e => e.getBoundingClientRect().right)"
    assert max(app_page.page.evaluate(ends)) <= 391
    app_page.shot("narrow")


def test_the_body_turns_and_grows(fresh):
    """It is drawn by a script of ours: keys and the mouse show other sides of it, and a new answer is drawn."""
    app_page = fresh()
    canvas = app_page.page.locator('[data-picture="shape"] canvas')

    def look():
        return canvas.evaluate("canvas => canvas.toDataURL()")

    looks = [look()]
    canvas.focus()
    for key in ("ArrowLeft", "ArrowUp"):
        app_page.page.keyboard.press(key)
        looks.append(look())
    box = canvas.bounding_box()
    app_page.page.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
    app_page.page.mouse.down()
    app_page.page.mouse.move(box["x"] + 0.7 * box["width"], box["y"] + 0.5 * box["height"], steps=4)
    app_page.page.mouse.up()
    looks.append(look())
    assert len(set(looks)) == len(looks)
    canvas.dblclick()
    assert look() == looks[0]
    edge = "() => document.querySelector('[data-picture=shape]').data.edge.radius"
    before = app_page.page.evaluate(edge)
    app_page.type(FORCE, "50 N")
    app_page.page.locator(".head .card .value", has_text="50 N").wait_for(timeout=20_000)
    app_page.settled()
    assert app_page.page.evaluate(edge) == pytest.approx(before * 0.5 ** (1 / 3), rel=1e-3)  # in the frame that is held
    assert look() != looks[0]


def test_a_history_plays(fresh):
    app_page = fresh()
    app_page.choose("problem", "tangential")
    app_page.busy()
    app_page.settled()
    counter = app_page.page.locator(".counter")
    before = counter.inner_text()
    assert "t = " in before  # a time with its unit
    assert before.endswith("s")
    app_page.page.get_by_role("button", name="play the history").click()
    app_page.page.wait_for_function("text => document.querySelector('.counter').innerText !== text", arg=before)
    app_page.page.get_by_role("button", name="play the history").click()
    app_page.page.locator('[data-picture="shear_force_over_shift"] .main-svg').first.wait_for()


def test_a_measured_profile_is_uploaded(fresh, tmp_path):
    tip = tmp_path / "my tip (1).csv"
    r = np.linspace(0.0, 2e-3, 41)
    tip.write_text("radius [mm], height [um]\n" + "".join(f"{a * 1e3}, {a * a / 0.02 * 1e6}\n" for a in r))
    app_page = fresh()
    app_page.choose("problem.bed.profile", "measured")
    app_page.page.locator('[data-upload="problem.bed.profile"]').wait_for()
    with app_page.page.expect_file_chooser() as chooser:
        app_page.page.locator('[data-upload="problem.bed.profile"]').click()
    chooser.value.set_files(tip)
    app_page.page.get_by_text("my_tip_1_.csv").first.wait_for(timeout=20_000)
    app_page.settled()
    study = parse_study(app_page.taken("study").decode("utf-8"))
    measured = study.problem.bed.profile
    assert isinstance(measured, wk.Measured)
    assert measured.radii.size == 41
    exported = numbers_of(app_page.taken("csv"))
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


def opened(app_page, tmp_path, profile):
    """Open a study file with a profile."""
    path = tmp_path / "mine.toml"
    path.write_text(STUDY.format(profile=profile), encoding="utf-8")
    with app_page.page.expect_file_chooser() as chooser:
        app_page.page.get_by_role("button", name="Open a study").click()
    chooser.value.set_files(path)


def test_a_study_is_opened(fresh, tmp_path):
    app_page = fresh()
    opened(app_page, tmp_path, '{ kind = "cone", half_angle = "80 deg" }')
    app_page.page.locator('input[data-path="problem.bed.profile.half_angle"]').wait_for(timeout=20_000)
    app_page.settled()
    exported = numbers_of(app_page.taken("csv"))
    assert [float(item) for item in exported["force"]] == [1.0, 10.0, 30.0]
    assert parse_study(app_page.taken("study").decode()).title == "From a file"


def test_nothing_outside_the_folder_is_read(fresh, tmp_path):
    app_page = fresh()
    opened(app_page, tmp_path, '{ kind = "measured", file = "../../../../etc/passwd" }')
    app_page.page.locator(".astext .wrong", has_text="uploaded files only").wait_for(timeout=20_000)
    assert "root:" not in app_page.page.content()
    assert app_page.page.locator(f'input[data-path="{RADIUS}"]').count() == 1  # the study before is still there


def test_a_formula_is_only_a_formula(fresh):
    app_page = fresh()
    app_page.choose("problem.bed.profile", "formula")
    app_page.page.locator('input[data-path="problem.bed.profile.expression"]').wait_for()
    app_page.type("problem.bed.profile.expression", "__import__('os').getcwd()")
    app_page.settled("wrong")
    assert app_page.page.locator(".study-side").get_by_text("expression", exact=False).count() >= 1
