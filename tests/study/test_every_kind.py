"""Each kind of problem, solved once and looked at from all sides: headline, notes, archive, figures, charts and page.

One solution of the study that a newcomer meets serves all looks; what is wrong is listed by kind.
"""

from __future__ import annotations

import functools
import json
import re
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from example_answers import COSTLY, LASTING
from headlines import headline_mistakes
from legibility import faults
from report_page import page_mistakes

from winkler.cli.draw import _drawn_value
from winkler.plot.registered import sheet_of_kind
from winkler.plot.render import render
from winkler.study.batch.run import run
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.reading import parse_study
from winkler.study.language.template import whole_text
from winkler.study.report import archive
from winkler.study.report.figures import figures_of
from winkler.study.report.headline.shown_contact import shown_point
from winkler.study.report.report import page
from winkler.values.readable import with_readable_numbers
from winkler.values.validity import Assumption, worst
from winkler.web.pictures import answer
from winkler.web.pictures.moments import initial_moment, moments_of
from winkler.web.pictures.view import NO_VIEW

KINDS = sorted(CATALOGUE["problem"])
QUICK = [kind for kind in KINDS if kind not in COSTLY]
GROUPS = {
    **{f"quick {first}": QUICK[first::8] for first in range(8)},
    "costly": sorted(COSTLY - LASTING),
    "lasting": sorted(LASTING),
}
RAW_SIZE = re.compile(r"\d[.\d]*e[-+]?\d|\b0\.0\d+ ?(?:m|N|Pa|J|W|K|A|V|s)\b(?!/)|\b\d{5,} ?(?:m|N|Pa)\b(?!/)")
"""A number that a page should show with the prefix of a unit."""


@functools.cache
def outcome_of(kind: str) -> Any:
    """Return what the study of a kind gives that a newcomer meets, once in each worker."""
    return run(parse_study(whole_text(kind)))


@functools.cache
def figures(kind: str) -> Any:
    """Return the figures of its report."""
    return figures_of(outcome_of(kind))


def notes(kind: str) -> Iterator[str]:
    """What a problem declares, and nothing else, is stated, in sentences with sources, lengths in micrometres."""
    solution = outcome_of(kind).points[0].solution
    declared = type(solution.problem).assumptions
    stated = solution.validity
    if not isinstance(declared, frozenset) or not declared <= set(Assumption):
        yield f"it declares {declared}"
    if not stated or not {note.assumption for note in stated} <= declared:
        yield f"it states {sorted({note.assumption.name for note in stated})}"
    yield from (note.statement for note in stated if not note.statement.endswith(".") or not note.source)
    yield from filter(RAW_SIZE.search, (with_readable_numbers(note.statement) for note in stated))
    if worst(stated) not in {note.standing for note in stated}:
        yield f"the worst is {worst(stated)}"


def legible(kind: str) -> Iterator[str]:
    """Nothing in a figure is empty, without a name, cut, too small or over something else."""
    for one in figures(kind):
        for drawn in (one.drawing, one.picture):
            yield from (f"{one.name}: {fault}" for fault in (faults(drawn) if drawn is not None else ()))


def drawn(kind: str) -> Iterator[str]:
    """What `winkler draw` makes without a part is a legible picture."""
    sheet = sheet_of_kind(_drawn_value(shown_point(outcome_of(kind)), "contact", -1))
    yield from faults(render(sheet))


def charts(kind: str) -> Iterator[str]:
    """The interactive pictures of the app and its sheets are computed, at the first and at the last moment."""
    outcome = outcome_of(kind)
    moments = moments_of(shown_point(outcome))
    sheets = [sheet for sheet in answer.sheets(outcome) if sheet.svg]
    for moment in {initial_moment(shown_point(outcome), moments), moments.total - 1}:
        drawn = list(answer.pictures(answer.scene(outcome, moments, moment, NO_VIEW, still=False)))
        yield from (one.title for one in drawn if not (json.loads(one.chart) if one.chart else one.missing))
        if not [one for one in drawn if one.chart] and not sheets:
            yield f"no picture at moment {moment}"
    if answer.has_sheets(outcome) != bool(sheets):
        yield f"{len(sheets)} sheets, which was not known before they were drawn"


def headline(kind: str) -> Iterator[str]:
    """The large number is what was asked, and stands in the sentence."""
    return headline_mistakes(kind, outcome_of(kind))


def whole_page(kind: str) -> Iterator[str]:
    """The report is one page with all chapters, notes and papers, which needs nothing else."""
    return page_mistakes(outcome_of(kind), page(outcome_of(kind), figures(kind)))


def archived(kind: str) -> Iterator[str]:
    """Every answer is in the dataset, to the last digit, with a meaning and a unit."""
    outcome = outcome_of(kind)
    data = archive.dataset(outcome)
    for name in outcome.answers:
        expected = outcome.answer(name)
        if not np.array_equal(
            data[name].values, expected if expected.shape[-1] > 1 else expected[..., 0], equal_nan=True
        ):
            yield f"{name} differs"
    for name, variable in data.variables.items():
        if name not in ("load", "point"):
            number = variable.dtype.kind not in "OU"
            if not variable.attrs.get("long_name") or (number and "units" not in variable.attrs):
                yield f"{name} has the attributes {variable.attrs}"


def seen(group: str, *looks: Callable[[str], Iterator[str]]) -> dict[str, dict[str, list[str]]]:
    """Return what is wrong, by kind and look."""
    found = {kind: {look.__name__: wrong for look in looks if (wrong := list(look(kind)))} for kind in GROUPS[group]}
    return {kind: mistakes for kind, mistakes in found.items() if mistakes}


def marked(default: tuple[str, ...], slow: tuple[str, ...]) -> list[Any]:
    """Return the groups, with the marks of those that do not run by default."""
    kept = {name: pytest.mark.slow if name in slow else pytest.mark.long for name in GROUPS if name not in default}
    return [pytest.param(name, marks=kept.get(name, ())) for name in GROUPS]


ALL_QUICK = tuple(name for name in GROUPS if name.startswith("quick"))


@pytest.mark.parametrize("group", marked(ALL_QUICK, ("costly",)))
def test_every_kind_answers_states_its_limits_and_is_archived(group):
    assert seen(group, headline, notes, archived) == {}


@pytest.mark.parametrize("group", marked((), ALL_QUICK[:3]))
def test_every_kind_is_drawn_and_reported(group):
    """Figures take a second for a kind: most groups are looked at before a release."""
    wrong = seen(group, legible, drawn, charts, whole_page)
    assert wrong == {}, wrong


def test_one_kind_is_drawn_and_reported():
    assert [*legible("tangential"), *drawn("tangential"), *charts("tangential"), *whole_page("tangential")] == []
