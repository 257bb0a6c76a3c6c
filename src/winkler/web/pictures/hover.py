"""What stands beside the mouse over a picture: both numbers with their units."""

from __future__ import annotations

from typing import Any

from winkler.plot.panel import Panel

__all__ = ["add_hover"]


def add_hover(data: list[dict[str, Any]], layout: dict[str, Any], panel: Panel, axis: str) -> None:
    """State units and factors of a panel in its figure.

    Parameters
    ----------
    data, layout
        The figure; ``layout["meta"]`` gets the SI value of one unit of each axis, and the text by vertical axis.
    panel
        The panel.
    axis
        Its vertical axis, as plotly.js names it.
    """
    pair = (("x", panel.across), ("y", panel.upright))
    x, y = (f"%{{{name}:.4~g}} {one.scale.unit}".rstrip() for name, one in pair)
    text = f"{x}<br>{y}<extra></extra>"
    layout["meta"] |= {"x": panel.across.scale.factor, axis: panel.upright.scale.factor}
    layout["meta"]["hover"][axis] = text
    for trace in data:
        if trace.get("yaxis") == axis and trace.get("hoverinfo") == "x+y":
            trace["hovertemplate"] = text
