"""Pictures to work with: an answer pinned and compared, numbers beside the mouse, zoom, and one picture taken along."""

from __future__ import annotations

from pathlib import Path

import pytest

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
