"""The report: whole, by itself, escaped, and honest about what is missing."""

from __future__ import annotations

import html
import itertools
import re
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from report_page import Page, page_mistakes
from study_samples import SAMPLES, pressed

import winkler as wk
from winkler.study.batch.run import run
from winkler.study.chapters.method_captions import CAPTIONS
from winkler.study.language.build import build
from winkler.study.language.explain import example_study
from winkler.study.language.study import Expectation, Output, Study
from winkler.study.language.varied import Axis
from winkler.study.report import figures, report
from winkler.study.report.figures import answers_over
from winkler.study.report.page_parts import REPORT
from winkler.study.report.writing import write_files
from winkler.values.validity import Standing

FULL = ("one load", "crystal", "no contact", "pinned")
"""Samples with every picture of the method; the others are written with one of them, which is quicker."""


BRIEF = ("together", "many loads, varied", "fields", "fields at lengths", "formula", "some fail", "hostile")
"""Samples that vary as others do; the first figure of their answers is drawn."""


AGAIN = {"many loads, varied", "fields", "fields at lengths", "formula", "sum", "area function"}
"""Samples whose pages have the parts of others; they are looked at among the slow tests."""


class Written(dict[str, tuple[Any, Path]]):
    """Every sample, written once where it is asked for: name -> (outcome, folder)."""

    def __init__(self, folders: pytest.TempPathFactory) -> None:
        super().__init__()
        self.folders = folders

    def __missing__(self, name: str) -> tuple[Any, Path]:
        folder = self.folders.mktemp("report")
        outcome = run(SAMPLES[name])
        with pytest.MonkeyPatch.context() as patch:
            if name not in FULL:
                patch.setattr(figures, "pictures_of", lambda contact: ("springs",))
            if name in BRIEF:
                patch.setattr(figures, "answers_over", lambda outcome: itertools.islice(answers_over(outcome), 1))
            write_files(report.report_files(outcome), folder)
        self[name] = outcome, folder
        return self[name]


@pytest.fixture(scope="session")
def written(tmp_path_factory):
    return Written(tmp_path_factory)


@pytest.fixture
def page(written):
    return lambda name: (written[name][1] / REPORT).read_text(encoding="utf-8")


SHOWN = [pytest.param(name, marks=pytest.mark.slow if name in AGAIN else ()) for name in SAMPLES]
REPORTED = [shown for shown in SHOWN if SAMPLES[shown.values[0]].output.report]


@pytest.mark.parametrize("name", REPORTED)
def test_the_page_is_whole_and_needs_nothing_else(name, written, page):
    assert [*page_mistakes(written[name][0], page(name))] == []


@pytest.mark.parametrize("name", SHOWN)
def test_figures_are_files_too(name, written):
    outcome, folder = written[name]
    formats = outcome.study.output.figures
    present = sorted(path.name for path in (folder / "figures").iterdir())
    stems = {path.stem for path in (folder / "figures").iterdir()}
    assert present == sorted(f"{stem}.{ending}" for stem in stems for ending in formats)
    assert "springs" in stems
    if name in FULL:
        assert stems <= set(CAPTIONS)
        missing = {"crystal": {"depths"}, "no contact": {"stress", "force", "depths"}, "pinned": {"depths"}}
        assert set(CAPTIONS) - stems == {"medium"} | missing.get(
            name, set()
        )  # a homogeneous medium has nothing to show of its own
    elif outcome.study.sweep:
        assert len(stems) > (1 if name in BRIEF else 3)
        assert all(stem == "springs" or stem.startswith("answer_") for stem in stems)
    for path in (folder / "figures").iterdir():
        start = path.read_bytes()[:5]
        assert start.startswith({".svg": b"<?xml", ".png": b"\x89PNG", ".pdf": b"%PDF-"}[path.suffix])
        if path.suffix == ".svg":
            ElementTree.parse(path)


def test_without_a_report_there_are_figures_only(written):
    _, folder = written["only figures"]
    assert sorted(path.name for path in folder.iterdir()) == ["figures"]


