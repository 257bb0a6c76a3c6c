"""One figure of a study: its name, its caption, its picture, and its files."""

from __future__ import annotations

import io
import re
from typing import TYPE_CHECKING, NamedTuple

from winkler.study.chapters.method_captions import CAPTIONS

if TYPE_CHECKING:
    from winkler.plot.panel import Sheet
    from winkler.plot.picture import Picture

__all__ = ["ReportFigure", "capital", "drawn", "figure_files", "svg_element"]


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
    picture.savefig(store, format="svg", dpi=200, metadata={"Creator": None})
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


def svg_element(shown: ReportFigure, description: str) -> str:
    """Return a figure as one SVG element for a page: no prolog, its own identifiers, scalable, with a description.

    Parameters
    ----------
    shown
        A figure that was drawn; its name is put before every identifier, so that many figures can stand on one page.
    description
        Description for screen readers; already escaped.
    """
    name = shown.name.replace("_", "-")
    text = shown.svg[shown.svg.index("<svg") :]
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    text = re.sub(r'\bid="', f'id="{name}-', text)
    text = re.sub(r"url\(#", f"url(#{name}-", text)
    text = re.sub(r'href="#', f'href="#{name}-', text)
    head, rest = text.split(">", 1)
    size = re.search(r'viewBox="[\d.]+ [\d.]+ ([\d.]+) ([\d.]+)"', head)
    assert size is not None
    box = f'viewBox="0 0 {size[1]} {size[2]}"'
    links = 'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'
    wide = f'style="max-width:{float(size[1]) * 1.6:.0f}px"'
    return f'<svg {links} {box} role="img" aria-label="{description}" {wide}>{rest}'


def figure_files(shown: tuple[ReportFigure, ...], formats: tuple[str, ...]) -> dict[str, bytes]:
    """Return every figure in every format: name in the folder of results -> content."""
    return {
        f"figures/{one.name}.{ending}": one.svg.encode("utf-8") if ending == "svg" else _drawn_file(one.picture, ending)
        for one in shown
        if one.picture is not None
        for ending in formats
    }


def _drawn_file(picture: Picture, ending: str) -> bytes:
    store = io.BytesIO()
    picture.savefig(store, format=ending, dpi=200)
    return store.getvalue()
