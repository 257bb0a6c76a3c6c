"""Which interactive pictures the app computes; `tests/study/test_every_kind.py` computes those of every kind."""

from __future__ import annotations

import pytest

from winkler.study.batch.run import run
from winkler.study.language.reading import parse_study
from winkler.study.language.template import whole_text
from winkler.study.report.headline.shown_contact import shown_point
from winkler.web.pictures import answer
from winkler.web.pictures.moments import moments_of
from winkler.web.pictures.view import NO_VIEW


@pytest.mark.parametrize(
    ("kind", "titles"),
    [
        ("elliptic_indentation", ["Pressure over the ellipse", "Von Mises stress below x", "Von Mises stress below y"]),
        ("elliptic_yield_onset", ["Von Mises stress below x", "Von Mises stress below y"]),
        ("nearly_round_indentation", ["Contour of the contact"]),
        ("line_indentation", ["Pressure", "Distance of the surfaces"]),
    ],
)
def test_pictures_that_take_milliseconds_follow_the_sliders(kind, titles):
    """They are interactive, and no sheet repeats them; in a sweep the sheets stand beside the curves, as before."""
    outcome = run(parse_study(whole_text(kind)))
    shown = answer.scene(outcome, moments_of(shown_point(outcome)), 0, NO_VIEW, still=False)
    assert [one.title for one in answer.pictures(shown) if one.chart] == titles
    assert not answer.has_sheets(outcome)
    assert list(answer.sheets(outcome)) == []
