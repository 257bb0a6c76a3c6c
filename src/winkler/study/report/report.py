"""The report of a study: figures as files, and one page that holds everything and needs nothing else.

``report.html`` carries its pictures, formulas and styles inside; it opens without a network, on narrow screens and on
paper.  Everything that a reader wrote is escaped.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from winkler.plot.series import told
from winkler.study.batch.outcome import Outcome
from winkler.study.chapters.answer import Contact
from winkler.study.chapters.contents import answer_of, formulas_of
from winkler.study.language.reading import study_text
from winkler.study.report import figures
from winkler.study.report.archive import CSV, NETCDF
from winkler.study.report.citing import cite
from winkler.study.report.figures import Shown, figures_of, shown_contact, shown_point
from winkler.study.report.markup import safe, section, table
from winkler.study.report.mathml import formula
from winkler.study.report.tables import answered, asked, expected, failures, settings_told
from winkler.validity import Note, Standing, worst

__all__ = ["REPORT", "figure_element", "framed", "page", "papers", "trust", "write"]

WIDE = 7.0
"""Figures wider than this [inch], panels side by side, take both columns of the page."""
REPORT = "report.html"

MEANINGS = {
    Standing.EXACT: "holds without error within the stated theory",
    Standing.ASYMPTOTIC: "right in a limit; the deviation is stated",
    Standing.APPROXIMATE: "the error is stated",
    Standing.OUTSIDE: "not to be trusted",
}


def write(outcome: Outcome, folder: Path) -> None:
    """Write the figures of a study and its report.

    Parameters
    ----------
    outcome
        What a study came to.
    folder
        Must exist. Figures go into its folder ``figures``, in the formats that the study's output names; the report,
        unless the study's output declines it, into ``report.html``.
    """
    shown = figures_of(outcome)
    figures.save(shown, folder, outcome.study.output.figures)
    if outcome.study.output.report:
        (folder / REPORT).write_text(page(outcome, shown), encoding="utf-8")


def page(outcome: Outcome, shown: tuple[Shown, ...] | None = None) -> str:
    """Return the report as one HTML page.

    Parameters
    ----------
    outcome
        What a study came to.
    shown
        Its figures; drawn if left out.
    """
    study = outcome.study
    title = safe(study.title or outcome.provenance.source or "A study")
    pictures = figures_of(outcome) if shown is None else shown
    notes = outcome.validity
    body = [
        f"<header><h1>{title}</h1>{_standing_line(outcome, worst(notes))}</header>",
        asked(outcome),
        answered(outcome),
        failures(outcome),
        expected(outcome),
        _pictures(outcome, pictures),
        _formulas(outcome),
        trust(notes),
        papers(outcome.study),
        _provenance(outcome),
    ]
    return framed(title, outcome.provenance.version, body)


def framed(title: str, version: str, body: list[str]) -> str:
    """Return a whole page; `title` and `body` are escaped already."""
    style = (Path(__file__).parent / "report.css").read_text(encoding="utf-8")
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<meta name="generator" content="winkler {safe(version)}">\n'
        f"<title>{title}</title>\n<style>\n{style}</style>\n</head>\n<body>\n"
        + "\n".join(body)
        + "\n</body>\n</html>\n"
    )


def _badge(standing: Standing) -> str:
    return f'<span class="standing {standing.value}">{standing.value}</span>'


def _standing_line(outcome: Outcome, standing: Standing) -> str:
    made = outcome.provenance
    counts = f"{len(outcome.points)} points" if len(outcome.points) > 1 else "one point"
    return (
        f"<p>{_badge(standing)} <span class='small'>{MEANINGS[standing]} (the worst of all statements below). Solved "
        f"with winkler {safe(made.version)}, {safe(made.created[:10])}, {counts}.</span></p>"
    )


# ------------------------------------------------------------------------------------------------------ pictures


def _pictures(outcome: Outcome, shown: tuple[Shown, ...]) -> str:
    answers = [one for one in shown if not one.of_method]
    method = [one for one in shown if one.of_method]
    parts = []
    if answers:
        curves = "".join(map(figure_element, answers))
        parts.append(section("The answers as curves", f'<div class="figures">{curves}</div>'))
    if method:
        figures_ = "".join(map(figure_element, method))
        parts.append(section("The method in pictures", _which(outcome), f'<div class="figures">{figures_}</div>'))
    point = shown_point(outcome)
    if shown_contact(point) is None and answer_of(point.problem).contact is not Contact.NONE:
        kind = type(point.problem).__name__
        sentence = (
            f"There are no pictures of the method for {kind}: its answer does not tell how the springs are pressed."
        )
        parts.append(section("The method in pictures", f'<p class="missing">{safe(sentence)}</p>'))
    return "\n".join(parts)


def _which(outcome: Outcome) -> str:
    point = shown_point(outcome)
    contact = shown_contact(point)
    where = [settings_told(outcome, point.settings)] if outcome.study.sweep else []
    which = answer_of(point.problem).contact_shown
    if which and contact is not None:
        where.append(f"{which}, at a depth of {told(float(contact.depth), 'm')}")
    if len(point.each) > 1 and contact is not None and not which:
        where.append(f"load {len(point.each)} of {len(point.each)}, a force of {told(float(contact.force), 'N')}")
    return f"<p>Shown is {safe('; '.join(where))}.</p>" if where else ""


def figure_element(one: Shown) -> str:
    """Return a figure with its caption for a page."""
    caption = f"<figcaption><h3>{safe(one.title)}</h3><p>{safe(one.sentence)}</p></figcaption>"
    if one.picture is None:
        return f'<figure>{caption}<p class="missing">Not shown: {safe(one.missing)}</p></figure>'
    drawn = figures.svg_element(one, safe(f"{one.title}. {one.sentence}"))
    # panels side by side would be too small to read in one column of the page
    kind = ' class="wide"' if one.picture.get_size_inches()[0] > WIDE else ""
    return f"<figure{kind}>{caption}{drawn}</figure>"


# --------------------------------------------------------------------------------------- formulas, trust, sources


def _formulas(outcome: Outcome) -> str:
    found = formulas_of(shown_point(outcome).problem)
    if not found:
        return section(
            "The formulas", "<p>For this problem the report knows no formulas; the papers below have them.</p>"
        )
    items = "".join(f"<li>{safe(one.says)}{formula(one.latex)}</li>" for one in found)
    return section("The formulas", f'<ol class="formulas">{items}</ol>')


def trust(notes: tuple[Note, ...]) -> str:
    """Return a section with every note, the worst first."""
    if not notes:
        return section("How far this can be trusted", "<p>The problem states nothing about its validity.</p>")
    order = list(Standing)
    ranked = sorted(notes, key=lambda note: -order.index(note.standing))
    items = "".join(
        f"<li><div>{_badge(note.standing)}</div><div>{safe(note.statement)}"
        f'<div class="source">{safe(note.assumption.value)}; {safe(note.source)}</div></div></li>'
        for note in ranked
    )
    legend = "; ".join(f"{standing.value}: {meaning}" for standing, meaning in MEANINGS.items())
    return section(
        "How far this can be trusted", f'<ul class="notes">{items}</ul>', f'<p class="small">{safe(legend)}.</p>'
    )


def papers(content: Any) -> str:
    """Return a section with the papers that a problem or study stands on; nothing if there are none."""
    items = []
    for paper in cite(content):
        text = safe(paper.text)
        if paper.doi:
            doi = safe(paper.doi)
            text = text.replace(f"doi:{doi}", f'<a href="https://doi.org/{doi}">doi:{doi}</a>')
        items.append(f"<li>{text}</li>")
    lead = "<p>If you use these numbers, cite the papers they stand on.</p>"
    return section("Papers", lead, f'<ol class="papers">{"".join(items)}</ol>') if items else ""


def _readable(text: str) -> str:
    """Return the text of a study without packed height maps, which nobody reads."""
    return re.sub(r'packed = "([^"]*)"', lambda found: f'packed = "... {len(found[1])} letters, in study.toml"', text)


def _provenance(outcome: Outcome) -> str:
    made = outcome.provenance
    rows = [
        ("winkler", made.version),
        ("study file", made.source or "made in Python"),
        ("hash of the question (SHA-256)", made.hash),
        ("created (UTC)", made.created),
        ("time taken", f"{made.seconds:.2f} s"),
        *((name, number) for name, number in made.packages if name != "winkler"),
    ]
    lines = [
        f'<tr><td>{safe(name)}</td><td class="wrap"><code>{safe(content)}</code></td></tr>' for name, content in rows
    ]
    text = (
        "<details><summary>The study as a file; it gives the same numbers again</summary>"
        f"<pre>{safe(_readable(study_text(outcome.study)))}</pre></details>"
    )
    files = f"<p class='small'>All numbers with all digits: {CSV} and {NETCDF}, beside this page.</p>"
    return section("What made these numbers", table([], lines), text, files)
