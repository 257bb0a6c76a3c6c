"""Numbers as people type them: bare, with a decimal comma, in another unit, as a range; and bodies of the table."""

from __future__ import annotations

import pytest

from winkler.study.language.reading import parse_study

pytestmark = pytest.mark.browser

FORCE, FIRST = "problem.load.force", "problem.bed.medium.first"


def test_units_commas_ranges_and_materials(fresh):
    app_page = fresh()
    page = app_page.page
    force = page.locator(f'input[data-path="{FORCE}"]')
    app_page.type(FORCE, "0,5")
    page.locator(".head .sought-line", has_text="under a force of 500 mN").wait_for()
    assert page.locator(f'[data-unit="{FORCE}"]').inner_text().startswith("N")
    page.locator("h1").click()  # leave the field
    page.wait_for_function("path => document.querySelector(path).value === '0.5 N'", arg=f'input[data-path="{FORCE}"]')
    page.locator(f'[data-unit="{FORCE}"]').click()
    app_page.shot("units")
    page.get_by_role("menuitem", name="500 mN").click()
    page.wait_for_function("path => document.querySelector(path).value === '500 mN'", arg=f'input[data-path="{FORCE}"]')
    force.fill("250")  # in the unit that is shown
    page.locator(".head .sought-line", has_text="under a force of 250 mN").wait_for()
    app_page.type(FORCE, "1,000 N")
    field = page.locator(".q-field", has=force)
    field.get_by_text("ambiguous; write '1000 N' if it groups thousands").wait_for()
    app_page.type(FORCE, "2 N")

    app_page.choose(FIRST, "elastic, material from the table")
    app_page.choose(f"{FIRST}.name", "tungsten")
    page.locator(".material-lines", has_text="Young's modulus 411 GPa").wait_for()
    page.locator(f'[data-unit="{FORCE}"]').click()
    page.get_by_role("menuitem", name="a range").click()
    app_page.type(f"{FORCE}.from", "1")
    app_page.type(f"{FORCE}.to", "4")
    app_page.type(f"{FORCE}.count", "4")
    page.locator(".counter", has_text="4 of 4").wait_for()
    app_page.settled()
    app_page.shot("range")
    study = parse_study(app_page.taken("study").decode())
    assert study.problem.load.force.tolist() == [1.0, 2.0, 3.0, 4.0]
    assert study.problem.bed.medium.first.young == 411e9
