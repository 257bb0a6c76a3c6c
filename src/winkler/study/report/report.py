"""The report of a study: figures as files, and one page that holds everything and needs nothing else."""

from __future__ import annotations

import re

from winkler.study.batch.outcome import Outcome
from winkler.study.chapters.answer import PicturedContact
from winkler.study.chapters.contents import answer_of, formulas_of
from winkler.study.language.writing import study_text
from winkler.study.report import page_parts as parts
from winkler.study.report.archive import CSV, NETCDF
from winkler.study.report.describe import settings_text
from winkler.study.report.figure import ReportFigure
from winkler.study.report.figures import figures_of
from winkler.study.report.headline.questions import questions_of
from winkler.study.report.headline.section import doubt_line, doubt_of
from winkler.study.report.headline.shown_contact import shown_contact, shown_point
from winkler.study.report.markup import assumed_line, badge, safe, section
from winkler.study.report.tables import (
    answer_section,
    contact_section,
    expected,
    failures,
    input_section,
    loops_section,
    question_section,
)
from winkler.values.readable import with_unit


def report_files(outcome: Outcome) -> dict[str, bytes]:
    """Return the figures of a study and its report: name -> content.

    Parameters
    ----------
    outcome
        The outcome of a study.

    Returns
    -------
    dict of str to bytes
        Figures in the folder ``figures``, in the formats that the study's output names; ``report.html``, unless the
        study's output declines it.
    """
    return parts.page_files(outcome, figures_of(outcome), page)


def page(outcome: Outcome, shown: tuple[ReportFigure, ...] | None = None, *, assumed: str = "") -> str:
    """Return the report as one HTML page.

    Parameters
    ----------
    outcome
        The outcome of a study.
    shown
        Its figures; drawn if left out.
    assumed
        Which numbers of the study nobody has given, in a sentence; empty if none.
    """
    study = outcome.study
    title = safe(study.title or outcome.provenance.source or "A study")
    pictures = figures_of(outcome) if shown is None else shown
    notes = outcome.validity
    answers = [one for one in pictures if not one.of_method]
    body = [
        f"<header><h1>{title}</h1>{_standing_line(outcome)}{doubt_line(doubt_of(outcome))}{assumed_line(assumed)}</header>",
        question_section(outcome),
        section("At a glance", parts.figure_elements((*answers, *pictures)[:1])) if pictures else "",
        answer_section(outcome),
        contact_section(outcome),
        loops_section(outcome),
        parts.trust(notes, questions_of(outcome)),
        failures(outcome),
        expected(outcome),
        _pictures(outcome, pictures, (*answers, *pictures)[:1]),
        input_section(outcome),
        _formulas(outcome),
        parts.papers(outcome.study),
        _provenance(outcome),
        parts.code_section(study, "study.toml"),
    ]
    return parts.framed(title, outcome.provenance.version, body)


def _standing_line(outcome: Outcome) -> str:
    made = outcome.provenance
    counts = f"{len(outcome.points)} points" if len(outcome.points) > 1 else "one point"
    return (
        f"<p>{badge(outcome.validity)} <span class='small'>The worst of all statements below. Solved with winkler "
        f"{safe(made.version)}, {safe(made.created[:10])}, {counts}.</span></p>"
    )


# ------------------------------------------------------------------------------------------------------ pictures


def _pictures(outcome: Outcome, shown: tuple[ReportFigure, ...], before: tuple[ReportFigure, ...]) -> str:
    """Return the figures but those that stand before the answers."""
    further = [one for one in shown if one not in before]
    answers = [one for one in further if not one.of_method]
    method = [one for one in further if one.of_method]
    sections = []
    if answers:
        sections.append(section("Results as curves", parts.figure_elements(answers)))
    if method:
        sections.append(section("The method in pictures", _which(outcome), parts.figure_elements(method)))
    point = shown_point(outcome)
    if shown_contact(point) is None and answer_of(point.problem).pictured is not PicturedContact.NONE:
        kind = type(point.problem).__name__
        sentence = (
            f"There are no pictures of the method for {kind}: its solution does not state how the springs are "
            "compressed."
        )
        sections.append(section("The method in pictures", f'<p class="missing">{safe(sentence)}</p>'))
    return "\n".join(sections)


def _which(outcome: Outcome) -> str:
    point = shown_point(outcome)
    contact = shown_contact(point)
    where = [settings_text(outcome.study, point.settings)] if outcome.study.sweep else []
    which = answer_of(point.problem).contact_shown
    if which and contact is not None:
        where.append(f"{which}, at a depth of {with_unit(float(contact.depth), 'm')}")
    if len(point.each) > 1 and contact is not None and not which:
        where.append(f"load {len(point.each)} of {len(point.each)}, a force of {with_unit(float(contact.force), 'N')}")
    return f"<p>Shown is {safe('; '.join(where))}.</p>" if where else ""


# --------------------------------------------------------------------------------------- formulas, trust, sources


def _formulas(outcome: Outcome) -> str:
    formulas = formulas_of(shown_point(outcome).problem)
    if not formulas:
        return section("The formulas", "<p>For this problem the report has no formulas; see the papers below.</p>")
    return section("The formulas", parts.formula_list(formulas))


def _readable(text: str) -> str:
    """Return the text of a study without packed height maps, which are not readable."""
    return re.sub(
        r'packed = "([^"]*)"', lambda formulas: f'packed = "... {len(formulas[1])} letters, in study.toml"', text
    )


def _provenance(outcome: Outcome) -> str:
    text = parts.folded("The study as a file; it gives the same results again", _readable(study_text(outcome.study)))
    files = f"<p class='small'>All values with all digits: {CSV} and {NETCDF}, beside this page.</p>"
    return parts.origin(outcome.provenance, "the study", text, files)
