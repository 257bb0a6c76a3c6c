"""The report of nanoindentations: quantities of ISO 14577, shares of uncertainty, figures, and the study."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from winkler.fitting.nanoindentation.quantities import IndentationQuantities
from winkler.plot.fitting.fits import numbers_sheet
from winkler.plot.fitting.nanoindentation import HARDNESS, YOUNG, over_depth
from winkler.plot.panel import Sheet
from winkler.plot.registered import sheet_of_kind
from winkler.plot.series import Series
from winkler.study.nanoindentation.running import Evaluated, NanoindentationOutcome
from winkler.study.report import page_parts as parts
from winkler.study.report.figure import ReportFigure, drawn
from winkler.study.report.fit_tables import batch_section
from winkler.study.report.markup import number, safe, section, table
from winkler.study.report.tables import expected_section
from winkler.study.report.thumbnails import ThumbnailOf, thumbnails_section
from winkler.values.readable import with_unit
from winkler.values.validity import Standing

MOST_CURVES_DRAWN, MOST_ROWS, LEAST_TOGETHER = 6, 40, 3
CURVES_BESIDE = 4
"""Curves in one table of quantities; more are wider than the page."""
UNLOADING_POINTS = 8
"""Points of a fitted unloading in a thumbnail."""
LONGEST_FLAG = 160
"""Characters of the doubts below a thumbnail."""
ISO_TEXT = "<p>At the greatest force of each curve; in brackets standard uncertainties.</p>"
MEANINGS = {
    "HM": "Martens hardness",
    "HMs": "Martens hardness by the slope of the loading",
    "HIT": "indentation hardness",
    "EIT": "indentation modulus",
    "HV*": "Vickers hardness converted from HIT (0.0945 HIT in MPa)",
    "CIT": "creep in the hold",
    "RIT": "relaxation in the hold",
    "W": "work of the loading",
    "W_e": "elastic work, of the unloading",
    "W_p": "plastic work, W - W_e",
    "eta_IT": "elastic part of the work, W_e/W",
}
"""What each quantity of ISO 14577 is."""


def figures_of(outcome: NanoindentationOutcome) -> tuple[ReportFigure, ...]:
    """Return the figures: the calibration, or E and H over depth, their histograms, and single curves."""
    return tuple(_figures(outcome))


def _figures(outcome: NanoindentationOutcome) -> Iterator[ReportFigure]:
    for item in outcome.calibration:
        sentence = "Left the area that every unloading demands, right its distance to the fitted function."
        yield drawn("calibration", "Area function", sentence, sheet_of_kind(item))
    solutions = [one.solution for one in outcome.evaluated]
    if len(solutions) >= LEAST_TOGETHER:
        sentence = "Every unloading of every curve with its 95 % interval."
        yield drawn(
            "over_depth",
            "Modulus and hardness over depth",
            sentence,
            Sheet(over_depth(solutions), width=4.4, height=3.2),
        )
        for word, name in ((YOUNG, "young"), (HARDNESS, "hardness")):
            numbers = np.array([getattr(one, name)[one.deepest] for one in solutions])
            errors = np.array([getattr(one, f"own_{name}_error") for one in solutions])
            sentence = "At the greatest force; standard uncertainty by noise, zero point and drift."
            yield drawn(
                f"all_{name}",
                f"All curves: {word.meaning}",
                sentence,
                numbers_sheet(Series(name, word, numbers), errors),
            )
    if (found := outcome.first_yield) is not None:
        sentence = "Greatest shear stress below the tip at the first pop-in of each curve, with Weibull's distribution."
        yield drawn("first_yield", "First yield", sentence, sheet_of_kind(found))
    for place, one in enumerate(outcome.continuous[:MOST_CURVES_DRAWN]):
        sentence = "E and H of the continuously measured stiffness; band: 95 % interval without noise."
        yield drawn(f"continuous_{place + 1}", one.name, sentence, sheet_of_kind(one.solution))
    chosen = np.unique(np.linspace(0, len(solutions) - 1, min(MOST_CURVES_DRAWN, len(solutions))).astype(int))
    for place in chosen.tolist() if solutions else []:
        sentence = (
            "The curve after drift, zero point and frame with its fitted unloadings; E and H with 95 % intervals."
        )
        yield drawn(f"curve_{place + 1}", outcome.evaluated[place].name, sentence, sheet_of_kind(solutions[place]))


def page(outcome: NanoindentationOutcome, shown: tuple[ReportFigure, ...]) -> str:
    """Return the report as one HTML page with its figures."""
    made = outcome.provenance
    title = safe(outcome.study.title)
    many = len(outcome.evaluated) + len(outcome.unevaluated)
    count = "Calibration" if outcome.calibration else f"{len(outcome.evaluated)} of {many} curves were evaluated"
    line = f'<p class="small">{count}, with winkler {safe(made.version)}, {safe(made.created[:10])}.</p>'
    body = [
        f"<header><h1>{title}</h1>{line}</header>",
        *_calibration(outcome),
        *_measurement(outcome),
        batch_section("All curves", outcome.batch, outcome.doubts, "quantities.csv"),
        *_continuous(outcome),
        *_first_yield(outcome),
        expected_section(outcome.verdicts),
        _failures(outcome),
        thumbnails_section(tuple(_thumbnails(outcome))),
        section("Figures", parts.figure_elements(shown)) if shown else "",
        parts.trust(outcome.validity),
        parts.origin(
            made, "the study with its curves", parts.folded("The study file, word for word", outcome.study.text)
        ),
    ]
    return parts.framed(title, made.version, body)


def calibration_rows(outcome: NanoindentationOutcome) -> list[tuple[str, str, str]]:
    """Return name, number and standard uncertainty of the frame compliance and the coefficients of the area."""
    rows = []
    for item in outcome.calibration:
        errors = np.sqrt(np.diag(item.indenter.covariance))
        frame = with_unit(item.frame_compliance, "m/N", 4)
        rows.append(("frame compliance", frame, with_unit(float(errors[0]), "m/N", 2)))
        for place, coefficient in enumerate(item.indenter.area.coefficients):
            power = 2.0 - 2.0 ** (1 - place)
            unit = {0.0: "", 1.0: " m"}.get(power, f" m^{power:g}")
            rows.append((f"C{place}", f"{coefficient:.5g}{unit}", f"{errors[1 + place]:.2g}{unit}"))
        low, high = item.contact_depth.min(), item.contact_depth.max()
        rows.append(("contact depths", f"{with_unit(float(low), 'm', 3)} to {with_unit(float(high), 'm', 3)}", ""))
        rows.append(("scatter over that of the noise", f"{math.sqrt(item.factor):.2f}", ""))
        if math.isfinite(item.correlation):
            rows.append(("correlation of frame and area", f"{item.correlation:.3f}", ""))
    return rows


def mean_rows(outcome: NanoindentationOutcome) -> list[tuple[str, str, str, str]]:
    """Return quantity, mean, standard uncertainty and 95 % interval over all curves."""
    rows = []
    for name, mean in outcome.means.items():
        low, high = mean.interval()
        interval = f"{with_unit(low, 'Pa', 4)} ... {with_unit(high, 'Pa', 4)}"
        word = {"young": "Young's modulus E", "hardness": "hardness H"}[name]
        rows.append((word, with_unit(mean.mean, "Pa", 4), with_unit(mean.error, "Pa", 2), interval))
    return rows


def _row(cells: tuple[str, ...]) -> str:
    return f"<tr><td>{safe(cells[0])}</td>{''.join(number(safe(cell)) for cell in cells[1:])}</tr>"


def _calibration(outcome: NanoindentationOutcome) -> Iterator[str]:
    if outcome.calibration:
        rows = [_row(row) for row in calibration_rows(outcome)]
        names = ", ".join(f"{one.name or 'reference'} (E = {with_unit(one.young, 'Pa')}, nu = {one.poisson:g})"
                          for one in outcome.calibration[0].references)  # fmt: skip
        lead = f"<p>From {len(outcome.calibration[0].force)} unloadings in {safe(names)}.</p>"
        yield section("The indenter", lead, table(["number", "#value", "#standard uncertainty"], rows))


def _measurement(outcome: NanoindentationOutcome) -> Iterator[str]:
    if not outcome.evaluated:
        return
    rows = [_row(row) for row in mean_rows(outcome)]
    yield section("Modulus and hardness at the greatest force",
                  table(["quantity", "#mean", "#standard uncertainty", "#95 % interval"], rows))  # fmt: skip
    means = outcome.means
    shares = [
        _row((source, *(_share(float(mean.shares[place]) / mean.mean) for mean in means.values())))
        for place, source in enumerate(means["young"].sources)
    ]
    lead = "<p>Standard uncertainties of the means, in parts of them; their squares add (GUM).</p>"
    calibrated = "" if outcome.study.indenter.calibrated else (
        "<p>The indenter was given without a covariance: its calibration is no part of the uncertainty.</p>"
    )  # fmt: skip
    yield section("Shares of the uncertainty", lead, calibrated, table(["source", "#of E", "#of H"], shares))
    yield section("Quantities of ISO 14577", ISO_TEXT, *_iso_tables(outcome.evaluated[:MOST_ROWS]), _rest(outcome))


def _share(share: float) -> str:
    return f"{100.0 * share:.2g} %" if share > 0.0 else "-"


def _iso_tables(shown: Sequence[Evaluated]) -> Iterator[str]:
    """Yield tables of a few curves each, with one row for each quantity, so that they fit the page."""
    common = max((one.name.rpartition("/")[0] + "/" for one in shown), key=len)
    common = common if all(one.name.startswith(common) for one in shown) else ""
    for first in range(0, len(shown), CURVES_BESIDE):
        part = shown[first : first + CURVES_BESIDE]
        heads = ["quantity", *(f"#{safe(one.name.removeprefix(common))}" for one in part)]
        quantities = [one.quantities for one in part]
        rows = [
            _row((f"{name}, {MEANINGS[name]}", *(_iso_cell(each, place) for each in quantities)))
            for place, name in enumerate(quantities[0].names)
        ]
        yield table(heads, rows)


def _iso_cell(quantities: IndentationQuantities, place: int) -> str:
    content, error = float(quantities.values[place]), float(quantities.errors[place])
    return "-" if math.isnan(content) else _with_error(content, error, quantities.units[place])


def _rest(outcome: NanoindentationOutcome) -> str:
    more = len(outcome.evaluated) - MOST_ROWS
    return f"<p class='small'>… and {more} more curves; quantities.csv holds all.</p>" if more > 0 else ""


def continuous_rows(outcome: NanoindentationOutcome) -> list[tuple[str, ...]]:
    """Return curve, depths, E and H with their uncertainty and scatter, the instrument's own, and whose touch it is.

    The last row of several curves is their mean, with the standard deviation between them.
    """
    rows = []
    for one in outcome.continuous[:MOST_ROWS]:
        mean, low, high = one.mean, *(with_unit(end, "m", 3) for end in one.window)
        ours = (
            (mean.young, mean.young_error, mean.young_scatter),
            (mean.hardness, mean.hardness_error, mean.hardness_scatter),
        )
        cells = [
            f"{_with_error(number, error or math.nan, 'Pa').removesuffix(')')}; {with_unit(scatter, 'Pa', 2)})"
            for number, error, scatter in ours
        ]
        theirs = ["-" if math.isnan(number) else with_unit(number, "Pa", 4) for number in one.stated]
        rows.append(
            (one.name, f"{low} ... {high}", *cells, *theirs, "found or given" if one.own_touch else "of the file")
        )
    if len(outcome.continuous) > 1:
        means = [
            f"{with_unit(float(np.mean(numbers)), 'Pa', 4)} ± {with_unit(float(np.std(numbers, ddof=1)), 'Pa', 2)}"
            for numbers in np.array([(one.mean.young, one.mean.hardness) for one in outcome.continuous]).T
        ]
        rows.append((f"mean of {len(outcome.continuous)} curves ± scatter between them", "", *means, "", "", ""))
    return rows


CONTINUOUS_HEADS = ("curve", "depth", "E", "H", "E of the instrument", "H of the instrument", "touch")


def _continuous(outcome: NanoindentationOutcome) -> Iterator[str]:
    if not outcome.continuous:
        return
    where = "the stated depths" if outcome.study.window else "the deeper half of each curve"
    lead = (
        f"<p>Means over {where}; in brackets standard uncertainties by calibration, touch and stiffness scale, and the "
        "standard deviation of the points.  All depths are in continuous.csv.</p>"
    )
    heads = [CONTINUOUS_HEADS[0], *(f"#{head}" for head in CONTINUOUS_HEADS[1:])]
    rows = [_row(row) for row in continuous_rows(outcome)]
    yield section("Continuously measured stiffness", lead, table(heads, rows))


def first_yield_rows(outcome: NanoindentationOutcome) -> list[tuple[str, str]]:
    """Return the numbers of first yield; no rows where it was not sought."""
    if "tip_radius" not in outcome.study.given:
        return []
    count = sum(math.isfinite(one.pop_in) for one in outcome.evaluated)
    rows = [("curves with a pop-in", f"{count} of {len(outcome.evaluated)}")]
    found = outcome.first_yield
    if found is None:
        return [*rows, ("statistics", "none: at least three curves with a pop-in are needed")]
    low, high = found.interval()
    return [
        *rows,
        ("mean shear stress", f"{with_unit(found.mean_stress, 'Pa', 4)} ({with_unit(found.mean_error, 'Pa', 2)})"),
        ("95 % interval", f"{with_unit(low, 'Pa', 4)} ... {with_unit(high, 'Pa', 4)}"),
        ("Weibull's stress", with_unit(found.scale, "Pa", 4)),
        ("Weibull's exponent", f"{found.shape:.3g} ({found.shape_error:.2g})"),
        ("activation volume", with_unit(found.activation_volume, "m^3", 3)),
    ]


def _first_yield(outcome: NanoindentationOutcome) -> Iterator[str]:
    if rows := first_yield_rows(outcome):
        radius = with_unit(outcome.study.given["tip_radius"], "m", 3)
        lead = f"<p>Greatest shear stress below a ball of radius {radius} at the first pop-in (Hertz).</p>"
        yield section("First yield", lead, table(["quantity", "#value"], [_row(row) for row in rows]))


def _with_error(content: float, error: float, unit: str) -> str:
    stated = "unknown" if math.isnan(error) else with_unit(float(error), unit, 2)
    return f"{with_unit(float(content), unit, 4)} ({stated})"


def _failures(outcome: NanoindentationOutcome) -> str:
    if not outcome.unevaluated:
        return ""
    items = "".join(f"<li>{safe(one.name)}: {safe(one.reason)}</li>" for one in outcome.unevaluated[:MOST_ROWS])
    return section("Curves without an answer", f"<ul>{items}</ul>")


def _thumbnails(outcome: NanoindentationOutcome) -> Iterator[ThumbnailOf]:
    """Yield force over position of each curve with its fitted unloadings, and what is doubtful of it."""
    doubts = dict(outcome.doubts)
    share = np.linspace(0.0, 1.0, UNLOADING_POINTS)
    for one in outcome.evaluated:
        found = one.solution
        curve = found.problem.curve
        compliance = found.problem.indenter.frame_compliance + curve.compliance
        time = curve.time - curve.time[0] if curve.timed else np.zeros(curve.count)
        laws = zip(found.force, found.exponent, found.final_depth, found.depth, strict=True)
        force = np.array([top * share**exponent for top, exponent, _, _ in laws])
        depth = found.final_depth[:, None] + share * (found.depth - found.final_depth)[:, None]
        place = depth + compliance * force + found.zero_point.position
        lines = (
            (curve.position - found.drift.rate * time, curve.force),
            (place.ravel(), force.ravel() + found.zero_point.baseline),
        )
        outside = [note.assumption.value for note in found.validity if note.standing is Standing.OUTSIDE]
        words = [*dict.fromkeys(outside), *doubts.get(one.name, ())]
        yield ThumbnailOf(lines, one.name, "; ".join(words)[:LONGEST_FLAG])
    for left in outcome.unevaluated:
        yield ThumbnailOf((), left.name, "no answer", answered=False)
