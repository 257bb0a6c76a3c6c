"""The report of a study: figures as files, and one page that holds everything and needs nothing else.

``report.html`` carries its pictures, formulas and styles inside; it opens without a network, on narrow screens and on
paper.  Everything that a reader wrote is escaped.
"""

from __future__ import annotations

import html
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from winkler.plot.series import scale_of, spoken, told
from winkler.study import figures
from winkler.study.archive import CSV, NETCDF
from winkler.study.citing import cite
from winkler.study.figures import Shown, figures_of, shown_contact, shown_point
from winkler.study.formulas import formulas_of
from winkler.study.inputs import in_words, inputs, setting_told
from winkler.study.mathml import formula, inline
from winkler.study.outcome import Column, Failed, Outcome
from winkler.study.reading import study_text
from winkler.validity import Note, Standing, worst
from winkler.vocabulary import Word

__all__ = ["REPORT", "page", "write"]

REPORT = "report.html"

ROWS = 24
"""Longer tables are cut in the middle; the CSV file holds all rows."""
CARDS = ("force", "depth", "radius", "stiffness")
"""What stands in large letters at the top, if it was answered."""

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
    title = _safe(study.title or outcome.provenance.source or "A study")
    style = (Path(__file__).parent / "report.css").read_text(encoding="utf-8")
    pictures = figures_of(outcome) if shown is None else shown
    notes = outcome.validity
    body = [
        f"<header><h1>{title}</h1>{_standing_line(outcome, worst(notes))}</header>",
        _asked(outcome),
        _answered(outcome),
        _failures(outcome),
        _verdicts(outcome),
        _pictures(outcome, pictures),
        _formulas(outcome),
        _trust(notes),
        _papers(outcome),
        _provenance(outcome),
    ]
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<meta name="generator" content="winkler {_safe(outcome.provenance.version)}">\n'
        f"<title>{title}</title>\n<style>\n{style}</style>\n</head>\n<body>\n"
        + "\n".join(body)
        + "\n</body>\n</html>\n"
    )


def _safe(text: object) -> str:
    return html.escape(str(text), quote=True)


def _section(title: str, *parts: str) -> str:
    return f"<section>\n<h2>{title}</h2>\n" + "\n".join(part for part in parts if part) + "\n</section>"


def _badge(standing: Standing) -> str:
    return f'<span class="standing {standing.value}">{standing.value}</span>'


def _standing_line(outcome: Outcome, standing: Standing) -> str:
    made = outcome.provenance
    counts = f"{len(outcome.points)} points" if len(outcome.points) > 1 else "one point"
    return (
        f"<p>{_badge(standing)} <span class='small'>{MEANINGS[standing]} (the worst of all statements on validity below). "
        f"Solved with winkler {_safe(made.version)}, {_safe(made.created[:10])}, {counts}.</span></p>"
    )


# ---------------------------------------------------------------------------------------------- asked and answered


def _asked(outcome: Outcome) -> str:
    rows, group = [], None
    for given in inputs(outcome.study):
        if given.group != group:
            group = given.group
            rows.append(f'<tr class="group"><td colspan="4">{_safe(group)}</td></tr>')
        rows.append(
            f"<tr><td>{_safe(given.name)}</td><td>{inline(given.symbol) if given.name else ''}</td>"
            f'<td class="{"value" if len(given.told) < 30 else "wrap"}">{_safe(given.told)}</td>'
            f'<td class="text small">{_safe(given.meaning if given.meaning != given.name else "")}</td></tr>'
        )
    table = (
        '<div class="scroll"><table><thead><tr><th>what</th><th></th><th>given</th><th>meaning</th></tr></thead><tbody>'
        + "".join(rows)
        + "</tbody></table></div>"
    )
    return _section("What was asked", f'<p class="lead">{_safe(in_words(outcome.study))}</p>', table)


def _answered(outcome: Outcome) -> str:
    columns = outcome.table()
    rows = len(columns[0].content)
    if rows == 1:
        return _section("What came out", _cards(outcome), _single(columns))
    cut = ""
    if rows > ROWS:
        cut = f"<p class='small'>{rows} rows, of which the first and last {ROWS // 2} are shown; {CSV} holds all.</p>"
    return _section("What came out", _many(columns, outcome), cut)


def _cards(outcome: Outcome) -> str:
    cards = []
    for name in CARDS:
        if name in outcome.answers:
            entry, number = outcome.word(name), float(outcome.answer(name).ravel()[0])
            cards.append(
                f'<div class="card"><div class="value">{_safe(told(number, entry.unit))}</div>'
                f'<div class="name">{_safe(spoken(name))} {inline(entry.symbol)}</div></div>'
            )
    return f'<div class="cards">{"".join(cards)}</div>'


