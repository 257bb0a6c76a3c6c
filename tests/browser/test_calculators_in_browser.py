"""The page of calculators as a file in a real browser: its digits are those of the package, and nothing leaves it."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

from winkler.calculators.catalogue import CALCULATORS, calculator
from winkler.calculators.single_page import calculator_page, described, joined_script, module_text
from winkler.calculators.widget import RENDER
from winkler.cli import main
from winkler.study.language.reading import parse_study
from winkler.web.form.link import study_of

pytestmark = pytest.mark.browser
POINTS = 4
AUDIT = Path(__file__).parent / "access.js"
READ_OFF = """
[problem]
kind = "indentation"
load = { kind = "force", force = "100 N" }

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }

[problem.bed.medium]
kind = "half_space"
first = { kind = "elastic", young = "210 GPa", poisson = 0.3 }
"""


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
    return {
        s.name: float(f"{s.low * (s.high / s.low) ** u if s.ratio else s.low + (s.high - s.low) * u:.5g}")
        for s, u in pairs
    }


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
    page.evaluate("() => new Promise(shown => requestAnimationFrame(() => setTimeout(shown)))")  # numbers: next frame
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
    assert page.locator(".spoken").text_content().startswith("FN 0.001 N")
    page.keyboard.press("End")
    page.keyboard.press("ArrowLeft")
    read = page.locator(".spoken").text_content()
    force, depth = (float(number) for number in re.findall(r"(\d[\d.]*) ", read))
    at.go(calculator("normal"), {"force": force})
    page.wait_for_function("force => document.querySelector('[data-field=force]').value === String(force)", arg=force)
    assert at.numbers()["depth"] * 1e6 == pytest.approx(depth, rel=1e-4)
    audit = f"() =>{AUDIT.read_text(encoding='utf-8').partition(chr(10) + '() =>')[2]}"
    for one in CALCULATORS:
        at.go(one)
        assert page.evaluate("() => document.documentElement.scrollWidth") <= 390, one.name
        assert page.locator("[data-number]").count() == len(one.numbers)
        for colours in ("dark", "light"):
            page.emulate_media(color_scheme=colours)
            assert page.evaluate(audit) == [], (one.name, colours)


def test_the_curves_of_a_report_are_read_off(browser, tmp_path):
    """The arrow keys and the mouse say the numbers that the page holds."""
    study, page_path = tmp_path / "ball.toml", tmp_path / "ball.html"
    study.write_text(READ_OFF, encoding="utf-8")
    assert main(["report", str(study), "--interactive", "--output", str(page_path)]) == 0
    heard = []
    context = browser.new_context(viewport={"width": 1200, "height": 900})
    page = context.new_page()
    page.on("console", lambda message: heard.append(message.text))
    page.on("pageerror", lambda error: heard.append(str(error)))
    page.goto(page_path.as_uri())
    figure = page.locator("figure", has_text="pressure").filter(has=page.locator('[id^="pressure-"]'))
    figure.locator("svg").focus()
    page.keyboard.press("End")
    panel = json.loads(page.locator("#curves").text_content())["pressure"][0]
    read = figure.locator(".spoken").text_content()
    assert read.startswith("distance from the axis r ")
    assert float(re.search(r"r (\S+) µm", read)[1]) == pytest.approx(panel["curves"][0]["x"][-1], rel=1e-4)
    box = figure.locator("svg").bounding_box()
    page.mouse.move(box["x"] + box["width"] * 0.5, box["y"] + box["height"] * 0.5)
    assert figure.locator(".spoken").text_content() != read
    assert figure.locator(".reading .said").count() == 1
    assert heard == []
    context.close()


def test_a_widget_draws_itself_and_tells_its_values(browser, tmp_path):
    """The module of the widget in a page of its own, with a model as a notebook gives it."""
    state = {"module": module_text(), "calculator": described(calculator("adhesion")), "values": {"work": 80.0}}
    script = joined_script(("reading", "chart", "calculators")) + RENDER.replace("export default", "const widget =")
    model = """
      const heard = {}, state = STATE;
      const model = {
        get: (name) => state[name],
        set: (name, value) => (state[name] = value),
        save_changes: () => (window.saved = state.values),
        on: (name, call) => (heard[name] = call),
        off: () => {},
      };
      window.follow = (values) => { state.values = { ...state.values, ...values }; heard["change:values"](); };
      await widget.render({ model, el: document.getElementById("cell") });
      document.documentElement.dataset.ready = "yes";
    """.replace("STATE", json.dumps(state))
    path = tmp_path / "cell.html"
    path.write_text(
        f'<meta charset="utf-8"><div id="cell"></div><script type="module">{script}{model}</script>', "utf-8"
    )
    at = CalculatorPage(browser, path)
    assert at.page.evaluate("() => window.saved.work") == 80.0
    slider = at.page.locator('[data-slider="work"]')
    slider.focus()
    at.page.keyboard.press("End")
    at.page.wait_for_function("() => window.saved.work === 10000")
    at.page.evaluate("() => window.follow({ work: 160 })")
    at.page.wait_for_function("() => document.querySelector('[data-field=work]').value === '160'")
    modulus, unit = 1e6 / 0.75, 1.5 * np.pi * 1e-3
    assert at.numbers()["pull_off"] == pytest.approx(-unit * 0.16, rel=1e-12)
    assert at.numbers()["radius"] == pytest.approx((9 * np.pi * 1e-6 * 0.16 / (2 * modulus)) ** (1 / 3), rel=1e-11)
    assert at.heard == []
    at.context.close()
