"""Many fitted curves: a list with flags, a map or the values, and a histogram; each leads to its curve."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.fitting.fits import Grid
from winkler.plot.panel import Line, Panel, PanelAxis
from winkler.plot.series import Scale, Series, middle_scale, name_in_words
from winkler.study.batch.fit_outcome import FitOutcome, Fitted
from winkler.study.language.fit_study import Free
from winkler.study.report.fit_tables import counts, curve_texts
from winkler.study.report.fit_writing import map_grid
from winkler.study.report.markup import safe, with_fixed_units
from winkler.study.report.mathml import symbol
from winkler.values.readable import with_unit
from winkler.web.form.fit_form import key_in_words
from winkler.web.pictures.chart import Chart, chart

__all__ = ["cards_of_many", "curve_list", "curve_names", "overviews"]

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