def _single(columns: tuple[Column, ...]) -> str:
    rows = []
    for column in columns:
        content = column.content[0]
        text = told(float(content), column.word.unit, 7) if column.word.unit is not None else str(content)
        rows.append(
            f"<tr><td>{_safe(spoken(column.name))}</td><td>{inline(column.word.symbol)}</td>"
            f'<td class="number">{_safe(text)}</td><td class="text small">{_safe(column.word.meaning)}</td></tr>'
        )
    head = '<tr><th>answer</th><th></th><th class="number">value</th><th>meaning</th></tr>'
    return f'<div class="scroll"><table><thead>{head}</thead><tbody>{"".join(rows)}</tbody></table></div>'


def _many(columns: tuple[Column, ...], outcome: Outcome) -> str:
    swept = [axis.key for axis in outcome.study.sweep]
    given = [column.content for column in columns if column.name in swept]
    kept = [
        column
        for column in columns
        if column.name != "failure"
        and (column.name in swept or not any(_same(column.content, content) for content in given))
    ]
    heads, bodies = [], []
    for column in kept:
        name = spoken(column.name.rpartition(".")[2])
        if column.word.unit is None:
            heads.append(f"<th>{_safe(name)}</th>")
            bodies.append([f"<td>{_safe(item)}</td>" for item in column.content])
            continue
        scale = scale_of(column.word.unit, column.content)
        unit = f"<br>[{_safe(scale.unit)}]" if scale.unit else ""
        heads.append(f'<th class="number">{_safe(name)} {inline(column.word.symbol)}{unit}</th>')
        bodies.append([_cell(float(item), scale.factor) for item in column.content])
    rows = ["<tr>" + "".join(cells) + "</tr>" for cells in zip(*bodies, strict=True)]
    if len(rows) > ROWS:
        half = ROWS // 2
        rows = [*rows[:half], f'<tr class="cut"><td colspan="{len(kept)}">…</td></tr>', *rows[-half:]]
    return f'<div class="scroll"><table><thead><tr>{"".join(heads)}</tr></thead><tbody>{"".join(rows)}</tbody></table></div>'


def _same(content: np.ndarray, given: np.ndarray) -> bool:
    return content.dtype == given.dtype and bool(np.array_equal(content, given))


def _cell(number: float, factor: float) -> str:
    text = f"{number / factor:.6g}".replace("-", "−") if np.isfinite(number) else "—"
    return f'<td class="number">{text}</td>'


def _settings(outcome: Outcome, settings: Iterable[Any]) -> str:
    pairs = zip(outcome.study.sweep, settings, strict=True)
    return ", ".join(setting_told(outcome.study, axis, content) for axis, content in pairs)


def _failures(outcome: Outcome) -> str:
    if not outcome.failed:
        return ""
    items = [_failure(outcome, point) for point in outcome.failed[:ROWS]]
    more = len(outcome.failed) - ROWS
    rest = f"<p class='small'>… and {more} more; {CSV} holds all.</p>" if more > 0 else ""
    lead = f"<p>{len(outcome.failed)} of {len(outcome.points)} points have no answer:</p>"
    return _section("Points without an answer", lead, f"<ul>{''.join(items)}</ul>", rest)


def _failure(outcome: Outcome, point: Failed) -> str:
    where = _settings(outcome, point.settings)
    return f"<li>{_safe(where)}: {_safe(point.reason)}</li>" if where else f"<li>{_safe(point.reason)}</li>"


def _verdicts(outcome: Outcome) -> str:
    if not outcome.verdicts:
        return ""
    rows = []
    for verdict in outcome.verdicts:
        asked = verdict.expectation
        unit = _unit_of(asked.quantity)
        where = ", ".join(f"{name} = {told(place, 'm')}" for name, place in asked.place)
        rows.append(
            f"<tr><td>{_safe(spoken(asked.quantity))}{_safe(f' at {where}' if where else '')}</td>"
            f'<td class="number">{_safe(_some(asked.expected, unit))}</td>'
            f'<td class="number">{_safe(_some(verdict.got, unit))}</td>'
            f'<td class="number">{verdict.deviation:.2g}</td><td class="number">{asked.tolerance:.2g}</td>'
            f"<td>{'as expected' if verdict.passed else '<strong>missed</strong>'}</td></tr>"
        )
    heads = ["what", "expected", "came out", "deviation", "allowed", ""]
    head = "".join(
        f'<th class="number">{name}</th>' if 0 < place < 5 else f"<th>{name}</th>" for place, name in enumerate(heads)
    )
    table = f'<div class="scroll"><table><thead><tr>{head}</tr></thead><tbody>{"".join(rows)}</tbody></table></div>'
    return _section("What was expected", table)


