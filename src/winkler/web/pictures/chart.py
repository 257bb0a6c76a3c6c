"""What all interactive figures have in common: plain dictionaries as plotly.js reads them, in the look of the house."""

from __future__ import annotations

import re
from typing import Any

from winkler.plot import style
from winkler.plot.series import Scale, Series, spoken
from winkler.study.language.explain import plain_symbol

__all__ = ["CONFIG", "LEGENDED", "Chart", "axis", "chart", "label", "line", "marked", "remark"]

Chart = dict[str, Any]
"""``data`` and ``layout`` of a figure."""

FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif'
CONFIG = {
    "displaylogo": False,
    "responsive": False,
    "displayModeBar": False,
    "scrollZoom": False,
}
"""No button leads out of this machine."""

LEGENDED = {
    "showlegend": True,
    "legend": {
        "orientation": "h",
        "x": 0.0,
        "y": 1.02,
        "xanchor": "left",
        "yanchor": "bottom",
        "font": {"size": 11},
        "itemclick": False,
        "itemdoubleclick": False,
    },
    "margin": {"l": 62, "r": 14, "t": 40, "b": 46},
}
"""What a figure adds that names its lines above."""


def marked(symbol: str) -> str:
    r"""Return a LaTeX symbol as plotly sets it: italic letters, indices below.

    Examples
    --------
    >>> marked("F_N"), marked("E^*"), marked(r"\sigma_{vM}")
    ('<i>F</i><sub>N</sub>', '<i>E</i><sup>*</sup>', '<i>σ</i><sub>vM</sub>')
    """
    if not symbol:
        return ""
    found = re.fullmatch(
        r"(\\?[A-Za-z]+|\\[A-Za-z]+ ?[A-Za-z])('*)(?:_(\{[^{}]*\}|\\?\w+))?(?:\^(\{[^{}]*\}|\*))?", symbol
    )
    if found is None:
        return plain_symbol(symbol)
    base, primes, below, above = found.groups()
    text = f"<i>{plain_symbol(base)}</i>{primes}"
    text += f"<sub>{plain_symbol(below)}</sub>" if below else ""
    return text + (f"<sup>{plain_symbol(above)}</sup>" if above else "")


def label(of: Series, scale: Scale | None = None) -> str:
    """Return the label of an axis: name, symbol, unit."""
    unit = (scale or of.scale).unit
    return f"{spoken(of.name)} {marked(of.word.symbol)}".rstrip() + (f" [{unit}]" if unit else "")


def axis(title: str, **more: Any) -> dict[str, Any]:
    """Return an axis with a title."""
    return {
        "title": {"text": title, "font": {"size": 12}, "standoff": 6},
        "gridcolor": "#d9dee4",
        "zeroline": False,
        "fixedrange": True,  # a finger that moves over a picture scrolls the page
        "linecolor": style.MUTED,
        "ticks": "outside",
        "ticklen": 4,
        "tickcolor": style.MUTED,
        "tickfont": {"size": 11},
        "exponentformat": "power",
        **more,
    }


def chart(data: list[dict[str, Any]], across: dict[str, Any], upright: dict[str, Any], **more: Any) -> Chart:
    """Return a figure of lines over each other."""
    layout = {
        "xaxis": across,
        "yaxis": upright,
        "margin": {"l": 62, "r": 14, "t": 12, "b": 46},
        "font": {"family": FONT, "color": style.INK, "size": 12},
        "paper_bgcolor": "white",
        "plot_bgcolor": "white",
        "showlegend": False,
        "hovermode": "closest",
        "dragmode": False,
        **more,
    }
    return {"data": data, "layout": layout, "config": CONFIG}


def line(x: Any, y: Any, colour: str, **more: Any) -> dict[str, Any]:
    """Return a line."""
    look = {"color": colour, "width": more.pop("width", 2), "dash": more.pop("dash", "solid")}
    return {"type": "scatter", "mode": "lines", "x": x, "y": y, "line": look, "hoverinfo": "x+y", **more}


def remark(text: str, *, x: float = 0.5, y: float = 0.97, **more: Any) -> dict[str, Any]:
    """Return a short remark, placed in parts of the frame."""
    return {
        "text": text,
        "xref": "paper",
        "yref": "paper",
        "x": x,
        "y": y,
        "showarrow": False,
        "bgcolor": "rgba(255,255,255,0.8)",
        "font": {"size": 11.5},
        **more,
    }
