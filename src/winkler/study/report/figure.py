"""One figure of a study: its name, its caption, and its picture."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, NamedTuple

from winkler.study.chapters.method_captions import CAPTIONS

if TYPE_CHECKING:
    from winkler.plot.panel import Sheet
    from winkler.plot.picture import Picture

__all__ = ["ReportFigure", "capital", "drawn"]


class ReportFigure(NamedTuple):
    """A figure of a study, or the reason why it is missing.

    Parameters
    ----------
    name
        The stem of its files: a picture of the method, or ``answer_`` and the name of an answer.
    title, sentence
        Its caption.
    picture
        The figure; None if it could not be drawn.
    svg
        The same as text; empty if it could not be drawn.
    missing
        Why there is none; empty if there is one.
    """

    name: str
    title: str
    sentence: str
    picture: Picture | None
    svg: str = ""
    missing: str = ""

    @property
    def of_method(self) -> bool:
        """Whether this is a picture of the method, not of the answers."""
        return self.name in CAPTIONS


def drawn(name: str, title: str, sentence: str, sheet: Sheet) -> ReportFigure:
    """Return a figure with its text, laid out once for all formats."""
    from winkler.plot.render import render  # matplotlib is loaded by the first figure

    picture = render(sheet)
    _lay_out(picture)
    store = io.BytesIO()
    picture.savefig(store, format="svg", dpi=200, metadata={"Date": None, "Creator": None})
    return ReportFigure(name, title, sentence, picture, store.getvalue().decode("utf-8"))


def _lay_out(picture: Picture) -> None:
    """Put the axes of a figure in their places, by the letters of SVG; each format is then drawn once."""
    from matplotlib.backends.backend_svg import FigureCanvasSVG

    from winkler.plot.picture import styled

    engine, canvas, dpi = picture.get_layout_engine(), picture.canvas, picture.dpi
    if engine is None:
        return
    try:
        FigureCanvasSVG(picture)
        with styled():
            engine.execute(picture)
            picture.set_layout_engine(None)  # with an engine matplotlib draws twice, first for the layout
    finally:
        picture.set_canvas(canvas)
        picture.dpi = dpi


def capital(text: str) -> str:
    """Return a text with a capital letter at its beginning."""
    return text[:1].upper() + text[1:]
