"""One interactive picture of the page: drawn once, then redrawn with new data."""

from __future__ import annotations

from collections.abc import Callable

from nicegui import ui

from winkler.study.report.markup import safe
from winkler.web.pictures.replies import InteractivePicture

__all__ = ["Card", "PictureLoader", "caption"]

PLOTLY = ui.plotly
"""Loads plotly.js, which the script of the drawing imports by name."""

BODY_PICTURE = "shape"
"""Name of the three-dimensional picture."""


class PictureLoader(ui.element, component="loader.js"):
    """Loads what draws pictures, while the first ones are computed."""


class PlotlyFigure(ui.element, component="picture.js", esm={"winkler-redraw": "redraw"}):
    """A figure: ``data``, ``layout`` and ``config`` for plotly.js, as JSON."""


class Solid(ui.element, component="solid.js"):
    """The body in space: the ``data`` of its curves, as JSON."""


NOT_PINNED = (BODY_PICTURE, "springs")
"""Pictures of bodies, over which nothing else is drawn."""
FORMATS = {"png": "PNG", "svg": "SVG", "csv": "CSV: the numbers of the curves"}


class Card:
    """A picture with its title, or the reason for its absence.

    Parameters
    ----------
    one
        The picture.
    pinned
        Pictures of an answer that is drawn below, by name.
    choose
        Called with the number of the moment, or of the curve, that was clicked.
    """

    def __init__(self, one: InteractivePicture, pinned: dict[str, str], choose: Callable[[object], None]) -> None:
        self.name, self.missing, self.chart = one.name, one.missing, one.chart
        with ui.element("figure").classes("card") as self.place:
            self.caption = ui.html(caption(one.title, one.sentence), sanitize=False)
            if one.chart:
                is_body = one.name == BODY_PICTURE
                self.drawing = (Solid if is_body else PlotlyFigure)().classes("plot")
                self.drawing.props.update({"first": one.chart, "data-picture": one.name})
                self.drawing.props["pinned"] = self._below(pinned)
                self.drawing.on("chosen", lambda event: choose(event.args))
                self._save_menu(one.title, ("png",) if is_body else tuple(FORMATS))
            else:
                ui.label(f"Not shown: {one.missing}").classes("missing")

    def _save_menu(self, title: str, formats: tuple[str, ...]) -> None:
        """Draw the button that saves this picture alone."""
        button = ui.button(icon="download").props("flat dense round size=sm").classes("save")
        button.props["aria-label"] = f"Save the picture: {title}"
        button.props["data-save"] = self.name
        with button, ui.menu().props('auto-close role="menu"'):
            for one in formats:
                call = f"getElement({self.drawing.id}).save('{one}', '{self.name}')"
                ui.menu_item(FORMATS[one]).props('role="menuitem"').on("click", js_handler=f"() => {call}")

    def shows(self, one: InteractivePicture) -> bool:
        """Return whether another picture can replace the data of this one."""
        return (self.name, self.missing) == (one.name, one.missing)

    def draw(self, one: InteractivePicture) -> None:
        """Redraw its figure, without a new layout of the page."""
        text = caption(one.title, one.sentence)
        if text != self.caption.content:
            self.caption.set_content(text)
        if one.chart:
            self.chart = one.chart
            self.drawing.run_method("draw", one.chart)

    def pin(self, pinned: dict[str, str]) -> None:
        """Draw the curves of another answer below those of this picture, or none."""
        if self.chart:
            self.drawing.run_method("pin", self._below(pinned))

    def _below(self, pinned: dict[str, str]) -> str:
        return pinned.get(self.name, "") if self.name not in NOT_PINNED else ""


def caption(title: str, sentence: str) -> str:
    """Return the caption of a picture."""
    text = f"<p>{safe(sentence)}</p>" if sentence else ""
    return f"<figcaption><h3>{safe(title)}</h3>{text}</figcaption>"
