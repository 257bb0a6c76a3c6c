"""Pictures to work with: an answer pinned and compared, numbers beside the mouse, zoom, and one picture taken along."""

from __future__ import annotations

from pathlib import Path

import pytest

from winkler.study.language.template import whole_text

pytestmark = pytest.mark.browser

FORCE, PLOT = "problem.load.force", '[data-picture="force"]'
RANGE = f"() => document.querySelector('{PLOT}').layout.xaxis.range.map(end => Number(end.toPrecision(6)))"


def saved(page, name, kind):
    """Save one picture, and return its content."""
    page.locator(f'[data-save="{name}"]').click()
    with page.expect_download() as promise:
        page.get_by_role("menuitem", name=kind).click()
    page.locator(".q-menu").wait_for(state="detached")
    assert promise.value.suggested_filename == f"{name}.{kind.lower()}"
    return Path(promise.value.path()).read_bytes()


def test_a_against_b_zoom_and_one_picture(fresh):
    app_page = fresh()
    page = app_page.page
    page.locator("[data-pin]").click()
    app_page.type(FORCE, "800 N")
    page.locator(".compared", has_text="From A to B: load › force 100 N → 800 N.").wait_for()
    app_page.settled()
    assert page.locator(".compared tr", has_text="force").first.locator("td").last.inner_text() == "8"
    app_page.shot("compared")
    curves = page.evaluate(
        f"() => document.querySelector('{PLOT}').data.map(one => [one.line?.dash, Math.max(...one.y)])"
    )
    pinned = next(top for dash, top in curves if dash == "2px,3px")
    assert pinned == pytest.approx(100.0)  # the greatest force of A, in the unit of B

    page.locator(PLOT).scroll_into_view_if_needed()
    box, whole = page.locator(PLOT).bounding_box(), page.evaluate(RANGE)
    page.mouse.move(box["x"] + 100, box["y"] + 50)
    page.mouse.down()
    page.mouse.move(box["x"] + 200, box["y"] + 150, steps=5)
    page.mouse.up()
    page.wait_for_function(f"before => String(({RANGE})()) !== String(before)", arg=whole)
    close = page.evaluate(RANGE)
    page.locator("[data-pin]").click()  # draws all pictures anew
    page.wait_for_function(f"() => document.querySelector('{PLOT}').data.every(one => one.line?.dash !== '2px,3px')")
    assert page.evaluate(RANGE) == close
    page.locator(PLOT).scroll_into_view_if_needed()
    box = page.locator(PLOT).bounding_box()
    page.mouse.dblclick(box["x"] + 150, box["y"] + 100)
    page.wait_for_function(f"before => String(({RANGE})()) !== String(before)", arg=close)

    head, *rows = saved(page, "force", "CSV").decode().split("\n")
    assert head == "curve,depth d [µm],force F_N [N]"
    assert max(float(row.split(",")[-1]) for row in rows if row) == pytest.approx(800.0)
    assert saved(page, "pressure", "PNG").startswith(b"\x89PNG")
    assert saved(page, "pressure", "SVG").startswith(b"<svg")
    assert saved(page, "shape", "PNG").startswith(b"\x89PNG")

    page.locator("[data-pin]").click()
    page.locator(".compared").wait_for()
    page.get_by_role("button", name="Fit a curve").click()  # whose numbers are of another kind
    page.locator("[data-pin]", has_text="Pin as A").wait_for()
    assert not page.locator(".compared").is_visible()


def test_numbers_beside_the_mouse_and_decades_along_an_axis(fresh):
    app_page = fresh()
    page = app_page.page
    page.locator('[data-picture="pressure"]').scroll_into_view_if_needed()
    ground = page.locator('[data-picture="pressure"] .nsewdrag').bounding_box()
    said = page.locator('[data-picture="pressure"] .hoverlayer .hovertext')
    for step in range(20):  # down across the curve
        page.mouse.move(ground["x"] + 0.55 * ground["width"], ground["y"] + step / 20 * ground["height"])
        page.wait_for_timeout(100)
        if said.count():
            break
    assert any(unit in said.first.text_content() for unit in ("MPa", "GPa"))
    app_page.show(whole_text("relaxation_test"))  # its times stand in equal ratios
    axis = page.locator('[data-picture="force_over_time"]').evaluate("plot => plot.layout.xaxis.type")
    assert axis == "log"