@pytest.mark.slow
def test_without_figures_there_is_a_report_only(tmp_path):
    write_files(report.report_files(run(Study("Plain", pressed(), output=Output(figures=())))), tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == [REPORT]


def test_what_a_reader_wrote_is_escaped(page):
    text = page("hostile")
    assert "<script" not in text
    assert "<b>bold" not in text
    assert "&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;" in text
    assert SAMPLES["hostile"].title in Page(text).text


def test_every_picture_of_the_method_is_on_the_page(page):
    parsed = Page(page("one load"))
    shown = [message for name, message in CAPTIONS.items() if name != "medium"]  # which is homogeneous
    for title, sentence in shown:
        assert title in parsed.text
        assert sentence in parsed.text
    svgs = [attributes for tag, attributes in parsed.tags if tag == "svg"]
    assert len(svgs) == len(shown)
    for attributes in svgs:
        assert attributes["role"] == "img"
        assert attributes["aria-label"]
        assert attributes["viewbox"].startswith("0 0 ")
        assert "width" not in attributes


def test_one_load_is_stated_in_large_letters(page):
    parsed = Page(page("one load"))
    assert "1.191 µm" in parsed.text
    assert "20 N" in parsed.text
    cards = [attributes["class"] for _, attributes in parsed.tags if attributes.get("class", "").startswith("card")]
    sought = ["cards", "card sought", "card", "card", "card"]  # depth, radius, mean pressure; the given force
    assert cards == [*sought, "cards beside", "card", "card"]  # the greatest stress, the load of yield
    assert "indentation depth: how far the bodies have approached since first touch" in parsed.text


def test_the_study_is_written_in_words(page):
    text = Page(page("one load")).text
    assert (
        "A body pressed into another one. The shape is a paraboloid (curvature radius = 10\u00a0mm). The body below is "
        "elastic (Young's modulus = 210\u00a0GPa, Poisson's ratio = 0.3, strength = 700\u00a0MPa). The body above is "
        "elastic (Young's modulus = 210\u00a0GPa, Poisson's ratio = 0.3). Prescribed: force = 20\u00a0N."
    ).replace("\u00a0", " ") in text.replace("\u00a0", " ")


def test_what_was_varied_is_stated(page):
    text = Page(page("two keys")).text.replace("\u00a0", " ")
    assert "Prescribed: force varied." in text
    assert "Varied: load.force = 1 N, 10 N, 100 N, 1 kN." in text
    assert "Every combination was solved." in text
    assert "They vary together." in Page(page("together")).text
    assert "Shown is force = 1 kN, curvature radius = 10 mm." in text


def test_shapes_are_stated_by_name_not_by_class(page):
    text = Page(page("shapes")).text
    assert "cone (half angle = 85.9437°)" in text
    assert "flat punch (radius = 1 mm)" in text
    assert "Cone(half_angle" not in text.partition("As Python")[0]


def test_failed_points_are_listed_with_their_reasons(written, page):
    outcome, _ = written["some fail"]
    text = Page(page("some fail")).text
    assert "1 of 3 points have no answer" in text
    assert f"radius = 2 mm: {outcome.failed[0].reason}" in text


def test_what_is_not_known_is_stated_in_a_sentence(page):
    text = Page(page("no contact")).text
    assert "Not shown: the bodies do not touch under this load" in text


def test_formulas_fit_the_problem(page):
    assert "Effective modulus of a transversely isotropic body" in Page(page("crystal")).text
    assert "Condition for the onset of yield" in Page(page("onset of yield")).text
    assert "The plane profile g(x) was given" in Page(page("plane profile")).text
    assert "up to the rim that limits the contact" in Page(page("pinned")).text
    assert page("one load").count('<math display="block">') == 7


@pytest.mark.slow
def test_the_worst_standing_stands_at_the_top(page):
    head = page("one load").split("</header>")[0]
    assert 'class="standing asymptotic"' in head
    beyond = Study("Beyond", pressed(load=wk.Force(1e4), medium=wk.HalfSpace(wk.Elastic(210e9, 0.3, 100e6))))
    head = report.page(run(beyond)).split("</header>")[0]
    assert f'class="standing {Standing.OUTSIDE.value}"' in head
    assert "do not use" in head


def test_long_tables_are_cut_and_say_where_the_rest_is():
    study = Study("Long", pressed(), sweep=(Axis("problem.load.force", tuple(np.linspace(1.0, 50.0, 50))),))
    text = report.page(run(study), ())
    parsed = Page(text)
    assert "50 rows, of which the first and last 12 are shown; results.csv holds all." in parsed.text
    table = re.search(r"Results</h2>.*?</table>", text, re.DOTALL)[0]
    assert table.count("<tr>") == 1 + 24


def test_a_table_repeats_no_column_that_was_given(page):
    for name, heading in (("two keys", "force"), ("some fail", "contact radius")):
        table = re.search(r"Results</h2>.*?</thead>", page(name), re.DOTALL)[0]
        assert len(re.findall(f">{heading} ", table)) == 1


def test_tables_are_shown_with_prefixes(page):
    table = re.search(r"Results</h2>.*?</table>", page("two keys"), re.DOTALL)[0]
    assert "[µm]" in table
    modulus = 210e9 / (2 * (1 - 0.3**2))
    depth = (9 * 1.0**2 / (16 * modulus**2 * 10e-3)) ** (1 / 3)
    assert f'<td class="number">{depth * 1e6:.6g}</td>' in table


def test_expectations_and_results_are_shown():
    study = Study(
        "Compared",
        pressed(),
        expect=(Expectation("depth", 1.191e-6, 1e-3), Expectation("pressure", 1e9, 1e-3, (("r", 0.0),))),
    )
    text = Page(report.page(run(study), ())).text
    assert "1 of 2 expectations were met." in text
    assert "pressure at r = 0 m missed" in text
    assert "depth as expected" in text


def test_a_problem_that_states_nothing_about_its_springs():
    outcome = run(SAMPLES["one load"])

    class Odd:
        """A question of another kind."""

    point = outcome.points[0]
    silent = type("Silent", (), {"depth": 1.0, "validity": ()})()
    odd = type("Point", (), {"each": (silent,), "problem": Odd(), "settings": (), "index": ()})()
    assert figures.shown_contact(odd) is None
    assert figures.shown_contact(point) is point.solution


def test_the_study_on_the_page_runs_again(written, page):
    from winkler.study.language.reading import parse_study

    text = page("two keys")
    source = re.search(r"<pre>(.*?)</pre>", text, re.DOTALL)[1]
    assert parse_study(html.unescape(source)) == written["two keys"][0].study


@pytest.fixture(scope="module")
def chromium():
    for name in ("chromium", "chromium-browser", "google-chrome"):
        if path := shutil.which(name):
            return path
    pytest.skip("no browser is installed")


@pytest.mark.browser
@pytest.mark.parametrize("width", [360, 700, 1400])
@pytest.mark.parametrize("name", ["one load", "two keys", "crystal"])
def test_a_real_browser_shows_it_without_a_network_and_without_sideways_scrolling(
    name, width, written, chromium, tmp_path
):
    """A probe, appended to a copy of the page, measures it in the browser; the page itself has no script."""
    probe = """<script>window.onload = () => {
      const wide = [...document.querySelectorAll('section, figure, figure > svg, h1, p, li')]
        .filter(e => e.getBoundingClientRect().right > document.documentElement.clientWidth + 1);
      const requests = performance.getEntriesByType('resource').filter(e => !e.name.startsWith('data:'));
      const small = [...document.querySelectorAll('figure > svg')].filter(e => e.getBoundingClientRect().height < 100);
      document.title = 'wide ' + wide.length + ' requests ' + requests.length + ' small ' + small.length
        + ' scroll ' + (document.documentElement.scrollWidth - document.documentElement.clientWidth)
        + ' math ' + (document.querySelector('mfrac').getBoundingClientRect().height > 20);
    };</script></body>"""
    copy = tmp_path / "report.html"
    text = (written[name][1] / REPORT).read_text(encoding="utf-8")
    # the window of a headless browser has a least width; a frame has none
    copy.write_text(text.replace("</body>", probe), encoding="utf-8")
    frame = tmp_path / "frame.html"
    frame.write_text(
        f'<body style="margin:0"><iframe src="report.html" width="{width}" height="800" onload="setTimeout(() => '
        'document.title = this.contentDocument.title, 300)"></iframe></body>',
        encoding="utf-8",
    )
    answer = subprocess.run(
        [
            chromium, "--headless", "--no-sandbox", "--disable-gpu", "--allow-file-access-from-files",
            "--host-resolver-rules=MAP * ~NOTFOUND", f"--user-data-dir={tmp_path / 'profile'}",
            "--window-size=1600,1000",
            "--virtual-time-budget=4000", "--dump-dom", frame.as_uri(),
        ],
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )  # fmt: skip
    title = re.search(r"<title>(.*?)</title>", answer.stdout)
    assert title, answer.stdout[:500] + answer.stderr[-500:]
    assert title[1] == "wide 0 requests 0 small 0 scroll 0 math true"


@pytest.mark.parametrize(
    "medium",
    [
        "coated_half_space",
        pytest.param("depth_graded_half_space", marks=pytest.mark.slow),
        pytest.param("graded_half_space", marks=pytest.mark.slow),
    ],
)
def test_shapes_on_layers_have_a_whole_report(tmp_path, medium):
    """The springs of an ellipse, which it has on homogeneous bodies alone, were asked for: no study on layers ended."""
    problem = build(example_study("elliptic_indentation", medium=medium)["problem"])
    write_files(report.report_files(run(Study("An ellipse", problem))), tmp_path)
    assert sorted(path.suffix for path in (tmp_path / "figures").iterdir()) == [".svg"]
