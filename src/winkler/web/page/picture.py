"""One interactive picture of the page: drawn once, then redrawn with new data."""

from __future__ import annotations

from nicegui import ui

from winkler.study.report.markup import safe
from winkler.web.pictures.answer import InteractivePicture

__all__ = ["Card", "caption"]

PLOTLY = ui.plotly
"""Loads plotly.js, which the script of the drawing imports by name."""

BODY_PICTURE = "shape"
"""Name of the three-dimensional picture."""


class PlotlyFigure(ui.element, component="picture.js"):
    """A figure: ``data``, ``layout`` and ``config`` for plotly.js, as JSON."""


class Solid(ui.element, component="solid.js"):
    """The body in space: the ``data`` of its curves, as JSON."""


class Card:
    """A picture with its title, or the reason for its absence.

    Parameters
    ----------
    one
        The picture.
    """

    def __init__(self, one: InteractivePicture) -> None:
        self.name, self.missing = one.name, one.missing
        with ui.element("figure").classes("card") as self.place:
            self.caption = ui.html(caption(one.title, one.sentence), sanitize=False)
            if one.chart:
                self.drawing = (Solid if one.name == BODY_PICTURE else PlotlyFigure)().classes("plot")
                self.drawing.props.update({"first": one.chart, "data-picture": one.name})
            else:
                ui.label(f"Not shown: {one.missing}").classes("missing")

    def shows(self, one: InteractivePicture) -> bool:
        """Return whether another picture can replace the data of this one."""
        return (self.name, self.missing) == (one.name, one.missing)

    def draw(self, one: InteractivePicture) -> None:
        """Redraw its figure, without a new layout of the page."""
        text = caption(one.title, one.sentence)
        if text != self.caption.content:
            self.caption.set_content(text)
        if one.chart:
            self.drawing.run_method("draw", one.chart)


def caption(title: str, sentence: str) -> str:
    """Return the caption of a picture."""
    text = f"<p>{safe(sentence)}</p>" if sentence else ""
    return f"<figcaption><h3>{safe(title)}</h3>{text}</figcaption>"
