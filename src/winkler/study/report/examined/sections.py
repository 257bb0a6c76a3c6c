"""Sections, figures and files of fits that were examined further.

::

    depths.csv     a number over the greatest fitted depth, one row per curve and depth
    models.csv     one row per curve and model: criteria, misfit, and the numbers of the model
    shared.csv     one row per curve: what it alone says of the shared numbers, and its part of the information
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import numpy as np

from winkler.fitting.compare import LEAST_DIFFERENCE
from winkler.plot.fitting.examined import comparison_sheet, depth_sheet, shared_sheet
from winkler.plot.series import name_in_words
from winkler.study.batch.fit_further import compared
from winkler.study.batch.fit_outcome import FitOutcome, Fitted
from winkler.study.batch.outcome import ResultColumn
from winkler.study.language.fit_study import FitStudy, Free, word_of
from winkler.study.report.archive import table_file
from winkler.study.report.examined.sentences import further_sentences
from winkler.study.report.figure import ReportFigure, drawn
from winkler.study.report.markup import number, safe, section, table
from winkler.values.errors import WinklerError
from winkler.values.readable import with_unit
from winkler.values.vocabulary import Word

MOST_DRAWN = 4
"""Curves of which depths and models are drawn."""
MOST_ROWS = 40


def further_section(outcome: FitOutcome) -> str:
    """Return the section of what else the curves say; empty if there is nothing."""
    items = "".join(f"<li>{safe(sentence)}</li>" for sentence in further_sentences(outcome))
    if not items:
        return ""
    tables = [_models(outcome), _shared(outcome)]
    return section("More from the curves", f"<ul>{items}</ul>", *tables)


def _models(outcome: FitOutcome) -> str:
    if not outcome.study.models:
        return ""
    rows = []
    for result in outcome.fitted:
        comparison = compared(outcome.study, result.fit, result.further)
        possible = comparison.possible
        for place, (name, one) in enumerate(zip(comparison.models, comparison.fits, strict=True)):
            free = _free_of(outcome.study, name)
            texts = [f"{label} = {with_unit(one.value(path), unit, 4)}" for path, label, unit in free]
            flags = ", ".join(flag.name for flag in one.flags)
            aic, bic = (float(criterion[place] - criterion.min()) for criterion in (comparison.aic, comparison.bic))
            rows.append(
                f"<tr><td>{safe(result.name)}</td><td>{safe(name)}</td>"
                f"<td>{'possible' if name in possible else 'excluded'}</td>{number(f'{aic:.1f}')}"
                f"{number(f'{bic:.1f}')}{number(f'{one.chi_square_in_contact:.3g}')}<td>{safe(', '.join(texts))}</td>"
                f"<td>{safe(flags)}</td></tr>"
            )
    heads = ["curve", "model", "", "#AIC", "#BIC", "#χ² in contact", "numbers", "flags"]
    lead = (
        "<p class='small'>Criteria above the least one, by the likelihood under white and slow noise; a model is "
        f"excluded from {LEAST_DIFFERENCE:g} on, in both; if the best does not explain the curve, none is possible.</p>"
    )
    return table(heads, rows[:MOST_ROWS]) + lead


def _free_of(study: FitStudy, name: str) -> list[tuple[str, str, str | None]]:
    """Return path, label and unit of the free numbers of a model."""
    problem, free = study.problem, study.free
    for other in study.models:
        if other.name == name:
            problem, free = other.problem, other.free
    own = [one for one in free if one.key.startswith("problem.")]
    return [(one.path, one.label, word_of(problem, one.key).unit) for one in own]


def _shared(outcome: FitOutcome) -> str:
    if not outcome.joint:
        return ""
    joint, keys = outcome.joint[0], {free.path: free for free in outcome.study.free}
    heads, bodies = ["#number", "curve"], []
    for place, name in enumerate(joint.names):
        unit = outcome.study.word(keys[name].key).unit
        heads += [f"#{safe(keys[name].label)} by this curve alone", "#standard error", "#part of the information"]
        bodies.append((place, unit))
    heads.append("#chance to differ more")
    rows = []
    for index, result in enumerate(outcome.independent[:MOST_ROWS]):
        cells = [number(str(index + 1)), f"<td>{safe(result.name)}</td>"]
        for place, unit in bodies:
            cells += [
                number(safe(with_unit(float(joint.single_values[index, place]), unit, 4))),
                number(safe(with_unit(float(joint.single_errors[index, place]), unit, 2))),
                number(f"{joint.shares[index, place]:.1%}"),
            ]
        rows.append(f"<tr>{''.join(cells)}{number(f'{joint.chances[index]:.2g}')}</tr>")
    return table(heads, rows)


def further_figures(outcome: FitOutcome) -> Iterator[ReportFigure]:
    """Yield shared numbers, then depths and models of the first curves."""
    study = outcome.study
    keys = {free.path: free for free in study.free}
    names = tuple(result.name for result in outcome.independent)
    for joint in outcome.joint:
        for place, path in enumerate(joint.names):
            free = keys[path]
            sheet = shared_sheet(joint, place, names, name_in_words(free.label), study.word(free.key))
            title = f"Shared: {name_in_words(free.label)}"
            yield drawn(f"shared_{_stem(free)}", title, "What each curve alone says, and all together.", sheet)
    shown = [result for result in outcome.fitted if result.further.depths or result.further.fits]
    for result in shown[:MOST_DRAWN]:
        yield from _of_curve(outcome, result)


def _of_curve(outcome: FitOutcome, result: Fitted) -> Iterator[ReportFigure]:
    study, index = outcome.study, outcome.results.index(result) + 1
    for series in result.further.depths:
        free = study.own_numbers[0]
        sheet = depth_sheet(series, name_in_words(free.label), study.word(free.key))
        sentence = f"Fitted up to each depth: {series.verdict}."
        yield drawn(f"depth_{index}", f"Over depth: {result.name}", sentence, sheet)
    if result.further.fits:
        try:
            comparison = compared(study, result.fit, result.further)
            sheet = comparison_sheet(comparison)
        except WinklerError:
            return
        yield drawn(f"models_{index}", f"Models: {result.name}", comparison.verdict, sheet)


def _stem(free: Free) -> str:
    return free.key.removeprefix("problem.").replace(".", "_")


def further_files(outcome: FitOutcome) -> dict[str, bytes]:
    """Return the tables of depths, models and shared numbers, where there are any: name -> content."""
    tables = {
        "depths.csv": _depth_columns if any(result.further.depths for result in outcome.fitted) else None,
        "models.csv": _model_columns if outcome.study.models else None,
        "shared.csv": _shared_columns if outcome.joint else None,
    }
    return {name: table_file(columns(outcome), nothing="") for name, columns in tables.items() if columns is not None}


TEXT = Word("", None, "")


def _depth_columns(outcome: FitOutcome) -> list[ResultColumn]:
    free = outcome.study.own_numbers[0]
    word = outcome.study.word(free.key)
    each = [(result.name, series) for result in outcome.fitted for series in result.further.depths]
    names = np.array([name for name, series in each for _ in series.depths])
    parts = {
        "depth": (Word("d", "m", "greatest fitted depth"), "depths"),
        "force": (Word("F_N", "N", "greatest fitted force"), "forces"),
        free.key: (word, "values"),
        f"{free.key}_error": (word._replace(meaning="standard error"), "standard_errors"),
        f"{free.key}_low": (word._replace(meaning="lower end of the 95 % interval"), "lows"),
        f"{free.key}_high": (word._replace(meaning="upper end of the 95 % interval"), "highs"),
    }
    columns = [
        ResultColumn(name, own, np.concatenate([getattr(series, field) for _, series in each]))
        for name, (own, field) in parts.items()
    ]
    return [ResultColumn("curve", TEXT, names), *columns]


def _model_columns(outcome: FitOutcome) -> list[ResultColumn]:
    rows: list[dict[str, Any]] = []
    paths: dict[str, str | None] = {}
    for result in outcome.fitted:
        comparison = compared(outcome.study, result.fit, result.further)
        possible = comparison.possible
        for place, (name, one) in enumerate(zip(comparison.models, comparison.fits, strict=True)):
            numbers = {}
            for path, _, unit in _free_of(outcome.study, name):
                paths[path] = unit
                numbers[path] = (one.value(path), one.error(path))
            rows.append({
                "curve": result.name, "model": name, "possible": int(name in possible),
                "aic": float(comparison.aic[place] - comparison.aic.min()),
                "bic": float(comparison.bic[place] - comparison.bic.min()),
                "chi_square_in_contact": one.chi_square_in_contact, "numbers": numbers,
            })  # fmt: skip
    columns = [ResultColumn(name, TEXT, np.array([row[name] for row in rows])) for name in ("curve", "model")]
    for name in ("possible", "aic", "bic", "chi_square_in_contact"):
        columns.append(ResultColumn(name, Word("", "", name), np.array([row[name] for row in rows])))
    for path, unit in paths.items():
        key = "problem." + re.sub(r"\[(\d+)\]", r".\1", path)
        for end, part in (("", 0), ("_error", 1)):
            content = np.array([row["numbers"].get(path, (np.nan, np.nan))[part] for row in rows])
            columns.append(ResultColumn(f"{key}{end}", Word("", unit, ""), content))
    return columns


def _shared_columns(outcome: FitOutcome) -> list[ResultColumn]:
    joint, keys = outcome.joint[0], {free.path: free for free in outcome.study.free}
    columns = [ResultColumn("curve", TEXT, np.array([result.name for result in outcome.independent]))]
    for place, path in enumerate(joint.names):
        free = keys[path]
        word = outcome.study.word(free.key)
        low, high = joint.interval(path)
        same = np.ones(len(joint.fits))
        columns += [
            ResultColumn(free.key, word, joint.value(path) * same),
            ResultColumn(f"{free.key}_error", word, joint.error(path) * same),
            ResultColumn(f"{free.key}_low", word, low * same),
            ResultColumn(f"{free.key}_high", word, high * same),
            ResultColumn(f"{free.key}_alone", word, joint.single_values[:, place]),
            ResultColumn(f"{free.key}_alone_error", word, joint.single_errors[:, place]),
            ResultColumn(f"{free.key}_share", Word("", "", "part of the information"), joint.shares[:, place]),
        ]
    columns.append(ResultColumn("chance", Word("", "", "chance to differ more from the others"), joint.chances))
    return columns
