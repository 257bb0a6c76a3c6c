"""One page per curve: its file and hash, calibration, corrections, segments, the fit, its residuals, and its doubts."""

from __future__ import annotations

import dataclasses
import hashlib
import math
import re
from pathlib import Path

from winkler.plot.fitting.noise_sheet import noise_sheet
from winkler.plot.registered import sheet_of_kind
from winkler.study.batch.fit_outcome import FitOutcome, Fitted
from winkler.study.batch.fit_recording import path_from_study
from winkler.study.language.fit_study import FitStudy
from winkler.study.report import page_parts as parts
from winkler.study.report.figure import ReportFigure, drawn
from winkler.study.report.fit_tables import answers, doubts
from winkler.study.report.markup import safe, section, table
from winkler.values.errors import WinklerError
from winkler.values.readable import with_unit

PAGES = "pages"
"""Folder of the pages."""


def curve_pages(outcome: FitOutcome, most: int) -> dict[str, bytes]:
    """Return the pages of the first curves that were fitted, in the folder ``pages``: name -> content.

    Parameters
    ----------
    outcome : FitOutcome
    most : int
        Number of pages.
    """
    files = {}
    width = len(str(len(outcome.results)))
    for result in outcome.fitted[:most]:
        number = outcome.results.index(result) + 1
        stem = re.sub(r"[^\w.+-]+", "_", result.name).strip("._") or "curve"
        own = dataclasses.replace(outcome, results=(result,), left=0)
        files[f"{PAGES}/{number:0{width}d}_{stem}.html"] = _page(own, result).encode("utf-8")
    return files


def _page(outcome: FitOutcome, result: Fitted) -> str:
    body = [
        f"<header><h1>{safe(result.name)}</h1><p class='small'>{safe(outcome.study.title)}</p></header>",
        answers(outcome),
        doubts(outcome),
        section("Figures", parts.figure_elements((_fit_figure(result), noise_figure(result), _segments(result)))),
        curve_facts(outcome, result),
        parts.trust(outcome.validity),
        parts.origin(
            outcome.provenance,
            "the study with its curves",
            parts.folded("The study file, word for word", outcome.study.text) if outcome.study.text else "",
        ),
    ]
    return parts.framed(safe(result.name), outcome.provenance.version, body)


def _fit_figure(result: Fitted) -> ReportFigure:
    return drawn("curve", "Fit", "The curve with the fitted model, below what is left over.", sheet_of_kind(result.fit))


def noise_figure(result: Fitted) -> ReportFigure:
    """Return the residuals in units of the noise, with their spectrum."""
    sentence = (
        "Left the residuals over the standard deviation of the noise, dashed: twice that; right their power over the "
        "frequency, 1 for white noise of that size. Slow noise, or a misfit, rises to the left."
    )
    return drawn("noise", "Residuals in units of the noise", sentence, noise_sheet(result.fit))


def _segments(result: Fitted) -> ReportFigure:
    sentence = "What was done, as the file states, the study states, or as detected: the points that were fitted."
    return drawn("segments", "Segments", sentence, sheet_of_kind(result.fit.curve))


def curve_facts(outcome: FitOutcome, result: Fitted) -> str:
    """Return what stands behind the numbers of a curve: file, hash, calibration, corrections, segments, noise."""
    study, curve = outcome.study, result.fit.curve
    segments = ", ".join(f"{one.kind.value} ({one.count} points)" for one in curve.segments)
    rows = [
        ("file", result.name),
        ("SHA-256 of the file", _hash(study, result.name)),
        ("fitted points", f"{curve.count}, with the part '{study.part}'"),
        ("segments of these", segments),
        ("spring constant", _stiffness(study, curve.machine_stiffness)),
        ("sensitivity", f"{with_unit(study.sensitivity, 'm/V')}, given in the study" if study.sensitivity else
         "none was given: that of the file, if it holds volts"),
        ("frame stiffness", with_unit(study.frame_stiffness, "N/m") if math.isfinite(study.frame_stiffness) else
         "none: the frame is assumed stiff"),
        ("noise", f"{with_unit(result.fit.noise, study.spread.unit)}, "
         + ("given in the study" if study.noise else "estimated from the points out of contact")),
        *((f"correction {number}", step) for number, step in enumerate(result.steps, 1)),
    ]  # fmt: skip
    if not result.steps:
        rows.append(("corrections", "none: it was fitted as it was measured"))
    lines = [f'<tr><td>{safe(name)}</td><td class="text wrap">{safe(content)}</td></tr>' for name, content in rows]
    return section("Basis of these values", table([], lines))


def _stiffness(study: FitStudy, stiffness: float) -> str:
    if not math.isfinite(stiffness):
        return "none: the position is the travel of the tip"
    source = "given in the study" if study.spring_constant else "from the file, with the frame if one is given"
    return f"{with_unit(stiffness, 'N/m')}, {source}"


def _hash(study: FitStudy, name: str) -> str:
    """Return the hash of the file to which a curve belongs; of several matches that with the longest name."""
    paths = [path for path in study.sources if name.startswith(path_from_study(study, path))]
    if len(study.sources) == 1:
        paths = list(study.sources)
    if not paths:
        return "unknown"
    try:
        with Path(max(paths, key=len)).open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except (OSError, WinklerError):
        return "the file can no longer be read"
