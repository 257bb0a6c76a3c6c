"""The figures of a study: the pictures of the method for one load, and the answers over what was varied."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from winkler.errors import WinklerError
from winkler.loading import Depth
from winkler.numerics.types import Array
from winkler.plot.adhesion.cycles import contact_of
from winkler.plot.families import bar_sheet, family_sheet
from winkler.plot.method import Contact, method_sheet, pictures_of
from winkler.plot.series import Series, spoken
from winkler.plot.sheets import SHEETS
from winkler.problems.adhesion.cycle import AdhesiveCycleSolution
from winkler.problems.adhesion.equilibrium import EquilibriumCurve
from winkler.problems.adhesion.indentation import AdhesiveSolution
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.study.batch.outcome import Answered, Outcome
from winkler.study.chapters.answer_curves import ALONG, LOOPS, MARCHED, STICKING, WITHOUT_CONTACT
from winkler.study.chapters.captions import CAPTIONS, SHOWN_WHOLE, STUCK
from winkler.study.chapters.figures_of_roughness import Beside, beside
from winkler.study.language.designs import POINT
from winkler.study.language.study import Axis, Study
from winkler.study.report.describe import content_label, setting_told
from winkler.study.report.figure import Shown, capital, drawn
from winkler.study.report.sweep_figures import clouds, mapped, maps, parts, varied_series

__all__ = [
    "CAPTIONS",
    "Shown",
    "answers_over",
    "drawn",
    "figures_of",
    "save",
    "settings_of",
    "shown_contact",
    "shown_point",
    "svg_element",
]

MOST_CURVES = 24
"""More curves are not drawn into one figure; the table holds all."""
MOST_BARS = 40


def shown_point(outcome: Outcome) -> Answered:
    """Return the point whose contact the pictures show: the last one that was solved."""
    return outcome.solved[-1]


def shown_contact(point: Answered) -> Contact | None:
    """Return the contact of a point that the pictures show, its last load; None if there is no contact to show."""
    solution = point.each[-1]
    if isinstance(solution, MARCHED):
        solution = point.solution  # the whole path
    if isinstance(solution, WITHOUT_CONTACT):
        return None
    if isinstance(solution, IndentationSolution):
        return solution
    if isinstance(solution, STICKING):
        return contact_of(solution)
    inside = getattr(solution, "contact", None)
    if isinstance(inside, IndentationSolution):
        return inside
    bed, depth = getattr(point.problem, "bed", None), getattr(solution, "depth", None)
    if bed is None or not isinstance(depth, float | np.ndarray):
        return None
    return Indentation(bed, Depth(float(np.max(depth)))).solve()


def figures_of(outcome: Outcome) -> tuple[Shown, ...]:
    """Return every figure of a study, the answers over what was varied first."""
    found = list(answers_over(outcome))
    contact = shown_contact(shown_point(outcome))
    if contact is None:
        return tuple(found)
    wanted = pictures_of(contact)
    if shown_point(outcome).answer_type in SHEETS:  # its own picture has F(d), as the edge came here
        wanted = tuple(name for name in wanted if name != "force")
    captions = CAPTIONS | (STUCK if isinstance(contact, AdhesiveSolution) else {})
    for name in wanted:
        try:
            found.append(drawn(name, *captions[name], method_sheet(name, contact)))
        except WinklerError as error:
            found.append(Shown(name, *captions[name], None, missing=re.sub(r"^\w+: ", "", str(error))))
    return tuple(found)


# ------------------------------------------------------------------------------------- answers over what was varied


def answers_over(outcome: Outcome) -> Iterator[Shown]:
    """Yield a figure for every answer over what was varied; none if nothing was."""
    columns = {column.name: column.content for column in outcome.table()}
    yield from _sheets(outcome)
    if any(issubclass(point.answer_type, EquilibriumCurve | AdhesiveCycleSolution) for point in outcome.solved):
        yield from _side_by_side(outcome)
        return
    loops = next((LOOPS[point.answer_type] for point in outcome.solved if point.answer_type in LOOPS), ())
    if loops and len(next(iter(columns.values()))) > len(outcome.points):
        yield from _loops(outcome, loops)
        if len(outcome.points) > 1:
            yield from _varied(outcome, {name: outcome.answer(name)[..., 0] for name in _single(outcome)})
        return
    if len(next(iter(columns.values()))) > len(outcome.points):
        over = next((name for name in ALONG if name in columns), "")
        yield from _over(outcome, over) if over else ()
        return
    if len(outcome.points) < 2:
        return
    yield from _varied(outcome, {name: outcome.answer(name)[..., 0] for name in _told_apart(outcome, columns)})


def _varied(outcome: Outcome, answers: dict[str, Array]) -> Iterator[Shown]:
    """Yield a figure for every one of the answers, one number at each point, over what was varied."""
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
    sentence = f"One curve for each of the other settings.{cut}" if len(curves) > 1 else "Everything else was kept."
    for name, content in answers.items():
        of = [Series(name, outcome.word(name), content[where]) for _, where in curves]
        picture = family_sheet([x for _ in curves], of, [label for label, _ in curves])
        yield drawn(f"answer_{name}", capital(f"{spoken(name)} over {spoken(x.name)}"), sentence, picture)


def _curves(study: Study, along: Axis) -> list[tuple[str, Any]]:
    """Return ``(label, where)`` of every curve over one axis of the sweep: where it stands in an array of answers."""
    if study.dims == (POINT,):
        return [("", slice(None))]
    place = study.axes.index(along)
    others = [axis for axis in study.axes if axis is not along]
    curves: list[tuple[str, Any]] = []
    for index in np.ndindex(*(len(axis.values) for axis in others)):
        told = (setting_told(study, axis, axis.values[here]) for axis, here in zip(others, index, strict=True))
        curves.append((", ".join(told), (*index[:place], slice(None), *index[place:])))
    return curves


def _told_apart(outcome: Outcome, columns: dict[str, Array]) -> list[str]:
    """Return the answers that are worth a figure: numbers that vary and are not what was given."""
    given = [columns[axis.key] for axis in outcome.study.sweep]
    found = []
    for name in outcome.answers:
        known = np.isfinite(columns[name])
        content = columns[name][known]
        same = any(one.dtype.kind == "f" and np.array_equal(one[known], content) for one in given)
        if not same and content.size and np.ptp(content) > 0.0:
            found.append(name)
    return found or list(outcome.answers)


def _bars(outcome: Outcome, answers: dict[str, Array]) -> Iterator[Shown]:
    points = outcome.points[:MOST_BARS]
    labels = [", ".join(content_label(item) for item in point.settings) for point in points]
    cut = f" The first {MOST_BARS} of {len(outcome.points)} are shown." if len(outcome.points) > MOST_BARS else ""
    for name, content in answers.items():
        of = Series(name, outcome.word(name), content.ravel()[:MOST_BARS])
        sentence = f"One bar for each that was varied.{cut}"
        yield drawn(f"answer_{name}", capital(spoken(name)), sentence, bar_sheet(labels, of))


def _sheets(outcome: Outcome) -> Iterator[Shown]:
    """Yield the picture of an answer that is a curve by itself: of the last point."""
    point = shown_point(outcome)
    wanted = [*beside(point.solution)]
    if point.answer_type in SHOWN_WHOLE:
        wanted.append(Beside(*SHOWN_WHOLE[point.answer_type], point.solution))
    where = settings_of(outcome, point)
    for name, title, told_by, item in wanted:
        from winkler.plot import sheet_of  # with every picture it knows, which the method's own do not need

        sentence = f"{told_by} Shown is {where}." if where else told_by
        try:
            yield drawn(f"answer_{name}", title, sentence, sheet_of(item))
        except WinklerError as error:
            yield Shown(f"answer_{name}", title, sentence, None, missing=re.sub(r"^\w+: ", "", str(error)))


def settings_of(outcome: Outcome, point: Answered) -> str:
    """Return what was varied, at one point."""
    pairs = zip(outcome.study.sweep, point.settings, strict=True)
    return ", ".join(setting_told(outcome.study, axis, item) for axis, item in pairs)


def _side_by_side(outcome: Outcome) -> Iterator[Shown]:
    """Yield force and radius of cycles or curves of equilibria, one for every point of the sweep, in their order."""
    points = outcome.solved[:MOST_CURVES]
    if len(points) < 2:
        return
    answered, labels = [point.answers for point in points], [settings_of(outcome, point) for point in points]
    name = "position" if "position" in outcome.answers else "depth"
    along = [Series(name, outcome.word(name), answers[name]) for answers in answered]
    for what in ("force", "radius"):
        of = [Series(what, outcome.word(what), answers[what]) for answers in answered]
        picture = family_sheet(along, of, labels, ordered=False)
        title = capital(f"{spoken(what)} over {spoken(name)}")
        yield drawn(f"answer_{what}", title, f"One curve for each point of the sweep.{_cut(outcome)}", picture)


def _loops(outcome: Outcome, loops: tuple[tuple[str, str], ...]) -> Iterator[Shown]:
    """Yield answers along paths over each other, one curve for every point of the sweep, in its order."""
    points = outcome.solved[:MOST_CURVES]
    if len(points) < 2 and points[0].answer_type in SHOWN_WHOLE:
        return  # the picture of the answer itself has them
    labels = [settings_of(outcome, point) for point in points]
    worth, known = _answers_worth(outcome), set[str]()
    for over, what in loops:
        if over in outcome.answers and what in worth:
            along, of = (
                [Series(name, outcome.word(name), point.answers[name]) for point in points] for name in (over, what)
            )
            if len(of) > 1 and all(np.array_equal(one.content, of[0].content) for one in of):
                continue  # given, not answered
            picture = family_sheet(along, of, labels, ordered=False)
            title = capital(f"{spoken(what)} over {spoken(over)}")
            name = f"answer_{what}_over_{over}" if what in known else f"answer_{what}"
            known.add(what)
            yield drawn(name, title, f"One curve for each point of the sweep.{_cut(outcome)}", picture)


def _single(outcome: Outcome) -> list[str]:
    """Return the answers along paths or over time that are one number at every point, and differ."""
    numbers = {name for point in outcome.solved for name, content in point.found if np.ndim(content) == 0}
    return [name for name in _answers_worth(outcome) if name in numbers]


def _cut(outcome: Outcome) -> str:
    count = len(outcome.solved)
    return f" The first {MOST_CURVES} of {count} curves are shown." if count > MOST_CURVES else ""


def _over(outcome: Outcome, over: str) -> Iterator[Shown]:
    """Yield a figure for every answer to many loads over one of them, one curve for every point of the sweep."""
    points, cut = outcome.solved[:MOST_CURVES], _cut(outcome)
    labels = [settings_of(outcome, point) for point in points]
    answered = [point.answers for point in points]
    along = [Series(over, outcome.word(over), answers[over]) for answers in answered]
    for name in _answers_worth(outcome):
        if name != over and all(name in answers for answers in answered):
            of = [Series(name, outcome.word(name), answers[name]) for answers in answered]
            sentence = f"All loads that were asked at once.{cut}"
            picture = family_sheet(along, of, labels)
            yield drawn(f"answer_{name}", capital(f"{spoken(name)} over {spoken(over)}"), sentence, picture)


def _answers_worth(outcome: Outcome) -> list[str]:
    """Return the answers whose curves tell something: not those that say yes or no, or the same everywhere."""
    found = []
    for name in outcome.answers:
        content = np.concatenate([point.answers[name] for point in outcome.solved if name in point.answers])
        known = content[np.isfinite(content)]
        if name != "stable" and known.size and np.ptp(known) > 1e-9 * np.max(np.abs(known)):
            found.append(name)
    return found


# ------------------------------------------------------------------------------------------------------- files


def svg_element(shown: Shown, description: str) -> str:
    """Return a figure as one SVG element for a page: no prolog, its own identifiers, scalable, with a description.

    Parameters
    ----------
    shown
        A figure that was drawn; its name is put before every identifier, so that many figures can stand on one page.
    description
        Read aloud where the figure cannot be seen; already escaped.
    """
    name = shown.name.replace("_", "-")
    text = shown.svg[shown.svg.index("<svg") :]
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    text = re.sub(r'\bid="', f'id="{name}-', text)
    text = re.sub(r"url\(#", f"url(#{name}-", text)
    text = re.sub(r'href="#', f'href="#{name}-', text)
    head, rest = text.split(">", 1)
    size = re.search(r'viewBox="[\d.]+ [\d.]+ ([\d.]+) ([\d.]+)"', head)
    assert size is not None
    box = f'viewBox="0 0 {size[1]} {size[2]}"'
    links = 'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'
    wide = f'style="max-width:{float(size[1]) * 1.6:.0f}px"'
    return f'<svg {links} {box} role="img" aria-label="{description}" {wide}>{rest}'


def save(shown: tuple[Shown, ...], folder: Path, formats: tuple[str, ...]) -> None:
    """Write every figure into ``folder/figures`` in every format."""
    if not formats:
        return
    target = folder / "figures"
    target.mkdir(exist_ok=True)
    for one in shown:
        for ending in formats if one.picture is not None else ():
            assert one.picture is not None
            if ending == "svg":
                (target / f"{one.name}.svg").write_text(one.svg, encoding="utf-8")
            else:
                one.picture.savefig(target / f"{one.name}.{ending}", dpi=200)
