"""Thumbnails of many curves: bounded in size, flagged ones first, and drawn where the numbers are."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from winkler.study.report.thumbnails import MOST_THUMBNAILS, ThumbnailOf, thumbnail, thumbnails_section

STUDIES = Path(__file__).parents[3] / "examples" / "studies" / "fitting"


def _points(svg):
    return [
        np.array([[float(one) for one in pair.split(",")] for pair in line.split()])
        for line in re.findall(r'points="([^"]*)"', svg)
    ]


def test_curves_share_one_scale_and_keep_their_extremes():
    x = np.linspace(0.0, 1.0, 5001)
    spike = np.where(np.arange(5001) == 1234, 2.0, 0.0)
    measured, fitted = _points(thumbnail([(x, spike), (x, np.ones(5001))], "curve"))
    assert len(measured) <= 48
    assert measured[:, 1].min() == pytest.approx(3.0)  # the spike reaches the top, of which SVG counts downwards
    assert measured[:, 1].max() == pytest.approx(41.0)
    assert np.allclose(fitted[:, 1], 22.0, atol=0.06)
    assert measured[:, 0].min() == 3.0
    assert measured[:, 0].max() == 117.0


def test_texts_are_escaped_and_nothing_is_drawn_of_nothing():
    assert "<b>" not in thumbnail([(np.arange(3.0), np.arange(3.0))], "<b>")
    assert thumbnail([], "nothing") == ""
    assert thumbnail([(np.full(3, np.nan), np.arange(3.0))], "nothing") == ""
    assert thumbnails_section([ThumbnailOf((), "one", "")]) == ""


def test_a_thousand_curves_are_bounded_and_flagged_ones_come_first():
    x = np.linspace(0.0, 1.0, 3000)
    line = ((x, np.sin(20.0 * x)), (x, np.cos(20.0 * x)))
    items = [ThumbnailOf(line, f"curve {n}", "misfit" * (n % 1000 == 7)) for n in range(2000)]
    items.append(ThumbnailOf((), "bad", "no answer", answered=False))
    page = thumbnails_section(items)
    assert page.count("<figure") == MOST_THUMBNAILS
    assert len(page) < 1.2e6
    first = re.findall(r"<figcaption>(.*?)<", page)[:4]
    assert first == ["curve 7", "curve 1007", "bad", "curve 0"]
    assert "3 of 2001 curves have flags or no answer" in page


@pytest.mark.slow
def test_batches_show_each_curve_with_its_fit():
    from winkler.study.batch.fit_run import fit_study
    from winkler.study.language.fit_reading import read_fit_study
    from winkler.study.report.fit_report import page

    outcome = fit_study(read_fit_study(STUDIES / "fit_batch.toml"))
    text = page(outcome, ())
    assert text.count('<figure class="mini') == len(outcome.results)
    for svg in re.findall(r'<svg class="thumbnail".*?</svg>', text):
        measured, fitted = _points(svg)
        assert abs(measured[0, 1] - fitted[0, 1]) < 2.0  # the fit lies on the curve out of contact, and at the end
        assert abs(measured[-1, 1] - fitted[-1, 1]) < 4.0


@pytest.mark.slow
def test_nanoindentations_show_each_curve_with_its_unloadings(tmp_path):
    from winkler.cli import main

    assert main(["fit", str(STUDIES / "hard_steel.toml"), "--output", str(tmp_path / "steel"), "--quiet"]) == 0
    text = (tmp_path / "steel" / "report.html").read_text(encoding="utf-8")
    pictures = re.findall(r'<svg class="thumbnail".*?</svg>', text)
    assert len(pictures) == 3
    for svg in pictures:
        measured, fitted = _points(svg)
        peak = measured[np.argmin(measured[:, 1])]
        assert np.hypot(*(fitted - peak).T).min() < 3.0  # a fitted unloading begins at the peak of the curve
