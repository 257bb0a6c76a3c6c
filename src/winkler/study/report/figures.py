"""The figures of a study: the pictures of the method for one load, and the answers over the varied keys."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.media.halfspace import HalfSpace
from winkler.media.interior.tensor import KINDS
from winkler.numerics.types import Array
from winkler.plot.families import bar_sheet, family_sheet
from winkler.plot.method import adheres, method_sheet, pictures_of
from winkler.plot.normal.depths import depth_sheet, disc_sheet
from winkler.plot.panel import Sheet
from winkler.plot.series import Series, name_in_words
from winkler.problems.normal.indentation import IndentationSolution
from winkler.study.batch.outcome import Outcome
from winkler.study.batch.points import SolvedPoint
from winkler.study.chapters.answer import ALONG, Answer
from winkler.study.chapters.answer import PicturedContact as Shows
from winkler.study.chapters.contents import answer_of
from winkler.study.chapters.method_captions import captions_of
from winkler.study.language.designs import POINT
from winkler.study.language.study import Study
from winkler.study.language.varied import Axis
from winkler.study.report.describe import content_label, setting_text, settings_text
from winkler.study.report.extra_pictures import ExtraPicture, extra_pictures
from winkler.study.report.figure import ReportFigure, capital, drawn
from winkler.study.report.headline.elastic_state import MOST_PIXELS, pressed_map
from winkler.study.report.headline.shown_contact import medium_of, shown_contact, shown_point, stressed_contact
from winkler.study.report.sweep_figures import clouds, mapped, maps, parts, varied_series
from winkler.study.report.variation import variation_shows
from winkler.values.checks.contract import is_a
from winkler.values.errors import InvalidInput, OutsideValidity, WinklerError

if TYPE_CHECKING:
    from winkler.plot.method import Contact

MOST_CURVES = 24
"""Curves in one figure; the table holds all."""
MOST_BARS = 40
FLAT = "winkler.problems.normal.elliptic:EllipticSolution", "winkler.problems.line.indentation:LineSolution"
CHECKS = ("misfit", "imbalance", "balance", "penetration", "mismatch", "freedom")
"""Answers that check others, beside those that end in ``_error``."""


def figures_of(outcome: Outcome) -> tuple[ReportFigure, ...]:
    """Return every figure of a study, first the answers over the varied keys."""
    contact = shown_contact(shown_point(outcome))
    return (*answers_over(outcome), *(_below(outcome) if contact is None else _of_method(outcome, contact)))


def _of_method(outcome: Outcome, contact: Contact) -> Iterator[ReportFigure]:
    """Yield the pictures of the method, of one contact."""
    wanted = pictures_of(contact)
    answer = answer_of(shown_point(outcome).problem)
    if answer.pictured is Shows.EDGE and answer.picture is not None:  # which shows F(d) along the path of the edge
        wanted = tuple(name for name in wanted if name != "force")
    captions = captions_of(sticks=adheres(contact))
    for name in wanted:
        try:
            yield drawn(name, *captions[name], method_sheet(name, contact))
        except WinklerError as error:
            yield ReportFigure(name, *captions[name], None, missing=re.sub(r"^\w+: ", "", str(error)))


def _below(outcome: Outcome) -> Iterator[ReportFigure]:
    """Yield the stresses over the depth below a contact, where they are no answer already."""
    point = shown_point(outcome)
    if is_a(point.solution, "winkler.problems.subsurface.contact_stress:ContactStressSolution"):
        return
    found = _stresses_over_depth(point)
    if found is None:
        return
    title, sentence = captions_of(sticks=False)["depths"]
    sheet, under = found
    sentence = f"The greatest stress of each kind at each depth, {under}." if under else sentence
    places = [settings_text(outcome.study, point.settings)] if outcome.study.sweep else []
    places += [f"load {len(point.each)} of {len(point.each)}"] if len(point.each) > 1 else []
    where = f" Shown is {', '.join(places)}." if places else ""
    yield drawn("depths", title, f"{sentence}{where}", sheet)


def _stresses_over_depth(point: SolvedPoint) -> tuple[Sheet, str] | None:
    """Return the greatest stresses at each depth below a contact or a map, and of which; None if they are not known."""
    contact = stressed_contact(point)
    if isinstance(medium_of(contact), HalfSpace):
        with contextlib.suppress(InvalidInput, OutsideValidity):  # stresses are infinite, or not known
            if isinstance(contact, IndentationSolution):
                return disc_sheet(contact.problem.bed, float(np.ravel(contact.depth)[-1])), ""
            if is_a(contact, *FLAT) and np.size(contact.peak_pressure) == 1:
                from winkler.plot.normal.below_contact import contact_stress_sheet
                from winkler.problems.subsurface.contact_stress import ContactStress

                return contact_stress_sheet(ContactStress(contact.problem).solve()), ""
    found = pressed_map(point)
    if found is None or not isinstance(found[0], HalfSpace) or found[1].pressure.size > MOST_PIXELS:
        return None
    from winkler.media.interior.map_peak import greatest_below
    from winkler.problems.normal.strong_parts import solid_parts

    medium, load, under = found
    part = solid_parts(medium)[0]
    below = greatest_below((load if part.first else load.reversed()).field(part.solid.poisson), KINDS, rounds=2)
    names = [measure.__name__ for measure in KINDS]
    greatest = {name: (spot.value, spot.z) for name, spot in zip(names, below.greatest, strict=True)}
    tractions = "with its tractions" if np.any(load.loads[1:]) else "without friction"
    return depth_sheet(below.depths, dict(zip(names, below.values, strict=True)), greatest), f"{under}, {tractions}"


# ------------------------------------------------------------------------------------- answers over what was varied


def answers_over(outcome: Outcome, *, pictured: bool = True) -> Iterator[ReportFigure]:
    """Yield a figure for every answer over the varied keys; none if no key is varied.

    Parameters
    ----------
    outcome
        Outcome of a study.
    pictured
        Whether the picture of the whole answer comes first.
    """
    columns = {column.name: column.content for column in outcome.table()}
    yield from _sheets(outcome) if pictured else ()
    answer = answer_of(shown_point(outcome).problem)
    if answer.compared:
        yield from _side_by_side(outcome, answer.compared)
        return
    if answer.curves and len(next(iter(columns.values()))) > len(outcome.points):
        yield from _loops(outcome, answer)
        if len(outcome.points) > 1:
            yield from _varied(outcome, {name: outcome.answer(name)[..., 0] for name in _single(outcome)})
        return
    if len(next(iter(columns.values()))) > len(outcome.points):
        if np.ndim(getattr(shown_point(outcome).solution, "patches", 0)) > 0 and outcome.study.axes:
            yield from _patches(outcome)
            return
        over = next((name for name in ALONG if name in columns), "")
        yield from _over(outcome, over) if over else ()
        return
    if len(outcome.points) < 2:
        return
    given = [columns[axis.key] for axis in outcome.study.sweep]
    names = [name for name in _answers_worth(outcome) if not _repeats(columns[name], given)] or outcome.answers
    yield from _varied(outcome, {name: outcome.answer(name)[..., 0] for name in names})


def _repeats(content: Array, given: list[Array]) -> bool:
    """Return whether an answer is one of the varied keys again."""
    known = np.isfinite(content)
    return any(one.dtype.kind == "f" and np.array_equal(one[known], content[known]) for one in given)


def _varied(outcome: Outcome, answers: dict[str, Array]) -> Iterator[ReportFigure]:
    """Yield a figure for every one of the answers, one number at each point, over the varied keys."""
    study = outcome.study
    numeric = [axis for axis in study.axes if axis.numeric]
    if study.design.draws and numeric:
        yield from parts(outcome)
        yield from clouds(outcome, answers)
        return
    if mapped(study):
        yield from maps(outcome, answers)
        return
    if not numeric:
        yield from _bars(outcome, answers)
        return
    along = max(numeric, key=lambda axis: len(axis.values))
    curves = _curves(study, along)
    cut = f" The first {MOST_CURVES} of {len(curves)} curves are shown." if len(curves) > MOST_CURVES else ""
    curves = curves[:MOST_CURVES]
    x = varied_series(study, along)
    sentence = (
        f"One curve for each of the other settings.{cut}" if len(curves) > 1 else "All other values are constant."
    )
    for name, content in answers.items():
        of = [Series(name, outcome.word(name), content[where]) for _, where in curves]
        picture = family_sheet([x for _ in curves], of, [label for label, _ in curves])
        yield drawn(f"answer_{name}", capital(f"{name_in_words(name)} over {name_in_words(x.name)}"), sentence, picture)


def _curves(study: Study, along: Axis) -> list[tuple[str, Any]]:
    """Return ``(label, index)`` of every curve over one axis of the sweep: its index in an array of answers."""
    if study.dims == (POINT,):
        return [("", slice(None))]
    place = study.axes.index(along)
    others = [axis for axis in study.axes if axis is not along]
    curves: list[tuple[str, Any]] = []
    for index in np.ndindex(*(len(axis.values) for axis in others)):
        texts = (setting_text(study, axis, axis.values[here]) for axis, here in zip(others, index, strict=True))
        curves.append((", ".join(texts), (*index[:place], slice(None), *index[place:])))
    return curves


def _bars(outcome: Outcome, answers: dict[str, Array]) -> Iterator[ReportFigure]:
    points = outcome.points[:MOST_BARS]
    units = [outcome.word(axis.key).unit for axis in outcome.study.sweep]
    labels = [", ".join(map(content_label, point.settings, units)) for point in points]
    cut = f" The first {MOST_BARS} of {len(outcome.points)} are shown." if len(outcome.points) > MOST_BARS else ""
    for name, content in answers.items():
        of = Series(name, outcome.word(name), content.ravel()[:MOST_BARS])
        sentence = f"One bar for each that was varied.{cut}"
        yield drawn(f"answer_{name}", capital(name_in_words(name)), sentence, bar_sheet(labels, of))


def _sheets(outcome: Outcome) -> Iterator[ReportFigure]:
    """Yield the picture of the whole answer, of the last point."""
    point = shown_point(outcome)
    picture = answer_of(point.problem).picture
    own = [] if picture is None else [ExtraPicture(picture, point.solution)]
    wanted = [*own, *extra_pictures(point.solution)]
    where = settings_text(outcome.study, point.settings)
    for (name, title, caption), item in wanted:
        from winkler.plot.registered import sheet_of_kind  # loads pictures that those of the method do not need

        sentence = f"{caption} Shown is {where}." if where else caption
        try:
            yield drawn(f"answer_{name}", title, sentence, sheet_of_kind(item))
        except WinklerError as error:
            yield ReportFigure(f"answer_{name}", title, sentence, None, missing=re.sub(r"^\w+: ", "", str(error)))


def _family(
    outcome: Outcome, over: str, what: str, *, ordered: bool = False, stem: str = "", sentence: str = ""
) -> ReportFigure:
    """Return one answer over another, one curve for each of the first points of the sweep."""
    points = outcome.solved[:MOST_CURVES]
    labels = [settings_text(outcome.study, point.settings) for point in points]
    along, of = ([Series(name, outcome.word(name), point.readable[name]) for point in points] for name in (over, what))
    count = len(outcome.solved)
    cut = f" The first {MOST_CURVES} of {count} curves are shown." if count > MOST_CURVES else ""
    title = capital(f"{name_in_words(what)} over {name_in_words(over)}")
    sentence = f"{sentence or 'One curve for each point of the sweep.'}{cut}"
    return drawn(stem or f"answer_{what}", title, sentence, family_sheet(along, of, labels, ordered=ordered))


def _side_by_side(outcome: Outcome, compared: tuple[str, ...]) -> Iterator[ReportFigure]:
    """Yield force and radius of cycles or curves of equilibria, one for every point of the sweep, in their order."""
    if len(outcome.solved) > 1:
        name = "position" if "position" in outcome.answers else "depth"
        yield from (_family(outcome, name, what) for what in compared)


def _loops(outcome: Outcome, answer: Answer) -> Iterator[ReportFigure]:
    """Yield answers along paths over each other, one curve for every point of the sweep, in its order."""
    points = outcome.solved[:MOST_CURVES]
    if len(points) < 2 and answer.picture is not None:
        return  # the picture of the answer shows them
    worth, used = _answers_worth(outcome), set[str]()
    for over, what in answer.curves:
        if over in worth and what in worth:
            of = [point.readable[what] for point in points]
            if len(of) > 1 and all(np.array_equal(one, of[0]) for one in of):
                continue  # given, not computed
            yield _family(outcome, over, what, stem=f"answer_{what}_over_{over}" if what in used else "")
            used.add(what)


def _single(outcome: Outcome) -> list[str]:
    """Return the answers along paths or over time that are one number at every point, and differ."""
    numbers = {name for point in outcome.solved for name, content in point.found if np.ndim(content) == 0}
    return [name for name in _answers_worth(outcome) if name in numbers]


def _over(outcome: Outcome, over: str) -> Iterator[ReportFigure]:
    """Yield a figure for every answer to many loads over one of them, one curve for every point of the sweep."""
    points = outcome.solved[:MOST_CURVES]
    for name in _answers_worth(outcome):
        if name != over and all(name in point.answers for point in points):
            yield _family(outcome, over, name, ordered=True, sentence="All loads of the problem.")


def _patches(outcome: Outcome) -> Iterator[ReportFigure]:
    """Yield a figure for every answer over a varied key, one curve for each patch of contact and other setting."""
    study, single = outcome.study, _single(outcome)
    numeric = [axis for axis in study.axes if axis.numeric]
    if not numeric or study.design.draws:
        yield from _varied(outcome, {name: outcome.answer(name)[..., 0] for name in single})
        return
    along = max(numeric, key=lambda axis: len(axis.values))
    x = varied_series(study, along)
    for name in _answers_worth(outcome):
        content = outcome.answer(name)
        count = 1 if name in single else content.shape[-1]
        rows = [
            (", ".join(part for part in (label, f"patch {patch + 1}" if count > 1 else "") if part), row)
            for label, where in _curves(study, along)
            for patch in range(count)
            if np.isfinite(row := content[where][..., patch]).any()
        ][:MOST_CURVES]
        of = [Series(name, outcome.word(name), row) for _, row in rows]
        title = capital(f"{name_in_words(name)} over {name_in_words(x.name)}")
        each = " and ".join(["patch of contact"] * (count > 1) + ["other setting"] * (len(study.axes) > 1))
        sentence = f"One curve for each {each}." if len(of) > 1 else "All other values are constant."
        yield drawn(f"answer_{name}", title, sentence, family_sheet([x for _ in of], of, [label for label, _ in rows]))


def _answers_worth(outcome: Outcome) -> list[str]:
    """Return the answers whose curves vary: not those that are true or false, or constant."""
    answers = {
        name: np.concatenate([point.answers[name] for point in outcome.solved if name in point.answers])
        for name in outcome.answers
    }
    return [
        name for name in answers if name != "stable" and not _checks(outcome, name) and variation_shows(name, answers)
    ]


def _checks(outcome: Outcome, name: str) -> bool:
    """Return whether an answer only says how well the others are known, so that a note holds it and no figure."""
    sought = answer_of(shown_point(outcome).problem).headline
    return name not in sought and (name in CHECKS or name.endswith("_error"))
