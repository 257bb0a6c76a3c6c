"""Every kind of problem on one page of 390 pixels: its address is opened, and its headline read."""

from __future__ import annotations

import pytest
from example_answers import LASTING
from shown_kinds import OTHERS, SHOWN

from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.template import whole_text

pytestmark = pytest.mark.browser

QUICK = {*SHOWN, *OTHERS[1::6], "torsion", "adhesive_cycle"} - LASTING
"""A half of the kinds, of each chapter some: `tests/study/test_every_kind.py` has the headlines and pages of all."""

SEEN = """() => {
  const all = what => [...document.querySelectorAll(what)].filter(one => one.getClientRects().length);
  return {
    refused: all('.refused').map(one => one.innerText).join(' '),
    sentence: all('.head .sought-line').map(one => one.innerText).join(' '),
    sought: all('.head .card.sought .value').map(one => one.innerText).join(' '),
    standing: all('.head .standing-line').map(one => one.innerText).join(' '),
    notes: all('.tail ul.notes li').length,
    chosen: all('[data-choice="problem"]').map(one => one.innerText).join(' '),
    raw: document.querySelector('.answer-side').innerText.match(/\\d[eE][+-]?\\d+ ?\\S*|\\bNaN\\b/g) ?? [],
    moment: all('.counter').map(one => one.innerText).join(' '),
  };
}"""
WIDE = """() => [...document.querySelectorAll('.tail .scroll')].map(box => {
  box.scrollLeft = 1e6;
  const [outer, last] = [box, box.querySelector('th:last-child')].map(one => one.getBoundingClientRect());
  const scrolls = box.scrollWidth > box.clientWidth;
  return [outer.right <= innerWidth, outer.height < innerHeight, last.right <= outer.right, scrolls];
})"""


def mistakes_of(app_page, kind, said):
    """Return what is wrong with the page of a kind; it waits for the pictures of a third of them.

    `tests/study/test_every_kind.py` computes those of all.
    """
    page = app_page.page
    app_page.show(whole_text(kind))
    seen = page.evaluate(SEEN)
    found = [*app_page.overflow(), *said, *seen["raw"]]
    said.clear()
    for what in ("sentence", "sought", "notes"):
        # what is not to be used is never the large number
        if not seen[what] and (what, seen["standing"]) != ("sought", "do not use"):
            found.append(f"no {what}")
    if seen["refused"] or not seen["chosen"].endswith(kind.replace("_", " ")):
        found.append(f"{seen['chosen']}: {seen['refused']}")
    if kind in SHOWN:
        page.locator("[data-picture] .main-svg, .sheets figure svg").first.wait_for(timeout=60_000)
    return found


@pytest.mark.parametrize(
    "kinds",
    [
        pytest.param([kind for kind in CATALOGUE["problem"] if kind in QUICK], id="quick"),
        pytest.param([kind for kind in CATALOGUE["problem"] if kind not in QUICK], id="others", marks=pytest.mark.long),
    ],
)
def test_every_kind_answers_on_a_phone(fresh, kinds):
    """A headline with a number, nothing wider than the window, nothing on the console, no number as 5e-05."""
    app_page, said, found, moments = fresh(width=390, height=800), [], {}, {}
    page = app_page.page
    page.on("console", lambda message: said.append(message.text))
    for kind in kinds:
        mistakes = mistakes_of(app_page, kind, said)
        if mistakes:
            found[kind] = mistakes
        if kind == "torsion":  # its table is the widest
            page.set_viewport_size({"width": 1100, "height": 900})
            assert app_page.overflow() == []
            assert page.evaluate(WIDE) == [[True, True, True, True]]
            page.set_viewport_size({"width": 390, "height": 800})
        moments[kind] = page.evaluate(SEEN)["moment"]
    assert found == {}
    if "tangential" in moments:
        assert "t = " in moments["tangential"], moments["tangential"]
    if "adhesive_cycle" in moments:
        assert "−" not in moments["adhesive_cycle"].partition("=")[2]  # it opens where the bodies are pressed together