def _unit_of(name: str) -> str | None:
    from winkler.vocabulary import GLOSSARY

    return GLOSSARY.get(name, Word("", "", "")).unit


def _some(content: Any, unit: str | None) -> str:
    numbers = np.ravel(np.asarray(content, dtype=float))
    return told(float(numbers[0]), unit, 7) + (f" … {told(float(numbers[-1]), unit, 7)}" if numbers.size > 1 else "")


# ------------------------------------------------------------------------------------------------------ pictures


def _pictures(outcome: Outcome, shown: tuple[Shown, ...]) -> str:
    answers = [one for one in shown if not one.of_method]
    method = [one for one in shown if one.of_method]
    parts = []
    if answers:
        parts.append(_section("The answers as curves", f'<div class="figures">{"".join(map(_figure, answers))}</div>'))
    if method:
        figures_ = "".join(map(_figure, method))
        parts.append(_section("The method in pictures", _which(outcome), f'<div class="figures">{figures_}</div>'))
    if shown_contact(shown_point(outcome)) is None:
        asked = type(shown_point(outcome).problem).__name__
        sentence = (
            f"There are no pictures of the method for {asked}: its answer does not tell how the springs are pressed."
        )
        parts.append(_section("The method in pictures", f'<p class="missing">{_safe(sentence)}</p>'))
    return "\n".join(parts)


def _which(outcome: Outcome) -> str:
    point = shown_point(outcome)
    contact = shown_contact(point)
    where = [_settings(outcome, point.settings)] if outcome.study.sweep else []
    if len(point.each) > 1 and contact is not None:
        where.append(f"load {len(point.each)} of {len(point.each)}, a force of {told(float(contact.force), 'N')}")
    return f"<p>Shown is {_safe('; '.join(where))}.</p>" if where else ""


def _figure(one: Shown) -> str:
    caption = f"<figcaption><h3>{_safe(one.title)}</h3><p>{_safe(one.sentence)}</p></figcaption>"
    if one.picture is None:
        return f'<figure>{caption}<p class="missing">Not shown: {_safe(one.missing)}</p></figure>'
    drawn = figures.svg_element(one, _safe(f"{one.title}. {one.sentence}"))
    return f"<figure>{caption}{drawn}</figure>"


# --------------------------------------------------------------------------------------- formulas, trust, sources


def _formulas(outcome: Outcome) -> str:
    found = formulas_of(shown_point(outcome).problem)
    if not found:
        return _section(
            "The formulas", "<p>For this problem the report knows no formulas; the papers below have them.</p>"
        )
    items = "".join(f"<li>{_safe(one.says)}{formula(one.latex)}</li>" for one in found)
    return _section("The formulas", f'<ol class="formulas">{items}</ol>')


def _trust(notes: tuple[Note, ...]) -> str:
    if not notes:
        return _section("How far this can be trusted", "<p>The problem states nothing about its validity.</p>")
    order = list(Standing)
    ranked = sorted(notes, key=lambda note: -order.index(note.standing))
    items = "".join(
        f"<li><div>{_badge(note.standing)}</div><div>{_safe(note.statement)}"
        f'<div class="source">{_safe(note.source)}</div></div></li>'
        for note in ranked
    )
    legend = "; ".join(f"{standing.value}: {meaning}" for standing, meaning in MEANINGS.items())
    return _section(
        "How far this can be trusted", f'<ul class="notes">{items}</ul>', f'<p class="small">{_safe(legend)}.</p>'
    )


def _papers(outcome: Outcome) -> str:
    items = []
    for paper in cite(outcome.study):
        text = _safe(paper.text)
        if paper.doi:
            doi = _safe(paper.doi)
            text = text.replace(f"doi:{doi}", f'<a href="https://doi.org/{doi}">doi:{doi}</a>')
        items.append(f"<li>{text}</li>")
    lead = "<p>If you use these numbers, cite the papers they stand on.</p>"
    return _section("Papers", lead, f'<ol class="papers">{"".join(items)}</ol>') if items else ""


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
    table = "".join(
        f'<tr><td>{_safe(name)}</td><td class="wrap"><code>{_safe(content)}</code></td></tr>' for name, content in rows
    )
    text = f"<details><summary>The study as a file; it gives the same numbers again</summary><pre>{_safe(study_text(outcome.study))}</pre></details>"
    files = f"<p class='small'>All numbers with all digits: {CSV} and {NETCDF}, beside this page.</p>"
    return _section(
        "What made these numbers", f'<div class="scroll"><table><tbody>{table}</tbody></table></div>', text, files
    )
