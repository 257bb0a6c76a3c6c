"""The page of calculators as a file in a real browser: its digits are those of the package, and nothing leaves it."""

from __future__ import annotations

import re

import numpy as np
import pytest

from winkler.calculators.catalogue import CALCULATORS, calculator
from winkler.calculators.single_page import calculator_page
from winkler.study.language.reading import parse_study
from winkler.web.form.link import study_of

pytestmark = pytest.mark.browser
POINTS = 4


class CalculatorPage:
    """The file, opened."""

    def __init__(self, browser, path, hash_="", **size):
        self.heard, self.asked = [], []
        self.context = browser.new_context(viewport=size or {"width": 1300, "height": 900}, accept_downloads=True)
        self.page = self.context.new_page()
        self.page.on("console", lambda message: self.heard.append(message.text))
        self.page.on("pageerror", lambda error: self.heard.append(str(error)))
        self.page.on("request", lambda request: self.asked.append(request.url))
        self.page.goto(path.as_uri() + hash_)
        self.page.locator("html[data-ready=yes]").wait_for(state="attached")

    def go(self, one, values=None):
        """Open a calculator at values by its link."""
        parts = [f"calculator={one.name}", *(f"{name}={value!r}" for name, value in (values or {}).items())]
        opens = """hash => {
          document.getElementById("study").textContent = "";
          if (location.hash === `#${hash}`) dispatchEvent(new Event("hashchange"));
          else location.hash = hash;
        }"""
        self.page.evaluate(opens, "&".join(parts))
        self.page.wait_for_function("() => document.getElementById('study').textContent !== ''")

    def numbers(self):
        """Return the numbers that stand there, in SI units, to the last digit."""
        cells = "all => Object.fromEntries(all.map(one => [one.dataset.number, Number(one.dataset.value)]))"
        return self.page.locator("dd[data-number]").evaluate_all(cells)


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    """The page as a file."""
    found = tmp_path_factory.mktemp("page") / "calculators.html"
    found.write_text(calculator_page(), encoding="utf-8")
    return found


@pytest.fixture
def opened(browser, path):
    """Return what opens the page; in the end nothing was said and nobody was asked."""
    pages = []

    def open_page(hash_="", **size):
        pages.append(CalculatorPage(browser, path, hash_, **size))
        return pages[-1]

    yield open_page
    for one in pages:
        assert one.heard == []
        assert all(url.startswith((path.as_uri(), "blob:", "data:")) for url in one.asked), one.asked
        one.context.close()


def drawn(one, rng):
    """Return numbers of the sliders, anywhere in their ranges."""
    part = rng.uniform(size=len(one.sliders))
    pairs = zip(one.sliders, part, strict=True)
    return {s.name: float(f"{s.low * (s.high / s.low) ** u if s.ratio else s.low + (s.high - s.low) * u:.5g}") for s, u in pairs}


@pytest.mark.parametrize("one", CALCULATORS, ids=lambda one: one.name)
def test_digits_are_those_of_the_package(opened, one):
    at, rng = opened(f"#calculator={one.name}"), np.random.default_rng(20261124)
    for values in ({}, *(drawn(one, rng) for _ in range(POINTS))):
        at.go(one, values)
        text = at.page.locator("#study").text_content()
        solution = parse_study(text).problem.solve()
        found = at.numbers()
        for number in one.numbers:
            true = float(eval(f"solution.{number.path}", {"solution": solution}))
            assert found[number.name] == pytest.approx(true, rel=1e-9, abs=0.0), (number.name, values)


def test_a_slider_a_link_and_a_study(opened):
    at = opened("#calculator=adhesion&work=80")
    page, one = at.page, calculator("adhesion")
    assert page.locator('[data-field="work"]').input_value() == "80"
    before = at.numbers()["pull_off"]
    slider = page.locator('[data-slider="work"]')
    slider.focus()
    page.keyboard.press("End")
    page.wait_for_function("() => document.querySelector('[data-field=work]').value === '10000'")
    assert at.numbers()["pull_off"] == pytest.approx(before * 10_000 / 80, rel=1e-12)
    page.keyboard.press("Home")
    page.locator('[data-field="young"]').fill("2,5")  # a decimal comma
    page.locator('[data-pick="up"]').select_option(label="pull-off force")
    page.wait_for_function("() => location.hash.includes('young=2.5') && location.hash.includes('work=1&')")
    link = page.evaluate("() => location.hash")
    with page.expect_download() as promise:
        page.locator("#download").click()
    text = promise.value.path().read_text(encoding="utf-8")
    assert promise.value.suggested_filename == "adhesion.toml"
    solved = parse_study(text).problem.solve()
    assert at.numbers()["radius"] == pytest.approx(float(solved.radius), rel=1e-9)
    code = re.fullmatch(r"http://127\.0\.0\.1:8765/#study=(.+)", page.locator("#app").get_attribute("href"))
    assert study_of(code[1]) == text
    other = opened(link)
    assert other.numbers() == at.numbers()
    assert other.page.locator('[data-pick="up"] option:checked').inner_text() == "pull-off force"
    page.locator('[data-field="work"]').fill("ten")
    assert "from 1 to 10000" in page.locator(".wrong").filter(has_text="Give").inner_text()
    assert at.numbers() == other.numbers()
    page.locator("#again").click()
    assert float(page.locator('[data-field="work"]').input_value()) == one.sliders[3].start


def test_a_curve_is_read_off_and_narrow_pages_fit(opened):
    at = opened(width=390, height=850)
    page = at.page
    chart = page.locator("svg.chart")
    chart.focus()
    page.keyboard.press("Home")
    assert page.locator(".told").text_content().startswith("FN 0.001 N")
    page.keyboard.press("End")
    page.keyboard.press("ArrowLeft")
    read = page.locator(".told").text_content()
    force, depth = (float(number) for number in re.findall(r"(\d[\d.]*) ", read))
    at.go(calculator("normal"), {"force": force})
    page.wait_for_function("force => document.querySelector('[data-field=force]').value === String(force)", arg=force)
    assert at.numbers()["depth"] * 1e6 == pytest.approx(depth, rel=1e-4)
    for one in CALCULATORS:
        at.go(one)
        assert page.evaluate("() => document.documentElement.scrollWidth") <= 390, one.name
        assert page.locator("[data-number]").count() == len(one.numbers)
