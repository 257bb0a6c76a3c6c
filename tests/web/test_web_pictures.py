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


@pytest.mark.parametrize(
    "kind",
    [
        pytest.param(kind, marks=pytest.mark.long if kind in SHOWN else pytest.mark.slow)
        for kind in CATALOGUE["problem"]
    ],
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
