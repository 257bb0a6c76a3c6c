"""A report whose curves can be read off: at the mouse, at a finger, or by the arrow keys; the page stays one file."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from typing import Any

import numpy as np

from winkler.calculators.single_page import joined_script
from winkler.study.language.explain import plain_symbol
from winkler.study.report.figure import ReportFigure

__all__ = ["readable_curves", "with_reading"]

POINTS_PER_INCH = 72.0
"""In which figures are sized on the page."""
LETTERS = 9.0
"""Size of the letters of figures, in the same."""
DIGITS = 7
KNOWN_SCALES = ("linear", "log")
LABEL = re.compile(r"(.*?)(?: \[([^\]]*)\])?", re.DOTALL)
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
    curves = {one.name.replace("_", "-"): readable_curves(one) for one in shown if one.picture is not None}
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
        Without panels that have no curve, no labelled axes, or axes other than linear and logarithmic.
    """
    assert one.picture is not None
    width, height = (size * POINTS_PER_INCH for size in one.picture.get_size_inches())
    panels = []
    for axes in one.picture.axes:
        across, upright = _axis(axes, "x"), _axis(axes, "y")
        curves = [
            {"name": _plain(str(line.get_label())), "x": _numbers(line.get_xdata()), "y": _numbers(line.get_ydata())}
            for line in axes.get_lines()
            if line.get_visible() and line.get_transform() == axes.transData and np.size(line.get_xdata()) > 2
        ]
        if across is None or upright is None or not curves:
            continue
        place = axes.get_position()
        box = [place.x0 * width, (1.0 - place.y1) * height, place.x1 * width, (1.0 - place.y0) * height]
        panels.append({"box": box, "size": LETTERS, "x": across, "y": upright, "curves": curves})
    return panels


def _axis(axes: Any, which: str) -> dict[str, Any] | None:
    label, scale = getattr(axes, f"get_{which}label")(), getattr(axes, f"get_{which}scale")()
    if not label or scale not in KNOWN_SCALES:
        return None
    low, high = map(float, getattr(axes, f"get_{which}lim")())
    found = LABEL.fullmatch(label)
    assert found is not None
    return {"title": _plain(found[1]), "unit": _plain(found[2] or ""), "low": low, "high": high, "log": scale == "log"}


def _plain(label: str) -> str:
    """Return a label without formulas; nothing for one that matplotlib made up."""
    if label.startswith("_"):
        return ""
    parts = label.split("$")
    return "".join(plain_symbol(part) if place % 2 else part for place, part in enumerate(parts))


def _numbers(column: Any) -> list[float | None]:
    return [
        float(f"{number:.{DIGITS}g}") if np.isfinite(number) else None for number in np.asarray(column, dtype=float)
    ]
