"""One interactive picture of the page: drawn once, then told to draw itself again."""

from __future__ import annotations

from nicegui import ui

from winkler.study.report.markup import safe
from winkler.web.pictures.answer import Picture

__all__ = ["Card", "caption"]

PLOTLY = ui.plotly
"""Brings plotly.js along, which the script of the drawing asks for by name."""

SOLID = "shape"
"""The picture that stands in space."""


class Figure(ui.element, component="picture.js"):
    """A figure: ``data``, ``layout`` and ``config`` for plotly.js, as JSON."""


class Solid(ui.element, component="solid.js"):
    """The body in space: the ``data`` of its curves, as JSON."""


class Card:
    """A picture with its title, or the reason why there is none.

    Parameters
    ----------
    one
        What it shows.
    """

    def __init__(self, one: Picture) -> None:
        self.name, self.missing = one.name, one.missing
        with ui.element("figure").classes("card") as self.place:
            self.caption = ui.html(caption(one.title, one.sentence), sanitize=False)
            if one.chart:
                self.drawing = (Solid if one.name == SOLID else Figure)().classes("plot")
                self.drawing.props.update({"first": one.chart, "data-picture": one.name})
            else:
                ui.label(f"Not shown: {one.missing}").classes("missing")

    def shows(self, one: Picture) -> bool:
        """Return whether another picture can take the place of this one."""
        return (self.name, self.missing) == (one.name, one.missing)

    def draw(self, one: Picture) -> None:
        """Draw its figure again; the page around it is not laid out anew."""
        words = caption(one.title, one.sentence)
        if words != self.caption.content:
            self.caption.set_content(words)
        if one.chart:
            self.drawing.run_method("draw", one.chart)


def caption(title: str, sentence: str) -> str:
    """Return the words above a picture."""
    text = f"<p>{safe(sentence)}</p>" if sentence else ""
    return f"<figcaption><h3>{safe(title)}</h3>{text}</figcaption>"
