"""Common parts of the pages of reports: frame, figures, formulas, papers, validity notes, and provenance.

A page carries its pictures, formulas and styles inside; it opens without a network, on narrow screens and on paper.
All texts of a user are escaped.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from winkler.study.batch.outcome import Provenance
from winkler.study.chapters.answer import Equation
from winkler.study.language.study import Study
from winkler.study.report.citing import cite
from winkler.study.report.figure import ReportFigure, figure_files, svg_element
from winkler.study.report.headline.as_code import command_text, python_text
from winkler.study.report.markup import badge, safe, section, table
from winkler.study.report.mathml import formula
from winkler.values.readable import with_readable_numbers
from winkler.values.validity import Note, Standing

if TYPE_CHECKING:
    from winkler.study.language.fit_study import FitStudy

WIDE_FIGURE = 504.0
"""Width [pt] above which figures, panels side by side, take both columns of the page."""
REPORT = "report.html"


def page_files(
    outcome: Any, shown: tuple[ReportFigure, ...], page: Callable[[Any, tuple[ReportFigure, ...]], str]
) -> dict[str, bytes]:
    """Return figures, and the page that shows them, as the study of an outcome asks: name -> content."""
    files = figure_files(shown, outcome.study.output.figures)
    return files | {REPORT: page(outcome, shown).encode("utf-8")} if outcome.study.output.report else files


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


def figure_elements(shown: Iterable[ReportFigure]) -> str:
    """Return figures with their captions for a page."""
    return f'<div class="figures">{"".join(map(_figure_element, shown))}</div>'


def _figure_element(one: ReportFigure) -> str:
    caption = f"<figcaption><h3>{safe(one.title)}</h3><p>{safe(one.sentence)}</p></figcaption>"
    if one.drawing is None:
        return f'<figure>{caption}<p class="missing">Not shown: {safe(one.missing)}</p></figure>'
    drawn = svg_element(one, safe(f"{one.title}. {one.sentence}"))
    # panels side by side would be too small to read in one column of the page
    kind = ' class="wide"' if one.drawing.width > WIDE_FIGURE else ""
    return f"<figure{kind}>{caption}{drawn}</figure>"


def formula_list(formulas: Iterable[Equation]) -> str:
    """Return formulas with their sentences; nothing if there are none."""
    items = "".join(f"<li>{safe(one.says)}{formula(one.latex)}</li>" for one in formulas)
    return f'<ol class="formulas">{items}</ol>' if items else ""


def trust(notes: tuple[Note, ...], questions: tuple[str, ...] = ()) -> str:
    """Return a section with questions about unlikely numbers, and with every note, the worst first."""
    asked = "".join(f'<p class="question">{safe(question)}</p>' for question in questions)
    if not notes:
        return section("How far this can be trusted", f"{asked}<p>The problem states nothing about its validity.</p>")
    order = list(Standing)
    ranked = sorted(notes, key=lambda note: -order.index(note.standing))
    items = "".join(
        f"<li><div>{badge((note,))}</div><div>{safe(with_readable_numbers(note.statement))}"
        f'<div class="source">{safe(note.assumption.value)}; {safe(note.source)}</div></div></li>'
        for note in ranked
    )
    return section("How far this can be trusted", asked, f'<ul class="notes">{items}</ul>')


def papers(content: Any) -> str:
    """Return a section with the papers on which a problem or study is based; nothing if there are none."""
    items = []
    for paper in cite(content):
        text = safe(paper.text)
        if paper.doi:
            doi = safe(paper.doi)
            text = text.replace(f"doi:{doi}", f'<a href="https://doi.org/{doi}">doi:{doi}</a>')
        items.append(f"<li>{text}</li>")
    lead = "<p>If you use these results, cite the papers on which they are based.</p>"
    return section("Papers", lead, f'<ol class="papers">{"".join(items)}</ol>') if items else ""


def origin(made: Provenance, hashed: str, *parts: str) -> str:
    """Return a section with the provenance of the numbers; `hashed` names the content of the hash."""
    rows = [
        ("winkler", f"{made.version}, sources {made.sources}"),
        ("study file", made.source or "made in Python"),
        (f"hash of {hashed} (SHA-256)", made.hash),
        ("created (UTC)", made.created),
        ("time taken", f"{made.seconds:.2f} s"),
        *((name, number) for name, number in made.packages if name != "winkler"),
    ]
    lines = [
        f'<tr><td>{safe(name)}</td><td class="wrap"><code>{safe(content)}</code></td></tr>' for name, content in rows
    ]
    return section("Version and origin of the results", table([], lines), *parts)


def code_section(study: Study | FitStudy, name: str) -> str:
    """Return a section with a study or a fit as Python and as commands; `name` is that of its file."""
    return section(
        "The same results elsewhere",
        folded("As Python", python_text(study, name)),
        folded("As commands in a terminal", command_text(name, fits=not isinstance(study, Study))),
    )


def folded(summary: str, text: str) -> str:
    """Return a text that a page shows when its summary is clicked."""
    return f"<details><summary>{summary}</summary><pre>{safe(text)}</pre></details>"