ANEW = """async names => {
  const { Plotly } = await import("nicegui-plotly");
  const number = /-?\\d+\\.?\\d*(e-?\\d+)?/g;
  const rounded = text => (text ?? "").replace(number, one => Math.round(10 * one) / 10 || 0);
  const marks = ".scatterlayer path, .contourfill path, .xtick text, .ytick text";
  const moving = ".annotation text, .annotation-arrow-g path, .shapelayer path";
  const look = plot => [...plot.querySelectorAll(marks)].map(
    one => [one.textContent, rounded(one.getAttribute("transform")), rounded(one.getAttribute("d"))].join());
  const notes = plot => [...plot.querySelectorAll(moving)].map(one => {
    const box = one.getBoundingClientRect();
    return [box.x + 0.5 * box.width, box.y + 0.5 * box.height, one.textContent];
  });
  const result = {};
  for (const name of names) {
    const plot = document.querySelector(`[data-picture="${name}"]`);
    const [moved, before] = [look(plot), notes(plot)];
    const figure = JSON.parse(JSON.stringify({ data: plot.data, layout: plot.layout }));
    await Plotly.newPlot(plot, figure.data, figure.layout, { displayModeBar: false });
    const after = notes(plot), apart = after.map(([x, y, text], k) =>
      text === before[k][2] ? Math.hypot(x - before[k][0], y - before[k][1]) : Infinity);
    result[name] = [moved.length, look(plot).filter((one, k) => one !== moved[k]).length, Math.max(0, ...apart)];
  }
  return result;
}"""
"""How many marks each picture has, how many of them differ in a drawing from nothing, and how far its notes are off."""

COUNTED = """async () => {
  const { Plotly } = await import("nicegui-plotly");
  const react = Plotly.react;
  window.whole = 0;
  Plotly.react = (...figure) => (window.whole++, react(...figure));
}"""
"""Counts whole drawings."""
KEYS = ("ArrowRight", "ArrowRight", "ArrowLeft", "ArrowRight", "ArrowLeft", "ArrowLeft")


def followed(app_page, names):
    """Move the force by the keyboard; return how many whole drawings it took, and what differs from a drawing anew."""
    page = app_page.page
    page.evaluate(COUNTED)
    slider = page.locator(f'[data-slide="{FORCE}"] [tabindex="0"]')
    for key in KEYS:
        before = page.locator(".head").inner_html()
        slider.press(key)
        app_page.answered(before)
        app_page.settled()
    page.wait_for_timeout(200)  # those out of sight are drawn when nothing else is to be done
    return page.evaluate("window.whole"), page.evaluate(ANEW, names)


def test_pictures_that_followed_a_slider_are_those_drawn_anew(fresh):
    """Data are exchanged within a figure, and notes moved: both are where a whole drawing puts them, axes included."""
    app_page = fresh()
    names = ["springs", "line_load", "pressure", "force", "stress"]
    whole, looks = followed(app_page, names)
    assert whole < len(KEYS) * len(names) / 2  # the others have followed
    app_page.show(whole_text("elliptic_indentation"))
    ellipses = [f"ellipse_{number}" for number in (1, 2, 3)]
    app_page.page.locator('[data-picture="ellipse_3"] .main-svg').first.wait_for()
    app_page.settled()
    for name, (count, other, off) in (looks | followed(app_page, ellipses)[1]).items():
        assert count > 5, name
        assert (other, off < 2.5) == (0, True), name


def test_the_film_of_a_report_shows_one_moment_and_follows_the_slider(browser, tmp_path):
    from winkler.cli import main

    (tmp_path / "a.toml").write_text(whole_text("tangential"), encoding="utf-8")
    assert main(["report", str(tmp_path / "a.toml"), "--film", "-o", str(tmp_path / "a.html")]) == 0
    page = browser.new_page()
    mistakes = []
    page.on("pageerror", lambda error: mistakes.append(str(error)))
    page.goto((tmp_path / "a.html").as_uri())
    slider, shown = page.locator(".film input"), page.locator(".film img:visible")
    assert slider.is_visible()
    assert ": 1 of " in shown.get_attribute("alt")  # one alone, or this fails
    slider.focus()
    page.keyboard.press("ArrowRight")
    second = shown.get_attribute("alt")
    assert ": 1 of " not in second
    assert slider.get_attribute("aria-valuetext") == second
    page.keyboard.press("End")
    number, total = second.split(": ")[1], shown.get_attribute("alt").split(": ")[1]
    assert number != total
    assert mistakes == []
    page.close()
