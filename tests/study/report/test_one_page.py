"""The report on one page: what stands on it, that it fits, and that it is the same each time."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from winkler.cli import main
from winkler.study.batch.run import run
from winkler.study.language.reading import parse_study, read_study
from winkler.study.language.template import template
from winkler.study.report.figures import figures_of
from winkler.study.report.headline.one_page import laid_out, one_page
from winkler.values.readable import with_unit

STUDIES = Path(__file__).resolve().parents[3] / "examples" / "studies"


def untitled(kind):
    """Return the example of a kind without its title."""
    return re.sub(r"(?m)^title = .*$", "", template(kind))


def boxes(outcome):
    """Return the texts of the page with their places, in dots."""
    page = laid_out(outcome, figures_of(outcome))
    renderer = FigureCanvasAgg(page).get_renderer()
    return page, [(text.get_text(), text.get_window_extent(renderer)) for text in page.texts if text.get_text()]


@pytest.mark.parametrize(
    "study",
    [
        "normal/hertz.toml",
        pytest.param("normal/wheel_rail.toml", marks=pytest.mark.slow),
        pytest.param("rough/stickiness.toml", marks=pytest.mark.slow),
    ],
)
def test_everything_fits_the_page_and_nothing_overlaps(study):
    outcome = run(read_study(STUDIES / study))
    page, found = boxes(outcome)
    wide, high = page.bbox.width, page.bbox.height
    assert [text for text, box in found if box.x0 < 0.0 or box.x1 > wide or box.y0 < 0.0 or box.y1 > high] == []
    assert min(text.get_fontsize() for text in page.texts) >= 7.0
    pictures = [axes.get_window_extent() for axes in page.axes]
    assert pictures
    # the page is filled: below the last text stands nothing but the line of origin
    assert min(box.y0 for text, box in found if not text.startswith("winkler ")) < 0.3 * high
    every = [box for _, box in found] + pictures
    met = [
        (one, two)
        for place, one in enumerate(every)
        for two in every[:place]
        if min(one.x1, two.x1) - max(one.x0, two.x0) > 1.0 and min(one.y1, two.y1) - max(one.y0, two.y0) > 1.0
    ]
    assert met == []


def test_the_page_has_question_answers_validity_and_yield():
    outcome = run(parse_study(f'title = "A ball in its race"\n{untitled("elliptic_indentation")}'))
    _, found = boxes(outcome)
    words = " ".join(text for text, _ in found)
    assert "A ball in its race" in words
    assert with_unit(float(outcome.points[0].answers["peak_pressure"][0]), "Pa") in words
    assert "greatest von Mises stress" in words
    assert "How far this can be trusted: " in words


@pytest.mark.slow
def test_the_page_is_one_and_the_same_each_time():
    outcome = run(parse_study(template("pull_off")))
    first = one_page(outcome, figures_of(outcome))
    assert first.startswith(b"%PDF")
    assert len(re.findall(rb"/Type /Page\b", first)) == 1
    assert one_page(outcome, figures_of(outcome)) == first


def test_the_command_writes_it(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["new", "pull_off", "--output", "a.toml"]) == 0
    assert main(["report", "a.toml", "--page"]) == 0
    assert (tmp_path / "a.pdf").read_bytes().startswith(b"%PDF")
    assert main(["report", "a.toml", "--page"]) == 2  # which stands already
    assert main(["report", "a.toml", "--page", "--output", "a.html"]) == 2
    assert main(["report", "a.toml", "--page", "--interactive", "--overwrite"]) == 2
    assert "leave --interactive out" in capsys.readouterr().err
