"""Each kind of problem at 390 pixels: a headline, nothing wider than the window, nothing said on the console."""

from __future__ import annotations

import pytest
from shown_kinds import OTHERS, SHOWN

pytestmark = pytest.mark.browser

LONG = ("elastomer_friction", "reduced_friction", "surface_constriction", "true_area")
"""Kinds that take seconds to solve; a release opens them."""
AGAIN = [one for one in OTHERS if one not in SHOWN][::2]
"""Half of those whose pictures it does not wait for: the parts of their pages are those of others."""
LATER = {*LONG, *AGAIN}


@pytest.mark.parametrize("kind", [pytest.param(one, marks=pytest.mark.long) if one in LATER else one for one in OTHERS])
def test_each_other_kind_fits_a_phone(kind, phone):
    """The page does not wait for the sheets, which `tests/web/test_web_pictures.py` draws, and goes on to the next.

    Of every third kind it waits for a picture; of the others `tests/web/test_web_pictures.py` computes the pictures.
    """
    app_page, said = phone
    page = app_page.page
    before = page.locator(".head").inner_html()
    app_page.choose("problem", kind)
    app_page.answered(before)
    assert page.locator(".head .card").count() >= 1
    assert page.locator(".tail ul.notes li").count() >= 1
    assert not page.locator(".refused").is_visible()
    if kind in SHOWN:
        page.locator("[data-picture] .main-svg, .sheets figure svg").first.wait_for(timeout=60_000)
    assert page.locator('[data-choice="problem"]').first.inner_text().endswith(kind.replace("_", " "))
    assert app_page.overflow() == []
    assert said == []
