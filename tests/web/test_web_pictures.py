"""Every kind of study, as the app opens it: its interactive pictures and its sheets are computed without a mistake.

Those that a browser does not show in `.ci/run`; the others are long tests.
"""

from __future__ import annotations

import json

import pytest
from shown_kinds import SHOWN

from winkler.study.batch.run import run
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.reading import parse_study
from winkler.study.language.template import whole_text
from winkler.study.report.figures import shown_point
from winkler.web.pictures import answer
from winkler.web.pictures.moments import initial_moment, moments_of
from winkler.web.pictures.view import NO_VIEW


@pytest.mark.few(0, slow=8)
@pytest.mark.parametrize(
    "kind",
    [pytest.param(kind, marks=pytest.mark.long) if kind in SHOWN else kind for kind in CATALOGUE["problem"]],
)
def test_pictures_of_each_kind(kind):
    outcome = run(parse_study(whole_text(kind)))
    point = shown_point(outcome)
    moments = moments_of(point)
    for moment in {initial_moment(point, moments), moments.total - 1}:
        shown = answer.scene(outcome, moments, moment, NO_VIEW, still=False)
        drawn = list(answer.pictures(shown))
        assert all(json.loads(picture.chart) if picture.chart else picture.missing for picture in drawn)
        sheets = [sheet for sheet in answer.sheets(outcome) if sheet.svg]
        assert len([picture for picture in drawn if picture.chart]) + len(sheets) >= 1


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


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["indentation", "pull_off", "constriction"])
def test_whether_sheets_follow_is_known_before_they_are_drawn(kind):
    outcome = run(parse_study(whole_text(kind)))
    assert answer.has_sheets(outcome) == bool(list(answer.sheets(outcome)))
