"""The report of fits: figures as files, and one page with everything that produced the numbers."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from winkler.plot.fits import Grid, fit_picture, map_picture, numbers_picture
from winkler.plot.series import Series, spoken, told
from winkler.problems.indentation import Indentation
from winkler.study import figures
from winkler.study.figures import Shown, drawn
from winkler.study.fit_outcome import FitOutcome
from winkler.study.fit_run import seen_from
from winkler.study.fit_tables import ROWS, answers, counts, doubts, failures
from winkler.study.fit_writing import CSV, FEW, MAPS, NETCDF, map_grid
from winkler.study.fitting import FitStudy, Free
from winkler.study.formulas import formulas_of
from winkler.study.inputs import inputs
from winkler.study.markup import safe, section, table
from winkler.study.mathml import formula, symbol
from winkler.study.report import REPORT, figure_element, framed, papers, trust
from winkler.study.study import Study

__all__ = ["figures_of_fits", "page", "write"]

DRAWN = 12
"""So many curves are drawn, spread evenly over all."""
MANY = 3
"""From so many curves on, their numbers are shown together."""


def write(outcome: FitOutcome, folder: Path) -> None:
    """Write the figures of fits into ``folder/figures``, and the report into ``report.html``, as the study asks."""
    shown = tuple(figures_of_fits(outcome))
    figures.save(shown, folder, outcome.study.output.figures)
    if outcome.study.output.report:
        (folder / REPORT).write_text(page(outcome, shown), encoding="utf-8")


def _series(study: FitStudy, free: Free, content: np.ndarray) -> Series:
    return Series(free.key.rpartition(".")[2], study.word(free.key), content)


def figures_of_fits(outcome: FitOutcome) -> Iterator[Shown]:
    """Yield the figures: maps, the numbers of many curves, then single curves with their models."""
    study = outcome.study
    grid = map_grid(outcome)
    many = len(outcome.fitted) >= MANY
    for free in study.free if many else ():
        of = _series(study, free, outcome.numbers(free))
        stem = _stem(free)
        if isinstance(grid, Grid):
            sentence = "Over the sample; grey where a curve has no answer."
            yield drawn(f"map_{stem}", f"Map: {spoken(of.name)}", sentence, map_picture(grid, of))
        sentence = "Every curve with its standard error, and how often each value occurs."
        yield drawn(
            f"all_{stem}", f"All curves: {spoken(of.name)}", sentence, numbers_picture(of, outcome.errors(free))
        )
    chosen = np.unique(np.linspace(0, len(outcome.fitted) - 1, min(DRAWN, len(outcome.fitted))).astype(int))
    for place in chosen.tolist():
        result = outcome.fitted[place]
        sentence = "Above the curve and the fitted model, below what is left over; dashed: first touch."
        yield drawn(f"curve_{outcome.results.index(result) + 1}", result.name, sentence, fit_picture(result.fit))


def _stem(free: Free) -> str:
    return free.key.removeprefix("problem.").replace(".", "_")


def page(outcome: FitOutcome, shown: tuple[Shown, ...]) -> str:
    """Return the report as one HTML page with its figures."""
    study = outcome.study
    title = safe(study.title or outcome.provenance.source or "Fits")
    body = [
        f"<header><h1>{title}</h1>{counts(outcome)}</header>",
        answers(outcome),
        doubts(outcome),
        failures(outcome),
        section("Figures", f'<div class="figures">{"".join(map(figure_element, shown))}</div>') if shown else "",
        _asked(outcome),
        _steps(outcome),
        _formulas(study),
        trust(outcome.validity),
        papers(study.problem),
        _made(outcome),
    ]
    return framed(title, outcome.provenance.version, body)


def _asked(outcome: FitOutcome) -> str:
    study = outcome.study
    rows = []
    for free in study.free:
        unit = study.word(free.key).unit
        match free.given:
            case (low, high):
                limits = f"between {told(low, unit)} and {told(high, unit)}"
            case (start,):
                limits = f"starting at {told(start, unit)}"
            case _:
                limits = "without bounds"
        rows.append(f"<tr><td>{safe(free.key)}</td><td>free</td><td>{safe(limits)}</td><td></td></tr>")
    group, free_ones = None, {free.key for free in study.free}
    for given in inputs(Study("", study.problem)):
        if given.group.startswith("load"):
            continue
        if given.group != group:
            group = given.group
            rows.append(f'<tr class="group"><td colspan="4">{safe(group)}</td></tr>')
        rows.append(
            f"<tr><td>{safe(given.name)}</td><td>{symbol(given.symbol) if given.name else ''}</td>"
            f'<td class="wrap">{safe(given.told)}</td><td class="text small">{safe(given.meaning)}</td></tr>'
        )
    lead = (
        f"<p>{safe(_in_words(study))} The table holds the model as it was given; of the {len(free_ones)} free numbers "
        "these are the values before the fit.</p>"
    )
    return section("What was asked", lead, table(["what", "", "given", "meaning"], rows))


def _in_words(study: FitStudy) -> str:
    parts = {"approach": "the way in", "retract": "the way out", "both": "both ways, held points left out,"}
    many = f"{len(study.sources)} files" if len(study.sources) != 1 else Path(study.sources[0]).name
    facts = [f"Of {many}, {parts[study.part]} was fitted."]
    if study.spring_constant:
        facts.append(f"The spring constant {told(study.spring_constant, 'N/m')} was given, not taken from the files.")
    if study.sensitivity:
        facts.append(f"The sensitivity {told(study.sensitivity, 'm/V')} was given.")
    if study.noise:
        facts.append(f"The noise {told(study.noise, 'N')} was given.")
    return " ".join(facts)


def _steps(outcome: FitOutcome) -> str:
    """Return what was done to the curves before they were fitted."""
    study = outcome.study
    if not any(result.steps for result in outcome.fitted):
        return section("What was done to the curves", "<p>Nothing: they were fitted as they were measured.</p>")
    first = outcome.fitted[0]
    of_many = f"<p>In this order; the numbers are those of {safe(first.name)}.</p>" if len(outcome.fitted) > 1 else ""
    items = "".join(f"<li>{safe(step)}</li>" for step in first.steps)
    order = f"<p class='small'>correct = {safe(list(study.correct))}</p>"
    return section("What was done to the curves", of_many, f"<ol>{items}</ol>", order)


def _formulas(study: FitStudy) -> str:
    found = formulas_of(study.problem) if isinstance(study.problem, Indentation) else ()  # without adhesion g(a) = d
    items = "".join(f"<li>{safe(one.says)}{formula(one.latex)}</li>" for one in found)
    lead = formula(r"d = D - D_0 - \frac{F}{k_m}, \quad F_i = F(d_i) + F_0 + t\,(D_i-D_0) + e_i")
    text = (
        "<p>The machine of the stiffness k<sub>m</sub> gives way; least squares make the residuals e small, and their "
        "own memory tells how sure the numbers are.</p>"
    )
    return section("The formulas", text, lead, f'<ol class="formulas">{items}</ol>' if items else "")


def _made(outcome: FitOutcome) -> str:
    made = outcome.provenance
    rows = [
        ("winkler", made.version),
        ("study file", made.source or "made in Python"),
        ("hash of the question with its curves (SHA-256)", made.hash),
        ("created (UTC)", made.created),
        ("time taken", f"{made.seconds:.2f} s"),
        *((name, number_) for name, number_ in made.packages if name != "winkler"),
    ]
    lines = [f'<tr><td>{safe(name)}</td><td class="wrap"><code>{safe(text)}</code></td></tr>' for name, text in rows]
    sources = ", ".join(seen_from(outcome.study, path) for path in outcome.study.sources[:ROWS])
    parts = [table([], lines), f"<p class='small'>Curves: {safe(sources)}</p>"]
    if outcome.study.text:
        parts.append(
            f"<details><summary>The study file, word for word</summary><pre>{safe(outcome.study.text)}</pre></details>"
        )
    grid = f", {MAPS} (maps)" if isinstance(map_grid(outcome), Grid) else ""
    parts.append(
        f"<p class='small'>All numbers with all digits: {CSV}, {NETCDF} (with every curve, model and residual){grid}, "
        f"and as text the first {FEW} curves in the folder curves, beside this page.</p>"
    )
    return section("What made these numbers", *parts)
