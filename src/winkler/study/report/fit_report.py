"""The report of fits: figures as files, and one page with everything that produced the numbers."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from winkler.fitting.outcome import CreepFit, Fit
from winkler.media.relaxing.layered import ViscoelasticCoatedHalfSpace
from winkler.plot.fitting.fits import Grid, map_sheet, numbers_sheet
from winkler.plot.registered import sheet_of_kind
from winkler.plot.series import Series, name_in_words
from winkler.problems.normal.indentation import Indentation
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.study.batch.fit_outcome import FitOutcome, Fitted, Refused
from winkler.study.batch.fit_recording import path_from_study
from winkler.study.batch.fit_run import measured_curve
from winkler.study.chapters.contents import formulas_of
from winkler.study.language.fit_study import FitStudy, Free
from winkler.study.language.study import Study
from winkler.study.report import page_parts as parts
from winkler.study.report.describe import inputs
from winkler.study.report.examined.sections import further_figures, further_section
from winkler.study.report.figure import ReportFigure, drawn
from winkler.study.report.fit_tables import MOST_ROWS, answers, batch_section, counts, doubts, failures
from winkler.study.report.fit_writing import CSV, MAPS, MOST_CURVES_AS_TEXT, NETCDF, map_grid
from winkler.study.report.fits.pages import curve_facts, noise_figure
from winkler.study.report.markup import assumed_line, safe, section, table
from winkler.study.report.mathml import formula
from winkler.study.report.tables import given_rows
from winkler.study.report.thumbnails import ThumbnailOf, thumbnails_section
from winkler.values.readable import with_unit

MOST_CURVES_DRAWN = 12
"""Curves that are drawn, spread evenly over all."""
MOST_MEASURED_DRAWN = 3
"""Curves that are also drawn as they were measured, with what was done: the first ones."""
MOST_READINGS = 12
"""How many different readings of files are listed."""
PLACEHOLDERS = ("load", "path", "normal", "lateral")
"""Parts of a model that its curve replaces."""
LEAST_SHOWN_TOGETHER = 3
"""Number of curves from which their numbers are shown together."""


def _series(study: FitStudy, free: Free, content: np.ndarray) -> Series:
    return Series(free.label, study.word(free.key), content)


def figures_of(outcome: FitOutcome) -> tuple[ReportFigure, ...]:
    """Return the figures: maps, the numbers of many curves, then single curves with their models."""
    return (*figures_of_many(outcome), *further_figures(outcome), *figures_of_curves(outcome))


def figures_of_many(outcome: FitOutcome) -> Iterator[ReportFigure]:
    """Yield maps and the numbers of many curves; nothing of few."""
    study = outcome.study
    grid = map_grid(outcome)
    many = len(outcome.fitted) >= LEAST_SHOWN_TOGETHER
    for free in study.free if many else ():
        of = _series(study, free, outcome.numbers(free))
        stem = _stem(free)
        if isinstance(grid, Grid):
            sentence = "Over the sample; grey where a curve has no answer."
            yield drawn(f"map_{stem}", f"Map: {name_in_words(of.name)}", sentence, map_sheet(grid, of))
        sentence = "Every curve with its standard error, and how often each value occurs."
        yield drawn(
            f"all_{stem}", f"All curves: {name_in_words(of.name)}", sentence, numbers_sheet(of, outcome.errors(free))
        )


def figures_of_curves(outcome: FitOutcome) -> Iterator[ReportFigure]:
    """Yield single curves with their models, spread evenly over all."""
    chosen = np.unique(np.linspace(0, len(outcome.fitted) - 1, min(MOST_CURVES_DRAWN, len(outcome.fitted))).astype(int))
    for place in chosen.tolist():
        result = outcome.fitted[place]
        sentence = "Above the curve and the fitted model, below what is left over; dashed: first touch."
        if not isinstance(result.fit, Fit):
            sentence = (
                "Left the curve and the fitted model over time, below what is left over; right the force over the "
                "depth, and the relaxation with its 95 % interval, grey where the curve does not determine it."
            )
        number = outcome.results.index(result) + 1
        yield drawn(f"curve_{number}", result.name, sentence, sheet_of_kind(result.fit))
        if place in chosen[:MOST_MEASURED_DRAWN]:
            curve = measured_curve(outcome.study, result)
            events = " ".join(f"{line}." for line in curve.events.lines(curve.time if curve.timed else ()))
            yield drawn(f"measured_{number}", f"{result.name}: what was done", events, sheet_of_kind(curve))
    if len(outcome.results) == 1:
        yield noise_figure(outcome.fitted[0])


def _stem(free: Free) -> str:
    return free.key.removeprefix("problem.").replace(".", "_")


def page(outcome: FitOutcome, shown: tuple[ReportFigure, ...] | None = None, *, assumed: str = "") -> str:
    """Return the report as one HTML page with its figures, drawn if left out; `assumed` says what nobody has given."""
    study = outcome.study
    shown = figures_of(outcome) if shown is None else shown
    title = safe(study.title or outcome.provenance.source or "Fits")
    body = [
        f"<header><h1>{title}</h1>{counts(outcome)}{assumed_line(assumed)}</header>",
        answers(outcome),
        further_section(outcome),
        batch_section("All curves", outcome.batch, outcome.doubts, CSV) if len(outcome.results) > 1 else "",
        doubts(outcome),
        failures(outcome),
        thumbnails_section([_thumbnail(one) for one in outcome.results]),
        section("Figures", parts.figure_elements(shown)) if shown else "",
        curve_facts(outcome, outcome.fitted[0]) if len(outcome.results) == 1 else "",
        _question(outcome),
        steps(outcome),
        _formulas(study),
        parts.trust(outcome.validity),
        parts.papers(study.problem),
        _made(outcome),
        parts.code_section(study, outcome.provenance.source or "study.toml"),
    ]
    return parts.framed(title, outcome.provenance.version, body)


def _thumbnail(result: Fitted | Refused) -> ThumbnailOf:
    """Return what is drawn of a curve: force over position, of bodies that relax force or position over time."""
    if isinstance(result, Refused):
        return ThumbnailOf((), result.name, "no answer", answered=False)
    fit = result.fit
    along = fit.curve.position if isinstance(fit, Fit) else fit.curve.time
    measured = fit.curve.position if isinstance(fit, CreepFit) else fit.curve.force
    flags = ", ".join(flag.name for flag in fit.flags)
    return ThumbnailOf(((along, measured), (along, fit.predicted)), result.name, flags)


def _question(outcome: FitOutcome) -> str:
    study = outcome.study
    rows = []
    for free in study.free:
        unit = study.word(free.key).unit
        match free.given:
            case (low, high):
                limits = f"between {with_unit(low, unit)} and {with_unit(high, unit)}"
            case (start,):
                limits = f"starting at {with_unit(start, unit)}"
            case _:
                limits = "without bounds"
        rows.append(f"<tr><td>{safe(free.key)}</td><td>free</td><td>{safe(limits)}</td><td></td></tr>")
    relaxing = isinstance(study.problem, ViscoelasticIndentation)
    rows += given_rows(
        given
        for given in inputs(Study("", study.problem))
        if not given.group.startswith(PLACEHOLDERS)
        and not (relaxing and given.group == "viscoelastic indentation")  # springs
    )
    lead = (
        f"<p>{safe(_in_words(study))} The table holds the model as it was given; of the {len(study.free)} free numbers "
        "these are the values before the fit.</p>"
    )
    return section("The problem", lead, table(["what", "", "given", "meaning"], rows))


def _in_words(study: FitStudy) -> str:
    relaxing = isinstance(study.problem, ViscoelasticIndentation)
    motions = {
        "approach": "the approach",
        "hold": "the approach with the hold",
        "retract": "the retraction",
        "both": "the approach, the hold and the retraction"
        if relaxing
        else "approach and retraction, held points left out,",
    }
    many = f"{len(study.sources)} files" if len(study.sources) != 1 else Path(study.sources[0]).name
    facts = [f"Of {many}, {motions[study.part]} was fitted."]
    if study.fitted == "position":
        facts.append("The measured forces drive the contact, and the positions were fitted.")
    if study.spring_constant:
        facts.append(
            f"The spring constant {with_unit(study.spring_constant, 'N/m')} was given, not read from the files."
        )
    if study.sensitivity:
        facts.append(f"The sensitivity {with_unit(study.sensitivity, 'm/V')} was given.")
    for word, error in (("spring constant", study.spring_constant_error), ("sensitivity", study.sensitivity_error)):
        if error:
            facts.append(f"The standard error of the {word} is {error:.2%}.")
    if study.noise:
        facts.append(f"The noise {with_unit(study.noise, study.spread.unit)} was given.")
    if study.noise_spectrum == "white":
        facts.append("The noise was stated to be white; intervals do not allow for slow noise.")
    return " ".join(facts)


def steps(outcome: FitOutcome) -> str:
    """Return the corrections of the curves before the fit."""
    study = outcome.study
    readings = _readings(outcome)
    if not any(result.steps for result in outcome.fitted):
        nothing = "<p>Nothing: they were fitted as they were measured.</p>"
        return section("Corrections of the curves", nothing, readings)
    first = outcome.fitted[0]
    of_many = f"<p>In this order; the numbers are those of {safe(first.name)}.</p>" if len(outcome.fitted) > 1 else ""
    items = "".join(f"<li>{safe(step)}</li>" for step in first.steps)
    order = f"<p class='small'>correct = {safe(list(study.correct))}</p>"
    return section("Corrections of the curves", of_many, f"<ol>{items}</ol>", order, readings)


def _readings(outcome: FitOutcome) -> str:
    """Return how the files were read, each reading once with the curves that share it."""
    shared: dict[str, list[str]] = {}
    for result in outcome.fitted:
        if result.fit.curve.reading:
            shared.setdefault(result.fit.curve.reading, []).append(result.name)
    if not shared:
        return ""
    rows = [
        f"<li>{safe(names[0])}{f' and {len(names) - 1} more' if len(names) > 1 else ''}: {safe(reading)}</li>"
        for reading, names in list(shared.items())[:MOST_READINGS]
    ]
    if left := len(shared) - len(rows):
        rows.append(f"<li>{left} more.</li>")
    return f"<p>How the files were read:</p><ul>{''.join(rows)}</ul>"


RELAXING_FORMULAS = {
    "force": (
        r"d = D - D_0 - u\,t - \frac{F}{k_m}, \quad F = \int_0^{t_1} E^*(t-s)\,\mathrm{d}\Phi(d(s)), \quad "
        r"F_i = F(t_i) + F_0 + t\,(D_i-D_0) + c_v\dot{D}_i + e_i",
        "The measured motion drives, and the forces F are fitted; Φ(d) is the force of an elastic contact with E* = 1 "
        "Pa. While the contact grows, t<sub>1</sub> = t; while it shrinks, nothing pressed since t<sub>1</sub> "
        "bears: the integral of E*(t − s) dd(s) from t<sub>1</sub> to t vanishes (Ting).",
    ),
    "position": (
        r"\Phi(d) = \int_0^{t} C(t-s)\,\mathrm{d}F(s), \quad D_i = D_0 + u\,t_i + d(t_i) + \frac{F_i}{k_m} + e_i",
        "The measured forces F, less the baseline, drive a contact that grows, and the positions D are fitted; Φ(d) is "
        "the force of an elastic contact with E* = 1 Pa, and C(t) the creep.",
    ),
    "layers": (
        r"u_\xi(t) = \int_0^t c(\xi,t-s)\,\mathrm{d}q_\xi(s), \quad u(x,t) = d(t) - h(x), \quad "
        r"F = 2\int_0^a q\,\mathrm{d}x, \quad d = D - D_0 - \frac{F}{k_m}",
        "Every wave of the line load q moves its own wave of the displacement u, by the creep c(ξ, t) of the stack; h "
        "is the shape of the body. The measured motion or the measured forces drive, and the other one is fitted.",
    ),
}
"""The fitted quantity of a body that relaxes, as a formula and in words."""


def _noise(study: FitStudy) -> str:
    return "white noise" if study.noise_spectrum == "white" else "white and slow noise"


def _formulas(study: FitStudy) -> str:
    if isinstance(study.problem, ViscoelasticIndentation):
        layered = isinstance(study.problem.bed.medium, ViscoelasticCoatedHalfSpace)
        latex, words = RELAXING_FORMULAS["layers" if layered else study.fitted]
        tail = f"Generalised least squares make the residuals e small; the uncertainty is that under {_noise(study)}."
        return section("The formulas", f"<p>{words} {tail}</p>", formula(latex))
    formulas = formulas_of(study.problem) if isinstance(study.problem, Indentation) else ()  # without adhesion g(a) = d
    lead = formula(r"d = D - D_0 - \frac{F}{k_m}, \quad F_i = F(d_i) + F_0 + t\,(D_i-D_0) + e_i")
    text = (
        "<p>The machine of the stiffness k<sub>m</sub> deforms; generalised least squares make the residuals e small, "
        f"and the uncertainty is that under {_noise(study)}.</p>"
    )
    return section("The formulas", text, lead, parts.formula_list(formulas))


def _made(outcome: FitOutcome) -> str:
    study = outcome.study
    sources = ", ".join(path_from_study(study, path) for path in study.sources[:MOST_ROWS])
    grid = f", {MAPS} (maps)" if isinstance(map_grid(outcome), Grid) else ""
    return parts.origin(
        outcome.provenance,
        "the study with its curves",
        f"<p class='small'>Curves: {safe(sources)}</p>",
        parts.folded("The study file, word for word", study.text) if study.text else "",
        f"<p class='small'>All values with all digits: {CSV}, {NETCDF} (with every curve, model and residual){grid}, "
        f"and as text the first {MOST_CURVES_AS_TEXT} curves in the folder curves, beside this page.</p>",
    )
