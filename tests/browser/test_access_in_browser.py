"""The page for everybody: names, headings, language and contrast, in light and dark, on a desk and on a phone."""

from __future__ import annotations

from pathlib import Path

import pytest

pytestmark = pytest.mark.browser

FORCE = "problem.load.force"
AUDIT = (Path(__file__).parent / "access.js").read_text(encoding="utf-8").partition("\n() =>")[2]


ALL = (("dark", 390), ("dark", 1400), ("light", 390), ("light", 1400))


def audited(app_page, name, looks=ALL):
    """Return what the audit of a page finds in some colours and widths."""
    page, found = app_page.page, {}
    for colours, width in looks:
        page.emulate_media(color_scheme=colours)
        page.wait_for_function(f"document.body.classList.contains('body--dark') === {str(colours == 'dark').lower()}")
        page.set_viewport_size({"width": width, "height": 950})
        page.wait_for_timeout(400)  # colours fade over
        found |= {(colours, width, one): name for one in page.evaluate(f"() =>{AUDIT}")}
        app_page.shot(f"{name}_{colours}_{width}")
    return found


def test_an_audit_finds_nothing(fresh):
    app_page = fresh()
    page = app_page.page
    page.locator("[data-pin]").click()
    app_page.type(FORCE, "100 kN")
    page.locator(".head .doubt").wait_for()
    app_page.choose("problem.bed.medium.first", "elastic, material from the table")
    page.locator("summary", has_text="Sources").click()
    page.locator(".compared", has_text="From A to B").wait_for()
    app_page.settled()
    assert audited(app_page, "access") == {}
    app_page.type(FORCE, "10 kg")
    app_page.settled("wrong")
    assert audited(app_page, "access_wrong", [("dark", 1400)]) == {}
    page.get_by_role("button", name="Fit a curve").click()
    page.get_by_text("95 %").first.wait_for()
    app_page.settled()
    assert audited(app_page, "access_fit", [("dark", 390)]) == {}
