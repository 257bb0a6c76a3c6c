"""A window of half the width, as at 200 %, and a phone: the asked number stays in sight while the study is changed."""

from __future__ import annotations

import pytest

from winkler.study.language.template import whole_text

pytestmark = pytest.mark.browser

FORCE = "problem.load.force"
IN_SIGHT = """() => {
  const one = document.querySelector('.head .sought-line'), { left, right, top, bottom } = one.getBoundingClientRect();
  const at = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
  return top >= 0 && bottom <= innerHeight && right <= innerWidth && one.contains(at);
}"""


@pytest.mark.parametrize("size", [(640, 400, 2), (390, 844, 3)], ids=["200 %", "phone"])
def test_the_answer_stays_in_sight(fresh, size):
    width, height, scale = size
    app_page = fresh(width=width, height=height, scale=scale)
    page = app_page.page
    lead = page.locator(".head .sought-line")

    def looked_at(name):
        assert page.evaluate(IN_SIGHT), name
        assert app_page.overflow() == [], name
        app_page.shot(f"{name}_{width}")

    looked_at("first")
    slider = page.locator(f'[data-slide="{FORCE}"] [tabindex="0"]').first
    slider.focus()
    page.keyboard.press("ArrowRight")
    lead.get_by_text("under a force of 102.3 N").wait_for()
    slider_box, lead_box = slider.bounding_box(), lead.bounding_box()
    assert slider_box["y"] >= 0
    assert slider_box["y"] + slider_box["height"] <= lead_box["y"]  # both are seen at once
    looked_at("moved")
    page.locator("[data-pin]").click()
    app_page.type(FORCE, "800 N")
    page.locator(".compared", has_text="From A to B").wait_for()
    looked_at("compared")
    app_page.type(FORCE, "10 kg")
    app_page.settled("wrong")
    looked_at("refused")
    app_page.show(whole_text("tangential"))
    looked_at("history")
    page.get_by_role("button", name="Fit a curve").click()
    lead.get_by_text("Young's modulus is 4.0").wait_for()
    looked_at("fit")
