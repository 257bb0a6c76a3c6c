"""Display of fits: parameters with their errors, doubts, and pictures of one curve."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any

import numpy as np

from winkler.fitting.outcome import Fit
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.fitting.fits import Grid, fit_panels
from winkler.plot.panel import Line, Panel, PanelAxis
from winkler.plot.series import Scale, Series, middle_scale, name_in_words
from winkler.plot.series import with_unit as number_text
from winkler.plot.viscoelastic.fits import relaxing_loop
from winkler.study.batch.fit_outcome import FitOutcome, Fitted, interval_of
from winkler.study.language.fit_study import Free
from winkler.study.report import fit_tables
from winkler.study.report.examined.sections import further_figures, further_section
from winkler.study.report.figure import capital
from winkler.study.report.fit_report import figures_of_curves, figures_of_many, steps
from winkler.study.report.fit_tables import counts, curve_texts
from winkler.study.report.fit_writing import map_grid
from winkler.study.report.headline.advice import worst_doubt
from winkler.study.report.headline.section import doubt_line
from winkler.study.report.markup import badge, safe, with_fixed_units
from winkler.study.report.mathml import symbol
from winkler.study.report.page_parts import code_section, papers, trust
from winkler.values.errors import WinklerError
from winkler.values.readable import with_unit
from winkler.values.validity import worst
from winkler.web.form.fit_form import key_in_words
from winkler.web.pictures.answer import method_pictures, sheet_of
from winkler.web.pictures.chart import Chart, chart
from winkler.web.pictures.packing import packed
from winkler.web.pictures.replies import AnswerText, DrawnSheet, InteractivePicture, NamedNumber
from winkler.web.pictures.view import fitting

MOST_POINTS = 3000
"""Most drawn points of a curve, evenly spaced."""
CURVE_CAPTION = (
    "Dots are measured, the line is the fitted law; below, the residuals, which should scatter without a trend."
)
METHOD_REMARK = "The pictures of the method show the fitted contact at the largest depth of the curve."


def fit_text(outcome: FitOutcome, text: str) -> AnswerText:
    """Return the fitted parameters as text."""
    count = len(outcome.fitted)
    several = len(outcome.results) > 1
    answers = [cards_of_many(outcome) if several else _cards(outcome), fit_tables.doubts(outcome)]
    body = [
        fit_tables.answers(outcome),
        further_section(outcome),
        steps(outcome),
        fit_tables.failures(outcome),
    ]
    return AnswerText(
        worst(outcome.validity).value,
        badge(outcome.validity),
        f"{''.join(answers)}<div class='whole'>{''.join(body)}</div>",
        trust(outcome.validity),
        papers(outcome.study.problem) + code_section(outcome.study, outcome.provenance.source or "study.toml"),
        text,
        count if count > 1 else 0,
        0,
        doubt=doubt_line(worst_doubt(outcome.validity)),
        numbers=_numbers(outcome) if count == 1 else (),
        curves=curve_list(outcome) if several else "",
        labels=curve_names(outcome) if count > 1 else (),
    )


def _numbers(outcome: FitOutcome) -> tuple[NamedNumber, ...]:
    """Return the fitted parameters of one curve."""
    fit, free = outcome.fitted[0].fit, outcome.study.free
    words = {one.key: outcome.study.word(one.key) for one in free}
    return tuple(
        NamedNumber(key_in_words(one.key), words[one.key].symbol, words[one.key].unit or "", float(fit.value(one.path)))
        for one in free
    )


def _cards(outcome: FitOutcome) -> str:
    """Return the fitted parameters with their intervals as cards, and the first one in a sentence."""
    (result,), cards, lead = outcome.fitted, [], ""
    fit = result.fit
    for free in outcome.study.free:
        word = outcome.study.word(free.key)
        low, high = (number_text(end, word.unit) for end in interval_of(result, free))
        name = key_in_words(free.key).rpartition("› ")[2]
        found = number_text(fit.value(free.path), word.unit)
        lead = lead or f"{capital(name)} is {found}, with 95 % between {low} and {high}."
        cards.append(
            f'<div class="card"><div class="value">{safe(found)}</div>'
            f'<div class="name">{safe(name)} {symbol(word.symbol)}<br>'
            f"95 %: {with_fixed_units(f'{low} … {high}')}</div></div>"
        )
    return f'<p class="lead sought-line">{with_fixed_units(lead)}</p><div class="cards">{"".join(cards)}</div>'


def fit_pictures(outcome: FitOutcome, moment: int) -> tuple[Iterator[InteractivePicture], str]:
    """Return the interactive pictures of one of the curves, and a remark on all of them.

    Parameters
    ----------
    outcome
        Outcome of the fits.
    moment
        Index of the fitted curve.
    """
    result = outcome.fitted[moment]
    before = _overviews(outcome, moment) if len(outcome.results) > 1 else iter(())
    if not isinstance(result.fit, Fit):
        return itertools.chain(before, _relaxing(result)), ""
    try:
        contact = result.fit.model.solve()
    except WinklerError as error:
        return itertools.chain(before, (_curve(result),)), f"There are no pictures of the method: {error}"
    return itertools.chain(before, _elastic(result, contact)), METHOD_REMARK


def _overviews(outcome: FitOutcome, moment: int) -> Iterator[InteractivePicture]:
    for name, title, sentence, drawn in overviews(outcome, moment):
        yield InteractivePicture(name, title, sentence, packed(drawn))


def drawn_points(count: int) -> Array:
    """Return the indices of the drawn points of a curve."""
    return np.unique(np.linspace(0, count - 1, min(count, MOST_POINTS)).astype(int))


def _curve(result: Fitted) -> InteractivePicture:
    count = result.fit.curve.count
    some = f" Of {count} points {MOST_POINTS} are drawn." if count > MOST_POINTS else ""
    drawn = chart(*fit_panels(result.fit, drawn_points(count)))
    return InteractivePicture("fit", f"Curve and fit: {result.name}", f"{CURVE_CAPTION}{some}", packed(drawn))


def _elastic(result: Fitted, contact: Any) -> Iterator[InteractivePicture]:
    yield _curve(result)
    yield from method_pictures(contact, fitting(contact.pressed))


def _relaxing(result: Fitted) -> Iterator[InteractivePicture]:
    yield _curve(result)
    sentence = "Measured response; loading and unloading differ because the body relaxes."
    loop = chart(relaxing_loop(result.fit, drawn_points(result.fit.curve.count)))
    yield InteractivePicture("loop", "Force over depth", sentence, packed(loop))


def fit_sheets(outcome: FitOutcome) -> Iterator[DrawnSheet]:
    """Yield the figures of the report that are not interactive: many curves, depths, models, events and noise."""
    relaxing = not isinstance(outcome.fitted[0].fit, Fit)
    yield from map(sheet_of, figures_of_many(outcome))
    yield from map(sheet_of, further_figures(outcome))
    if relaxing or len(outcome.fitted) == 1:
        yield from (
            sheet_of(one) for one in figures_of_curves(outcome) if relaxing or not one.name.startswith("curve_")
        )


MOST_COLUMNS = 2
"""Most fitted numbers in the list."""
LEAST_COUNTED = 3
"""Number of curves from which there is a histogram."""
MOST_BINS = 40
MICRON = Scale(1e-6, "µm")


def _shown(outcome: FitOutcome) -> tuple[Free, ...]:
    """Return the fitted numbers of the problem, or all if it has none."""
    of_problem = tuple(free for free in outcome.study.free if free.key.startswith("problem."))
    return of_problem or outcome.study.free


def curve_names(outcome: FitOutcome) -> tuple[str, ...]:
    """Return the names of the fitted curves."""
    return tuple(result.name for result in outcome.fitted)


def cards_of_many(outcome: FitOutcome) -> str:
    """Return the medians of the fitted numbers as cards, and the first one in a sentence."""
    cards, lead = [], ""
    for free in _shown(outcome)[:MOST_COLUMNS]:
        word, numbers = outcome.study.word(free.key), outcome.numbers(free)
        low, middle, high = (with_unit(one, word.unit) for one in np.nanquantile(numbers, (0.25, 0.5, 0.75)))
        name = key_in_words(free.key).rpartition("› ")[2]
        lead = lead or f"The median of {name} is {middle}, of {len(outcome.fitted)} curves."
        cards.append(
            f'<div class="card"><div class="value">{safe(middle)}</div><div class="name">{safe(name)} '
            f"{symbol(word.symbol)}, median<br>middle half: {safe(low)} … {safe(high)}</div></div>"
        )
    return f'<p class="lead sought-line">{with_fixed_units(lead)}</p><div class="cards">{"".join(cards)}</div>'


def curve_list(outcome: FitOutcome) -> str:
    """Return all curves in their order: fitted numbers, flags, or why there is no answer; names are buttons."""
    heads, columns = ["curve"], []
    for free in _shown(outcome)[:MOST_COLUMNS]:
        unit, texts = curve_texts(outcome, free, "")
        heads.append(f"{safe(key_in_words(free.key).rpartition('› ')[2])}{f' [{safe(unit)}]' if unit else ''}")
        columns.append(texts)
    rows, place = [], 0
    for number, result in enumerate(outcome.results):
        cells = "".join(f"<td class='number'>{safe(texts[number])}</td>" for texts in columns)
        if isinstance(result, Fitted):
            flags = ", ".join(flag.name for flag in result.fit.flags)
            button = f'<button type="button" data-curve="{place}">{safe(result.name)}</button>'
            rows.append(f"<tr><td>{button}</td>{cells}<td>{safe(flags)}</td></tr>")
            place += 1
        else:
            reason = f'<td colspan="{len(columns) + 1}" class="no-answer">{safe(result.reason)}</td>'
            rows.append(f"<tr><td>{safe(result.name)}</td>{reason}</tr>")
    titles = "".join(f"<th>{head}</th>" for head in (*heads, "flags"))
    return (
        f"<h3>Curves</h3>{counts(outcome)}<div class='curve-rows' tabindex='0' role='region' aria-label='Curves'>"
        f"<table><thead><tr>{titles}</tr></thead><tbody>{''.join(rows)}</tbody></table></div>"
    )


def overviews(outcome: FitOutcome, chosen: int) -> Iterator[tuple[str, str, str, Chart]]:
    """Yield name, title, caption and figure of what all curves say of their first number.

    Parameters
    ----------
    outcome
        Of several curves.
    chosen
        Index of the displayed one among the fitted.
    """
    free = _shown(outcome)[0]
    numbers, grid = outcome.numbers(free), map_grid(outcome)
    name = name_in_words(free.label)
    of = Series(name, outcome.study.word(free.key), numbers)
    scale = middle_scale(of.word.unit, numbers)
    order = np.where(np.isfinite(numbers), np.cumsum(np.isfinite(numbers)) - 1.0, np.nan)
    if isinstance(grid, Grid):
        sentence = "Over the sample; a click shows the curve of a place, the square marks it. Empty: no answer."
        yield "map", f"Map: {name}", sentence, _map(grid, of, scale, order, chosen)
    else:
        sentence = "Each curve with its standard error; a click shows it."
        yield "values", f"All curves: {name}", sentence, _values(of, scale, outcome.errors(free), order, chosen)
    if len(outcome.fitted) >= LEAST_COUNTED:
        yield "histogram", f"How often: {name}", "Curves by their value; the line is the median.", _histogram(of, scale)


def _map(grid: Grid, of: Series, scale: Scale, order: Array, chosen: int) -> Chart:
    x, y = (1e6 * (places - places.min()) for places in (grid.x, grid.y))
    (row, column), *_ = grid.index[order == chosen]
    here = Line(1e-6 * x[[column]], 1e-6 * y[[row]], style.RED, width=0.0, marker="o")
    figure = chart(Panel((here,), PanelAxis("x", MICRON), PanelAxis("y", MICRON), equal=True, grid=""))
    figure["data"][0] |= {"hoverinfo": "skip", "hovertemplate": None}
    figure["data"][0]["marker"] = {
        "size": 16, "symbol": "square-open", "color": style.RED, "line": {"width": 2.5, "color": style.RED},
    }  # fmt: skip
    colours = {
        "type": "heatmap",
        "x": x,
        "y": y,
        "z": grid.arranged(of.content / scale.factor),
        "customdata": grid.arranged(order),
        "colorscale": "Viridis",
        "hoverongaps": False,
        "colorbar": {"title": {"text": f"[{scale.unit}]", "side": "top"}, "thickness": 12, "outlinewidth": 0},
        "hovertemplate": f"%{{z:.4~g}} {scale.unit}<br>x = %{{x:.4~g}} µm, y = %{{y:.4~g}} µm<extra></extra>",
    }
    figure["data"].insert(0, colours)
    return figure


def _values(of: Series, scale: Scale, errors: Array, order: Array, chosen: int) -> Chart:
    number = np.arange(1.0, of.content.size + 1.0)
    finite, here = np.isfinite(of.content), order == chosen
    points = Line(number[finite], of.content[finite], width=0.0, marker="o", size=4.0)
    mark = Line(number[here], of.content[here], style.RED, width=0.0, marker="o", size=6.0)
    figure = chart(Panel((points, mark), PanelAxis("number of the curve", margin=0.03), PanelAxis.of(of, scale)))
    figure["data"][0]["customdata"] = order[finite]
    bars: dict[str, Any] = {"type": "data", "array": errors[finite] / scale.factor, "color": style.MUTED, "width": 0}
    figure["data"][0]["error_y"] = bars | {"thickness": 1}
    return figure


def _histogram(of: Series, scale: Scale) -> Chart:
    content = of.content[np.isfinite(of.content)] / scale.factor
    most = min(MOST_BINS, max(5, int(np.sqrt(content.size))))
    heights, edges = np.histogram(content, bins=most)
    middle = float(np.median(content)) * scale.factor
    line = Line(np.full(2, middle), np.array([0.0, float(heights.max())]), style.RED, width=1.4)
    figure = chart(Panel((line,), PanelAxis.of(of, scale), PanelAxis("number of curves", low=0.0)))
    bars = {
        "type": "bar",
        "x": 0.5 * (edges[1:] + edges[:-1]),
        "y": heights.astype(float),
        "width": np.diff(edges),
        "marker": {"color": style.BLUE, "line": {"color": "white", "width": 1}},
        "showlegend": False,
        "hovertemplate": f"%{{y}} curves around %{{x:.4~g}} {scale.unit}<extra></extra>",
    }
    figure["data"].insert(0, bars)
    return figure
