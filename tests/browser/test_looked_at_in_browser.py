"""A file that is chosen, or dropped on the page, says what it is taken for, and begins its study."""

from __future__ import annotations

from pathlib import Path

import pytest

pytestmark = pytest.mark.browser

DATA = Path(__file__).parents[2] / "examples" / "data"

DROPPED = """([name, text]) => {
  const transfer = new DataTransfer();
  transfer.items.add(new File([text], name));
  const how = { dataTransfer: transfer, bubbles: true, cancelable: true };
  document.querySelector('.desk').dispatchEvent(new DragEvent('drop', how));
}"""


def test_a_chosen_file_says_what_it_is_and_begins_the_study(app_page):
    page = app_page.page
    with page.expect_file_chooser() as chooser:
        page.locator('[data-look="button"]').click()
    chooser.value.set_files(DATA / "gel_bead.csv")
    window = page.locator(".looked-at")
    window.get_by_text("gel_bead.csv: force curve").wait_for()
    assert window.locator("svg.thumbnail").count() == 2
    page.locator('[data-look="begin"]').click()
    window.wait_for(state="hidden")
    page.locator(".head").get_by_text("Young").first.wait_for()
    assert page.locator('[data-choice="fit.curve"]').is_visible()
    assert not app_page.mistakes


def test_a_dropped_file_says_what_is_doubtful(app_page):
    page = app_page.page
    rows = "\n".join(f"{x}, {5000 if x == 50 else max(x - 100, 0) ** 1.5}" for x in range(200))
    page.evaluate(DROPPED, ["spike.csv", f"depth [nm], force [nN]\n{rows}\n"])
    window = page.locator(".looked-at")
    window.get_by_text("single number far from both neighbours").wait_for()
    window.get_by_role("button", name="Close").click()
    window.wait_for(state="hidden")
    page.evaluate(DROPPED, ["bad.csv", "nothing, here\n"])
    window.get_by_text("bad.csv cannot be read as it is").wait_for()
    assert not page.locator('[data-look="begin"]').is_visible()
    assert not app_page.mistakes
