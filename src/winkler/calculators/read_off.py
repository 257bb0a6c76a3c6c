"""A report whose curves can be read off: at the mouse, at a finger, or by the arrow keys; the page stays one file."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

import numpy as np

from winkler.calculators.single_page import joined_script
from winkler.numerics.types import Array
from winkler.plot.axis import PanelAxis
from winkler.plot.marks import Line
from winkler.plot.svg.scales import Side
from winkler.study.language.explain import plain_symbol
from winkler.study.report.figure import ReportFigure

__all__ = ["readable_curves", "with_reading"]

LETTERS = 9.0
"""Size of the letters of figures [pt]."""
DIGITS = 7
STYLE = """
figure svg:focus-visible { outline: 3px solid #00639c; outline-offset: 2px; }
.reading { pointer-events: none; }
.reading .cross { stroke: #57626e; stroke-width: .6; stroke-dasharray: 2 2; fill: none; }
.reading .at { fill: #b34700; }
.reading .back { fill: #fff; stroke: #57626e; stroke-width: .6; }
.reading text { fill: #22272e; font-family: system-ui, sans-serif; }
.spoken { position: absolute; width: 1px; height: 1px; margin: 0; overflow: hidden; clip-path: inset(50%); }
@media print { .reading { display: none; } }
"""
BEGIN = """
for (const [name, panels] of Object.entries(JSON.parse(document.getElementById("curves").textContent))) {
  const picture = document.querySelector(`[id^="${name}-"]`)?.closest("svg");
  if (!picture) continue;
  const spoken = document.createElement("p");
  spoken.className = "spoken";
  spoken.setAttribute("aria-live", "polite");
  picture.after(spoken);
  readOff(picture, () => panels, spoken);
  picture.setAttribute("aria-label", `${picture.getAttribute("aria-label")} Arrow keys read the curves off.`);
}
"""


def with_reading(page: str, shown: Iterable[ReportFigure]) -> str:
    """Return a report with the numbers of its curves, and the script that reads them off.

    Parameters
    ----------
    page : str
        The report.
    shown : iterable of ReportFigure
        Its figures.
    """
    curves = {one.name.replace("_", "-"): readable_curves(one) for one in shown if one.drawing is not None}
    data = json.dumps({name: panels for name, panels in curves.items() if panels}, ensure_ascii=False)
    script = joined_script(("reading",)) + BEGIN
    head, body = page.split("</style>", 1)
    inside, end = body.rsplit("</body>", 1)
    store = f'<script type="application/json" id="curves">{data.replace("</", "<" + chr(92) + "/")}</script>'
    return f'{head}{STYLE}</style>{inside}{store}\n<script type="module">\n{script}</script>\n</body>{end}'


def readable_curves(one: ReportFigure) -> list[dict[str, Any]]:
    """Return the panels of a figure with the curves in them, in the coordinates of its drawing.

    Parameters
    ----------
    one : ReportFigure
        A figure that was drawn.

    Returns
    -------
    list of dict
        Without panels that have no curve or no labelled axes.
    """
    assert one.drawing is not None
    panels = []
    for panel, plane in one.drawing.panels:
        across, upright = (_axis(*of) for of in ((panel.across, plane.across), (panel.upright, plane.upright)))
        curves = [
            {
                "name": _plain(mark.name),
                "x": _numbers(mark.x, plane.factors[0]),
                "y": _numbers(mark.y, plane.factors[1]),
            }
            for mark in panel.marks
            if isinstance(mark, Line) and not mark.beside and mark.x.size > 2
        ]
        if across is None or upright is None or panel.bare or not curves:
            continue
        panels.append({"box": list(plane.box), "size": LETTERS, "x": across, "y": upright, "curves": curves})
    return panels


def _axis(axis: PanelAxis, side: Side) -> dict[str, Any] | None:
    if not axis.label:
        return None
    ends = {"low": float(side.low), "high": float(side.high), "log": side.log}
    return {"title": _plain(axis.label), "unit": axis.scale.unit, **ends}


def _plain(label: str) -> str:
    """Return a label without formulas; nothing for a hidden name."""
    if label.startswith("_"):
        return ""
    parts = label.split("$")
    return "".join(plain_symbol(part) if place % 2 else part for place, part in enumerate(parts))


def _numbers(column: Array, factor: float) -> list[float | None]:
    return [
        float(f"{number:.{DIGITS}g}") if np.isfinite(number) else None
        for number in (np.ravel(column) / factor).tolist()
    ]
